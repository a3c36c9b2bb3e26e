"""The panel View ADC Data."""

from PySide6.QtCore import QEvent, QSize, Qt, QTimer
from PySide6.QtGui import QGuiApplication, QHideEvent, QKeySequence, QPalette, QShortcut, QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from gui.devices.adc import AdcPresenter, AdcState
from gui.languages.shown import shown
from gui.widgets.states import TableState
from gui.widgets.table_model import Index, TableModel
from gui.widgets.table_text import table_text
from gui.widgets.word_label import WordLabel

_PERIOD_MS = 250
_EMPTY = TableState("", "", (), ())


class AdcPanel(QWidget):
    """Live numbers of all channels; copied as a spreadsheet reads them.

    Parameters
    ----------
    presenter : the numbers
    """

    def __init__(self, presenter: AdcPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._state: AdcState | None = None
        self._title, self._samples, self._hint = QLabel(), QLabel(), WordLabel()
        self._samples.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._hint.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._clear, self._copy = QPushButton(), QPushButton()
        self._clear.clicked.connect(presenter.clear)
        self._copy.clicked.connect(self.copy)
        self._model = _Model(self)
        self.table = QTableView()
        self.table.setModel(self._model)
        self.table.setShowGrid(False)
        self.table.setAlternatingRowColors(True)
        self.table.setWordWrap(False)
        self.table.setTabKeyNavigation(False)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.table.verticalHeader().hide()
        unit = self.fontMetrics().height()
        self.table.verticalHeader().setDefaultSectionSize(round(1.4 * unit))
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setHighlightSections(False)
        top = QHBoxLayout()
        top.addWidget(self._title)
        top.addWidget(self._samples, 1)
        top.addWidget(self._clear)
        top.addWidget(self._copy)
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 3, unit // 2, unit // 3)
        column.setSpacing(unit // 3)
        column.addLayout(top)
        column.addWidget(self._hint)
        column.addWidget(self.table, 1)
        shortcut = QShortcut(QKeySequence(QKeySequence.StandardKey.Copy), self.table)
        shortcut.setContext(Qt.ShortcutContext.WidgetShortcut)
        shortcut.activated.connect(self.copy)
        self._timer = QTimer(self)
        self._timer.setInterval(_PERIOD_MS)
        self._timer.timeout.connect(self.refresh)
        presenter.changed.connect(self.refresh)
        self._retranslate()

    def refresh(self) -> None:
        """Show the numbers of now."""
        if not self.isVisible():
            return
        state = self._presenter.state()
        self._state = state
        self._title.setText(state.device)
        parts = [self.tr("{count} samples since Clear").format(count=state.samples)]
        if state.calibration:
            parts.append(self.tr("calibrated by {name}").format(name=state.calibration))
        self._samples.setText("   ".join(parts) if not state.hint else "")
        self._hint.setText(state.hint)
        self._hint.setVisible(bool(state.hint))
        self._fit_columns(anew=self._model.replace(state.table))

    def copy(self) -> None:
        """Put all rows on the clipboard."""
        if self._state is not None:
            QGuiApplication.clipboard().setText(table_text(self._state.table))

    def _fit_columns(self, *, anew: bool) -> None:
        """Wide enough for the longest numbers so far: columns must not jitter while they run."""
        header = self.table.horizontalHeader()
        for column in range(len(self._model.table.header)):
            hint = self.table.sizeHintForColumn(column)
            needed = max(hint, header.sectionSizeHint(column)) + self.fontMetrics().height() // 2
            if anew or needed > self.table.columnWidth(column):
                self.table.setColumnWidth(column, needed)

    def sizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(50 * unit, 16 * unit)

    def minimumSizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(20 * unit, 11 * unit)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._presenter.set_open(True)
        self._timer.start()
        self.refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._presenter.set_open(False)
        self._timer.stop()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self._clear.setText(self.tr("Clear"))
        self._clear.setToolTip(self.tr("Begin mean, STD, Min and Max anew"))
        self._copy.setText(self.tr("Copy"))
        self.table.setAccessibleName(self.tr("ADC data of all channels"))


class _Model(TableModel):
    """Keeps its selection while the numbers run."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.table = _EMPTY

    def replace(self, table: TableState) -> bool:
        """Take new numbers; tell whether rows or columns are others."""
        names = [row[0] for row in table.rows]
        other = table.header != self.table.header or names != [row[0] for row in self.table.rows]
        if other:
            self.beginResetModel()
        self.table, self.rows, self.header = table, table.rows, table.header
        if other:
            self.endResetModel()
        elif table.rows:
            last = self.index(len(table.rows) - 1, len(table.header) - 1)
            self.dataChanged.emit(self.index(0, 0), last, [Qt.ItemDataRole.DisplayRole])
        return other

    def side(self, column: int) -> Qt.AlignmentFlag:
        words = column < self.table.words
        return Qt.AlignmentFlag.AlignLeft if words else Qt.AlignmentFlag.AlignRight

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if role == Qt.ItemDataRole.DisplayRole:
            return shown(self.rows[index.row()][index.column()])
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return self.alignment(index.column())
        return None
