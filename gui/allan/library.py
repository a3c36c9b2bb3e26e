"""The records of the list, and the work on them: one after another, in a worker thread."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import LabError
from core.records.noise_study import NoiseStudy, StudyRequest, study
from core.records.series import Series
from drivers.series import read_series
from gui.jobs import Jobs


@dataclass(slots=True, eq=False)
class Entry:
    """One record.

    Parameters
    ----------
    key : by which it is meant; never used again
    path : its file
    colour : number of its curve colour
    shown : whether its curve is drawn
    request : what the operator decided
    series : the samples, None until they were read
    study : what was found, None until then
    error : why nothing was found
    """

    key: int
    path: Path
    colour: int
    shown: bool = True
    request: StudyRequest = field(default_factory=StudyRequest)
    series: Series | None = None
    study: NoiseStudy | None = None
    error: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class _Done:
    series: Series
    study: NoiseStudy | LabError


class Library(QObject):
    """Keeps records and has them analysed.

    Parameters
    ----------
    jobs : where the work is done
    """

    changed = Signal()
    failed = Signal(int)
    """Key of a record that could not be analysed; its `error` tells why."""

    def __init__(self, jobs: Jobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._entries: dict[int, Entry] = {}
        self._next = 1
        self._waiting: list[int] = []
        self._running: tuple[int, StudyRequest] | None = None

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All records, in the order in which they came."""
        return tuple(self._entries.values())

    @property
    def studies(self) -> tuple[NoiseStudy, ...]:
        """Results of the records that are shown."""
        return tuple(e.study for e in self.entries if e.shown and e.study is not None)

    def get(self, key: int) -> Entry | None:
        """Return a record; None if it was removed."""
        return self._entries.get(key)

    def busy(self, key: int) -> bool:
        """Whether work on a record waits or runs."""
        return key in self._waiting or (self._running is not None and self._running[0] == key)

    def add(self, paths: Sequence[Path], request: StudyRequest | None = None) -> int:
        """Read and analyse files; return the key of the last one, 0 for none."""
        key = 0
        for path in paths:
            key = self._next
            self._next += 1
            taken = {entry.colour for entry in self._entries.values()}
            colour = next(number for number in range(len(taken) + 1) if number not in taken)
            entry = Entry(key, path, colour, request=request or StudyRequest())
            self._entries[key] = entry
            self._waiting.append(key)
        self._go_on()
        self.changed.emit()
        return key

    def remove(self, key: int) -> None:
        """Take a record out of the list; its file stays."""
        if self._entries.pop(key, None) is not None:
            self._waiting = [one for one in self._waiting if one != key]
            self.changed.emit()

    def show(self, key: int, shown: bool) -> None:
        """Draw the curve of a record, or not."""
        entry = self._entries.get(key)
        if entry is not None and entry.shown != shown:
            entry.shown = shown
            self.changed.emit()

    def decide(self, key: int, request: StudyRequest) -> None:
        """Analyse a record anew, with other decisions."""
        entry = self._entries.get(key)
        if entry is None or entry.request == request:
            return
        entry.request = request
        if key not in self._waiting:
            self._waiting.append(key)
        self._go_on()
        self.changed.emit()

    def _go_on(self) -> None:
        if self._running is not None or not self._waiting:
            return
        entry = self._entries[self._waiting.pop(0)]
        self._running = (entry.key, entry.request)
        path, series, request = entry.path, entry.series, entry.request
        self._jobs.start(
            f"noise of {path.name}",
            lambda: _work(path, series, request),
            self._on_done,
            self._on_failed,
        )

    def _on_done(self, result: object) -> None:
        if not isinstance(result, _Done):
            raise TypeError(f"the analysis brought {type(result).__name__}")
        entry = self._finished()
        if entry is not None:
            entry.series = result.series
            if isinstance(result.study, LabError):
                self._refuse(entry, result.study)
            else:
                entry.study, entry.error = result.study, ""
        self._go_on()
        self.changed.emit()

    def _on_failed(self, error: LabError) -> None:
        entry = self._finished()
        if entry is not None:
            self._refuse(entry, error)
        self._go_on()
        self.changed.emit()

    def _finished(self) -> Entry | None:
        """The record whose work has ended; None if it was removed or decided anew meanwhile."""
        if self._running is None:
            raise RuntimeError("a result came that nobody asked for")
        key, request = self._running
        self._running = None
        entry = self._entries.get(key)
        return entry if entry is not None and entry.request == request else None

    def _refuse(self, entry: Entry, error: LabError) -> None:
        entry.study, entry.error = None, str(error)
        self.failed.emit(entry.key)


def _work(path: Path, series: Series | None, request: StudyRequest) -> _Done:
    read = read_series(path) if series is None else series
    try:
        return _Done(read, study(read, request))
    except LabError as error:
        # The samples were read: the operator may decide otherwise without reading them again.
        return _Done(read, error)
