"""The files of the comparison, and what their gyros are called."""

from pathlib import Path

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from gui.comparison.state import ComparisonState
from gui.languages.shown import shown
from gui.widgets.fields import NumberField
from gui.widgets.word_label import WordLabel

_KEY = Qt.ItemDataRole.UserRole


class ComparisonSide(QWidget):
    """Add, name and remove."""

    added = Signal(object)
    """Paths of files."""
    renamed = Signal(int, str)
    removed = Signal(object)
    """Keys of rows."""
    g_edited = Signal(float)

    def __init__(self, g_mps2: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        unit = self.fontMetrics().height()
        self._dialog: QFileDialog | None = None
        self._hint = WordLabel()
        self._hint.setWordWrap(True)
        self._hint.setProperty("muted", True)
        self.list = QTreeWidget()
        self.list.setRootIsDecorated(False)
        self.list.setColumnCount(2)
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.list.setMinimumHeight(12 * unit)
        self.list.itemChanged.connect(self._on_item)
        self.add, self.remove = QPushButton(), QPushButton()
        self.add.clicked.connect(self._open)
        self.remove.clicked.connect(self._on_remove)
        self._g_label, self._g = QLabel(), NumberField(9.7, 9.9, 5)
        self._g.setValue(g_mps2)
        self._g.valueChanged.connect(self.g_edited)
        self._g_label.setBuddy(self._g)
        buttons, gravity = QHBoxLayout(), QHBoxLayout()
        buttons.addWidget(self.add)
        buttons.addWidget(self.remove)
        gravity.addWidget(self._g_label, 1)
        gravity.addWidget(self._g)
        for button in (self.add, self.remove):
            button.setMinimumWidth(0)
        column = QVBoxLayout(self)
        column.setSpacing(unit // 2)
        column.addWidget(self._hint)
        column.addLayout(buttons)
        column.addWidget(self.list, 1)
        column.addLayout(gravity)
        self._retranslate()

    def render(self, state: ComparisonState) -> None:
        """Show a state."""
        blocker = QSignalBlocker(self.list)
        self.list.clear()
        for row in state.rows:
            item = QTreeWidgetItem([row.name, row.source])
            item.setData(0, _KEY, row.key)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
            for column in (0, 1):
                item.setToolTip(column, shown(f"{row.source}: {row.tells}"))
            self.list.addTopLevelItem(item)
        self.list.resizeColumnToContents(0)
        blocker.unblock()
        self._hint.setText(state.hint)
        self.add.setEnabled(not state.busy)
        self.remove.setEnabled(bool(state.rows))

    def _on_item(self, item: QTreeWidgetItem, column: int) -> None:
        if column == 0:
            self.renamed.emit(item.data(0, _KEY), item.text(0))

    def _on_remove(self) -> None:
        chosen = self.list.selectedItems()
        self.removed.emit([item.data(0, _KEY) for item in chosen])

    def _open(self) -> None:
        """Choose files, in a window that does not block the others."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.add.text())
            dialog.setModal(False)
            dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
            dialog.setNameFilters(
                [
                    self.tr("Results and runs (*.json *.csv *.txt)"),
                    self.tr("All files (*)"),
                ]
            )
            dialog.filesSelected.connect(self._on_files)
            self._dialog = dialog
        self._dialog.show()

    def _on_files(self, names: list[str]) -> None:
        self.added.emit([Path(name) for name in names])

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self._dialog = None

    def _retranslate(self) -> None:
        self.list.setHeaderLabels([self.tr("Gyro"), self.tr("File")])
        self.list.setAccessibleName(self.tr("Gyros that are compared"))
        self.add.setText(self.tr("Add files"))
        self.remove.setText(self.tr("Remove"))
        self._g_label.setText(self.tr("Local g, m/s²"))
        self._g.setAccessibleName(self._g_label.text())
        self._g.setToolTip(self.tr("Taken where a file states none"))
