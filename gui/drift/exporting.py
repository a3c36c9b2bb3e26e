"""Export: the table for the microcontroller, and the plots as a picture."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from core.errors import FitError, LabError, Severity
from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import DriftResult
from core.records.drift_exports import DRIFT_EXPORTS, export_drift
from core.records.names import safe_name
from core.version import SOFTWARE
from gui.drift.library import Library
from gui.drift.presenter import DriftPresenter
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.states import BannerState

SOURCE = "export"
PROCEDURE = "drift after switching on, source 003"
_PICTURES = ("svg", "png", "pdf")


class Exporting(QObject):
    """Writes what the tab shows.

    Parameters
    ----------
    presenter : whose table is written, as it was dragged
    library : tells the names of the records
    draw : writes the plots to a file, in the window's thread
    folder : returns the folder where files go that are named without one
    jobs : writes the other files
    messages : where it is told
    """

    def __init__(
        self,
        presenter: DriftPresenter,
        library: Library,
        draw: Callable[[Path], None],
        folder: Callable[[], Path],
        jobs: Jobs,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._library = library
        self._draw = draw
        self._folder = folder
        self._jobs = jobs
        self._messages = messages

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        plot = QCoreApplication.translate("Drift", "Plots, {suffix}")
        return (
            *((key, one.title) for key, one in DRIFT_EXPORTS.items()),
            *((key, plot.format(suffix=key.upper())) for key in _PICTURES),
        )

    @property
    def device(self) -> str:
        """What the unit is called, by the names of its records."""
        names = [entry.path.name.partition(".")[0] for entry in self._library.entries if entry.path]
        return names[0] if names else "simulated_gyro"

    def propose(self, key: str) -> str:
        """File name for a format, with its folder."""
        suffix = f".{key}" if key in _PICTURES else DRIFT_EXPORTS[key].suffix
        return str(self._folder() / f"{safe_name(self.device)}_drift{suffix}")

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the sessions'."""
        knots = self._presenter.knots
        if not name.strip() or knots is None:
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
        result, device = knots.result, self.device
        self._jobs.start(
            "export", lambda: _write(result, device, key, path), self._on_done, self._on_failed
        )

    def _on_done(self, path: object) -> None:
        what = QCoreApplication.translate("Drift", "Exported")
        self._messages.show(SOURCE, BannerState(Severity.INFO, what, str(path)))

    def _on_failed(self, error: LabError) -> None:
        what = QCoreApplication.translate("Drift", "Not exported")
        self._messages.tell_error(SOURCE, what, error)


def _write(result: DriftResult, device: str, key: str, path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    provenance = Provenance(
        procedure=PROCEDURE,
        device=device,
        software=SOFTWARE,
        computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
    )
    export_drift(result, provenance, key, path)
    return path
