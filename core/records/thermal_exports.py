"""Calibrations over temperature as files: JSON, C header, CSV."""

from collections.abc import Mapping

from core.errors import FitError
from core.procedures.calibration import Provenance
from core.procedures.thermal.cycle import ThermalCalibration
from core.procedures.thermal.export import c_header, csv_text, document, record_document
from core.procedures.thermal.record import RecordResult
from core.records.json_text import to_json
from core.records.result_format import ResultFormat

Found = ThermalCalibration | RecordResult


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


THERMAL_EXPORTS: Mapping[str, ResultFormat[Found]] = {
    "json": ResultFormat("JSON with covariance and provenance", ".thermal.json", _json),
    "c": ResultFormat("C header", ".h", _c),
    "csv": ResultFormat("CSV of the coefficients", ".thermal.csv", _csv),
}
"""Every format, by identifier."""
