"""The files that results of gyros can be exported to."""

from core.records.legacy.layout import CLBDUS_HEAD, ROTATION_TABLE
from core.samples.run import Run
from gui.exporting import ExportFormat
from gui.measuring.formats import calibration_formats, legacy_formats, run_format
from gui.rate_table.processing import RateResult


def formats() -> tuple[ExportFormat, ...]:
    """Calibrations, the legacy texts, the run file."""
    return (
        *calibration_formats(),
        *legacy_formats((ROTATION_TABLE, CLBDUS_HEAD), _run),
        run_format("Run file of the rates", _run, lambda run: f"_{run.test}.run.csv"),
    )


def _run(result: RateResult) -> Run:
    return result.latest.run
