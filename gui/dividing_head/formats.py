"""The files that a calibration on the head can be exported to."""

from core.records.legacy.layout import LEGACY_FORMATS
from core.samples.run import Run
from gui.dividing_head.processing import HeadResult
from gui.exporting import ExportFormat
from gui.measuring.formats import calibration_formats, legacy_formats, run_format


def formats() -> tuple[ExportFormat, ...]:
    """Calibrations, the legacy texts, the run file."""
    return (
        *calibration_formats(),
        *legacy_formats((LEGACY_FORMATS["clbacc"], LEGACY_FORMATS["pointer"]), _run),
        run_format("Run file of the positions", _run, lambda _: ".run.csv"),
    )


def _run(result: HeadResult) -> Run:
    return result.run
