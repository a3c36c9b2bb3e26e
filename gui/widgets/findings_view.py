"""The right-hand side: tables with their laws, doubts, and what can be exported."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QVBoxLayout,
    QWidget,
)

from gui.widgets.export_foot import ExportFoot
from gui.widgets.note_line import NoteLine
from gui.widgets.page_scroll import PageScroll
from gui.widgets.result_table import ResultTable
from gui.widgets.states import FindingsState
from gui.widgets.word_label import WordLabel


class FindingsView(QWidget):
    """Shows a `FindingsState`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state: FindingsState | None = None
        self._tables: list[ResultTable] = []
        self._notes: list[NoteLine] = []
        unit = self.fontMetrics().height()
        self._title, self._source = WordLabel(), WordLabel()
        font = self._title.font()
        font.setBold(True)
        font.setPointSizeF(font.pointSizeF() * 1.2)
        self._title.setFont(font)
        self._source.setWordWrap(True)
        for label in (self._title, self._source):
            label.setTextFormat(Qt.TextFormat.PlainText)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._page = QWidget()
        self._column = QVBoxLayout(self._page)
        self._column.setContentsMargins(0, 0, unit // 2, unit)
        self._column.setSpacing(round(0.8 * unit))
        self._doubts = QVBoxLayout()
        self._column.addLayout(self._doubts)
        self._column.addStretch(1)
        self.foot = ExportFoot()
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        column.setSpacing(unit // 2)
        for label in (self._title, self._source):
            column.addWidget(label)
        column.addWidget(PageScroll(self._page), 1)
        column.addWidget(self.foot)

    @property
    def tables(self) -> tuple[ResultTable, ...]:
        """The tables on the page, from above."""
        return tuple(self._tables[: len(self._state.tables)]) if self._state is not None else ()

    def render(self, state: FindingsState | None) -> None:
        """Show a state; tables that stay where they are keep their selection and place."""
        if state == self._state:
            return
        old = self._state
        self._state = state
        self._title.setText("" if state is None else state.title)
        self._source.setText("" if state is None else state.source)
        tables = () if state is None else state.tables
        while len(self._tables) < len(tables):
            view = ResultTable()
            self._column.insertWidget(1 + len(self._tables), view)
            self._tables.append(view)
        before = () if old is None else old.tables
        for place, view in enumerate(self._tables):
            view.setVisible(place < len(tables))
            if place < len(tables) and (place >= len(before) or before[place] != tables[place]):
                view.render(tables[place])
        if state is None or old is None or state.notes != old.notes:
            self._render_notes(state)

    def _render_notes(self, state: FindingsState | None) -> None:
        for line in self._notes:
            self._doubts.removeWidget(line)
            line.hide()
            line.deleteLater()
        self._notes = [NoteLine(note) for note in (() if state is None else state.notes)]
        for line in self._notes:
            self._doubts.addWidget(line)
