"""The list of what was found."""

from PySide6.QtCore import (
    QEvent,
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QWidget

from gui.archive.state import ListRow
from gui.languages.shown import shown
from gui.widgets.kept_columns import WideTable
from gui.widgets.states import Tone
from gui.widgets.table_model import Index, TableModel
from gui.widgets.theme import current_theme

_VERDICT = 3
_SIGNS = {Tone.BAD: "✕ ", Tone.DOUBT: "△ "}


class EntryTable(WideTable):
    """Rows are chosen; with Ctrl or Shift a second one for comparing."""

    chosen = Signal(object)
    """Numbers of the chosen entries, in the order of choosing."""
    opened = Signal()
    """A row was pressed twice, or Return."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = _Model(self)
        self._order: list[int] = []
        self._rendering = False
        self.setModel(self._model)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(round(1.7 * self.fontMetrics().height()))
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setStretchLastSection(True)
        self.selectionModel().selectionChanged.connect(self._on_selection)
        self.activated.connect(self._on_activated)
        self.keep_columns(1)

    def render_rows(
        self, rows: tuple[ListRow, ...], header: tuple[str, ...], chosen: tuple[int, ...]
    ) -> None:
        """Show rows; the chosen ones stay chosen wherever they are now."""
        self._rendering = True
        if rows != self._model.rows or header != self._model.header:
            first = not self._model.rows
            self._model.replace(rows, header)
            if rows and first:
                self._fit()
        selected = {index.row() for index in self.selectionModel().selectedRows()}
        wanted = {place for place, row in enumerate(rows) if row.id in chosen}
        if selected != wanted:
            self._select(wanted)
        self._order = list(chosen)
        self._rendering = False

    def _select(self, places: set[int]) -> None:
        selection = QItemSelection()
        for place in places:
            index = self._model.index(place, 0)
            selection.select(index, self._model.index(place, self._model.columnCount() - 1))
        flags = QItemSelectionModel.SelectionFlag.ClearAndSelect
        self.selectionModel().select(selection, flags)

    def _fit(self) -> None:
        """Columns as wide as their words ask for, but for the last."""
        mode = QHeaderView.ResizeMode.Interactive
        unit = self.fontMetrics().averageCharWidth()
        for column in range(self._model.columnCount() - 1):
            self.resizeColumnToContents(column)
            if column == 0:  # a damaged file stands under its whole name
                self.setColumnWidth(column, min(self.columnWidth(column), 18 * unit))
            self.horizontalHeader().setSectionResizeMode(column, mode)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._fit()

    def _on_selection(self) -> None:
        if self._rendering:
            return
        selected = [
            self._model.rows[index.row()].id for index in self.selectionModel().selectedRows()
        ]
        kept = [number for number in self._order if number in selected]
        order = kept + [number for number in selected if number not in kept]
        # The first and the latest choice are compared.
        self._order = order if len(order) <= 2 else [order[0], order[-1]]
        self.chosen.emit(tuple(self._order))

    def _on_activated(self, index: QModelIndex) -> None:  # noqa: ARG002
        self.opened.emit()

    def sizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(26 * unit, 20 * unit)


class _Model(TableModel):
    def replace(self, rows: tuple[ListRow, ...], header: tuple[str, ...]) -> None:
        self.beginResetModel()
        self.rows, self.header = rows, header
        self.endResetModel()

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        row = self.rows[index.row()]
        text = shown(row.cells[index.column()])
        if role == Qt.ItemDataRole.DisplayRole:
            return _SIGNS.get(row.tone, "") + text if index.column() == _VERDICT else text
        if role in (Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleTextRole):
            return text
        if role == Qt.ItemDataRole.ForegroundRole and index.column() == _VERDICT:
            return QColor(current_theme().tones[row.tone]) if row.tone in _SIGNS else None
        return None
