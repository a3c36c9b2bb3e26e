"""The signs that stand beside every colour, drawn so that no icon file or font is needed."""

import math

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QTransform

from core.errors import Severity
from gui.widgets.states import StepMark, Tone


def paint_tone(painter: QPainter, rect: QRectF, tone: Tone, colour: str) -> None:
    """Draw the sign of a tone: ring, arrow, hourglass, tick, or triangle with a bar."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    side = min(rect.width(), rect.height())
    painter.translate(rect.center())
    painter.scale(side / 2.0, side / 2.0)
    pen = QPen(QColor(colour), 0.2)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    painter.setPen(pen)
    _SIGNS[tone](painter, QColor(colour))
    painter.restore()


_MARK_TONE = {
    StepMark.DONE: Tone.GOOD,
    StepMark.NOW: Tone.ACTION,
    StepMark.PROBLEM: Tone.BAD,
    StepMark.TO_COME: Tone.IDLE,
}


def tone_of_mark(mark: StepMark) -> Tone:
    """Return the tone whose colour a step's mark has."""
    return _MARK_TONE[mark]


def paint_mark(painter: QPainter, rect: QRectF, mark: StepMark, colour: str) -> None:
    """Draw where a step stands: full disc, arrow head, ring, or triangle with a bar."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    side = min(rect.width(), rect.height())
    painter.translate(rect.center())
    painter.scale(side / 2.0, side / 2.0)
    painter.setPen(QPen(QColor(colour), 0.22))
    if mark is StepMark.DONE:
        painter.setBrush(QColor(colour))
        painter.drawEllipse(QPointF(0, 0), 0.62, 0.62)
    elif mark is StepMark.TO_COME:
        painter.drawEllipse(QPointF(0, 0), 0.62, 0.62)
    elif mark is StepMark.NOW:
        path = QPainterPath(QPointF(-0.55, -0.8))
        path.lineTo(0.8, 0.0)
        path.lineTo(-0.55, 0.8)
        path.closeSubpath()
        painter.fillPath(path, QColor(colour))
    else:
        _warn(painter, QColor(colour))
    painter.restore()


_SEVERITY_TONE = {
    Severity.INFO: Tone.ACTION,
    Severity.WARNING: Tone.DOUBT,
    Severity.ERROR: Tone.BAD,
}


def tone_of_severity(severity: Severity) -> Tone:
    """Return the tone in whose colours a severity is shown."""
    return _SEVERITY_TONE[severity]


def paint_severity(painter: QPainter, rect: QRectF, severity: Severity, colour: str) -> None:
    """Draw the sign of a severity: disc with an i, triangle with a bar, disc with a cross."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    side = min(rect.width(), rect.height())
    painter.translate(rect.center())
    painter.scale(side / 2.0, side / 2.0)
    if severity is Severity.WARNING:
        _warn(painter, QColor(colour))
    else:
        disc = QPainterPath()
        disc.setFillRule(Qt.FillRule.OddEvenFill)
        disc.addEllipse(QPointF(0, 0), 0.9, 0.9)
        if severity is Severity.INFO:
            disc.addEllipse(QPointF(0, -0.45), 0.15, 0.15)
            disc.addRect(QRectF(-0.12, -0.15, 0.24, 0.7))
        else:
            cross = QPainterPath()
            cross.setFillRule(Qt.FillRule.WindingFill)
            cross.addRect(QRectF(-0.55, -0.11, 1.1, 0.22))
            cross.addRect(QRectF(-0.11, -0.55, 0.22, 1.1))
            disc.addPath(QTransform().rotate(45).map(cross.simplified()))
        painter.fillPath(disc, QColor(colour))
    painter.restore()


def _idle(painter: QPainter, colour: QColor) -> None:  # noqa: ARG001
    painter.drawEllipse(QPointF(0, 0), 0.62, 0.62)


def _turn(painter: QPainter, colour: QColor) -> None:
    """An arrow that goes round clockwise, as the picture turns."""
    radius = 0.66
    painter.drawArc(QRectF(-radius, -radius, 2 * radius, 2 * radius), 60 * 16, 270 * 16)
    angle = math.radians(60)
    tip = QPointF(radius * math.cos(angle), -radius * math.sin(angle))
    path = QPainterPath(tip + QPointF(0.42, 0.20))
    path.lineTo(tip + QPointF(-0.12, 0.36))
    path.lineTo(tip + QPointF(0.06, -0.34))
    path.closeSubpath()
    painter.fillPath(path, colour)


def _hourglass(painter: QPainter, colour: QColor) -> None:
    path = QPainterPath(QPointF(-0.55, -0.8))
    for x, y in ((0.55, -0.8), (-0.55, 0.8), (0.55, 0.8)):
        path.lineTo(x, y)
    path.closeSubpath()
    painter.drawPath(path)
    sand = QPainterPath(QPointF(0, 0.1))
    sand.lineTo(0.5, 0.78)
    sand.lineTo(-0.5, 0.78)
    sand.closeSubpath()
    painter.fillPath(sand, colour)


def _tick(painter: QPainter, colour: QColor) -> None:  # noqa: ARG001
    path = QPainterPath(QPointF(-0.7, 0.05))
    path.lineTo(-0.2, 0.6)
    path.lineTo(0.75, -0.6)
    pen = painter.pen()
    pen.setWidthF(0.28)
    painter.setPen(pen)
    painter.drawPath(path)


def _warn(painter: QPainter, colour: QColor) -> None:
    path = QPainterPath(QPointF(0.0, -0.85))
    path.lineTo(0.92, 0.75)
    path.lineTo(-0.92, 0.75)
    path.closeSubpath()
    path.addRect(QRectF(-0.1, -0.35, 0.2, 0.55))
    path.addEllipse(QPointF(0, 0.45), 0.13, 0.13)
    painter.fillPath(path, colour)


_SIGNS = {
    Tone.IDLE: _idle,
    Tone.ACTION: _turn,
    Tone.BUSY: _hourglass,
    Tone.DOUBT: _warn,
    Tone.GOOD: _tick,
    Tone.BAD: _warn,
}
