"""The Archive tab: clicks in, `ArchiveState` out."""

import math
from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.archive.entry import BAD, DAMAGED, DOUBT, Entry
from core.archive.history import TOLERANCE_K, History, temperatures_of
from core.errors import LabError, Note, Severity
from gui.archive.actions import items_of
from gui.archive.failures import failure_of, no_tab_remedy, remedy_of
from gui.archive.findings import name_of, of_details, of_import, of_redecoded, picture_of
from gui.archive.library import Library
from gui.archive.opening import CERTIFICATES
from gui.archive.questions import (
    Details,
    Listed,
    Parameter,
    Redecoded,
    details,
    followed,
    listed,
    redecoded,
)
from gui.archive.state import ArchiveState, HistoryState, ListRow
from gui.archive.texts import listed as cells_of
from gui.messages import Messages
from gui.widgets.number_text import fixed, grouped
from gui.widgets.states import (
    ActionBarState,
    BannerState,
    FindingsState,
    Tone,
)

SOURCE = "archive"
_TONES = {DOUBT: Tone.DOUBT, BAD: Tone.BAD, DAMAGED: Tone.BAD}


class ArchivePresenter(QObject):
    """Everything the view asks for.

    Parameters
    ----------
    library : the archive
    messages : where failures are told
    open_file : hands a file to the tab of a title; returns whether there is one
    """

    changed = Signal(object)
    """A new `ArchiveState`."""

    def __init__(
        self,
        library: Library,
        messages: Messages,
        open_file: Callable[[str, Path], bool],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._library = library
        self._messages = messages
        self._open_file = open_file
        self._text = self._kind = ""
        self._listed: Listed | None = None
        self._chosen: tuple[int, ...] = ()
        self._details: Details | None = None
        self._parameter: Parameter | None = None
        self._temperature_c = math.nan
        self._history: History | None = None
        self._picture: HistoryState | None = None
        self._report: FindingsState | None = None
        self._progress = (0, 0)
        self._told: set[str] = set()
        self._failing = ""
        self._answers = {
            "list": self._on_listed,
            "refresh": self._on_refreshed,
            "rebuild": self._on_refreshed,
            "details": self._on_details,
            "history": self._on_history,
            "import": self._on_imported,
            "reprocess": self._on_redecoded,
        }
        library.answered.connect(self._on_answer)
        library.failed.connect(self._on_failed)
        library.progress.connect(self._on_progress)
        library.changed.connect(self._on_work)

    # --- what the operator does -------------------------------------------------------------------

    def shown(self) -> None:
        """The tab comes to the front: show what is known, then look for what is new."""
        self._search()
        self._library.ask("refresh", lambda archive: archive.refresh(self._library.tell))

    def look_for(self, text: str, kind: str) -> None:
        """Search for words, of a kind or of all."""
        if (text, kind) != (self._text, self._kind):
            self._text, self._kind = text, kind
            self._search()

    def choose(self, numbers: Sequence[int]) -> None:
        """Take these entries; two are compared."""
        numbers = tuple(numbers[:2])
        if numbers == self._chosen and self._report is None:
            return
        self._chosen, self._report = numbers, None
        if numbers:
            self._library.ask("details", lambda archive: details(archive, numbers))
        else:
            self._details = self._history = self._picture = None
        self._tell()

    def follow(self, place: int) -> None:
        """Follow another parameter of the chosen device."""
        if self._details is not None and 0 <= place < len(self._details.parameters):
            self._parameter = self._details.parameters[place]
            self._ask_history()

    def at(self, place: int) -> None:
        """Count calibrations at one of the temperatures alone; 0 for all."""
        offered = () if self._history is None else temperatures_of(self._history.readings)
        self._temperature_c = offered[place - 1] if 0 < place <= len(offered) else math.nan
        self._ask_history()

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        if key == "open":
            self._open()
        elif key == "certificate" and self._details is not None and self._details.path is not None:
            self._open_file(CERTIFICATES, self._details.path)
        elif key == "refresh":
            self.shown()
        elif key == "rebuild":
            self._library.ask("rebuild", lambda archive: archive.rebuild(self._library.tell))
        elif key == "reprocess" and self._chosen:
            number = self._chosen[0]
            self._library.ask("reprocess", lambda archive: redecoded(archive, number))

    def import_folder(self, name: str) -> None:
        """Copy the known files of a folder into the archive."""
        from core.archive.importing import import_folder

        folder = Path(name)
        self._library.ask(
            "import", lambda archive: import_folder(archive, folder, self._library.tell)
        )

    def _open(self) -> None:
        found = self._details
        if found is not None and found.opening is not None and self._chosen:
            title, path = found.opening
            if not self._open_file(title, path):
                what = QCoreApplication.translate(
                    "Archive", "There is no tab {title} to open it in"
                )
                banner = BannerState(
                    Severity.WARNING, what.format(title=title), f"{path}.", no_tab_remedy()
                )
                self._messages.show(SOURCE, banner)

    # --- what the archive answers -----------------------------------------------------------------

    def _search(self) -> None:
        text, kind = self._text, self._kind
        self._library.ask("list", lambda archive: listed(archive, text, kind))

    def _ask_history(self) -> None:
        parameter, temperature_c = self._parameter, self._temperature_c
        if parameter is not None:
            self._library.ask(
                "history", lambda archive: followed(archive, parameter, temperature_c)
            )

    def _on_answer(self, key: str, result: object) -> None:
        if key == self._failing:
            self._failing = ""
            self._messages.clear(SOURCE)
        self._answers[key](result)
        self._tell()

    def _on_listed(self, result: object) -> None:
        if not isinstance(result, Listed):
            raise TypeError("no list")
        self._listed = result
        for note in result.notes:
            self._tell_note(note)
        there = {entry.id for entry in result.hits.entries}
        if self._chosen and not there.issuperset(self._chosen):
            self.choose(())

    def _tell_note(self, note: Note) -> None:
        if note.text not in self._told:
            self._told.add(note.text)
            what = QCoreApplication.translate("Archive", "The archive")
            banner = BannerState(note.severity, what, f"{note.text}.", remedy_of(note))
            self._messages.show(SOURCE, banner)

    def _on_refreshed(self, result: object) -> None:  # noqa: ARG002
        self._progress = (0, 0)
        self._search()
        if self._chosen:
            numbers = self._chosen
            self._library.ask("details", lambda archive: details(archive, numbers))

    def _on_details(self, result: object) -> None:
        if not isinstance(result, Details):
            raise TypeError("no details")
        if tuple(entry.id for entry in result.entries) != self._chosen:
            return
        self._details = result
        self._parameter = _same(self._parameter, result.parameters)
        self._history = self._picture = None
        self._ask_history()

    def _on_history(self, result: object) -> None:
        if self._parameter is None or not isinstance(result, History):
            return
        if not math.isnan(self._temperature_c) and not any(result.counted):
            # Another device or parameter has nothing at the temperature that was chosen.
            self._temperature_c = math.nan
            self._ask_history()
            return
        self._history = result
        self._picture = picture_of(result, self._parameter, self._chosen)

    def _on_imported(self, result: object) -> None:
        if not isinstance(result, tuple):
            raise TypeError("no report")
        self._progress = (0, 0)
        self.choose(())
        self._report = of_import(result)
        self._search()

    def _on_redecoded(self, result: object) -> None:
        if not isinstance(result, Redecoded):
            raise TypeError("no session")
        self._report = of_redecoded(result)

    def _on_failed(self, key: str, error: LabError) -> None:
        self._progress = (0, 0)
        if key == "details" and self._listed is not None:
            # What was listed has gone meanwhile.
            self._search()
        self._failing = key
        what, remedy = failure_of(key)
        self._messages.tell_error(SOURCE, what, error, remedy=remedy)
        self._tell()

    def _on_progress(self, done: int, of: int) -> None:
        self._progress = (done, of)
        self._tell()

    def _on_work(self) -> None:
        self._tell()

    # --- what is shown ----------------------------------------------------------------------------

    @property
    def state(self) -> ArchiveState:
        """The tab as it is now."""
        found, parameters = self._listed, ()
        if self._details is not None and self._chosen:
            parameters = self._details.parameters
        place = parameters.index(self._parameter) if self._parameter in parameters else -1
        temperatures, at = self._temperatures()
        return ArchiveState(
            text=self._text,
            kind=self._kind,
            rows=() if found is None else tuple(map(_row, found.hits.entries)),
            status=self._status(),
            chosen=self._chosen,
            parameters=tuple(map(name_of, parameters)),
            parameter=place,
            temperatures=temperatures,
            temperature=at,
            history=self._picture if self._chosen else None,
            findings=self._findings(place, parameters),
            actions=ActionBarState(
                items_of(self._details, self._chosen, self._library.running, empty=self._empty)
            ),
            hint=self._hint(),
        )

    def _temperatures(self) -> tuple[tuple[str, ...], int]:
        """At which temperatures the parameter can be followed, and which is chosen."""
        found = () if self._history is None else temperatures_of(self._history.readings)
        every = QCoreApplication.translate("Archive", "all temperatures")
        words = tuple(f"{fixed(one, 0)} ± {fixed(TOLERANCE_K, 0)} °C" for one in found)
        near = [place for place, one in enumerate(found, 1) if one == self._temperature_c]
        return (every, *words), near[0] if near else 0

    def _findings(self, place: int, parameters: tuple[Parameter, ...]) -> FindingsState | None:
        if self._report is not None:
            return self._report
        if self._details is None or not self._chosen:
            return None
        name = name_of(parameters[place]) if place >= 0 else ""
        return of_details(self._details, self._history if place >= 0 else None, name)

    def _status(self) -> str:
        done, of = self._progress
        if of and self._library.running in ("refresh", "rebuild", "import"):
            text = QCoreApplication.translate("Archive", "{done} of {all} taken in …")
            return text.format(done=grouped(done), all=grouped(of))
        if self._listed is None:
            return QCoreApplication.translate("Archive", "The archive is being opened …")
        hits = self._listed.hits
        if len(hits.entries) < hits.total:
            text = QCoreApplication.translate("Archive", "the latest {shown} of {all}")
            return text.format(shown=grouped(len(hits.entries)), all=grouped(hits.total))
        return QCoreApplication.translate("Archive", "{all} found").format(all=grouped(hits.total))

    @property
    def _empty(self) -> bool:
        """Whether nothing at all is in the archive."""
        return self._listed is not None and not self._listed.anything

    def _hint(self) -> str:
        if self._empty:
            return QCoreApplication.translate(
                "Archive",
                "Nothing is in the archive yet.\n\nEvery session and calibration of the folder of"
                " sessions comes here by itself. Import Folder (Ctrl+I) copies old files into it:"
                " those of ClbAcc, Pointer, ClbDUS and CVGCom, run files, whole sessions.",
            )
        if not self._chosen:
            return QCoreApplication.translate(
                "Archive",
                "Choose an entry to see its parameters and their history; hold Ctrl and choose a"
                " second one to compare them.",
            )
        if self._details is None or self._library.running in ("details", "history"):
            return ""
        return QCoreApplication.translate(
            "Archive", "There is no calibration of this device whose parameters could be followed."
        )

    def _tell(self) -> None:
        self.changed.emit(self.state)


def _row(entry: Entry) -> ListRow:
    return ListRow(entry.id, cells_of(entry), _TONES.get(entry.verdict, Tone.IDLE))


def _same(old: Parameter | None, offered: tuple[Parameter, ...]) -> Parameter | None:
    """The parameter that was followed, of the device that is chosen now; else the first."""
    if old is not None:
        for one in offered:
            if (one.channel, one.name) == (old.channel, old.name):
                return one
    return offered[0] if offered else None
