"""Records from the disk, read in a worker: onto the screen, or beneath it."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import LabError
from drivers.recording import Recording
from drivers.records import open_record
from gui.jobs import Jobs
from gui.live.trace import Trace, trace_of
from gui.messages import Messages
from gui.widgets.states import BannerState

SOURCE = "load"


@dataclass(frozen=True, slots=True)
class Loaded:
    """A record and its trace."""

    record: Recording
    trace: Trace
    beneath: bool


class Loading(QObject):
    """Opens records."""

    loaded = Signal(object)
    """`Loaded`."""

    def __init__(self, jobs: Jobs, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages

    def load(self, path: Path, *, beneath: bool = False) -> None:
        """Open a record; `beneath` draws it under the one on the screen."""
        self._jobs.start("load", lambda: _load(path, beneath), self._on_done, self._on_failed)

    def _on_done(self, found: object) -> None:
        if not isinstance(found, Loaded):
            raise TypeError(f"{type(found).__name__} is no record")
        self._messages.clear(SOURCE)
        notes = found.record.notes
        if notes:
            words = " ".join(note.text for note in notes)
            what = f"{found.record.path.name} has been opened with doubts"
            self._messages.show(SOURCE, BannerState(notes[0].severity, what, words))
        self.loaded.emit(found)

    def _on_failed(self, error: LabError) -> None:
        self._messages.tell_error(SOURCE, "The record cannot be opened", error)


def _load(path: Path, beneath: bool) -> Loaded:
    record = open_record(path)
    return Loaded(record, trace_of(record), beneath)
