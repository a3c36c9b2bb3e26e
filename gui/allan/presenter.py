"""The Allan tab: clicks in, `AllanState` out."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import Severity
from core.records.noise_study import StudyRequest
from gui.allan.findings import of_error, of_live, of_study
from gui.allan.library import Entry, Library
from gui.allan.live import LiveRecord
from gui.allan.picture import LIVE_COLOUR, picture_of
from gui.allan.state import AllanState, ChoiceState, RecordRow
from gui.allan.texts import duration, plain_unit, titled
from gui.analysis.records import beside
from gui.devices.connection import Connection
from gui.messages import Messages
from gui.widgets.number_text import grouped
from gui.widgets.states import ActionBarState, ActionItem, BannerState, FindingsState

SOURCE = "allan"
LIVE_KEY = -1


class AllanPresenter(QObject):
    """Everything the view asks for.

    Parameters
    ----------
    library : the records
    live : the curve of the running device
    connection : whether there is a device
    messages : where a refused record is told
    """

    changed = Signal(object)
    """A new `AllanState`."""

    def __init__(
        self,
        library: Library,
        live: LiveRecord,
        connection: Connection,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._library = library
        self._live = live
        self._connection = connection
        self._messages = messages
        self._current = 0
        self._band = True
        self._terms = True
        self._actions = {
            "live": self.start_live,
            "stop": live.stop,
            "analyse": self.analyse_live,
            "remove": self.remove,
        }
        library.changed.connect(self._tell)
        library.failed.connect(self._on_failed)
        live.changed.connect(self._tell)
        connection.changed.connect(self._tell)

    @property
    def state(self) -> AllanState:
        """The tab as it is now."""
        live_key = LIVE_KEY if self._live.exists else 0
        picture = picture_of(self._library.entries, self._live, self._current, LIVE_KEY)
        return AllanState(
            rows=tuple(self._rows()),
            current=self._current if self._current != LIVE_KEY or live_key else 0,
            choices=self._choices(),
            picture=picture,
            findings=self._findings(),
            actions=ActionBarState(self._items()),
            hint=self._hint(),
            band=self._band,
            terms=self._terms,
        )

    # --- what the operator does -------------------------------------------------------------------

    def add(self, names: Sequence[str]) -> None:
        """Read and analyse files."""
        key = self._library.add([Path(name) for name in names])
        if key:
            self.choose(key)

    def choose(self, key: int) -> None:
        """Make a record the chosen one."""
        if key != self._current:
            self._current = key
            self._tell()

    def show(self, key: int, shown: bool) -> None:
        """Draw the curve of a record, or not."""
        self._library.show(key, shown)

    def decide(self, request: StudyRequest) -> None:
        """Take what was decided about the chosen record."""
        if self._current == LIVE_KEY:
            self._live.decide(request)
        else:
            self._library.decide(self._current, request)

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        self._actions[key]()

    def start_live(self) -> None:
        """Begin the curve of the running device."""
        self._current = LIVE_KEY
        self._live.start()

    def analyse_live(self) -> None:
        """Analyse all that the device has sent since its port was opened, as a record."""
        path = self._live.raw_path
        if path is not None:
            request = replace(self._live.request, rate=0.0)
            self.choose(self._library.add([path], request))

    def remove(self) -> None:
        """Take the chosen record out of the list; its file stays."""
        if self._current == LIVE_KEY:
            self._current = 0
            self._live.clear()
            return
        keys = [entry.key for entry in self._library.entries]
        if self._current in keys:
            gone, self._current = self._current, beside(keys, self._current)
            self._messages.clear(SOURCE)
            self._library.remove(gone)

    def draw_band(self, on: bool) -> None:
        """Draw the confidence bands, or not."""
        self._band = on
        self._tell()

    def draw_terms(self, on: bool) -> None:
        """Draw the fitted terms, or not."""
        self._terms = on
        self._tell()

    # --- what is shown ----------------------------------------------------------------------------

    def _rows(self) -> list[RecordRow]:
        rows = [self._row(entry) for entry in self._library.entries]
        live = self._live
        if live.exists:
            detail = live.why or f"{grouped(live.count)} samples"
            if live.running and not live.why:
                detail = f"growing: {detail}"
            title = f"{live.device} {live.channel.name}, live"
            rows.insert(0, RecordRow(LIVE_KEY, title, detail, LIVE_COLOUR, True))
        return rows

    def _row(self, entry: Entry) -> RecordRow:
        study = entry.study
        title = entry.path.name if study is None else titled(study)
        if self._library.busy(entry.key):
            detail = "is being analysed …"
        elif study is None:
            detail = "cannot be used"
        else:
            curve = study.coefficients.curve
            unit = plain_unit(study.unit)
            detail = f"{duration(curve.duration)} at {study.rate:.6g} Hz, {unit}"
        return RecordRow(entry.key, title, detail, entry.colour, entry.shown, entry.error)

    def _choices(self) -> ChoiceState | None:
        live = self._live
        if self._current == LIVE_KEY and live.exists:
            names = tuple(channel.name for channel in live.channels)
            name, rate, unit = live.channel.name, live.rate, live.unit
            return ChoiceState(live.request, names, name, rate, unit, live.factor, True)
        entry = self._library.get(self._current)
        if entry is None or entry.series is None:
            return None
        series, study = entry.series, entry.study
        names = tuple(channel.name for channel in series.channels)
        main = series.channels[series.main].name
        return ChoiceState(
            request=entry.request,
            channels=names,
            channel=entry.request.channel or main,
            rate=series.rate if study is None else study.rate,
            unit="" if study is None else study.unit,
            factor=1.0 if study is None else study.scale_factor,
            live=False,
        )

    def _findings(self) -> FindingsState | None:
        if self._current == LIVE_KEY:
            return of_live(self._live)
        entry = self._library.get(self._current)
        if entry is None:
            return None
        if entry.error:
            return of_error(entry.path.name, entry.error)
        return None if entry.study is None else of_study(entry.study, self._library.studies)

    def _items(self) -> tuple[ActionItem, ...]:
        live = self._live
        device = self._connection.link is not None
        no_device = "No device is connected: open Properties at the top."
        first = (
            ActionItem("stop", "Stop live curve", "Esc")
            if live.running
            else ActionItem("live", "Live curve", "Space", device, device, no_device)
        )
        raw = live.raw_path is not None
        return (
            first,
            ActionItem("add", "Add Records", "Ctrl+O", not device and not live.running),
            ActionItem(
                "analyse", "Analyse Recording", "F5", False, raw, "No live curve was begun."
            ),
            ActionItem("remove", "Remove", "Delete", False, self._current != 0, "None is chosen."),
            ActionItem(
                "export",
                "Export",
                "Ctrl+E",
                enabled=bool(self._library.studies) or live.found is not None,
                why_not="There is nothing to export yet.",
            ),
        )

    def _hint(self) -> str:
        entry = self._library.get(self._current)
        if entry is not None and entry.error:
            return entry.error
        if self._live.running:
            return f"The live curve begins in some seconds: {self._live.why}."
        if any(self._library.busy(one.key) for one in self._library.entries):
            return "The record is being read and analysed …"
        return (
            "Add Records (Ctrl+O) reads records of a sensor at rest: recordings, files of CVGCom,"
            " run files, columns of numbers. An hour at 100 Hz is a good beginning.\n\n"
            "Live curve (Space) draws the curve of the connected device while it runs."
        )

    def _on_failed(self, key: int) -> None:
        entry = self._library.get(key)
        if entry is not None:
            self._messages.show(
                SOURCE,
                BannerState(
                    Severity.ERROR,
                    f"{entry.path.name} cannot be analysed",
                    entry.error,
                    "Set its channel and rate at the left, or remove it from the list.",
                ),
            )

    def _tell(self) -> None:
        self.changed.emit(self.state)
