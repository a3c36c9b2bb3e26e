"""Calibrations over temperature as files: JSON, C header, CSV."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from core.errors import FitError
from core.procedures.calibration import Provenance
from core.procedures.thermal.cycle import ThermalCalibration
from core.procedures.thermal.export import c_header, csv_text, document, record_document
from core.procedures.thermal.record import RecordResult
from core.records.atomic import write_bytes_atomic
from core.records.json_text import to_json

Found = ThermalCalibration | RecordResult


@dataclass(frozen=True, slots=True)
class ThermalExport:
    """One format.

    Parameters
    ----------
    title : for the list of formats
    suffix : end of the file's name
    text : (result, provenance, name) -> content; `name` becomes the names in C
    """

    title: str
    suffix: str
    text: Callable[[Found, Provenance, str], str]


def _json(found: Found, provenance: Provenance, _name: str) -> str:
    if isinstance(found, RecordResult):
        return to_json(record_document(found, provenance))
    return to_json(document(found))


def _c(found: Found, _provenance: Provenance, name: str) -> str:
    if isinstance(found, RecordResult):
        raise FitError(
            "a record in one orientation compensates this orientation only: no C header is written"
            " of it; measure positions at each temperature"
        )
    return c_header(found, name)


def _csv(found: Found, _provenance: Provenance, _name: str) -> str:
    return csv_text(found)


THERMAL_EXPORTS: Mapping[str, ThermalExport] = {
    "json": ThermalExport("JSON with covariance and provenance", ".thermal.json", _json),
    "c": ThermalExport("C header", ".h", _c),
    "csv": ThermalExport("CSV of the coefficients", ".thermal.csv", _csv),
}
"""Every format, by identifier."""


def export_thermal(found: Found, provenance: Provenance, key: str, path: Path) -> None:
    """Write a result in the format `key` of THERMAL_EXPORTS.

    Parameters
    ----------
    provenance : of a record; a `ThermalCalibration` has its own

    Raises
    ------
    FitError
        The format cannot hold this result.
    StorageError
        The file could not be written.
    """
    text = THERMAL_EXPORTS[key].text(found, provenance, path.stem)
    write_bytes_atomic(path, text.encode())
