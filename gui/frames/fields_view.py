"""The numbers of a board with their values and courses, and the form of one of them."""

from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    QPointF,
    QSignalBlocker,
    Qt,
)
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from gui.frames.field_form_view import FieldForm
from gui.frames.presenter import FramesPresenter
from gui.frames.readings import Readings
from gui.frames.state import FieldRow, FramesState, Live
from gui.frames.texts import TYPE_WORDS
from gui.languages.shown import shown, shown_number
from gui.widgets.theme import current_theme

_VALUE, _COURSE = 3, 4
Index = QModelIndex | QPersistentModelIndex


class FieldsView(QWidget):
    """Table above, form below."""

    def __init__(self, presenter: FramesPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self.model = _Model(self)
        self.table = QTableView()
        self.table.setModel(self.model)
        self.table.setItemDelegateForColumn(_COURSE, _CourseDelegate(self.table))
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.table.verticalHeader().hide()
        self.table.setShowGrid(False)
        self.table.setAlternatingRowColors(True)
        self.table.setTabKeyNavigation(False)
        unit = self.fontMetrics().height()
        self.table.verticalHeader().setDefaultSectionSize(round(1.5 * unit))
        header = self.table.horizontalHeader()
        header.setHighlightSections(False)
        for column, width in enumerate((5.5, 4.7, 5.5, 9.5, 5)):
            self.table.setColumnWidth(column, round(width * unit))
        header.setSectionResizeMode(_COURSE, QHeaderView.ResizeMode.Interactive)
        header.setStretchLastSection(True)
        self.form = FieldForm(presenter)
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, 0, unit // 2, 0)
        column.setSpacing(unit // 2)
        column.addWidget(self.table, 1)
        column.addWidget(self.form)
        self.table.selectionModel().currentRowChanged.connect(self._on_row)
        presenter.changed.connect(self.render)
        presenter.ticked.connect(self._on_tick)
        self.render(presenter.state)

    def render(self, state: FramesState) -> None:
        """Show the numbers of a state."""
        self.model.put_rows(state.fields)
        chosen = self.table.selectionModel()
        with QSignalBlocker(chosen):
            if 0 <= state.field < len(state.fields):
                flags = QItemSelectionModel.SelectionFlag
                index = self.model.index(state.field, 0)
                chosen.setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
            else:
                chosen.clear()
        self.table.viewport().update()
        self.form.render(state)

    def _on_tick(self, readings: Readings) -> None:
        self.model.put_live(readings.live)

    def _on_row(self, index: QModelIndex) -> None:
        if index.isValid():
            self._presenter.edit(index.row())


class _Model(QAbstractTableModel):
    """Rows of numbers; the values change some times a second."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._rows: tuple[FieldRow, ...] = ()
        self._live: tuple[Live, ...] = ()

    def put_rows(self, rows: tuple[FieldRow, ...]) -> None:
        if rows == self._rows:
            return
        if len(rows) == len(self._rows):
            self._rows = rows
            self.dataChanged.emit(self.index(0, 0), self.index(len(rows) - 1, 5))
            return
        self.beginResetModel()
        self._rows = rows
        self.endResetModel()

    def put_live(self, live: tuple[Live, ...]) -> None:
        self._live = live
        if self._rows:
            last = self.index(len(self._rows) - 1, _COURSE)
            self.dataChanged.emit(self.index(0, _VALUE), last)

    def live(self, row: int) -> Live | None:
        return self._live[row] if row < len(self._live) else None

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else 6

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        row = self._rows[index.row()]
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
            return self._text(row, index.row(), index.column())
        if role == Qt.ItemDataRole.TextAlignmentRole and index.column() == _VALUE:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.ForegroundRole and row.hide:
            return QColor(current_theme().muted)
        return None

    def _text(self, row: FieldRow, place: int, column: int) -> str:
        live = self.live(place)
        order = {"little": " LE", "big": " BE"}.get(row.endian, "") if len(row.type) > 2 else ""
        unit = "" if row.unit == "code" else f" {row.unit}"
        texts = (
            row.name,
            shown(row.place),
            f"{TYPE_WORDS.get(row.type, '')}{order}",
            f"{shown_number(live.value)}{unit}" if live else "",
            "",
            shown(f"{row.hint}, no channel" if row.hide and row.hint else row.hint),
        )
        return texts[column]

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        if orientation is not Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        names = (
            self.tr("Name"),
            self.tr("Bytes"),
            self.tr("Type"),
            self.tr("Value"),
            self.tr("Course"),
            self.tr("Looks like"),
        )
        return names[section]


class _CourseDelegate(QStyledItemDelegate):
    """A small chart of the latest values."""

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        super().paint(painter, option, index)
        model = index.model()
        live = model.live(index.row()) if isinstance(model, _Model) else None
        if live is None or len(live.course) < 2:
            return
        box = option.rect.adjusted(4, 4, -4, -4)  # pyright: ignore[reportAttributeAccessIssue]
        low, high = min(live.course), max(live.course)
        span = (high - low) or 1.0
        steps = len(live.course) - 1
        points = QPolygonF(
            [
                QPointF(
                    box.left() + box.width() * n / steps,
                    box.bottom() - box.height() * ((value - low) / span if high > low else 0.5),
                )
                for n, value in enumerate(live.course)
            ]
        )
        theme = current_theme()
        painter.save()
        painter.setPen(QPen(QColor(theme.accent), 1.0))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.drawPolyline(points)
        painter.restore()
