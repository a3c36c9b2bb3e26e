"""The results page: verdicts, the graph with its pages and traces, readouts and tables below."""

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QTabBar, QVBoxLayout, QWidget

from gui.accuracy.graph_view import ErrorGraph
from gui.accuracy.page import AccuracyPage
from gui.accuracy.state import Chip, TraceToggle
from gui.languages.shown import shown
from gui.measuring.page import ResultsPage
from gui.measuring.results_view import ResultsView
from gui.widgets.icons import paint_tone
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel


class AccuracyResultsView(ResultsView):
    """Shows an `AccuracyPage`."""

    page_chosen = Signal(str)
    trace_toggled = Signal(str, bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        self._rule = WordLabel()
        self.tabs = QTabBar()
        self.graph = ErrorGraph()
        self.chips: list[VerdictChip] = []
        self.toggles: dict[str, QCheckBox] = {}
        self._names: tuple[tuple[str, str], ...] = ()
        self._traces: tuple[TraceToggle, ...] = ()
        super().__init__(parent)
        self._parts: object = None
        unit = self.fontMetrics().height()
        self._rule.setWordWrap(True)
        self._rule.setProperty("muted", True)
        self._rule.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.tabs.setDocumentMode(True)
        self.tabs.setExpanding(False)
        self.tabs.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.tabs.currentChanged.connect(self._on_tab)
        self._chip_row, self._toggle_row = QHBoxLayout(), QHBoxLayout()
        self._chip_row.setSpacing(unit)
        self._toggle_row.setSpacing(unit)
        upper = QWidget()
        box = QVBoxLayout(upper)
        box.setContentsMargins(0, 0, unit // 2, 0)
        box.setSpacing(unit // 3)
        box.addLayout(self._chip_row)
        box.addWidget(self.tabs)
        box.addWidget(self.graph, 1)
        box.addLayout(self._toggle_row)
        box.addWidget(self._rule)
        self._upper = upper
        self._column.insertWidget(0, upper)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The graph takes its share of the page; the tables below it are scrolled."""
        super().resizeEvent(event)
        unit = self.fontMetrics().height()
        self.graph.setFixedHeight(min(max(11 * unit, round(0.42 * self.height())), 26 * unit))

    def render(self, state: ResultsPage | None) -> None:
        """Show a state; tables that stay as they are keep their selection."""
        if not isinstance(state, AccuracyPage):
            super().render(None)
            return
        if self._parts is None or state.parts != self._parts:
            self._column.removeWidget(self._upper)
            super().render(state)
            self._column.insertWidget(0, self._upper)
            self._upper.show()
        self._state, self._parts = state, state.parts
        self._rule.setText(state.rule)
        self._render_chips(state.chips)
        self._render_tabs(state)
        self._render_toggles(state.traces if state.shown != "temperature" else ())
        self.graph.render(state.graph)

    def _render_chips(self, chips: tuple[Chip, ...]) -> None:
        while len(self.chips) < len(chips):
            chip = VerdictChip()
            self.chips.append(chip)
            self._chip_row.insertWidget(len(self.chips) - 1, chip)
        for place, view in enumerate(self.chips):
            view.setVisible(place < len(chips))
            if place < len(chips):
                view.render(chips[place])

    def _render_tabs(self, state: AccuracyPage) -> None:
        blocked = self.tabs.blockSignals(True)
        if state.names != self._names:
            self._names = state.names
            while self.tabs.count():
                self.tabs.removeTab(0)
            for key, name in state.names:
                self.tabs.setTabData(self.tabs.addTab(shown(name)), key)
        self.tabs.setCurrentIndex([key for key, _ in state.names].index(state.shown))
        self.tabs.blockSignals(blocked)

    def _render_toggles(self, traces: tuple[TraceToggle, ...]) -> None:
        self._traces = traces
        for trace in traces:
            if trace.key not in self.toggles:
                box = QCheckBox()
                box.toggled.connect(lambda on, key=trace.key: self.trace_toggled.emit(key, on))
                self.toggles[trace.key] = box
                self._toggle_row.addWidget(box)
        there = {trace.key: trace for trace in traces}
        for key, box in self.toggles.items():
            box.setVisible(key in there)
            if key in there:
                blocked = box.blockSignals(True)
                box.setText(shown(there[key].name))
                box.setChecked(there[key].shown)
                box.blockSignals(blocked)

    def _on_tab(self, index: int) -> None:
        if index >= 0:
            self.page_chosen.emit(self.tabs.tabData(index))

    def _retranslate(self) -> None:
        super()._retranslate()
        for place, (_, name) in enumerate(self._names):
            self.tabs.setTabText(place, shown(name))
        for trace in self._traces:
            self.toggles[trace.key].setText(shown(trace.name))
        self.tabs.setAccessibleName(self.tr("Pages of the graph"))


class VerdictChip(QWidget):
    """The verdict on one trace, with its sign; colour is not all that tells it."""

    def __init__(self) -> None:
        super().__init__()
        self._chip: Chip | None = None
        self._words = QLabel()
        self._words.setWordWrap(True)
        self._words.setTextFormat(Qt.TextFormat.RichText)
        unit = self.fontMetrics().height()
        row = QHBoxLayout(self)
        row.setContentsMargins(round(2.2 * unit), unit // 3, unit // 2, unit // 3)
        row.addWidget(self._words, 1)

    def render(self, chip: Chip) -> None:
        """Show a verdict."""
        if chip == self._chip:
            return
        self._chip = chip
        told, name, why = shown(chip.verdict), shown(chip.name), shown(chip.why)
        verdict = f"<b>{told}</b>&nbsp; " if told else ""
        self._words.setText(f"{verdict}{name}<br><small>{why}</small>")
        self.setAccessibleName(f"{name} {told}, {why}")
        self.update()

    @property
    def verdict(self) -> str:
        """PASS, FAIL, UNDECIDED, or nothing."""
        return "" if self._chip is None else self._chip.verdict

    def minimumSizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(8 * unit, round(2.8 * unit))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        if self._chip is None:
            return
        theme = current_theme()
        unit = self.fontMetrics().height()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(theme.line))
        painter.setBrush(QColor(theme.tints[self._chip.tone]))
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4)
        sign = QRectF(0.5 * unit, (self.height() - 1.2 * unit) / 2, 1.2 * unit, 1.2 * unit)
        paint_tone(painter, sign, self._chip.tone, theme.tones[self._chip.tone])
        painter.end()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.update()
        elif event.type() == QEvent.Type.LanguageChange and self._chip is not None:
            chip, self._chip = self._chip, None
            self.render(chip)
