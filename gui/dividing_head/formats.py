"""The files that a calibration on the head can be exported to."""

from datetime import datetime
from pathlib import Path

from core.records.exports import EXPORTS, export, proposed_name
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.legacy.writer import write_legacy
from core.records.names import stamp
from core.records.run_file import write_run
from gui.dividing_head.processing import HeadResult
from gui.exporting import ExportFormat


def formats() -> tuple[ExportFormat, ...]:
    """Calibrations, the legacy texts, the run file."""
    return (
        *(_calibration(key) for key in EXPORTS),
        *(_legacy(key) for key in ("clbacc", "pointer")),
        ExportFormat("run", "Run file of the positions", _run_name, _write_run),
    )


def _calibration(key: str) -> ExportFormat:
    def write(result: HeadResult, path: Path) -> None:
        export(result.calibration, key, path)

    return ExportFormat(
        key, EXPORTS[key].title, lambda result: proposed_name(result.calibration, key), write
    )


def _legacy(key: str) -> ExportFormat:
    layout = LEGACY_FORMATS[key]
    return ExportFormat(
        f"legacy {key}",
        layout.title,
        lambda result: f"{layout.stem}_{_stamp(result)}.txt",
        lambda result, path: write_legacy(result.run, layout, path),
    )


def _run_name(result: HeadResult) -> str:
    stem = proposed_name(result.calibration, "json").removesuffix(EXPORTS["json"].suffix)
    return f"{stem}.run.csv"


def _write_run(result: HeadResult, path: Path) -> None:
    write_run(result.run, path)


def _stamp(result: HeadResult) -> str:
    """Local time of the test's start, of the processing where that is not known."""
    measured = result.run.meta.get("measured_utc") or result.calibration.provenance.computed_utc
    return stamp(datetime.fromisoformat(str(measured)).astimezone())
