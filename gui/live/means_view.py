"""The page Means: a table, what was set for each record, and the run file for the fits."""

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QGuiApplication, QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown_number
from gui.live.means import POSITIONS, RATES, MeansState
from gui.widgets.fields import ChoiceField
from gui.widgets.table_model import Index, TableModel

_GIVEN = 1
"""Column that the operator fills."""
_WORDS = 2


class MeansView(QWidget):
    """Shows a `MeansState`."""

    folder_wanted = Signal()
    selection_wanted = Signal()
    kind_chosen = Signal(str)
    given = Signal(int, list)
    """Row and texts from it on."""
    handed_over = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.folder, self.selection = QPushButton(), QPushButton()
        self.table = _Table(self)
        self.hint = QLabel()
        self.hint.setWordWrap(True)
        self.kind, self.file, self.hand_over = ChoiceField(), QLineEdit(), QPushButton()
        self._kind_label = QLabel()
        for key in (RATES, POSITIONS):
            self.kind.addItem("", key)
        unit = self.fontMetrics().height()
        first, last = QHBoxLayout(), QHBoxLayout()
        for row in (first, last):
            row.setSpacing(unit // 3)
        first.addWidget(self.selection)
        first.addWidget(self.folder)
        first.addStretch(1)
        last.addWidget(self._kind_label)
        last.addWidget(self.kind)
        last.addWidget(self.file, 1)
        last.addWidget(self.hand_over)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, unit // 3, 0, 0)
        column.setSpacing(unit // 3)
        column.addLayout(first)
        column.addWidget(self.hint)
        column.addWidget(self.table, 1)
        column.addLayout(last)
        self.folder.clicked.connect(self.folder_wanted)
        self.selection.clicked.connect(self.selection_wanted)
        self.kind.activated.connect(self._on_kind)
        self.table.given.connect(self.given)
        self.file.returnPressed.connect(self._on_hand_over)
        self.hand_over.clicked.connect(self._on_hand_over)
        self._retranslate()
        self.render(MeansState())

    def render(self, state: MeansState) -> None:
        """Show a state."""
        self.table.show_means(state)
        self.kind.setCurrentIndex(self.kind.findData(state.kind))
        if not self.file.hasFocus():
            self.file.setText(state.file)
        for field in (self.kind, self.file, self.hand_over):
            field.setEnabled(bool(state.rows))

    def _on_kind(self) -> None:
        self.kind_chosen.emit(self.kind.currentData())

    def _on_hand_over(self) -> None:
        self.handed_over.emit(self.file.text())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.selection.setText(self.tr("Means of the selection"))
        self.selection.setToolTip(
            self.tr("Of the selected intervals, else from A to B, else of everything on the charts")
        )
        self.folder.setText(self.tr("Means of a folder…"))
        self.hint.setText(
            self.tr(
                "Mean ± its standard error, which respects correlated noise. Enter what was set for"
                " each record, or paste a column of it; the run file then goes into the fit."
            )
        )
        self._kind_label.setText(self.tr("For the fit of the"))
        self.kind.setItemText(0, self.tr("rate table: set rate, °/s"))
        self.kind.setItemText(1, self.tr("dividing head: X_from:90"))
        self.kind.setAccessibleName(self._kind_label.text())
        self.file.setAccessibleName(self.tr("Run file"))
        self.hand_over.setText(self.tr("Write run file"))
        self.table.setAccessibleName(self.tr("Means"))


class _Table(QTableView):
    given = Signal(int, list)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.means = _Model(self)
        self.means.entered.connect(self._on_entered)
        self.setModel(self.means)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(round(1.8 * self.fontMetrics().height()))
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setHighlightSections(False)

    def show_means(self, state: MeansState) -> None:
        self.means.take(state)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Paste):
            lines = QGuiApplication.clipboard().text().splitlines()
            self.given.emit(max(0, self.currentIndex().row()), lines)
            return
        super().keyPressEvent(event)

    def _on_entered(self, row: int, text: str) -> None:
        self.given.emit(row, [text])


class _Model(TableModel):
    entered = Signal(int, str)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._state = MeansState()

    def take(self, state: MeansState) -> None:
        before, self._state = self._state, state
        self.rows, self.header = state.rows, state.header
        if (before.header, len(before.rows)) == (state.header, len(state.rows)):
            # No reset: the cell that is being walked to keeps the focus.
            if state.rows:
                last = self.index(len(state.rows) - 1, len(state.header) - 1)
                self.dataChanged.emit(self.index(0, 0), last)
            return
        self.beginResetModel()
        self.endResetModel()

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        return flags | Qt.ItemFlag.ItemIsEditable if index.column() == _GIVEN else flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            text = self._state.rows[index.row()][index.column()]
            empty = index.column() == _GIVEN and role == Qt.ItemDataRole.DisplayRole and not text
            return "…" if empty else shown_number(text)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return self.alignment(index.column())
        return None

    def setData(self, index: Index, value: object, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or index.column() != _GIVEN:
            return False
        self.entered.emit(index.row(), str(value))
        return True

    def side(self, column: int) -> Qt.AlignmentFlag:
        return Qt.AlignmentFlag.AlignLeft if column < _WORDS else Qt.AlignmentFlag.AlignRight
