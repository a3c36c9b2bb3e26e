"""The steps of a plan: where each one stands, its picture, what was measured."""

from collections.abc import Sequence

from PySide6.QtCore import QAbstractListModel, QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt
from PySide6.QtCore import Signal as QtSignal
from PySide6.QtGui import QColor, QFont, QKeyEvent, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from gui.languages.shown import shown
from gui.widgets.icons import paint_mark, tone_of_mark
from gui.widgets.position_picture import describe, paint_pose
from gui.widgets.states import StepMark, StepState
from gui.widgets.theme import current_theme

_PICTURE_PX = 64


class StepList(QListView):
    """List of steps; `chosen` tells the row that the operator picked.

    A click, Enter, or a digit picks. Moving with the arrows only looks.
    """

    chosen = QtSignal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._steps = _Steps(self)
        self.setModel(self._steps)
        self.setItemDelegate(_StepDelegate(self))
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setMouseTracking(True)
        self.clicked.connect(self._on_clicked)

    def render(self, steps: Sequence[StepState]) -> None:
        """Show these steps; the one that is `NOW` is made current and scrolled to."""
        before = self._steps.now()
        self._steps.replace(tuple(steps))
        now = self._steps.now()
        if now is not None and now != before:
            index = self._steps.index(now)
            self.setCurrentIndex(index)
            self.scrollTo(index, QAbstractItemView.ScrollHint.EnsureVisible)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        row = self.currentIndex().row()
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if row >= 0:
                self.chosen.emit(row)
            return
        digit = event.key() - Qt.Key.Key_1
        if 0 <= digit <= 8 and not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            if digit < self._steps.rowCount():
                self.setCurrentIndex(self._steps.index(digit))
                self.chosen.emit(digit)
            return
        super().keyPressEvent(event)

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 40, 400)

    def _on_clicked(self, index: QModelIndex) -> None:
        self.chosen.emit(index.row())


