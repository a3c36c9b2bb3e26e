"""The page Table: samples as numbers, the newest on top."""

import math

from PySide6.QtCore import QAbstractTableModel, QEvent, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtWidgets import QHeaderView, QTableView, QWidget

from gui.languages.shown import shown_number
from gui.live.trace import Trace
from gui.widgets.number_text import MINUS

_MOST_ROWS = 100_000
_DECIMALS = 9


class SampleTable(QTableView):
    """A row a sample; every so many-th where Decimation says so."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.samples = _Samples(self)
        self.setModel(self.samples)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(round(1.5 * self.fontMetrics().height()))
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.horizontalHeader().setDefaultSectionSize(13 * self.fontMetrics().averageCharWidth())
        self.horizontalHeader().setHighlightSections(False)
        self._retranslate()

    def take(self, trace: Trace | None, shown: list[int], decimation: int) -> None:
        """Show another trace, or other channels of it."""
        self.samples.take(trace, shown, decimation)
        metrics = self.fontMetrics()
        for column in range(self.samples.columnCount()):
            title = str(self.samples.headerData(column, Qt.Orientation.Horizontal))
            number = "  −00.000000000  "
            width = max(metrics.horizontalAdvance(text) for text in (f"  {title}  ", number))
            self.setColumnWidth(column, width)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.setAccessibleName(self.tr("Table of samples"))

    def refresh(self) -> None:
        """Show the samples that have come since."""
        self.samples.refresh()


class _Samples(QAbstractTableModel):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._trace: Trace | None = None
        self._shown: list[int] = []
        self._decimation = 1
        self._rows = 0
        self._newest = -1

    def take(self, trace: Trace | None, shown: list[int], decimation: int) -> None:
        self.beginResetModel()
        self._trace, self._shown, self._decimation = trace, list(shown), decimation
        self._rows, self._newest = self._count(), -1 if trace is None else trace.newest
        self.endResetModel()

    def refresh(self) -> None:
        if self._trace is None or self._trace.newest == self._newest:
            return
        self._newest = self._trace.newest
        rows = self._count()
        if rows > self._rows:
            self.beginInsertRows(QModelIndex(), self._rows, rows - 1)
            self._rows = rows
            self.endInsertRows()
        elif rows < self._rows:
            self.beginResetModel()
            self._rows = rows
            self.endResetModel()
        self.dataChanged.emit(self.index(0, 0), self.index(self._rows - 1, self.columnCount() - 1))

    def _count(self) -> int:
        if self._trace is None or not self._trace.history.end:
            return 0
        history = self._trace.history
        return min(_MOST_ROWS, -(-(history.end - history.first) // self._decimation))

    def rowCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else self._rows

    def columnCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() or self._trace is None else 1 + len(self._shown)

    def data(
        self, index: QModelIndex | QPersistentModelIndex, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role != Qt.ItemDataRole.DisplayRole or self._trace is None:
            return None
        history = self._trace.history
        # Rows stand at multiples of the decimation, so that they keep their numbers as they sink.
        span = (self._newest - history.first) // self._decimation * self._decimation
        number = history.first + span - index.row() * self._decimation
        if index.column() == 0:
            return shown_number(f"{history.seconds(number):.4f}")
        value = history.value(self._shown[index.column() - 1], number)
        if math.isnan(value):
            return "—"
        return shown_number(f"{value:.{_DECIMALS}f}".replace("-", MINUS))

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> object:
        if role != Qt.ItemDataRole.DisplayRole or self._trace is None:
            return None
        if orientation is Qt.Orientation.Vertical:
            return None
        if section == 0:
            return "t, s"
        channel = self._trace.channels[self._shown[section - 1]]
        return f"{channel.name}, {channel.unit}" if channel.unit else channel.name
