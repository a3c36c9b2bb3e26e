"""The open archive and the queue of work on it: one thing after another, in a worker thread."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from core.archive.place import same_place
from core.errors import LabError, StorageError
from core.records.atomic import make_folder
from gui.jobs import Job, Jobs

if TYPE_CHECKING:
    from core.archive.store import Archive

Question = Callable[["Archive"], object]


@dataclass(frozen=True, slots=True)
class _Answer:
    key: str
    result: object


class Library(QObject):
    """Asks the archive. Of several questions under one key that wait, the last is asked.

    The archive is opened by the first question, in the worker: a window that is started knows
    nothing of databases.

    Parameters
    ----------
    jobs : where the work is done
    root : the folder of all sessions
    """

    answered = Signal(str, object)
    """Key and result."""
    failed = Signal(str, object)
    """Key and `LabError`."""
    progress = Signal(int, int)
    """So many of so many are done, of the question that is being worked at."""
    changed = Signal()
    """Another question is being worked at, or none."""

    def __init__(self, jobs: Jobs, root: Callable[[], Path], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._root = root
        self._archive: Archive | None = None
        self._seen: Path | None = None
        self._waiting: dict[str, Question] = {}
        self._running = ""
        self._job: Job | None = None
        self._closing = False

    @property
    def running(self) -> str:
        """Key of the question that is being worked at; empty for none."""
        return self._running

    @property
    def idle(self) -> bool:
        """Whether nothing waits or runs."""
        return not self._running and not self._waiting

    def ask(self, key: str, question: Question) -> None:
        """Have a question answered after those before it."""
        if self._closing:
            return
        self._waiting.pop(key, None)
        self._waiting[key] = question
        self._go_on()

    def tell(self, done: int, of: int) -> None:
        """Progress of the question, told by the worker; breaks off when the window closes."""
        if self._closing:
            raise StorageError("the window was closed; what was taken in stays")
        if of < 100 or done == of or done % (of // 100) == 0:
            self.progress.emit(done, of)

    def close(self) -> None:
        """Break off what runs, let go of the archive; may be called again."""
        self._closing = True
        self._waiting.clear()
        if self._job is not None:
            self._job.wait(5.0)
        if self._archive is not None:
            self._archive.close()
            self._archive = None

    def _go_on(self) -> None:
        if self._running or not self._waiting:
            return
        key = next(iter(self._waiting))
        question = self._waiting.pop(key)
        self._running = key
        self._job = self._jobs.start(
            f"archive {key}",
            lambda: _Answer(key, question(self._opened())),
            self._on_done,
            self._on_failed,
        )
        self.changed.emit()

    def _opened(self) -> "Archive":
        """In the worker: the archive of the folder as it is now."""
        from core.archive.store import Archive
        from gui.archive.raw import RAW_READERS

        root = self._root()
        if self._archive is not None and not self._is_here(self._archive, root):
            self._archive.close()
            self._archive = None
        if self._archive is None:
            if root != self._seen:
                # A folder that was there and is gone is not made anew: its disk may come back.
                make_folder(root)
            self._archive = Archive(root, more=RAW_READERS)
            self._seen = root
        return self._archive

    @staticmethod
    def _is_here(archive: "Archive", root: Path) -> bool:
        """Whether an open archive is still that of the folder, which may have been moved away."""
        place = archive.place
        return place.root == root and (same_place(place) if place.stored else root.is_dir())

    def _on_done(self, answer: object) -> None:
        if not isinstance(answer, _Answer):
            raise TypeError(f"the archive brought {type(answer).__name__}")
        self._running = ""
        if not self._closing:
            self.answered.emit(answer.key, answer.result)
            self._go_on()
            self.changed.emit()

    def _on_failed(self, error: LabError) -> None:
        key, self._running = self._running, ""
        if not self._closing:
            self.failed.emit(key, error)
            self._go_on()
            self.changed.emit()
