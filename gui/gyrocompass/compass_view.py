"""A compass seen from above: readings, heading, and the wedge of its uncertainty."""

import math

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen
from PySide6.QtWidgets import QWidget

from core.units import RAD_PER_DEG
from gui.gyrocompass.state import RoseState
from gui.languages.shown import shown_number
from gui.widgets.number_text import value_and_uncertainty
from gui.widgets.painted_view import PaintedView
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme

_LEAST_WEDGE_DEG = 6.0
"""A wedge that is narrower is drawn ten, a hundred, ... times as wide."""
_POINTS = {0: "N", 90: "E", 180: "S", 270: "W"}


class CompassView(PaintedView):
    """Draws a `RoseState`; north is up, clockwise is positive."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__((26, 22), (14, 13), parent)
        self._state = RoseState()

    def render(self, state: RoseState) -> None:
        """Show a heading."""
        self._state = state
        self.setAccessibleName(self.tr("Compass"))
        self.setAccessibleDescription(self._words())
        self.update()

    def paint(self, painter: QPainter, size: QSize) -> None:
        theme = current_theme()
        painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(theme.window))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(self.font())
        unit = painter.fontMetrics().height()
        head = 2.6 * unit
        # Below stands how the wedge is drawn.
        height = size.height() - head - 1.4 * unit
        radius = min(size.width(), height) / 2.0 - 2.0 * unit
        middle = QPointF(size.width() / 2.0, head + height / 2.0)
        self._rose(painter, middle, radius, unit)
        self._readings(painter, middle, radius, unit)
        if math.isfinite(self._state.heading_deg):
            self._wedge(painter, middle, radius, size, unit)
            self._arrow(painter, middle, radius, unit)
        painter.setPen(QColor(theme.text))
        font = painter.font()
        font.setPointSizeF(font.pointSizeF() * 1.4)
        font.setBold(True)
        painter.setFont(font)
        painter.drawText(
            QRectF(0.6 * unit, 0.2 * unit, size.width(), 2.2 * unit),
            Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
            self._words(),
        )

    def _words(self) -> str:
        state = self._state
        if not math.isfinite(state.heading_deg):
            return self.tr("Heading: not measured yet")
        half = 0.5 * (state.high_deg - state.low_deg)
        value, width = map(shown_number, value_and_uncertainty(state.heading_deg, half))
        return self.tr("Heading {value}° ± {half}°").format(value=value, half=width)

    def _rose(self, painter: QPainter, middle: QPointF, radius: float, unit: int) -> None:
        theme = current_theme()
        painter.setBrush(QColor(theme.base))
        painter.setPen(QPen(QColor(theme.line), 1))
        painter.drawEllipse(middle, radius, radius)
        for angle in range(0, 360, 10):
            strong = angle % 30 == 0
            length = 0.7 * unit if strong else 0.35 * unit
            direction = _direction(angle)
            painter.setPen(QPen(QColor(theme.muted if strong else theme.line), 1))
            painter.drawLine(
                QLineF(middle + direction * (radius - length), middle + direction * radius)
            )
            if not strong:
                continue
            cardinal = angle in _POINTS
            font = self.font()
            font.setBold(cardinal)
            painter.setFont(font)
            painter.setPen(QColor(theme.text if cardinal else theme.muted))
            at = middle + direction * (radius + 1.0 * unit)
            painter.drawText(
                QRectF(at.x() - 2 * unit, at.y() - unit, 4 * unit, 2 * unit),
                Qt.AlignmentFlag.AlignCenter,
                _POINTS.get(angle, f"{angle}°"),
            )
        painter.setFont(self.font())

    def _readings(self, painter: QPainter, middle: QPointF, radius: float, unit: int) -> None:
        """Where the input axis pointed at each reading; without a heading, the plan."""
        theme = current_theme()
        measured = math.isfinite(self._state.heading_deg)
        style = Qt.PenStyle.SolidLine if measured else Qt.PenStyle.DashLine
        painter.setPen(QPen(QColor(theme.curves[0]), 1.2, style))
        for azimuth in self._state.readings_deg:
            direction = _direction(azimuth)
            outer = middle + direction * (radius - 1.2 * unit)
            painter.drawLine(QLineF(middle + direction * (0.25 * radius), outer))
            painter.setBrush(QColor(theme.curves[0]))
            painter.drawEllipse(outer, 3.0, 3.0)

    def _wedge(
        self, painter: QPainter, middle: QPointF, radius: float, size: QSize, unit: int
    ) -> None:
        """The 95 % interval; a narrow one many times as wide, and the words say so."""
        theme = current_theme()
        state = self._state
        low, high = state.low_deg - state.heading_deg, state.high_deg - state.heading_deg
        wider = 1
        while (high - low) * wider < _LEAST_WEDGE_DEG and high > low:
            wider *= 10
        low, high = max(low * wider, -180.0), min(high * wider, 180.0)
        reach = radius - 0.9 * unit
        box = QRectF(middle.x() - reach, middle.y() - reach, 2 * reach, 2 * reach)
        path = QPainterPath(middle)
        # Qt counts counter-clockwise from the right.
        path.arcTo(box, 90.0 - (state.heading_deg + high), high - low)
        path.closeSubpath()
        tint = QColor(theme.tones[Tone.ACTION])
        tint.setAlphaF(0.30)
        painter.fillPath(path, tint)
        if wider > 1:
            painter.setPen(QColor(theme.muted))
            words = self.tr("wedge: 95 %, drawn {count} times as wide")
            painter.drawText(
                QRectF(
                    0.6 * unit, size.height() - 1.6 * unit, size.width() - 1.2 * unit, 1.4 * unit
                ),
                Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
                words.format(count=wider),
            )

    def _arrow(self, painter: QPainter, middle: QPointF, radius: float, unit: int) -> None:
        theme = current_theme()
        direction = _direction(self._state.heading_deg)
        side = QPointF(-direction.y(), direction.x())
        tip = middle + direction * (radius - 0.9 * unit)
        painter.setPen(QPen(QColor(theme.accent), 2.4))
        painter.drawLine(QLineF(middle - direction * (0.3 * radius), tip))
        head = QPainterPath(tip)
        head.lineTo(tip - direction * (1.1 * unit) + side * (0.45 * unit))
        head.lineTo(tip - direction * (1.1 * unit) - side * (0.45 * unit))
        head.closeSubpath()
        painter.fillPath(head, QColor(theme.accent))


def _direction(azimuth_deg: float) -> QPointF:
    angle = azimuth_deg * RAD_PER_DEG
    return QPointF(math.sin(angle), -math.cos(angle))
