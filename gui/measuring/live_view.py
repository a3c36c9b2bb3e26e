"""The table of live means: Accelerations, Angular Rates."""

from dataclasses import replace

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QSizePolicy,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from gui.languages.shown import shown_number
from gui.measuring.state import LiveRow, LiveState


class LiveTable(QTableWidget):
    """Mean, STD and thermometer of every sensor over the last second."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state = LiveState()
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom)
        header.setSectionsClickable(False)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.verticalHeader().setDefaultSectionSize(round(1.6 * self.fontMetrics().height()))
        self.verticalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)
        self.hide()

    def render(self, state: LiveState) -> None:
        """Show a state."""
        before, self._state = self._state, state
        names = [row.name for row in state.rows]
        if (
            replace(state, rows=()) != replace(before, rows=())
            or names != [row.name for row in before.rows]
            or self.columnCount() == 0
        ):
            self._set_shape(names)
        for place, row in enumerate(state.rows):
            for column, text in enumerate(self._texts(row)):
                item = self.item(place, column)
                text = shown_number(text)
                if item is not None and item.text() != text:
                    item.setText(text)
        columns = range(self.columnCount())
        # Only then, so that columns do not dance with their numbers.
        if any(self.sizeHintForColumn(i) > self.columnWidth(i) for i in columns):
            self._share_width()

    def _texts(self, row: LiveRow) -> tuple[str, ...]:
        texts = (row.mean, row.std, row.temp)
        return (*texts, row.other_mean, row.other_temp) if self._state.has_others else texts

    def _set_shape(self, names: list[str]) -> None:
        headers = self._headers()
        self.setRowCount(len(names))
        self.setColumnCount(len(headers))
        self.setHorizontalHeaderLabels(headers)
        self.setVerticalHeaderLabels(names)
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for row in range(len(names)):
            for column in range(len(headers)):
                item = QTableWidgetItem("")
                item.setTextAlignment(right)
                self.setItem(row, column, item)
        self.setVisible(bool(names))
        self._share_width()
        self.updateGeometry()

    def _headers(self) -> list[str]:
        unit = self._state.unit
        titles = [self.tr("Accelerations"), self.tr("Angular Rates")]
        own, other = titles if self._state.sensor == "accelerometer" else titles[::-1]
        headers = [
            f"{own}\n" + self.tr("Mean ({unit})").format(unit=unit),
            "\n" + self.tr("STD ({unit})").format(unit=self._state.std_unit),
            "\n" + self.tr("Termo (code)"),
        ]
        if self._state.has_others:
            headers += [
                f"{other}\n" + self.tr("Mean ({unit})").format(unit=unit),
                "\n" + self.tr("Termo (code)"),
            ]
        return headers

    def _share_width(self) -> None:
        """Each column has what it needs, and they share the rest."""
        header = self.horizontalHeader()
        needed = [self.sizeHintForColumn(i) for i in range(header.count())]
        needed = [max(header.sectionSizeHint(i), width) for i, width in enumerate(needed)]
        rest = max(0, self.viewport().width() - sum(needed))
        for place, width in enumerate(needed):
            share = rest // (len(needed) - place)
            rest -= share
            header.resizeSection(place, width + share)

    def needed_width(self) -> int:
        """Width at which no column is cut."""
        header = self.horizontalHeader()
        columns = sum(header.sectionSizeHint(i) for i in range(header.count()))
        return columns + self.verticalHeader().sizeHint().width() + 2 * self.frameWidth() + 2

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share_width()

    def sizeHint(self) -> QSize:
        rows = self.rowCount() * self.verticalHeader().defaultSectionSize()
        height = self.horizontalHeader().sizeHint().height() + rows + 2 * self.frameWidth()
        return QSize(30 * self.fontMetrics().height(), height)

    def minimumSizeHint(self) -> QSize:
        return QSize(20 * self.fontMetrics().height(), min(self.sizeHint().height(), 120))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange and self.columnCount():
            self.setHorizontalHeaderLabels(self._headers())
            self._share_width()
