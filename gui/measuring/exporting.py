"""Export: a proposed file name, and the writing of every format."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject

from core.errors import LabError, Severity
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.states import BannerState


@dataclass(frozen=True, slots=True)
class ExportFormat:
    """One format.

    Parameters
    ----------
    key, title : of the choice
    name : proposes a file name, without a folder, for what is on the page
    write : writes what is on the page, in a worker; raises `LabError`
    """

    key: str
    title: str
    name: Callable[[Any], str]
    write: Callable[[Any, Path], object]


class Exporting(QObject):
    """Writes what is on the results page.

    Parameters
    ----------
    key : of the tab's guide
    formats : the first is proposed
    current : returns what is on the page, None for nothing
    folder : returns the folder where files go that are named without one
    jobs : writes the files; MATLAB's format is slow to load
    messages : where it is told
    """

    def __init__(
        self,
        key: str,
        formats: Sequence[ExportFormat],
        current: Callable[[], Any],
        folder: Callable[[], Path],
        jobs: Jobs,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._source = f"{key} export"
        self._formats = {one.key: one for one in formats}
        self._current = current
        self._folder = folder
        self._jobs = jobs
        self._messages = messages
        self.chosen = formats[0].key

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        return tuple((key, one.title) for key, one in self._formats.items())

    def propose(self, key: str) -> str:
        """File name for a format, with its folder; empty while there are no results."""
        self.chosen = key
        state = self._current()
        return "" if state is None else str(self._folder() / self._formats[key].name(state))

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the session's."""
        state = self._current()
        if state is None or not name.strip():
            return
        path = self._folder() / Path(name.strip()).expanduser()
        write = self._formats[key].write

        def work() -> Path:
            write(state, path)
            return path

        self._jobs.start("export", work, self._on_done, self._on_failed)

    def forget(self) -> None:
        """What was exported is no longer on the screen: take the word of it away."""
        self._messages.clear(self._source)

    def _on_done(self, path: object) -> None:
        self._messages.show(self._source, BannerState(Severity.INFO, "Exported", str(path)))

    def _on_failed(self, error: LabError) -> None:
        self._messages.tell_error(self._source, "Not exported", error)
