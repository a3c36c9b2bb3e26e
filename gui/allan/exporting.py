"""Export: the plot as a picture, the results as files for other programs."""

from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject

from core.errors import FitError, LabError, Severity
from core.records.names import safe_name, stamp
from core.records.noise_exports import NOISE_EXPORTS, export_noise
from core.records.noise_study import NoiseStudy
from gui.allan.library import Library
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.states import BannerState

SOURCE = "export"
PICTURES = {"svg": "Plot, SVG", "png": "Plot, PNG", "pdf": "Plot, PDF"}


class Exporting(QObject):
    """Writes what the tab shows.

    Parameters
    ----------
    library : whose shown records are exported
    draw : writes the plot to a file, in the window's thread
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
        return (*PICTURES.items(), *((key, one.title) for key, one in NOISE_EXPORTS.items()))

    def propose(self, key: str) -> str:
        """File name for a format, with its folder."""
        names = dict.fromkeys(study.device for study in self._library.studies)
        stem = "_".join(safe_name(name) for name in names) if 0 < len(names) < 4 else "devices"
        suffix = f".{key}" if key in PICTURES else NOISE_EXPORTS[key].suffix
        if key == "kalibr":
            return str(self._folder() / f"imu_{stem}{suffix}")
        return str(self._folder() / f"Allan_{stem}_{stamp(datetime.now())}{suffix}")

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the sessions'."""
        if not name.strip():
            return
        path = self._folder() / Path(name.strip()).expanduser()
        studies = self._library.studies
        try:
            if key in PICTURES:
                path.parent.mkdir(parents=True, exist_ok=True)
                self._draw(path)
                self._on_done(path)
                return
            if not studies:
                raise FitError("no analysed record is shown; analyse a record first")
        except (LabError, OSError) as error:
            self._on_failed(error if isinstance(error, LabError) else FitError(str(error)))
            return
        self._jobs.start(
            "export", lambda: _write(studies, key, path), self._on_done, self._on_failed
        )

    def _on_done(self, path: object) -> None:
        self._messages.show(SOURCE, BannerState(Severity.INFO, "Exported", str(path)))

    def _on_failed(self, error: LabError) -> None:
        self._messages.tell_error(SOURCE, "Not exported", error)


def _write(studies: Sequence[NoiseStudy], key: str, path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    export_noise(studies, key, path)
    return path
