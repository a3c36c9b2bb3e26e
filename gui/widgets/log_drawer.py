"""What happened since the start, under a line that opens and closes."""

from collections import deque

from PySide6.QtCore import (
    QAbstractTableModel,
    QEvent,
    QModelIndex,
    QPersistentModelIndex,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QGuiApplication, QKeyEvent, QKeySequence, QPainter, QPixmap, QShortcut
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QSizePolicy,
    QTableView,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from core.errors import Severity
from gui.languages.shown import shown
from gui.widgets.icons import paint_severity, tone_of_severity
from gui.widgets.states import LogEntry
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel

KEPT = 2000
"""Entries on the screen; the log file of the session has all of them."""


class LogDrawer(QWidget):
    """The newest event in one line; opened, a list of all with the newest on top."""

    toggled = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        unit = self.fontMetrics().height()
        self._model = _Entries(self)
        self._tip = ""
        self._newest = WordLabel()
        self._newest.setTextFormat(Qt.TextFormat.PlainText)
        self._newest.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._button = QToolButton()
        self._button.setCheckable(True)
        self._button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        # Not the button's own shortcut: Qt drops that with every change of the text.
        QShortcut(QKeySequence("Ctrl+L"), self).activated.connect(self._button.toggle)
        self._button.toggled.connect(self._on_toggled)
        line = QHBoxLayout()
        line.setContentsMargins(unit, unit // 6, unit, unit // 6)
        line.addWidget(self._newest, 1)
        line.addWidget(self._button)
        self._table = _LogTable(self._model)
        self._table.hide()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(line)
        column.addWidget(self._table)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self._retranslate()

    def append(self, entry: LogEntry) -> None:
        """Add an event."""
        self._model.append(entry)
        self._newest.setText(f"{entry.at:%H:%M:%S}  {entry.text}")
        self._tip = entry.text
        self._newest.setToolTip(shown(entry.text))

    def set_open(self, opened: bool) -> None:
        """Open or close the list."""
        self._button.setChecked(opened)

    def _on_toggled(self, opened: bool) -> None:
        self._table.setVisible(opened)
        self._retranslate()
        self.toggled.emit(opened)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self._button.setText(self.tr("Log") + (" ▾" if self._button.isChecked() else " ▴"))
        self._button.setToolTip(self.tr("Show or hide the log (Ctrl+L)"))
        for widget in (self._button, self._table):
            widget.setAccessibleName(self.tr("Log"))
        self._newest.setToolTip(shown(self._tip))


class _Entries(QAbstractTableModel):
    """Newest first."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.entries: deque[LogEntry] = deque()

    def append(self, entry: LogEntry) -> None:
        self.beginInsertRows(QModelIndex(), 0, 0)
        self.entries.appendleft(entry)
        self.endInsertRows()
        if len(self.entries) > KEPT:
            last = len(self.entries) - 1
            self.beginRemoveRows(QModelIndex(), last, last)
            self.entries.pop()
            self.endRemoveRows()

    def rowCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self.entries)

    def columnCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else 3

    def data(
        self, index: QModelIndex | QPersistentModelIndex, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        entry = self.entries[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return (f"{entry.at:%H:%M:%S}", shown(entry.source), shown(entry.text))[index.column()]
        if role == Qt.ItemDataRole.DecorationRole and index.column() == 0:
            return _sign(entry.severity)
        if role == Qt.ItemDataRole.ToolTipRole:
            return shown(entry.text)
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return f"{entry.severity.value}, {entry.at:%H:%M:%S}, {shown(entry.text)}"
        return None


def _sign(severity: Severity) -> QPixmap:
    ratio = 2.0
    pixmap = QPixmap(round(14 * ratio), round(14 * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    colour = current_theme().tones[tone_of_severity(severity)]
    paint_severity(painter, QRectF(1, 1, 12, 12), severity, colour)
    painter.end()
    return pixmap


class _LogTable(QTableView):
    def __init__(self, entries: _Entries) -> None:
        super().__init__()
        self._entries = entries
        self.setModel(entries)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setShowGrid(False)
        self.setTabKeyNavigation(False)
        self.setWordWrap(False)
        self.horizontalHeader().hide()
        self.verticalHeader().hide()
        unit = self.fontMetrics().height()
        self.verticalHeader().setDefaultSectionSize(round(1.5 * unit))
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setStretchLastSection(True)
        header.resizeSection(0, 7 * unit)
        header.resizeSection(1, 6 * unit)

    def sizeHint(self) -> QSize:
        return QSize(super().sizeHint().width(), 11 * self.fontMetrics().height())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            rows = sorted(index.row() for index in self.selectionModel().selectedRows())
            entries = [
                self._entries.entries[row] for row in rows or range(len(self._entries.entries))
            ]
            lines = [
                f"{entry.at.isoformat(timespec='milliseconds')}\t{entry.severity.value}"
                f"\t{entry.source}\t{entry.text}"
                for entry in entries
            ]
            QGuiApplication.clipboard().setText("\n".join(lines))
            return
        super().keyPressEvent(event)
