"""The ladder: what is left of the gap on each rung, against the noise floor."""

import math

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from gui.discrepancy.grade_view import Light
from gui.discrepancy.state import RungState
from gui.languages.shown import shown, shown_number
from gui.widgets.colours import blend
from gui.widgets.number_text import fixed
from gui.widgets.page_scroll import PageScroll
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme
from gui.widgets.word_label import paragraph

_LEAST, _WIDEST = 0.5, 3.0
_NEAR_FLOOR = 1.3


class GapBar(QWidget):
    """What is left of the gap, on a logarithmic scale with the noise floor at 1.

    Parameters
    ----------
    rung : which
    largest : end of the scale, in noise floors
    """

    def __init__(self, rung: RungState, largest: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rung = rung
        self._largest = largest
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(self.tr("gap {gap}").format(gap=shown_number(fixed(rung.gap, 2))))
        self.setToolTip(
            self.tr("Gap {gap} noise floors; rows left out of the fit: {held}").format(
                gap=shown_number(fixed(rung.gap, 2)), held=shown_number(fixed(rung.held_out, 2))
            )
        )

    def sizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(14 * unit, round(1.5 * unit))

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw on any painter, for export."""
        theme = current_theme()
        unit = painter.fontMetrics().height()
        room = size.width() - 3.2 * unit
        whole = QRectF(0, 0.15 * unit, room, size.height() - 0.3 * unit)
        painter.fillRect(whole, QColor(theme.grid))
        tone = Tone.GOOD if self._rung.gap < _NEAR_FLOOR else Tone.BAD
        colour = QColor(theme.tones[tone])
        bar = QRectF(whole.left(), whole.top(), room * self._share(self._rung.gap), whole.height())
        if self._rung.proposed:
            painter.fillRect(bar, blend(theme.tones[tone], theme.base, 0.35))
            painter.setPen(QPen(colour, 1, Qt.PenStyle.DashLine))
            painter.drawRect(bar.adjusted(0, 0, -1, -1))
        else:
            painter.fillRect(bar, colour)
        if math.isfinite(self._rung.held_out):
            x = room * self._share(self._rung.held_out)
            painter.setPen(QPen(QColor(theme.text), 2))
            painter.drawLine(QPointF(x, whole.top()), QPointF(x, whole.bottom()))
        floor = room * self._share(1.0)
        painter.setPen(QPen(QColor(theme.text), 1, Qt.PenStyle.DotLine))
        painter.drawLine(QPointF(floor, 0), QPointF(floor, size.height()))
        painter.setPen(QColor(theme.text))
        font = painter.font()
        font.setBold(True)
        painter.setFont(font)
        painter.drawText(
            QRectF(room + 0.3 * unit, 0, 2.9 * unit, size.height()),
            Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
            shown_number(fixed(self._rung.gap, 2)),
        )

    def _share(self, gap: float) -> float:
        if not math.isfinite(gap):
            return 0.0
        span = math.log(self._largest / _LEAST)
        return min(max(math.log(max(gap, _LEAST) / _LEAST) / span, 0.0), 1.0)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        painter = QPainter(self)
        self.paint(painter, self.size())
        painter.end()


class RungView(QWidget):
    """One rung: title, bar, numbers, and the way back."""

    undone = Signal(int)
    """Number of a rung that is taken back, with all above it."""

    def __init__(self, rung: RungState, largest: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._number = rung.number
        unit = self.fontMetrics().height()
        added, _, name = rung.title.partition("+ ")
        title = paragraph(rung.title if added else f"+ {shown(name)}", bold=True)
        head = QHBoxLayout()
        head.addWidget(title, 1)
        if rung.proposed:
            head.addWidget(paragraph(self.tr("proposed"), muted=True), 0, Qt.AlignmentFlag.AlignTop)
        elif rung.number and not rung.kept:
            back = QToolButton()
            back.setText("✕")
            back.setAutoRaise(True)
            back.setToolTip(self.tr("Take it back, with all above it"))
            back.setAccessibleName(self.tr("Take back {title}").format(title=shown(rung.title)))
            back.clicked.connect(self._on_back)
            head.addWidget(back, 0, Qt.AlignmentFlag.AlignTop)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, unit // 3, 0, unit // 3)
        column.setSpacing(unit // 6)
        column.addLayout(head)
        if rung.certainty:
            sure = QHBoxLayout()
            sure.setSpacing(unit // 4)
            sure.addWidget(Light(rung.tone), 0, Qt.AlignmentFlag.AlignTop)
            sure.addWidget(paragraph(rung.certainty), 1)
            column.addLayout(sure)
        column.addWidget(GapBar(rung, largest))
        facts = " · ".join(shown(fact) for fact in rung.facts)
        column.addWidget(paragraph(facts, muted=True))
        for line in rung.parameters:
            column.addWidget(paragraph(line))

    def _on_back(self) -> None:
        self.undone.emit(self._number)


class LadderView(QWidget):
    """All rungs, the plain model on top."""

    undone = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rungs: tuple[RungState, ...] = ()
        unit = self.fontMetrics().height()
        self._title, self._legend = QLabel(), QLabel()
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._legend.setWordWrap(True)
        self._legend.setForegroundRole(self._legend.palette().ColorRole.PlaceholderText)
        self._page = QWidget()
        self._column = QVBoxLayout(self._page)
        self._column.setContentsMargins(unit // 2, 0, unit // 2, 0)
        self._column.setSpacing(unit // 4)
        self._column.addStretch(1)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, unit // 2, 0, 0)
        rows.setSpacing(unit // 6)
        for label in (self._title, self._legend):
            label.setContentsMargins(unit // 2, 0, unit // 2, 0)
            rows.addWidget(label)
        rows.addWidget(PageScroll(self._page), 1)
        self._retranslate()

    def render(self, rungs: tuple[RungState, ...]) -> None:
        """Show a ladder."""
        if rungs == self._rungs:
            return
        self._rungs = rungs
        while self._column.count() > 1:
            item = self._column.takeAt(0)
            if item is not None and (old := item.widget()) is not None:
                old.hide()
                old.deleteLater()
        largest = largest_of(rungs)
        for place, rung in enumerate(rungs):
            view = RungView(rung, largest)
            view.undone.connect(self.undone)
            self._column.insertWidget(place, view)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            rungs, self._rungs = self._rungs, ()
            self.render(rungs)

    def _retranslate(self) -> None:
        self._title.setText(self.tr("The ladder"))
        self._legend.setText(
            self.tr("Bars: gap in noise floors (dotted: the floor, 1). Stroke: rows left out.")
        )


def largest_of(rungs: tuple[RungState, ...]) -> float:
    """End of the scale of all bars."""
    sizes = [size for rung in rungs for size in (rung.gap, rung.held_out) if math.isfinite(size)]
    return max([_WIDEST, *(1.05 * size for size in sizes)])
