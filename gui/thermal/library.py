"""Sessions and records of the list, and the work on them: in a worker, the newest wish last."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import LabError
from core.samples.run import Run
from gui.jobs import Jobs
from gui.thermal.state import Settings
from gui.thermal.working import Outcome, computed, read_source, simulated, sources_of


@dataclass(frozen=True, slots=True, eq=False)
class Entry:
    """One row of the list.

    Parameters
    ----------
    key : by which it is meant
    path : its file or folder; None for the simulated cycle
    check : whether it only checks the compensation
    run : what it holds; None until it was read
    error : why it cannot be used
    """

    key: int
    path: Path | None
    check: bool = False
    run: Run | None = None
    error: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class _Wish:
    entries: tuple[Entry, ...]
    settings: Settings


@dataclass(frozen=True, slots=True, eq=False)
class _Done:
    wish: _Wish
    entries: tuple[Entry, ...]
    outcome: Outcome | None
    error: str


class Library(QObject):
    """Keeps the sources and has them processed as one set.

    Parameters
    ----------
    jobs : where the work is done
    """

    changed = Signal()
    """Entries, outcome or work have changed."""

    def __init__(self, jobs: Jobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._entries: dict[int, Entry] = {}
        self._next = 1
        self._running = False
        self._again = False
        self.settings = Settings()
        self.outcome: Outcome | None = None
        self.error = ""

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All rows, in the order in which they came."""
        return tuple(self._entries.values())

    @property
    def busy(self) -> bool:
        """Whether work runs."""
        return self._running

    def get(self, key: int) -> Entry | None:
        """Return a row; None if it was removed."""
        return self._entries.get(key)

    def add(self, paths: Sequence[Path]) -> int:
        """Read files, sessions, or all of a folder; return the key of the last, 0 for none."""
        return self._put([Entry(0, path) for path in sources_of(paths)])

    def simulate(self) -> int:
        """Put the simulated cycle into the list; return its key."""
        return self._put([Entry(0, None)])

    def _put(self, fresh: Sequence[Entry]) -> int:
        key = 0
        for entry in fresh:
            key = self._next
            self._entries[key] = replace(entry, key=key)
            self._next += 1
        if key:
            self._go_on()
        return key

    def remove(self, key: int) -> None:
        """Take a row out of the list; its file stays."""
        if self._entries.pop(key, None) is not None:
            self._go_on()

    def check(self, key: int, check: bool) -> None:
        """Let a row only check the compensation, or let it take part."""
        entry = self._entries.get(key)
        if entry is not None and entry.check != check:
            self._entries[key] = replace(entry, check=check)
            self._go_on()

    def decide(self, settings: Settings) -> None:
        """Process with other settings."""
        if settings == self.settings:
            return
        if settings.outputs != self.settings.outputs:
            for key, entry in self._entries.items():
                if entry.path is not None:
                    self._entries[key] = Entry(key, entry.path, entry.check)
        self.settings = settings
        self._go_on()

    def _go_on(self) -> None:
        if self._running:
            self._again = True
        else:
            wish = _Wish(self.entries, self.settings)
            self._running, self._again = True, False
            self._jobs.start("thermal", lambda: _work(wish), self._on_done, self._on_failed)
        self.changed.emit()

    def _on_done(self, done: object) -> None:
        if not isinstance(done, _Done):
            raise TypeError(f"the work brought {type(done).__name__}")
        self._running = False
        for before, after in zip(done.wish.entries, done.entries, strict=True):
            if self._entries.get(after.key) is before:
                self._entries[after.key] = after
        if self._again:
            self._go_on()
            return
        self.outcome, self.error = done.outcome, done.error
        self.changed.emit()

    def _on_failed(self, error: LabError) -> None:
        self._running = False
        self.outcome, self.error = None, str(error)
        self.changed.emit()


def _work(wish: _Wish) -> _Done:
    entries = tuple(_read(entry, wish.settings) for entry in wish.entries)
    runs = [entry.run for entry in entries if entry.run is not None and not entry.check]
    checks = [entry.run for entry in entries if entry.run is not None and entry.check]
    if not runs:
        return _Done(wish, entries, None, "")
    try:
        return _Done(wish, entries, computed(runs, checks, wish.settings), "")
    except LabError as error:
        return _Done(wish, entries, None, str(error))


def _read(entry: Entry, settings: Settings) -> Entry:
    if entry.run is not None or entry.error:
        return entry
    if entry.path is None:
        return replace(entry, run=simulated())
    try:
        return replace(entry, run=read_source(entry.path, settings))
    except LabError as error:
        return replace(entry, error=str(error))