class _Steps(QAbstractListModel):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._steps: tuple[StepState, ...] = ()

    def replace(self, steps: tuple[StepState, ...]) -> None:
        old = self._steps
        if len(steps) != len(old):
            self.beginResetModel()
            self._steps = steps
            self.endResetModel()
            return
        self._steps = steps
        for row, (before, after) in enumerate(zip(old, steps, strict=True)):
            if before != after:
                self.dataChanged.emit(self.index(row), self.index(row))

    def now(self) -> int | None:
        rows = (row for row, step in enumerate(self._steps) if step.mark is StepMark.NOW)
        return next(rows, None)

    def step(self, row: int) -> StepState:
        return self._steps[row]

    def starts_group(self, row: int) -> bool:
        group = self._steps[row].group
        return bool(group) and (row == 0 or self._steps[row - 1].group != group)

    def rowCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._steps)

    def data(
        self,
        index: QModelIndex | QPersistentModelIndex,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> object:
        step = self._steps[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return shown(step.label)
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return ", ".join(
                shown(part) for part in (step.group, step.label, step.mark.value, step.values)
            )
        if role == Qt.ItemDataRole.ToolTipRole:
            lines = [
                shown(step.label),
                shown(step.values),
                describe(step.pose) if step.pose else "",
            ]
            return "\n".join(line for line in lines if line)
        return None


class _StepDelegate(QStyledItemDelegate):
    """Sign, picture, label over values, and the count of replicates at the right."""

    def __init__(self, parent: StepList) -> None:
        super().__init__(parent)
        self._list = parent

    def sizeHint(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        unit = option.fontMetrics.height()  # type: ignore[attr-defined]
        model = self._model()
        step = model.step(index.row())
        height = _PICTURE_PX + 6 if step.pose is not None else round(2.9 * unit)
        if model.starts_group(index.row()):
            height += self._heading(unit)
        return QSize(unit * 12, height)

    def _model(self) -> _Steps:
        model = self._list.model()
        if not isinstance(model, _Steps):
            raise TypeError("a step list shows steps only")
        return model

    @staticmethod
    def _heading(unit: int) -> int:
        return round(1.9 * unit)

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        theme = current_theme()
        model = self._model()
        step = model.step(index.row())
        rect = QRectF(option.rect)  # type: ignore[attr-defined]
        font = QFont(option.font)  # type: ignore[attr-defined]
        metrics = option.fontMetrics  # type: ignore[attr-defined]
        unit = metrics.height()
        painter.save()
        if model.starts_group(index.row()):
            head = QRectF(rect)
            head.setHeight(self._heading(unit))
            rect.setTop(head.bottom())
            small = QFont(font)
            small.setBold(True)
            painter.setFont(small)
            painter.setPen(QColor(theme.muted))
            painter.drawText(
                head.adjusted(unit * 0.6, 0, 0, -unit * 0.25),
                Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom,
                shown(step.group),
            )
        self._background(painter, rect, option, step)
        tone = tone_of_mark(step.mark)
        sign = QRectF(rect.left() + 0.6 * unit, 0, 0.9 * unit, 0.9 * unit)
        sign.moveCenter(QRectF(sign.left(), rect.top(), sign.width(), rect.height()).center())
        paint_mark(painter, sign, step.mark, theme.tones[tone])
        left = sign.right() + 0.6 * unit
        if step.pose is not None:
            picture = QRectF(left, rect.top() + 3, _PICTURE_PX, _PICTURE_PX)
            painter.setFont(font)
            paint_pose(painter, picture, step.pose, theme)
            left = picture.right() + 0.5 * unit
        self._words(
            painter, QRectF(left, rect.top(), rect.right() - left, rect.height()), step, font
        )
        painter.restore()

    def _background(
        self, painter: QPainter, rect: QRectF, option: QStyleOptionViewItem, step: StepState
    ) -> None:
        theme = current_theme()
        state = option.state  # type: ignore[attr-defined]
        if step.mark is StepMark.NOW:
            painter.fillRect(rect, QColor(theme.tints[tone_of_mark(step.mark)]))
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(rect, QColor(theme.alternate))
        if state & QStyle.StateFlag.State_Selected:
            focused = bool(state & QStyle.StateFlag.State_HasFocus)
            painter.setPen(QColor(theme.accent if focused else theme.line))
            painter.drawRect(rect.adjusted(0.5, 0.5, -1.5, -1.5))
        painter.setPen(QColor(theme.grid))
        painter.drawLine(rect.bottomLeft(), rect.bottomRight())

    def _words(self, painter: QPainter, rect: QRectF, step: StepState, font: QFont) -> None:
        theme = current_theme()
        metrics = painter.fontMetrics()
        unit = metrics.height()
        rect = rect.adjusted(0, 0, -0.6 * unit, 0)
        if step.replicates > 1:
            painter.setFont(font)
            painter.setPen(QColor(theme.muted))
            count = f"×{step.replicates}"
            painter.drawText(
                rect, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, count
            )
            rect.setRight(rect.right() - metrics.horizontalAdvance(count) - 0.4 * unit)
        bold = QFont(font)
        bold.setBold(step.mark is StepMark.NOW)
        lines = [(shown(step.label), bold, theme.text)]
        if step.values:
            tone = theme.tones[tone_of_mark(step.mark)]
            lines.append(
                (shown(step.values), font, tone if step.mark is StepMark.PROBLEM else theme.muted)
            )
        top = rect.center().y() - 0.55 * unit * len(lines)
        for number, (text, face, colour) in enumerate(lines):
            painter.setFont(face)
            painter.setPen(QColor(colour))
            place = QRectF(rect.left(), top + number * 1.1 * unit, rect.width(), 1.1 * unit)
            elided = painter.fontMetrics().elidedText(
                text, Qt.TextElideMode.ElideRight, int(rect.width())
            )
            painter.drawText(
                place, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, elided
            )
