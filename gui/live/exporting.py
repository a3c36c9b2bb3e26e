"""Samples, means and charts into files: in a worker but for pictures, which are painted."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QSize, Signal

from core.errors import LabError, Severity
from core.records.atomic import make_folder
from core.records.means import NAME, TABLE, RecordMean, write_means
from gui.jobs import Jobs, Work
from gui.live.sample_files import FORMATS
from gui.live.trace import Excerpt
from gui.messages import Messages
from gui.widgets.chart_export import Paint, save_chart
from gui.widgets.states import BannerState

SOURCE, FAILED = "export", "export failed"
PICTURES = {"svg": "Charts, SVG", "png": "Charts, PNG", "pdf": "Charts, PDF"}


class Exporting(QObject):
    """Writes files in a worker, one after another; pictures at once, since they are painted.

    Several at once would leave the thread that reads the port too few turns.
    """

    averaged = Signal(object, object)
    """List of `RecordMean`, and the folder where their files stand."""

    def __init__(self, jobs: Jobs, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages
        self._waiting: list[tuple[str, Work]] = []
        self._busy = False

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        return (*((key, one[0]) for key, one in FORMATS.items()), *PICTURES.items())

    def suffix(self, key: str) -> str:
        """File suffix of a format."""
        return FORMATS[key][1] if key in FORMATS else f".{key}"

    def samples(
        self,
        key: str,
        path: Path,
        excerpt: Excerpt,
    ) -> None:
        """Write samples."""
        write = FORMATS[key][2]

        def work() -> Path:
            make_folder(path.parent)
            write(excerpt, path)
            return path

        self._queue("export", work)

    def means(self, make: Callable[[], list[RecordMean]], folder: Path) -> None:
        """Average in a worker, and write ``means.dat`` and ``means.csv``."""

        def work() -> tuple[list[RecordMean], Path]:
            found = make()
            make_folder(folder)
            write_means(found, folder)
            return found, folder

        self._queue("means", work)

    def picture(self, paint: Paint, size: QSize, path: Path) -> None:
        """Draw the charts into a file."""
        try:
            save_chart(paint, size, path, path.stem)
        except LabError as error:
            self._on_failed(error)
        else:
            self._on_done(path)

    def _queue(self, name: str, work: Work) -> None:
        self._waiting.append((name, work))
        if not self._busy:
            self._next()

    def _next(self) -> None:
        self._busy = bool(self._waiting)
        if self._waiting:
            name, work = self._waiting.pop(0)
            done = self._on_means if name == "means" else self._on_written
            self._jobs.start(name, work, done, self._on_refused)

    def _on_written(self, path: object) -> None:
        self._next()
        self._on_done(path)

    def _on_refused(self, error: LabError) -> None:
        self._next()
        self._on_failed(error)

    def _on_means(self, result: object) -> None:
        if not isinstance(result, tuple):
            raise TypeError(f"{type(result).__name__} are no means")
        self._next()
        found, folder = result
        self._messages.show(
            SOURCE, BannerState(Severity.INFO, f"{NAME} and {TABLE} written", str(folder))
        )
        self.averaged.emit(found, folder)

    def _on_done(self, path: object) -> None:
        self._messages.show(SOURCE, BannerState(Severity.INFO, "Exported", str(path)))

    def _on_failed(self, error: LabError) -> None:
        # Not to be replaced by the success of the next one in the queue.
        self._messages.tell_error(FAILED, "Not exported", error)
