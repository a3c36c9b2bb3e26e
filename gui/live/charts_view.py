"""The page Charts: stacked charts and their tools."""

from PySide6.QtCore import QEvent, QSize, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLineEdit, QPushButton, QVBoxLayout, QWidget

from gui.live.settings import LiveSettings
from gui.live.state import LiveState
from gui.live.trace import Trace
from gui.widgets.fields import NumberField
from gui.widgets.strip_charts import StripCharts
from gui.widgets.strip_view import Follow

_BUTTONS = ("all", "track", "cross", "pause", "edit", "overlay", "no_overlay")
_EDITS = ("select_all", "deselect_all", "select", "show", "remove", "means")
_SWITCHES = ("all", "track", "cross", "pause", "edit", "select", "show")


class _Button(QPushButton):
    """A button; one that stays pressed says so by a sign too."""

    def __init__(self, key: str) -> None:
        super().__init__()
        self.setProperty("key", key)
        self.setCheckable(key in _SWITCHES)
        self._words = ""
        self.toggled.connect(self._show)

    def set_words(self, words: str) -> None:
        self._words = words
        self._show()

    def _show(self) -> None:
        self.setText(f"✓ {self._words}" if self.isChecked() else self._words)

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()


class ChartsView(QWidget):
    """Charts with CVGCom's buttons."""

    tail_set = Signal(float)
    marked = Signal(str)
    edit = Signal(str)
    """``"select_all"``, ``"deselect_all"``, ``"remove"``, ``"means"``, ``"overlay"``, ..."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.charts = StripCharts()
        self.buttons = {key: _Button(key) for key in (*_BUTTONS, *_EDITS, "mark")}
        self.tail = NumberField(0.1, 1e5, 1, "s")
        self.note = QLineEdit()
        self._note_label = QLabel()
        self._edit_row = QWidget()
        self._settings = LiveSettings()
        self._trace: Trace | None = None
        self._shown: list[int] = []
        self._wants_all = True
        self.buttons["cross"].setChecked(True)
        self.buttons["show"].setChecked(True)
        self._build()
        self._connect()
        self._retranslate()
        self._on_follow()

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        first, second = QHBoxLayout(), QHBoxLayout(self._edit_row)
        for row in (first, second):
            row.setSpacing(unit // 3)
            row.setContentsMargins(0, 0, 0, 0)
        for key in ("all", "track"):
            first.addWidget(self.buttons[key])
        first.addWidget(self.tail)
        self.tail.setMaximumWidth(7 * unit)
        for key in ("cross", "pause", "edit"):
            first.addWidget(self.buttons[key])
        first.addStretch(1)
        for key in _EDITS:
            second.addWidget(self.buttons[key])
        second.addStretch(1)
        third = QHBoxLayout()
        third.setSpacing(unit // 3)
        third.addWidget(self._note_label)
        third.addWidget(self.note, 1)
        for key in ("mark", "overlay", "no_overlay"):
            third.addWidget(self.buttons[key])
        column = QVBoxLayout(self)
        column.setContentsMargins(0, unit // 3, 0, 0)
        column.setSpacing(unit // 3)
        column.addLayout(first)
        column.addWidget(self._edit_row)
        column.addWidget(self.charts, 1)
        column.addLayout(third)
        self._edit_row.hide()

    def _connect(self) -> None:
        for key in ("overlay", "no_overlay", "select_all", "deselect_all", "remove", "means"):
            self.buttons[key].clicked.connect(self._on_edit)
        self.buttons["all"].clicked.connect(self._on_all)
        self.buttons["track"].clicked.connect(self._on_track)
        self.buttons["cross"].toggled.connect(self.charts.set_crosshair)
        self.buttons["pause"].toggled.connect(self.charts.set_paused)
        self.buttons["edit"].toggled.connect(self._on_edit_mode)
        self.buttons["select"].toggled.connect(self.charts.set_selecting)
        self.buttons["show"].toggled.connect(self._show_intervals)
        self.buttons["mark"].clicked.connect(self._on_mark)
        self.note.returnPressed.connect(self._on_mark)
        self.tail.valueChanged.connect(self._on_tail)
        self.charts.follow_changed.connect(self._on_follow)

    # --- what is shown ----------------------------------------------------------------------------

    def take(self, trace: Trace | None, shown: list[int]) -> None:
        """Show another trace."""
        self._trace, self._shown = trace, []
        self.charts.set_history(None if trace is None else trace.history)
        self.show_channels(shown)
        if trace is not None and trace.name:
            self._wants_all = True
            self._on_all()

    def show_channels(self, shown: list[int]) -> None:
        """Show these channels."""
        if shown != self._shown:
            self._shown = shown
            self.charts.set_channels(shown)

    def render(self, state: LiveState, overlays: list[Trace]) -> None:
        """Show a state."""
        self._settings = state.settings
        self.tail.blockSignals(True)
        self.tail.setValue(state.settings.tail_s)
        self.tail.blockSignals(False)
        self.charts.set_marks(state.marks)
        self._state = state
        self._show_intervals()
        self.charts.set_overlays([one.history for one in overlays])
        self.buttons["no_overlay"].setVisible(bool(overlays))
        self.buttons["no_overlay"].setToolTip("\n".join(state.overlays))

    def refresh(self) -> None:
        """Show the samples that have come; Full time scale ends at the limit of points."""
        history = None if self._trace is None else self._trace.history
        if history is not None and self._wants_all:
            long = history.end - history.first > self._settings.points
            if long and self.charts.follow is Follow.ALL:
                self.charts.track(self._settings.points / history.rate)
        self.charts.refresh()

    def _show_intervals(self) -> None:
        shown = self.buttons["show"].isChecked()
        self.charts.set_intervals(self._state.intervals if shown else ())

    # --- what the operator does -------------------------------------------------------------------

    def _on_all(self) -> None:
        self._wants_all = True
        self.charts.show_all()
        self._on_follow()

    def _on_track(self) -> None:
        self._wants_all = False
        self.charts.track(self.tail.value())
        self._on_follow()

    def _on_tail(self, seconds: float) -> None:
        self.tail_set.emit(seconds)
        if self.buttons["track"].isChecked():
            self.charts.track(seconds)

    def _on_follow(self) -> None:
        moves = self.charts.follow is not Follow.NOTHING
        self.buttons["all"].setChecked(moves and self._wants_all)
        self.buttons["track"].setChecked(moves and not self._wants_all)

    def _on_edit_mode(self, on: bool) -> None:
        self._edit_row.setVisible(on)
        if not on:
            self.buttons["select"].setChecked(False)

    def _on_edit(self) -> None:
        self.edit.emit(self.sender().property("key"))

    def _on_mark(self) -> None:
        self.marked.emit(self.note.text())
        self.note.clear()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        words = {
            "all": self.tr("Full time scale"),
            "track": self.tr("Auto tracking"),
            "cross": self.tr("X Cursor"),
            "pause": self.tr("Pause"),
            "edit": self.tr("Edit mode"),
            "overlay": self.tr("Overlay…"),
            "no_overlay": self.tr("No overlay"),
            "select_all": self.tr("Select all"),
            "deselect_all": self.tr("Deselect all"),
            "select": self.tr("Select interval"),
            "show": self.tr("Show intervals"),
            "remove": self.tr("Remove intervals"),
            "means": self.tr("Means"),
            "mark": self.tr("Mark"),
        }
        for key, button in self.buttons.items():
            button.set_words(words[key])
        self.buttons["pause"].setToolTip(self.tr("Freezes the picture; the record goes on"))
        self.buttons["mark"].setToolTip(self.tr("Marks this moment in the record, with the note"))
        self.buttons["means"].setToolTip(
            self.tr("Averages the selected intervals and writes means.dat beside the record")
        )
        self.tail.setAccessibleName(self.tr("Seconds of Auto tracking"))
        self._note_label.setText(self.tr("Note"))
        self.note.setPlaceholderText(self.tr("what happens now; Enter marks it"))
        self.note.setAccessibleName(self.tr("Note"))
