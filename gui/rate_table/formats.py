"""The files that results of gyros can be exported to."""

from datetime import datetime
from pathlib import Path

from core.records.exports import EXPORTS, export, proposed_name
from core.records.legacy.layout import CLBDUS_HEAD, ROTATION_TABLE, LegacyLayout
from core.records.legacy.writer import write_legacy
from core.records.names import stamp
from core.records.run_file import write_run
from gui.exporting import ExportFormat
from gui.rate_table.processing import RateResult


def formats() -> tuple[ExportFormat, ...]:
    """Calibrations, the legacy texts, the run file."""
    return (
        *(_calibration(key) for key in EXPORTS),
        *(_legacy(layout) for layout in (ROTATION_TABLE, CLBDUS_HEAD)),
        ExportFormat("run", "Run file of the rates", _run_name, _write_run),
    )


def _calibration(key: str) -> ExportFormat:
    def write(result: RateResult, path: Path) -> None:
        export(result.calibration, key, path)

    return ExportFormat(
        key, EXPORTS[key].title, lambda result: proposed_name(result.calibration, key), write
    )


def _legacy(layout: LegacyLayout) -> ExportFormat:
    return ExportFormat(
        f"legacy {layout.id}",
        layout.title,
        lambda result: f"{layout.stem}_{_stamp(result)}.txt",
        lambda result, path: write_legacy(result.latest.run, layout, path),
    )


def _run_name(result: RateResult) -> str:
    stem = proposed_name(result.calibration, "json").removesuffix(EXPORTS["json"].suffix)
    return f"{stem}_{result.latest.run.test}.run.csv"


def _write_run(result: RateResult, path: Path) -> None:
    write_run(result.latest.run, path)


def _stamp(result: RateResult) -> str:
    """Local time of the test's start, of the processing where that is not known."""
    run, provenance = result.latest.run, result.calibration.provenance
    measured = run.meta.get("measured_utc") or provenance.computed_utc
    return stamp(datetime.fromisoformat(str(measured)).astimezone())
