"""The files that every calibration measured step by step can be exported to."""

from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

from core.records.exports import EXPORTS, export, proposed_name
from core.records.legacy.layout import LegacyLayout
from core.records.legacy.writer import write_legacy
from core.records.names import stamp
from core.records.run_file import write_run
from core.samples.run import Run
from gui.exporting import ExportFormat

RunOf = Callable[[Any], Run]
"""Returns the rows of a result; a result has its ``calibration`` besides."""


def calibration_formats() -> tuple[ExportFormat, ...]:
    """The calibration in every format."""
    return tuple(_calibration(key) for key in EXPORTS)


def legacy_formats(layouts: Sequence[LegacyLayout], run_of: RunOf) -> tuple[ExportFormat, ...]:
    """The rows as texts of the old programs."""
    return tuple(_legacy(layout, run_of) for layout in layouts)


def run_format(title: str, run_of: RunOf, ending: Callable[[Run], str]) -> ExportFormat:
    """The rows as a run file; `ending` follows the name of the calibration."""

    def name(result: Any) -> str:
        stem = proposed_name(result.calibration, "json").removesuffix(EXPORTS["json"].suffix)
        return f"{stem}{ending(run_of(result))}"

    return ExportFormat("run", title, name, lambda result, path: write_run(run_of(result), path))


def _calibration(key: str) -> ExportFormat:
    def write(result: Any, path: Path) -> None:
        export(result.calibration, key, path)

    return ExportFormat(
        key, EXPORTS[key].title, lambda result: proposed_name(result.calibration, key), write
    )


def _legacy(layout: LegacyLayout, run_of: RunOf) -> ExportFormat:
    def name(result: Any) -> str:
        # Local time of the test's start, of the processing where that is not known.
        known = run_of(result).meta.get("measured_utc")
        when = known or result.calibration.provenance.computed_utc
        return f"{layout.stem}_{stamp(datetime.fromisoformat(str(when)).astimezone())}.txt"

    return ExportFormat(
        f"legacy {layout.id}",
        layout.title,
        name,
        lambda result, path: write_legacy(run_of(result), layout, path),
    )
