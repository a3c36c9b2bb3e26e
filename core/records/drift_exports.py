"""Drift tables as files: C header, JSON, CSV."""

import csv
import io
from collections.abc import Mapping

from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import DriftResult
from core.procedures.drift.export import c_header, document
from core.records.json_text import to_json
from core.records.result_format import ResultFormat


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


DRIFT_EXPORTS: Mapping[str, ResultFormat[DriftResult]] = {
    "c": ResultFormat(
        "C header with int16 table",
        ".h",
        lambda result, provenance, name: c_header(result.table, name, provenance),
    ),
    "json": ResultFormat(
        "JSON with scores and provenance",
        ".drift.json",
        lambda result, provenance, _: to_json(document(result, provenance)),
    ),
    "csv": ResultFormat("CSV of the table", ".drift.csv", _csv),
}
"""Every format, by identifier."""
