"""A table of results under its title and equation, ready for the clipboard."""

from PySide6.QtCore import QEvent, QPoint, QSize, Qt
from PySide6.QtGui import QAction, QGuiApplication, QKeyEvent, QKeySequence, QPalette, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QMenu,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown
from gui.widgets.kept_columns import WideTable
from gui.widgets.number_text import MINUS, aligned
from gui.widgets.states import TableState
from gui.widgets.table_model import Index, TableModel
from gui.widgets.table_text import table_text
from gui.widgets.word_label import WordLabel

_NUMBER_STARTS = "0123456789(∞\N{EM DASH}" + MINUS
"""What stands first in a column of numbers; others, a unit or a note, are set flush left."""
_EMPTY = TableState("", "", (), ())


class ResultTable(QWidget):
    """Title, equation and table; as high as its rows need.

    Ctrl+C copies the selected rows, or all, as a spreadsheet reads them; the context menu has CSV
    with either decimal mark.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._title = WordLabel()
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._equation = WordLabel()
        self._equation.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._equation.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._equation.setWordWrap(True)
        for label in (self._title, self._equation):
            label.setTextFormat(Qt.TextFormat.PlainText)
        self._view = _View(self)
        unit = self.fontMetrics().height()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(unit // 4)
        for part in (self._title, self._equation, self._view):
            column.addWidget(part)
        self.setFocusProxy(self._view)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)
        self.render(_EMPTY)

    def render(self, table: TableState) -> None:
        """Show a table."""
        self._title.setText(table.title)
        self._title.setVisible(bool(table.title))
        self._equation.setText(table.equation)
        self._equation.setVisible(bool(table.equation))
        self._view.show_table(table)
        self._view.setAccessibleName(shown(table.title) or self.tr("Table of results"))
        self.setAccessibleName(shown(table.title))
        self.setAccessibleDescription(shown(table.equation))
        self.updateGeometry()

    def copy(self, *, separator: str = "\t", decimal: str = ".") -> None:
        """Put the selected rows, or all, on the clipboard."""
        self._view.copy(separator, decimal)


class _Model(TableModel):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.table = _EMPTY
        self._shown: list[list[str]] = []

    def replace(self, table: TableState) -> None:
        self.beginResetModel()
        self.table, self.rows, self.header = table, table.rows, table.header
        columns = [list(column) for column in zip(*table.rows, strict=True)]
        self._shown = [
            column if number < table.words else aligned(column)
            for number, column in enumerate(columns)
        ]
        self.endResetModel()

    def side(self, column: int) -> Qt.AlignmentFlag:
        numbers = column >= self.table.words and all(
            row[column][0] in _NUMBER_STARTS for row in self.table.rows if row[column]
        )
        return Qt.AlignmentFlag.AlignRight if numbers else Qt.AlignmentFlag.AlignLeft

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if role == Qt.ItemDataRole.DisplayRole:
            return shown(self._shown[index.column()][index.row()])
        if role in (Qt.ItemDataRole.AccessibleTextRole, Qt.ItemDataRole.ToolTipRole):
            return shown(self.table.rows[index.row()][index.column()])
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return self.alignment(index.column())
        return None


class _View(WideTable):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._model = _Model(self)
        self.setModel(self._model)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        # Tab leaves the table; arrows walk in it.
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(round(1.7 * self.fontMetrics().height()))
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setHighlightSections(False)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.customContextMenuRequested.connect(self._menu)
        self._copy = QAction(self)
        self._copy.setShortcut(QKeySequence(QKeySequence.StandardKey.Copy))
        self._copy_csv = QAction(self)
        self._copy_comma = QAction(self)
        self._copy.triggered.connect(self._on_copy)
        self._copy_csv.triggered.connect(self._on_copy_csv)
        self._copy_comma.triggered.connect(self._on_copy_comma)
        self._retranslate()

    def show_table(self, table: TableState) -> None:
        self._model.replace(table)
        self.keep_columns(min(2, max(1, table.words)))
        self._share_width()
        self.updateGeometry()

    def _share_width(self) -> None:
        """The last column takes the rest of the width, but never less than its words need."""
        header = self.horizontalHeader()
        columns = range(header.count())
        needed = sum(max(header.sectionSizeHint(i), self.sizeHintForColumn(i)) for i in columns)
        header.setStretchLastSection(needed <= self.viewport().width())

    def sizeHint(self) -> QSize:
        rows = self._model.rowCount() * self.verticalHeader().defaultSectionSize()
        height = self.horizontalHeader().sizeHint().height() + rows + 2 * self.frameWidth()
        if self.horizontalScrollBar().maximum() > 0:
            height += self.horizontalScrollBar().sizeHint().height()
        return QSize(super().sizeHint().width(), height)

    def minimumSizeHint(self) -> QSize:
        return QSize(10 * self.fontMetrics().averageCharWidth(), self.sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._share_width()
        super().resizeEvent(event)

    def updateGeometries(self) -> None:
        before = self.horizontalScrollBar().maximum() > 0
        super().updateGeometries()
        if (self.horizontalScrollBar().maximum() > 0) != before:
            self.updateGeometry()

    def copy(self, separator: str, decimal: str) -> None:
        table = self._model.table
        chosen = sorted(index.row() for index in self.selectionModel().selectedRows())
        rows = tuple(table.rows[row] for row in chosen) if chosen else table.rows
        part = TableState(
            shown(table.title),
            shown(table.equation),
            tuple(shown(name) for name in table.header),
            tuple(
                (*(shown(text) for text in row[: table.words]), *row[table.words :]) for row in rows
            ),
            table.words,
        )
        text = table_text(part, separator=separator, decimal=decimal)
        QGuiApplication.clipboard().setText(text)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self._on_copy()
            return
        super().keyPressEvent(event)

    def _on_copy(self) -> None:
        # As a spreadsheet in this language reads numbers.
        self.copy("\t", self.locale().decimalPoint())

    def _on_copy_csv(self) -> None:
        self.copy(",", ".")

    def _on_copy_comma(self) -> None:
        self.copy(";", ",")

    def _menu(self, at: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addActions([self._copy, self._copy_csv, self._copy_comma])
        menu.popup(self.viewport().mapToGlobal(at))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self._model.replace(self._model.table)
        self._share_width()
        self._copy.setText(self.tr("Copy"))
        self._copy_csv.setText(self.tr("Copy as CSV (1.5, …)"))
        self._copy_comma.setText(self.tr("Copy as CSV (1,5; …)"))
