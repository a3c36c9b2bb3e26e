"""The records of a list and the work on them all: in a worker thread, the newest wish last."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from core.errors import LabError
from gui.jobs import Jobs


@dataclass(frozen=True, slots=True, eq=False)
class Entry:
    """One row of the list; a tab adds what it holds.

    Parameters
    ----------
    key : by which it is meant
    path : its file or folder; None for what is simulated
    error : why it cannot be used
    """

    key: int
    path: Path | None
    error: str = ""


E = TypeVar("E", bound=Entry)
S = TypeVar("S")
R = TypeVar("R")


@dataclass(frozen=True, slots=True)
class Method(Generic[E, S, R]):
    """The work.

    Parameters
    ----------
    name : of the job
    fresh : makes an entry of its key and its path
    sources : returns the files that are meant; of a folder those in it
    reading : returns what of the settings the reading depends on
    read : returns an entry with what its file holds; one that was read already as it is
    unread : returns an entry without what its file held
    compute : makes the result of all entries; None where none can be used
    """

    name: str
    fresh: Callable[[int, Path | None], E]
    sources: Callable[[Sequence[Path]], Sequence[Path]]
    reading: Callable[[S], object]
    read: Callable[[E, S], E]
    unread: Callable[[E], E]
    compute: Callable[[Sequence[E], S], R | None]


@dataclass(frozen=True, slots=True, eq=False)
class _Done:
    before: tuple[Any, ...]
    after: tuple[Any, ...]
    result: Any
    error: str


class Library(Generic[E, S, R], QObject):
    """Keeps records and has them worked out as one set.

    Parameters
    ----------
    jobs : where the work is done
    method : the work; a `LabError` of a record refuses it, one of the whole becomes `error`
    settings : of the operator
    """

    changed = Signal()
    """Entries, result or work have changed."""

    def __init__(
        self, jobs: Jobs, method: Method[E, S, R], settings: S, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._method = method
        self._entries: dict[int, E] = {}
        self._next = 1
        self._running = False
        self._again = False
        self.settings = settings
        self.result: R | None = None
        self.error = ""

    @property
    def entries(self) -> tuple[E, ...]:
        """All rows, in the order in which they came."""
        return tuple(self._entries.values())

    @property
    def busy(self) -> bool:
        """Whether work runs."""
        return self._running

    def get(self, key: int) -> E | None:
        """Return a row; None if it was removed."""
        return self._entries.get(key)

    def add(self, paths: Sequence[Path]) -> int:
        """Read files, or all of a folder; return the key of the last one, 0 for none."""
        return self._put(self._method.sources(paths))

    def simulate(self) -> int:
        """Put what is made up into the list; return its key."""
        return self._put([None])

    def _put(self, paths: Sequence[Path | None]) -> int:
        key = 0
        for path in paths:
            key = self._next
            self._entries[key] = self._method.fresh(key, path)
            self._next += 1
        if key:
            self._go_on()
        return key

    def exchange(self, entry: E) -> None:
        """Take a row instead of the one that has its key."""
        self._entries[entry.key] = entry
        self._go_on()

    def remove(self, key: int) -> None:
        """Take a row out of the list; its file stays."""
        if self._entries.pop(key, None) is not None:
            self._go_on()

    def decide(self, settings: S) -> None:
        """Work with other settings."""
        if settings == self.settings:
            return
        method = self._method
        if method.reading(settings) != method.reading(self.settings):
            self._entries = {
                key: entry if entry.path is None else method.unread(entry)
                for key, entry in self._entries.items()
            }
        self.settings = settings
        self._go_on()

    def _go_on(self) -> None:
        if self._running:
            self._again = True
        else:
            method, entries, settings = self._method, self.entries, self.settings
            self._running, self._again = True, False
            self._jobs.start(
                method.name,
                lambda: _work(method, entries, settings),
                self._on_done,
                self._on_failed,
            )
        self.changed.emit()

    def _on_done(self, done: object) -> None:
        if not isinstance(done, _Done):
            raise TypeError(f"the work brought {type(done).__name__}")
        self._running = False
        for before, after in zip(done.before, done.after, strict=True):
            if self._entries.get(after.key) is before:
                self._entries[after.key] = after
        if self._again:
            self._go_on()
            return
        self.result, self.error = done.result, done.error
        self.changed.emit()

    def _on_failed(self, error: LabError) -> None:
        self._running = False
        self.result, self.error = None, str(error)
        self.changed.emit()


def _work(method: Method[E, S, R], entries: tuple[E, ...], settings: S) -> _Done:
    read = tuple(_read(method, entry, settings) for entry in entries)
    try:
        return _Done(entries, read, method.compute(read, settings), "")
    except LabError as error:
        return _Done(entries, read, None, str(error))


def _read(method: Method[E, S, R], entry: E, settings: S) -> E:
    if entry.error:
        return entry
    try:
        return method.read(entry, settings)
    except LabError as error:
        return replace(entry, error=str(error))
