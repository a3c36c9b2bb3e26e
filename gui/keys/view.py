"""The window of the sheet of keys; it stands beside the program and holds nothing up."""

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QDialog,
    QFrame,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from gui.keys.key_html import sheet_title
from gui.keys.sheet import KeyGroup, KeySheet
from gui.widgets.word_label import WordLabel


class KeysView(QDialog):
    """Groups of keys in columns, a field to find one, and a button that prints."""

    print_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setModal(False)
        self._sheet = KeySheet(())
        self._find = QLineEdit()
        self._find.setClearButtonEnabled(True)
        self._find.textChanged.connect(self._fill)
        self._print, self._close = QPushButton(), QPushButton()
        self._print.clicked.connect(self.print_requested)
        self._close.clicked.connect(self.hide)
        for button in (self._print, self._close):
            button.setAutoDefault(False)
        self._scroll = QScrollArea()
        self._scroll.setWidgetResizable(True)
        self._scroll.setFrameShape(QFrame.Shape.NoFrame)
        row = QHBoxLayout()
        row.addWidget(self._find, 1)
        row.addWidget(self._print)
        row.addWidget(self._close)
        column = QVBoxLayout(self)
        column.addLayout(row)
        column.addWidget(self._scroll, 1)
        unit = self.fontMetrics().height()
        self.resize(74 * unit, 44 * unit)
        self._retranslate()

    def render(self, sheet: KeySheet) -> None:
        """Show a sheet."""
        self._sheet = sheet
        self._fill()

    def open_sheet(self) -> None:
        """Come to the front, ready to be searched."""
        self.show()
        self.activateWindow()
        self._find.selectAll()
        self._find.setFocus(Qt.FocusReason.OtherFocusReason)

    def _fill(self) -> None:
        wanted = self._find.text().casefold()
        groups = [found for one in self._sheet.groups if (found := _found(one, wanted)).lines]
        unit = self.fontMetrics().height()
        page = QWidget()
        across = QHBoxLayout(page)
        across.setSpacing(2 * unit)
        heights, columns = [0, 0], [QVBoxLayout(), QVBoxLayout()]
        for column in columns:
            across.addLayout(column, 1)
        for group in groups:
            shorter = heights.index(min(heights))
            columns[shorter].addWidget(_block(group, unit))
            heights[shorter] += len(group.lines) + 2
        for column in columns:
            column.addStretch(1)
        self._scroll.setWidget(page)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.setWindowTitle(sheet_title())
        self._find.setPlaceholderText(self.tr("Find a key or what it does"))
        self._find.setAccessibleName(self.tr("Find a key or what it does"))
        self._print.setText(self.tr("Save as PDF"))
        self._close.setText(self.tr("Close"))
        self._scroll.setAccessibleName(sheet_title())


def _found(group: KeyGroup, wanted: str) -> KeyGroup:
    """The lines that hold the words; all if the group's title holds them."""
    if wanted in group.title.casefold():
        return group
    lines = (x for x in group.lines if wanted in f"{x.keys} {x.text}".casefold())
    return KeyGroup(group.title, tuple(lines))


def _block(group: KeyGroup, unit: int) -> QWidget:
    block = QWidget()
    column = QVBoxLayout(block)
    column.setContentsMargins(0, 0, 0, unit)
    column.setSpacing(unit // 4)
    title = WordLabel(group.title)
    font = title.font()
    font.setBold(True)
    title.setFont(font)
    column.addWidget(title)
    for line in group.lines:
        keys, text = WordLabel(line.keys), WordLabel(line.text)
        keys.setFixedWidth(13 * unit)
        text.setWordWrap(True)
        text.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        row = QHBoxLayout()
        row.addWidget(keys, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(text, 1)
        column.addLayout(row)
    return block
