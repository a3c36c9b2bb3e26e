"""What can be exported: the table for the microcontroller, and the plots as pictures."""

from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import DriftResult
from core.records.atomic import make_folder
from core.records.drift_exports import DRIFT_EXPORTS
from core.records.names import safe_name
from core.version import SOFTWARE
from gui.drift.library import Library
from gui.drift.presenter import DriftPresenter
from gui.exporting import ExportFormat, pictures

PROCEDURE = "drift after switching on, source 003"


@dataclass(frozen=True, slots=True, eq=False)
class Page:
    """What is on the page: the table, as it was dragged, and what the unit is called."""

    result: DriftResult
    device: str


def page_of(presenter: DriftPresenter, library: Library) -> Page | None:
    """Return what can be exported now; the unit is called after its first record."""
    if presenter.knots is None:
        return None
    names = [entry.path.name.partition(".")[0] for entry in library.entries if entry.path]
    return Page(presenter.knots.result, names[0] if names else "simulated_gyro")


def formats(draw: Callable[[Path], None]) -> tuple[ExportFormat, ...]:
    """The formats; `draw` writes the plots."""
    plots = QCoreApplication.translate("Drift", "Plots, {suffix}")
    return (
        *(_file(key) for key in DRIFT_EXPORTS),
        *pictures(plots, _stem, lambda _, path: draw(path)),
    )


def _file(key: str) -> ExportFormat:
    kind = DRIFT_EXPORTS[key]

    def write(page: Page, path: Path) -> None:
        make_folder(path.parent)
        provenance = Provenance(
            procedure=PROCEDURE,
            device=page.device,
            software=SOFTWARE,
            computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
        )
        kind.write(page.result, provenance, path)

    return ExportFormat(key, kind.title, lambda page: f"{_stem(page)}{kind.suffix}", write)


def _stem(page: Page) -> str:
    return f"{safe_name(page.device)}_drift"
