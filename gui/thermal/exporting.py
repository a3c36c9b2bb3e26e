"""What can be exported: the compensated calibration, and the plots as pictures."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.errors import FitError
from core.procedures.calibration import Provenance
from core.records.atomic import make_folder
from core.records.names import safe_name
from core.records.thermal_exports import THERMAL_EXPORTS
from core.version import SOFTWARE
from gui.exporting import ExportFormat, pictures
from gui.thermal.working import Outcome, RecordOutcome

PROCEDURE = "outputs of a standing unit over temperature"


def formats(draw: Callable[[Path], None]) -> tuple[ExportFormat, ...]:
    """The formats; `draw` writes the plots."""
    plots = QCoreApplication.translate("Thermal", "Plots, {suffix}")
    return (
        *(_file(key) for key in THERMAL_EXPORTS),
        *pictures(plots, _stem, lambda _, path: draw(path)),
    )


def _file(key: str) -> ExportFormat:
    kind = THERMAL_EXPORTS[key]

    def write(outcome: Outcome, path: Path) -> None:
        found = outcome.found if isinstance(outcome, RecordOutcome) else outcome.thermal
        if found is None:
            raise FitError("nothing was found over temperature; see the notes")
        make_folder(path.parent)
        provenance = Provenance(
            procedure=PROCEDURE,
            device=outcome.run.device,
            software=SOFTWARE,
            computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
        )
        kind.write(found, provenance, path)

    return ExportFormat(key, kind.title, lambda outcome: f"{_stem(outcome)}{kind.suffix}", write)


def _stem(outcome: Outcome) -> str:
    return f"{safe_name(outcome.run.device)}_thermal"
