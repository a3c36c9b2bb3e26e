"""The coefficients of the harmonics as bars, each beside what noise alone would reach."""

import math

from PySide6.QtCore import QLineF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QWidget

from gui.languages.shown import shown, shown_number
from gui.tumble.state import BarsState, HarmonicBar
from gui.widgets.number_text import significant
from gui.widgets.painted_view import PaintedView
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme


class HarmonicsView(PaintedView):
    """Draws a `BarsState` over a logarithmic axis; what is not above its threshold is hollow."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__((30, 12), (14, 9), parent)
        self._state = BarsState((), "")

    def render(self, state: BarsState) -> None:
        """Show coefficients."""
        self._state = state
        self.setAccessibleName(self.tr("Harmonics"))
        seen = [f"{b.label} {significant(b.value, 3)}" for b in state.bars if b.seen]
        self.setAccessibleDescription(", ".join(seen))
        self.update()

    def paint(self, painter: QPainter, size: QSize) -> None:
        theme = current_theme()
        painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(theme.window))
        if not self._state.bars:
            return
        painter.setFont(self.font())
        metrics = painter.fontMetrics()
        unit = metrics.height()
        left = metrics.horizontalAdvance("10\u207b\u2070\u2070") + 1.2 * unit
        plot = QRectF(left, 1.9 * unit, size.width() - left - unit, size.height() - 3.6 * unit)
        painter.fillRect(plot, QColor(theme.base))
        painter.setPen(QColor(theme.muted))
        words = self.tr("|C|, {unit}; dashes: what noise alone exceeds in 1 % of cases")
        painter.drawText(
            QRectF(0.6 * unit, 0.3 * unit, size.width(), 1.4 * unit),
            Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
            words.format(unit=shown(self._state.unit)),
        )
        low, high = self._range()
        self._ground(painter, plot, low, high)
        each = plot.width() / len(self._state.bars)
        for place, bar in enumerate(self._state.bars):
            column = QRectF(plot.left() + place * each, plot.top(), each, plot.height())
            self._bar(painter, column, bar, low, high)
        painter.setPen(QColor(theme.line))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(plot)

    def _range(self) -> tuple[int, int]:
        """Decades from below the least threshold to above the largest value."""
        sizes = [abs(bar.value) for bar in self._state.bars]
        sizes += [bar.threshold for bar in self._state.bars if bar.threshold > 0]
        positive = [size for size in sizes if size > 0] or [1.0]
        high = math.ceil(math.log10(max(positive)) + 0.05)
        edges = [bar.threshold for bar in self._state.bars if bar.threshold > 0] or positive
        low = math.floor(math.log10(min(edges)) - 0.7)
        return low, max(high, low + 1)

    def _ground(self, painter: QPainter, plot: QRectF, low: int, high: int) -> None:
        theme = current_theme()
        unit = painter.fontMetrics().height()
        every = max(1, math.ceil((high - low) * 1.5 * unit / plot.height()))
        for power in range(low, high + 1):
            y = round(_place(plot, power, low, high))
            painter.setPen(QColor(theme.grid))
            painter.drawLine(QLineF(plot.left(), y, plot.right(), y))
            if (power - low) % every:
                continue
            painter.setPen(QColor(theme.muted))
            painter.drawText(
                QRectF(0, y - unit, plot.left() - 5, 2 * unit),
                Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
                f"10{_raised(power)}",
            )

    def _bar(
        self, painter: QPainter, column: QRectF, bar: HarmonicBar, low: int, high: int
    ) -> None:
        theme = current_theme()
        unit = painter.fontMetrics().height()
        painter.setPen(QColor(theme.muted))
        painter.drawText(
            QRectF(column.left() - unit, column.bottom() + 3, column.width() + 2 * unit, unit),
            Qt.AlignmentFlag.AlignCenter,
            bar.label,
        )
        size = abs(bar.value)
        top = _place(column, math.log10(size) if size > 0 else low, low, high)
        top = min(top, column.bottom())
        width = min(0.5 * column.width(), 3.0 * unit)
        solid = QRectF(column.center().x() - width / 2, top, width, column.bottom() - top)
        if bar.seen:
            painter.fillRect(solid, QColor(theme.curves[0]))
        else:
            painter.setPen(QPen(QColor(theme.muted), 1))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(solid)
        if bar.threshold > 0:
            y = _place(column, math.log10(bar.threshold), low, high)
            painter.setPen(QPen(QColor(theme.tones[Tone.DOUBT]), 1.5, Qt.PenStyle.DashLine))
            painter.drawLine(QLineF(solid.left() - 0.6 * unit, y, solid.right() + 0.6 * unit, y))
        if bar.seen:
            painter.setPen(QColor(theme.text))
            painter.drawText(
                QRectF(column.left() - unit, top - 1.3 * unit, column.width() + 2 * unit, unit),
                Qt.AlignmentFlag.AlignCenter,
                shown_number(significant(bar.value, 3)),
            )


def _place(plot: QRectF, power: float, low: int, high: int) -> float:
    # Room above the highest bar for its number.
    height = plot.height() - 18.0
    return plot.bottom() - (power - low) / (high - low) * height


def _raised(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
