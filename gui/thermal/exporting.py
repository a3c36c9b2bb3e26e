"""Export: the compensated calibration, and the plots as a picture."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from core.errors import FitError, LabError, Severity
from core.procedures.calibration import Provenance
from core.records.names import safe_name
from core.records.thermal_exports import THERMAL_EXPORTS, export_thermal
from core.version import SOFTWARE
from gui.jobs import Jobs
from gui.messages import Messages
from gui.thermal.library import Library
from gui.thermal.working import Outcome, RecordOutcome
from gui.widgets.states import BannerState

SOURCE = "export"
PROCEDURE = "outputs of a standing unit over temperature"
_PICTURES = ("svg", "png", "pdf")


class Exporting(QObject):
    """Writes what the tab shows.

    Parameters
    ----------
    library : whose outcome is written
    draw : writes the plots to a file, in the window's thread
    folder : returns the folder where files go that are named without one
    jobs : writes the other files
    messages : where it is told
    """

    def __init__(
        self,
        library: Library,
        draw: Callable[[Path], None],
        folder: Callable[[], Path],
        jobs: Jobs,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._library = library
        self._draw = draw
        self._folder = folder
        self._jobs = jobs
        self._messages = messages

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        plot = QCoreApplication.translate("Thermal", "Plots, {suffix}")
        return (
            *((key, one.title) for key, one in THERMAL_EXPORTS.items()),
            *((key, plot.format(suffix=key.upper())) for key in _PICTURES),
        )

    def propose(self, key: str) -> str:
        """File name for a format, with its folder."""
        suffix = f".{key}" if key in _PICTURES else THERMAL_EXPORTS[key].suffix
        outcome = self._library.outcome
        device = "unit" if outcome is None else outcome.run.device
        return str(self._folder() / f"{safe_name(device)}_thermal{suffix}")

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the sessions'."""
        outcome = self._library.outcome
        if not name.strip() or outcome is None:
            return
        path = self._folder() / Path(name.strip()).expanduser()
        if key in _PICTURES:
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
                self._draw(path)
            except (LabError, OSError) as error:
                self._on_failed(error if isinstance(error, LabError) else FitError(str(error)))
            else:
                self._on_done(path)
            return
        self._jobs.start(
            "export", lambda: _write(outcome, key, path), self._on_done, self._on_failed
        )

    def _on_done(self, path: object) -> None:
        what = QCoreApplication.translate("Thermal", "Exported")
        self._messages.show(SOURCE, BannerState(Severity.INFO, what, str(path)))

    def _on_failed(self, error: LabError) -> None:
        what = QCoreApplication.translate("Thermal", "Not exported")
        self._messages.tell_error(SOURCE, what, error)


def _write(outcome: Outcome, key: str, path: Path) -> Path:
    found = outcome.found if isinstance(outcome, RecordOutcome) else outcome.thermal
    if found is None:
        raise FitError("nothing was found over temperature; see the notes")
    path.parent.mkdir(parents=True, exist_ok=True)
    provenance = Provenance(
        procedure=PROCEDURE,
        device=outcome.run.device,
        software=SOFTWARE,
        computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
    )
    export_thermal(found, provenance, key, path)
    return path
