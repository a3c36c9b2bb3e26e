"""The Thermal tab: clicks in, `ThermalState` out."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from core.errors import LabError, Severity
from gui.analysis.presenter import RecordsPresenter
from gui.jobs import Jobs
from gui.messages import Messages
from gui.thermal.findings import of_error, of_outcome
from gui.thermal.library import Entry, Library
from gui.thermal.pictures import plots_of
from gui.thermal.state import PlotState, Settings, ThermalState
from gui.thermal.texts import degrees, quantity_words
from gui.thermal.working import RecordOutcome, newest_cycle
from gui.widgets.number_text import grouped
from gui.widgets.states import ActionItem, BannerState

SOURCE = "thermal"


class ThermalPresenter(RecordsPresenter[Entry, Settings]):
    """Everything the view asks for.

    Parameters
    ----------
    library : the sources and what was found
    root : returns the folder of all sessions
    jobs : looks for the last cycle
    messages : where refused sources are told
    """

    _library: Library

    def __init__(
        self,
        library: Library,
        root: Callable[[], Path],
        jobs: Jobs,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        actions = {"last": self.add_last, "check": self.switch_check}
        super().__init__(library, SOURCE, messages, actions, parent)
        self._root = root
        self._jobs = jobs
        self._messages = messages
        self._quantity = 0
        self._plots: tuple[PlotState, ...] = ()

    @property
    def state(self) -> ThermalState:
        """The tab as it is now."""
        outcome = self._library.result
        record = isinstance(outcome, RecordOutcome)
        output = QCoreApplication.translate("Thermal", "Outputs")
        return ThermalState(
            page=self._page(),
            settings=self._library.settings,
            quantities=(output,) if record else quantity_words(),
            quantity=0 if record else self._quantity,
            plots=self._plots,
        )

    # --- what the operator does -------------------------------------------------------------------

    def add_last(self) -> None:
        """Take the newest session of the dividing head that went through temperatures."""
        root = self._root()
        self._jobs.start(
            "last cycle", lambda: newest_cycle(root), self._on_newest, self._on_no_newest
        )

    def switch_check(self) -> None:
        """Let the chosen source only check the compensation, or let it take part again."""
        entry = self._library.get(self._current)
        if entry is not None:
            self._library.check(entry.key, not entry.check)

    def show(self, quantity: int) -> None:
        """Plot another quantity."""
        if quantity != self._quantity:
            self._quantity = quantity
            self._look()
            self._tell()

    # --- what is shown ----------------------------------------------------------------------------

    def _on_newest(self, path: object) -> None:
        if isinstance(path, Path):
            self.add([str(path)])
            return
        what = QCoreApplication.translate("Thermal", "There is no cycle yet")
        meaning = QCoreApplication.translate(
            "Thermal",
            "In {root} no session of the dividing head went through temperatures.",
        ).format(root=self._root())
        remedy = QCoreApplication.translate(
            "Thermal", "Measure one there (Temperatures), or add its files here."
        )
        self._messages.show(SOURCE, BannerState(Severity.INFO, what, meaning, remedy))

    def _on_no_newest(self, error: LabError) -> None:
        what = QCoreApplication.translate("Thermal", "The last cycle was not found")
        self._messages.tell_error(SOURCE, what, error)

    def _look(self) -> None:
        outcome, error = self._library.result, self._library.error
        if outcome is None:
            self._findings, self._plots = of_error(error) if error else None, ()
        else:
            self._findings = of_outcome(outcome)
            self._plots = plots_of(outcome, self._quantity)

    def _refused(self) -> tuple[str, str]:
        return (
            QCoreApplication.translate("Thermal", "{name} cannot be used"),
            QCoreApplication.translate(
                "Thermal", "Remove it from the list; the others are used without it."
            ),
        )

    def _title(self, entry: Entry) -> str:
        if entry.path is None:
            return QCoreApplication.translate("Thermal", "Simulated cycle")
        return entry.path.name

    def _detail(self, entry: Entry) -> str:
        run = entry.run
        if run is None:
            return QCoreApplication.translate("Thermal", "is being read …")
        rows = QCoreApplication.translate("Thermal", "{rows} rows").format(rows=grouped(len(run)))
        low, high = degrees(float(run.temperature_c.min())), degrees(float(run.temperature_c.max()))
        warmth = low if low == high else f"{low.removesuffix(' °C')} … {high}"
        named = entry.path is None or run.device in entry.path.name
        parts = [rows, warmth] if named else [run.device, rows, warmth]
        if entry.check:
            parts.append(QCoreApplication.translate("Thermal", "check only"))
        return ", ".join(parts)

    def _items(self) -> tuple[ActionItem, ...]:
        library = self._library
        empty = not library.entries
        chosen = library.get(self._current)
        none = QCoreApplication.translate("Thermal", "None is chosen.")
        only = chosen is not None and not chosen.check
        return (
            ActionItem("last", QCoreApplication.translate("Thermal", "Last Cycle"), "Space", empty),
            ActionItem("add", QCoreApplication.translate("Thermal", "Add Files"), "Ctrl+O"),
            ActionItem(
                "folder", QCoreApplication.translate("Thermal", "Add Folder"), "Ctrl+Shift+O"
            ),
            ActionItem("simulate", QCoreApplication.translate("Thermal", "Simulated cycle"), "F6"),
            ActionItem(
                "check",
                QCoreApplication.translate("Thermal", "Check only")
                if only or chosen is None
                else QCoreApplication.translate("Thermal", "Let take part"),
                enabled=chosen is not None,
                why_not=none,
            ),
            ActionItem(
                "remove",
                QCoreApplication.translate("Thermal", "Remove"),
                "Delete",
                enabled=chosen is not None,
                why_not=none,
            ),
            ActionItem(
                "export",
                QCoreApplication.translate("Thermal", "Export"),
                "Ctrl+E",
                enabled=library.result is not None,
                why_not=QCoreApplication.translate("Thermal", "There is nothing to export yet."),
            ),
        )

    def _hint(self) -> str:
        library = self._library
        if self._plots:
            return ""
        if library.busy:
            return QCoreApplication.translate("Thermal", "The files are being read …")
        if library.error:
            return library.error
        if library.result is not None:
            return QCoreApplication.translate(
                "Thermal", "There is nothing to draw over the temperature; see the notes."
            )
        return QCoreApplication.translate(
            "Thermal",
            "Last Cycle (Space) takes the newest session that the dividing head measured through"
            " its Temperatures (+27 −10 −40 −10 +27 +50 +70 +50 +27 °C).\n\n"
            "Add Files or Add Folder takes sessions, run files and ClbAcc's text files as one set,"
            " or the record of a unit that stood in the chamber.\n\n"
            "Simulated cycle (F6) shows the tab on a made-up unit.",
        )
