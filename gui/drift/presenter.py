"""The Drift tab: clicks in, `DriftState` out."""

import math

from PySide6.QtCore import QCoreApplication, QObject, Signal

from gui.analysis.presenter import RecordsPresenter
from gui.drift.findings import of_error, of_result
from gui.drift.knots import Knots
from gui.drift.library import Entry, Library
from gui.drift.picture import knot_words, knots_of, picture_of
from gui.drift.state import ALL, ChoiceState, DriftState, KnotsState, PictureState, Settings
from gui.drift.texts import degrees
from gui.messages import Messages
from gui.widgets.states import ActionItem

SOURCE = "drift"


class DriftPresenter(RecordsPresenter[Entry, Settings]):
    """Everything the view asks for.

    Parameters
    ----------
    library : the turn-ons and the table
    messages : where refused records are told
    """

    _library: Library
    dragged = Signal(object)
    """A new `KnotsState`, while a knot is dragged; all else stays."""

    def __init__(self, library: Library, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(library, SOURCE, messages, {"reset": self.reset}, parent)
        self._shown = ALL
        self._snap = True
        self._knots: Knots | None = None
        self._picture: PictureState | None = None

    @property
    def state(self) -> DriftState:
        """The tab as it is now."""
        knots = self._knots
        return DriftState(
            page=self._page(),
            choices=self._choices(),
            temperatures=self._temperatures(),
            shown=self._shown,
            picture=self._picture,
            knots=None if knots is None else knots_of(knots, self._shown),
            snap=self._snap,
        )

    @property
    def knots(self) -> Knots | None:
        """The table on the screen; None without one."""
        return self._knots

    # --- what the operator does -------------------------------------------------------------------

    def state_ambient(self, ambient_c: float) -> None:
        """Say how warm the chamber was during the chosen record."""
        self._library.state_ambient(self._current, ambient_c)

    def show(self, place: int) -> None:
        """Show one temperature, or all."""
        if place != self._shown:
            self._shown = place
            self._look()
            self._tell()

    def set_snap(self, on: bool) -> None:
        """Let dragged knots stop at the blocks, or not."""
        self._snap = on
        self._tell()

    # --- knots ------------------------------------------------------------------------------------

    def drag(self, place: int, time_s: float) -> None:
        """Move an inner knot; only the table over the plot follows."""
        knots = self._knots
        if knots is None or not 0 < place < len(knots.table.times_s) - 1:
            return
        table = knots.drag(place, time_s, snap=self._snap)
        now = knots_of(knots, self._shown)
        words = f"{knot_words(float(table.times_s[place]))}:  {now.reading}"
        self.dragged.emit(KnotsState(now.times_s, now.values, words))

    def drop(self) -> None:
        """The knot is let go of."""
        if self._knots is not None:
            self._knots.drop()
            self._look()
            self._tell()

    def nudge(self, place: int, steps: int) -> None:
        """Move an inner knot by blocks, from the keyboard."""
        knots = self._knots
        if knots is not None and 0 < place < len(knots.table.times_s) - 1:
            t = knots.optimal.curves.t
            self.drag(place, float(knots.table.times_s[place] + steps * (t[1] - t[0])))
            self.drop()

    def reset(self) -> None:
        """Put the best knots back."""
        if self._knots is not None:
            self._knots.reset()
            self._look()
            self._tell()

    # --- what is shown ----------------------------------------------------------------------------

    def _on_library(self) -> None:
        library = self._library
        result = library.result
        if result is None:
            self._knots = None
        elif self._knots is None or self._knots.optimal is not result:
            self._knots = Knots(result)
        if result is not None and self._shown >= len(result.curves.temperatures_c):
            self._shown = ALL
        super()._on_library()

    def _look(self) -> None:
        if self._knots is None:
            error = self._library.error
            self._picture, self._findings = None, of_error(error) if error else None
            return
        self._picture = picture_of(self._knots.result, self._shown)
        memory = self._library.settings.memory
        self._findings = of_result(self._knots.result, self._shown, memory)

    def _refused(self) -> tuple[str, str]:
        return (
            QCoreApplication.translate("Drift", "{name} is no turn-on"),
            QCoreApplication.translate(
                "Drift", "Remove it from the list, or choose another output at the left."
            ),
        )

    def _title(self, entry: Entry) -> str:
        if entry.path is None:
            return QCoreApplication.translate("Drift", "Simulated gyro")
        return entry.path.name

    def _detail(self, entry: Entry) -> str:
        if not entry.turn_ons:
            return QCoreApplication.translate("Drift", "is being read …")
        starts = [
            one.ambient_c if math.isfinite(one.ambient_c) else float(one.temperature_c[0])
            for one in entry.turn_ons
        ]
        low, high = degrees(min(starts), 0), degrees(max(starts), 0)
        count = (
            QCoreApplication.translate("Drift", "1 turn-on")
            if len(starts) == 1
            else QCoreApplication.translate("Drift", "{n} turn-ons").format(n=len(starts))
        )
        warmth = low if low == high else f"{low.removesuffix(' °C')} … {high}"
        seconds = QCoreApplication.translate("Drift", "{seconds} s").format(
            seconds=f"{entry.turn_ons[0].end_s:.4g}"
        )
        return f"{count}, {warmth}, {seconds}"

    def _choices(self) -> ChoiceState:
        entry = self._library.get(self._current)
        has_file = entry is not None and entry.path is not None
        ambient = entry.ambient_c if entry is not None else math.nan
        return ChoiceState(self._library.settings, ambient, has_file)

    def _temperatures(self) -> tuple[str, ...]:
        everything = QCoreApplication.translate("Drift", "All temperatures")
        if self._knots is None:
            return (everything,)
        curves = self._knots.result.curves
        return (everything, *(degrees(float(one)) for one in curves.temperatures_c))

    def _items(self) -> tuple[ActionItem, ...]:
        table = self._knots is not None
        empty = not self._library.entries
        nothing = QCoreApplication.translate("Drift", "There is no table yet.")
        same = QCoreApplication.translate("Drift", "The knots stand where the search put them.")
        changed = self._knots is not None and self._knots.changed
        return (
            ActionItem("add", QCoreApplication.translate("Drift", "Add Turn-ons"), "Ctrl+O", empty),
            ActionItem("folder", QCoreApplication.translate("Drift", "Add Folder"), "Ctrl+Shift+O"),
            ActionItem("simulate", QCoreApplication.translate("Drift", "Simulated turn-ons"), "F6"),
            ActionItem(
                "reset",
                QCoreApplication.translate("Drift", "Optimal knots"),
                "F5",
                enabled=changed,
                why_not=same if table else nothing,
            ),
            ActionItem(
                "remove",
                QCoreApplication.translate("Drift", "Remove"),
                "Delete",
                enabled=self._current != 0,
                why_not=QCoreApplication.translate("Drift", "None is chosen."),
            ),
            ActionItem(
                "export",
                QCoreApplication.translate("Drift", "Export"),
                "Ctrl+E",
                enabled=table,
                why_not=nothing,
            ),
        )

    def _hint(self) -> str:
        library = self._library
        if self._picture is not None:
            return ""
        if library.busy:
            return QCoreApplication.translate("Drift", "The turn-ons are being read …")
        if library.error:
            return library.error
        return QCoreApplication.translate(
            "Drift",
            "Add Turn-ons (Ctrl+O) reads records that began with switching on: recordings, files of"
            " CVGCom, run files, columns of numbers. About five at each temperature, at least"
            " 5 minutes apart so that the unit cools down.\n\n"
            "Simulated turn-ons (F6) shows the tab on a made-up gyro.",
        )
