"""Tables that are wider than their place: the first columns stay while the others are scrolled."""

from PySide6.QtCore import QEvent, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QFrame, QHeaderView, QTableView, QWidget

from gui.widgets.theme import current_theme

_Index = QModelIndex | QPersistentModelIndex
_MOST = 0.6
"""Of the width of a table that columns which stay may take."""


class WideTable(QTableView):
    """A table whose first columns can be kept; Left and Right scroll it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._kept: _Kept | None = None
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)

    def keep_columns(self, count: int) -> None:
        """Let so many columns stay in sight; the table has its model."""
        if self._kept is None:
            self._kept = _Kept(self)
        self._kept.take(count)

    @property
    def kept_width(self) -> int:
        """Pixels at the left that columns cover which stay; 0 while nothing is scrolled."""
        kept = self._kept
        return kept.width() if kept is not None and not kept.isHidden() else 0

    def scrollTo(
        self,
        index: _Index,
        hint: QAbstractItemView.ScrollHint = QAbstractItemView.ScrollHint.EnsureVisible,
    ) -> None:
        """Bring a cell into sight, also from below the columns that stay."""
        super().scrollTo(index, hint)
        kept = self._kept
        if kept is None or index.column() < kept.count:
            return
        covered = self.kept_width - self.visualRect(index).left()
        if covered > 0:
            bar = self.horizontalScrollBar()
            bar.setValue(bar.value() - covered)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._kept is not None:
            self._kept.place()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        kept = getattr(self, "_kept", None)  # none while Qt makes the table
        if event.type() == QEvent.Type.FontChange and kept is not None:
            kept.place()


class _Kept(QTableView):
    """The columns that stay, above the table itself; clicks go through to the table."""

    def __init__(self, table: WideTable) -> None:
        super().__init__(table)
        self._table = table
        self.count = 0
        self.setModel(table.model())
        self.setSelectionModel(table.selectionModel())
        self.setSelectionBehavior(table.selectionBehavior())
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setFrameShape(QFrame.Shape.NoFrame)
        # The border of all tables would move the rows by its width.
        self.setStyleSheet("QTableView { border: none; }")
        self.setAutoScroll(False)
        self.setShowGrid(table.showGrid())
        self.setAlternatingRowColors(table.alternatingRowColors())
        self.setWordWrap(table.wordWrap())
        self.verticalHeader().hide()
        for policy in (self.setHorizontalScrollBarPolicy, self.setVerticalScrollBarPolicy):
            policy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(table.verticalScrollMode())
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header.setHighlightSections(False)
        header.setMinimumSectionSize(1)
        table.verticalScrollBar().valueChanged.connect(self.verticalScrollBar().setValue)
        table.horizontalScrollBar().valueChanged.connect(self.place)
        table.horizontalScrollBar().rangeChanged.connect(self.place)
        table.horizontalHeader().sectionResized.connect(self.place)
        table.model().modelReset.connect(self._on_reset)
        self.hide()

    def take(self, count: int) -> None:
        self.count = count
        self._on_reset()

    def _on_reset(self) -> None:
        model = self.model()
        for column in range(0 if model is None else model.columnCount()):
            self.setColumnHidden(column, column >= self.count)
        self.place()

    def place(self) -> None:
        """Stand where the columns stood before the table was scrolled."""
        table, header = self._table, self._table.horizontalHeader()
        widths = [header.sectionSize(column) for column in range(min(self.count, header.count()))]
        width, frame = sum(widths), table.frameWidth()
        fits = 0 < width <= _MOST * table.viewport().width()
        if not (fits and table.horizontalScrollBar().value() > 0):
            self.hide()
            return
        for column, size in enumerate(widths):
            self.setColumnWidth(column, size)
        self.verticalHeader().setDefaultSectionSize(table.verticalHeader().defaultSectionSize())
        self.horizontalHeader().setFixedHeight(header.height())
        self.setGeometry(frame, frame, width, header.height() + table.viewport().height())
        self.setAccessibleName(table.accessibleName())
        self.show()
        self.verticalScrollBar().setValue(table.verticalScrollBar().value())

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self.viewport())
        painter.setPen(current_theme().field)
        right = self.viewport().width() - 1
        painter.drawLine(right, 0, right, self.viewport().height())
        painter.end()
