"""Drift tables as files: C header, JSON, CSV."""

import csv
import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import DriftResult
from core.procedures.drift.export import c_header, document
from core.records.atomic import write_bytes_atomic
from core.records.json_text import to_json


@dataclass(frozen=True, slots=True)
class DriftExport:
    """One format.

    Parameters
    ----------
    title : for the list of formats
    suffix : end of the file's name
    text : (result, provenance, name) -> content; `name` becomes the names in C
    """

    title: str
    suffix: str
    text: Callable[[DriftResult, Provenance, str], str]


def _csv(result: DriftResult, _provenance: Provenance, _name: str) -> str:
    table = result.table
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    head = [f"correction_at_{value:.2f}_degC ({table.unit})" for value in table.temperatures_c]
    writer.writerow(["time_s", *head, *(name.replace("correction", "u") for name in head)])
    for place, time in enumerate(table.times_s.tolist()):
        cells = [*table.values[:, place].tolist(), *table.u[:, place].tolist()]
        writer.writerow([repr(time), *map(repr, cells)])
    return text.getvalue()


DRIFT_EXPORTS: Mapping[str, DriftExport] = {
    "c": DriftExport(
        "C header with int16 table",
        ".h",
        lambda result, provenance, name: c_header(result.table, name, provenance),
    ),
    "json": DriftExport(
        "JSON with scores and provenance",
        ".drift.json",
        lambda result, provenance, _: to_json(document(result, provenance)),
    ),
    "csv": DriftExport("CSV of the table", ".drift.csv", _csv),
}
"""Every format, by identifier."""


def export_drift(result: DriftResult, provenance: Provenance, key: str, path: Path) -> None:
    """Write a result in the format `key` of DRIFT_EXPORTS.

    Raises
    ------
    FitError
        The table does not fit 16-bit integers.
    StorageError
        The file could not be written.
    """
    text = DRIFT_EXPORTS[key].text(result, provenance, path.stem)
    write_bytes_atomic(path, text.encode())
