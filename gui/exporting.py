"""Export: a proposed file name, and the writing of every format."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject

from core.errors import LabError, Severity
from core.records.atomic import make_folder
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.export_foot import ExportFoot
from gui.widgets.states import BannerState

_PICTURES = ("svg", "png", "pdf")


@dataclass(frozen=True, slots=True)
class ExportFormat:
    """One format.

    Parameters
    ----------
    key, title : of the choice
    name : proposes a file name, without a folder, for what is on the page
    write : writes what is on the page; raises `LabError`
    at_once : written in the window's thread, as what is drawn must be; else in a worker
    """

    key: str
    title: str
    name: Callable[[Any], str]
    write: Callable[[Any, Path], object]
    at_once: bool = False


def pictures(
    title: str, stem: Callable[[Any], str], draw: Callable[[Any, Path], object]
) -> tuple[ExportFormat, ...]:
    """The formats of a picture.

    Parameters
    ----------
    title : of the choice, with a gap for the ``{suffix}``
    stem : proposes a file name without its suffix, for what is on the page
    draw : writes the picture; the suffix of the path chooses the format
    """

    def write(page: Any, path: Path) -> None:
        make_folder(path.parent)
        draw(page, path)

    def one(key: str) -> ExportFormat:
        words = title.format(suffix=key.upper())
        return ExportFormat(key, words, lambda page: f"{stem(page)}.{key}", write, at_once=True)

    return tuple(one(key) for key in _PICTURES)


class Exporting(QObject):
    """Writes what is on a page.

    Parameters
    ----------
    source : of the messages
    formats : the first is proposed
    current : returns what is on the page, None for nothing
    folder : returns the folder where files go that are named without one
    jobs : writes the files; MATLAB's format is slow to load
    messages : where it is told
    """

    def __init__(
        self,
        source: str,
        formats: Sequence[ExportFormat],
        current: Callable[[], Any],
        folder: Callable[[], Path],
        jobs: Jobs,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._source = source
        self._formats = {one.key: one for one in formats}
        self._current = current
        self._folder = folder
        self._jobs = jobs
        self._messages = messages
        self._foot: ExportFoot | None = None

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        return tuple((key, one.title) for key, one in self._formats.items())

    def serve(self, foot: ExportFoot) -> None:
        """Offer the formats under results, and write what is asked for there."""
        self._foot = foot
        foot.set_formats(self.formats)
        foot.format_chosen.connect(self._on_format)
        foot.export_requested.connect(self.export)

    def propose(self, key: str) -> str:
        """File name for a format, with its folder; empty while there are no results."""
        page = self._current()
        return "" if page is None else str(self._folder() / self._formats[key].name(page))

    def renew(self) -> None:
        """Other results are on the page: propose a name for them."""
        if self._foot is not None:
            self._on_format(self._foot.chosen_format)

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the session's."""
        page = self._current()
        if page is None or not name.strip():
            return
        path = self._folder() / Path(name.strip()).expanduser()
        wanted = self._formats[key]

        def work() -> Path:
            wanted.write(page, path)
            return path

        if not wanted.at_once:
            self._jobs.start("export", work, self._on_done, self._on_failed)
            return
        try:
            self._on_done(work())
        except LabError as error:
            self._on_failed(error)

    def forget(self) -> None:
        """What was exported is no longer on the screen: take the word of it away."""
        self._messages.clear(self._source)

    def _on_format(self, key: str) -> None:
        if self._foot is not None:
            self._foot.show_name(self.propose(key))

    def _on_done(self, path: object) -> None:
        self._messages.show(self._source, BannerState(Severity.INFO, "Exported", str(path)))

    def _on_failed(self, error: LabError) -> None:
        self._messages.tell_error(self._source, "Not exported", error)
