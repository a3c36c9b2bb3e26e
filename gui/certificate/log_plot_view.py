"""Deviations over averaging times, both axes logarithmic, as they are drawn on paper."""

import math
from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QApplication

from gui.languages.shown import shown
from gui.measuring.page import LogCurveState
from gui.widgets.theme import current_theme

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_DOT = 2.2


class LogPlot:
    """Points with their limits, and the lines of a model.

    Parameters
    ----------
    state : what is drawn
    """

    def __init__(self, state: LogCurveState) -> None:
        self._state = state
        every = (*state.low, *state.high, *state.y)
        self._x = _decades(state.x)
        self._y = _decades(every)

    def accessibleName(self) -> str:
        """What the picture shows."""
        return shown(self._state.title)

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw."""
        theme = current_theme()
        painter.setFont(QApplication.font())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        unit = painter.fontMetrics().height()
        painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(theme.base))
        plot = QRectF(4.5 * unit, 1.8 * unit, size.width() - 5.5 * unit, size.height() - 4.6 * unit)
        self._ground(painter, plot, unit)
        painter.setClipRect(plot)
        for number, (_, x, y) in enumerate(self._state.lines):
            colour = QColor(theme.curves[number % len(theme.curves)])
            painter.setPen(
                QPen(colour, 1.0, Qt.PenStyle.DashLine if number else Qt.PenStyle.SolidLine)
            )
            points = [self._spot(plot, *one) for one in zip(x, y, strict=True) if min(one) > 0]
            painter.drawPolyline(QPolygonF(points))
        self._points(painter, plot)
        painter.setClipping(False)
        self._legend(painter, plot, unit)

    def _points(self, painter: QPainter, plot: QRectF) -> None:
        state, ink = self._state, QColor(current_theme().text)
        painter.setPen(QPen(ink, 1.0))
        painter.setBrush(ink)
        for x, y, low, high in zip(state.x, state.y, state.low, state.high, strict=True):
            if not min(x, y) > 0:
                continue
            spot = self._spot(plot, x, y)
            bottom = self._spot(plot, x, low).y() if low > 0 else plot.bottom()
            painter.drawLine(QPointF(spot.x(), bottom), self._spot(plot, x, high))
            painter.drawEllipse(spot, _DOT, _DOT)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _ground(self, painter: QPainter, plot: QRectF, unit: int) -> None:
        theme = current_theme()
        for power in range(self._x[0], self._x[1] + 1):
            x = self._spot(plot, 10.0**power, 1.0).x()
            painter.setPen(QColor(theme.grid))
            painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()))
            painter.setPen(QColor(theme.text))
            place = QRectF(x - 2 * unit, plot.bottom() + 2, 4 * unit, unit)
            painter.drawText(place, Qt.AlignmentFlag.AlignCenter, _power(power))
        for power in range(self._y[0], self._y[1] + 1):
            y = self._spot(plot, 1.0, 10.0**power).y()
            painter.setPen(QColor(theme.grid))
            painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y))
            painter.setPen(QColor(theme.text))
            place = QRectF(0, y - unit, plot.left() - 4, 2 * unit)
            side = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
            painter.drawText(place, side, _power(power))
        painter.setPen(QColor(theme.field))
        painter.drawRect(plot)
        painter.setPen(QColor(theme.text))
        below = QRectF(plot.left(), plot.bottom() + 1.3 * unit, plot.width(), 1.2 * unit)
        painter.drawText(below, Qt.AlignmentFlag.AlignCenter, shown(self._state.x_label))
        above = QRectF(0, 0, plot.right(), 1.5 * unit)
        left = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(above, left, shown(self._state.y_label))

    def _legend(self, painter: QPainter, plot: QRectF, unit: int) -> None:
        theme = current_theme()
        x = plot.right()
        middle = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for number, (name, _, _) in reversed(list(enumerate(self._state.lines))):
            width = painter.fontMetrics().horizontalAdvance(shown(name))
            painter.setPen(QColor(theme.text))
            painter.drawText(QRectF(x - width, 0, width, 1.5 * unit), middle, shown(name))
            colour = QColor(theme.curves[number % len(theme.curves)])
            painter.setPen(QPen(colour, 1.6))
            end = x - width - 0.4 * unit
            painter.drawLine(QPointF(end - unit, 0.75 * unit), QPointF(end, 0.75 * unit))
            x = end - 2.0 * unit

    def _spot(self, plot: QRectF, x: float, y: float) -> QPointF:
        across = (math.log10(x) - self._x[0]) / (self._x[1] - self._x[0])
        up = (math.log10(y) - self._y[0]) / (self._y[1] - self._y[0])
        return QPointF(plot.left() + across * plot.width(), plot.bottom() - up * plot.height())


def _decades(values: Sequence[float]) -> tuple[int, int]:
    """The whole powers of ten around some values."""
    known = [value for value in values if math.isfinite(value) and value > 0]
    if not known:
        return 0, 1
    low, high = math.floor(math.log10(min(known))), math.ceil(math.log10(max(known)))
    return low, max(high, low + 1)


def _power(power: int) -> str:
    return "10" + str(power).translate(_SUPERSCRIPTS)
