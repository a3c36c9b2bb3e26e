"""Residuals round the turn: a circle is zero, out is positive, the shade is their interval."""

import math

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen
from PySide6.QtWidgets import QWidget

from core.units import RAD_PER_DEG
from gui.languages.shown import shown, shown_number
from gui.tumble.state import PolarSeries, PolarState
from gui.widgets.chart_scale import nice_step, tick_text
from gui.widgets.number_text import significant
from gui.widgets.painted_view import PaintedView
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme

_ZERO = 0.62
"""Radius of the zero circle, of the whole."""
_ROOM = 0.34
"""Half width of the ring in which residuals lie, of the whole."""
_SPOKE_DEG = 30
_MOST_NAMED = 6


class PolarView(PaintedView):
    """Draws a `PolarState`; 0 degrees is level at the right, 90 degrees is up."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__((30, 24), (14, 13), parent)
        self._state = PolarState((), "")

    def render(self, state: PolarState) -> None:
        """Show residuals."""
        self._state = state
        self.setAccessibleName(self.tr("Residuals by elevation"))
        worst = max((float(np.abs(s.residual).max()) for s in state.series), default=0.0)
        words = self.tr("largest residual {value} {unit}")
        self.setAccessibleDescription(words.format(value=significant(worst, 2), unit=state.unit))
        self.update()

    def paint(self, painter: QPainter, size: QSize) -> None:
        theme = current_theme()
        painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(theme.window))
        if not self._state.series:
            return
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(self.font())
        unit = painter.fontMetrics().height()
        head = self._head(painter, size, unit)
        radius = min(size.width() / 2.0 - 3.2 * unit, (size.height() - head) / 2.0 - 1.4 * unit)
        middle = QPointF(size.width() / 2.0, head + (size.height() - head) / 2.0)
        step = nice_step(2.0 * self._reach(), 4)
        reach = max(step, math.ceil(self._reach() / step - 1e-9) * step)
        scale = _ROOM * radius / reach
        self._band(painter, middle, radius, scale)
        self._ground(painter, middle, radius, unit)
        self._rings(painter, middle, radius, scale, step, reach, unit)
        for place, series in enumerate(self._state.series):
            self._points(painter, middle, radius, scale, series, place)

    def _reach(self) -> float:
        sizes = [
            float(np.nanmax(np.abs(values)))
            for series in self._state.series
            for values in (series.residual, series.u95)
            if np.any(np.isfinite(values))
        ]
        return max(sizes, default=0.0) or 1.0

    def _head(self, painter: QPainter, size: QSize, unit: int) -> float:
        """What is drawn, and which colour is what; return the height that it takes."""
        theme = current_theme()
        painter.setPen(QColor(theme.muted))
        words = self.tr("Residuals, {unit}; out is positive, shade: ±U (95 %)")
        line = QRectF(0.6 * unit, 0.3 * unit, size.width() - 1.2 * unit, 1.4 * unit)
        middle = Qt.AlignmentFlag.AlignVCenter
        painter.drawText(
            line, Qt.AlignmentFlag.AlignLeft | middle, words.format(unit=shown(self._state.unit))
        )
        if not 1 < len(self._state.series) <= _MOST_NAMED:
            return 1.9 * unit
        metrics = painter.fontMetrics()
        x, y = 0.6 * unit, 2.5 * unit
        for place, series in enumerate(self._state.series):
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(theme.curves[place % len(theme.curves)]))
            painter.drawEllipse(QPointF(x + 0.3 * unit, y), 3.0, 3.0)
            painter.setPen(QColor(theme.text))
            width = metrics.horizontalAdvance(series.name)
            painter.drawText(
                QRectF(x + 0.8 * unit, y - unit, width + unit, 2 * unit),
                Qt.AlignmentFlag.AlignLeft | middle,
                series.name,
            )
            x += width + 2.0 * unit
        return 3.3 * unit

    def _ground(self, painter: QPainter, middle: QPointF, radius: float, unit: int) -> None:
        """Spokes with their elevations."""
        theme = current_theme()
        for angle in range(0, 360, _SPOKE_DEG):
            direction = _direction(angle)
            painter.setPen(QPen(QColor(theme.grid), 1))
            inner = middle + direction * (radius * (_ZERO - _ROOM))
            painter.drawLine(inner, middle + direction * (radius * (_ZERO + _ROOM)))
            painter.setPen(QColor(theme.muted))
            at = middle + direction * (radius * (_ZERO + _ROOM) + 1.1 * unit)
            painter.drawText(
                QRectF(at.x() - 3 * unit, at.y() - unit, 6 * unit, 2 * unit),
                Qt.AlignmentFlag.AlignCenter,
                f"{angle}°",
            )

    def _rings(
        self,
        painter: QPainter,
        middle: QPointF,
        radius: float,
        scale: float,
        step: float,
        reach: float,
        unit: int,
    ) -> None:
        theme = current_theme()
        count = round(reach / step)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for number in range(-count, count + 1):
            ring = radius * _ZERO + number * step * scale
            zero = number == 0
            painter.setPen(QPen(QColor(theme.muted if zero else theme.grid), 1))
            painter.drawEllipse(middle, ring, ring)
            if zero or abs(number) == count:
                painter.setPen(QColor(theme.muted))
                text = "0" if zero else shown_number(tick_text(number * step, step))
                at = middle + _direction(75.0) * ring
                box = QRectF(at.x() - 4 * unit, at.y() - 0.6 * unit, 8 * unit, 1.2 * unit)
                width = painter.fontMetrics().horizontalAdvance(text) + 4
                ground = QRectF(0, 0, width, unit)
                ground.moveCenter(box.center())
                painter.fillRect(ground, QColor(theme.window))
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def _band(self, painter: QPainter, middle: QPointF, radius: float, scale: float) -> None:
        """The interval of the first realisation all round."""
        u95 = self._state.series[0].u95
        if not np.any(np.isfinite(u95)):
            return
        half = float(np.nanmedian(u95)) * scale
        path = QPainterPath()
        path.setFillRule(Qt.FillRule.OddEvenFill)
        outer, inner = radius * _ZERO + half, max(radius * _ZERO - half, 0.0)
        path.addEllipse(middle, outer, outer)
        path.addEllipse(middle, inner, inner)
        theme = current_theme()
        painter.fillPath(path, QColor(theme.tints[Tone.ACTION]))

    def _points(
        self,
        painter: QPainter,
        middle: QPointF,
        radius: float,
        scale: float,
        series: PolarSeries,
        place: int,
    ) -> None:
        theme = current_theme()
        colour = QColor(theme.curves[place % len(theme.curves)])
        rows = zip(series.alpha_deg, series.residual, series.u95, strict=True)
        for alpha, residual, u95 in rows:
            at = middle + _direction(float(alpha)) * (radius * _ZERO + float(residual) * scale)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(colour)
            painter.drawEllipse(at, 2.4, 2.4)
            if abs(residual) > u95:
                painter.setPen(QPen(QColor(theme.tones[Tone.BAD]), 1))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawEllipse(at, 4.4, 4.4)


def _direction(angle_deg: float) -> QPointF:
    angle = angle_deg * RAD_PER_DEG
    return QPointF(math.cos(angle), -math.sin(angle))
