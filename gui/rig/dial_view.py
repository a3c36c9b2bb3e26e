"""The dividing head as a dial: drag, wheel or keys turn it."""

import math

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from gui.widgets.theme import current_theme

_FINE, _STEP, _COARSE = 1.0, 15.0, 90.0


class Dial(QWidget):
    """Shows where the head stands and where it goes; clockwise is positive, zero is up.

    Arrows turn by 15 degrees, with Shift by 1, Page Up and Down by 90, Home to zero. While it is
    dragged it snaps to 15 degrees; with Shift to 1.
    """

    turned = Signal(float)
    """The angle that the head shall go to, 0 to 360."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._angle = 0.0
        self._target = 0.0
        self._dragging = False
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self.setAccessibleName(self.tr("Dividing head"))

    def set_angles(self, angle_deg: float, target_deg: float) -> None:
        """Show where the head is and where it goes."""
        if self._dragging:
            target_deg = self._target
        if (angle_deg, target_deg) != (self._angle, self._target):
            self._angle, self._target = angle_deg, target_deg
            self.setAccessibleDescription(f"{angle_deg:.1f}°")
            self.update()

    def sizeHint(self) -> QSize:
        return QSize(220, 220)

    def minimumSizeHint(self) -> QSize:
        return QSize(150, 150)

    def heightForWidth(self, width: int) -> int:
        return min(width, 210)

    def _go(self, angle_deg: float) -> None:
        self._target = angle_deg % 360.0
        self.update()
        self.turned.emit(self._target)

    def _angle_at(self, at: QPointF) -> float:
        centre = QPointF(self.width() / 2, self.height() / 2)
        return math.degrees(math.atan2(at.x() - centre.x(), centre.y() - at.y())) % 360.0

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self._dragging = True
            self.mouseMoveEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not self._dragging:
            return
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        grid = _FINE if shift else _STEP
        angle = round(self._angle_at(event.position()) / grid) * grid % 360.0
        if angle != self._target:
            self._target = angle
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._dragging and event.button() is Qt.MouseButton.LeftButton:
            self._dragging = False
            self._go(self._target)

    def wheelEvent(self, event: QWheelEvent) -> None:
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        delta = event.angleDelta()
        clicks = (delta.y() or delta.x()) / 120.0
        self._go(self._target - clicks * (_FINE if shift else _STEP))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        step = _FINE if shift else _STEP
        turns = {
            Qt.Key.Key_Right: step,
            Qt.Key.Key_Up: step,
            Qt.Key.Key_Left: -step,
            Qt.Key.Key_Down: -step,
            Qt.Key.Key_PageUp: _COARSE,
            Qt.Key.Key_PageDown: -_COARSE,
        }
        key = Qt.Key(event.key())
        if key is Qt.Key.Key_Home:
            self._go(0.0)
        elif key in turns:
            self._go(self._target + turns[key])
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        side = min(self.width(), self.height()) - 4
        radius = side / 2
        painter.translate(self.width() / 2, self.height() / 2)
        painter.setPen(QPen(QColor(theme.line), 1))
        painter.setBrush(QColor(theme.base))
        painter.drawEllipse(QPointF(0, 0), radius, radius)
        self._scale(painter, radius)
        self._hand(painter, self._target, 0.62 * radius, QPen(QColor(theme.muted), 1.5))
        self._hand(painter, self._angle, 0.62 * radius, QPen(QColor(theme.accent), 4))
        painter.setPen(QPen(QColor(theme.accent if self.hasFocus() else theme.line), 1))
        painter.setBrush(QColor(theme.raised))
        hub = 0.34 * radius
        painter.drawEllipse(QPointF(0, 0), hub, hub)
        painter.setPen(QColor(theme.text))
        font = painter.font()
        font.setBold(True)
        font.setPointSizeF(font.pointSizeF() * 1.25)
        painter.setFont(font)
        shown = self._angle % 360.0
        painter.drawText(
            QRectF(-hub, -hub, 2 * hub, 2 * hub),
            Qt.AlignmentFlag.AlignCenter,
            f"{shown:.1f}°" if shown % 1.0 > 0.05 else f"{shown:.0f}°",
        )
        painter.end()

    def _scale(self, painter: QPainter, radius: float) -> None:
        theme = current_theme()
        metrics = painter.fontMetrics()
        for angle in range(0, 360, 15):
            long = angle % 90 == 0
            sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
            inner = radius * (0.88 if long else 0.93)
            painter.setPen(QPen(QColor(theme.muted), 2 if long else 1))
            painter.drawLine(
                QPointF(inner * sine, -inner * cosine),
                QPointF(0.98 * radius * sine, -0.98 * radius * cosine),
            )
            if long:
                text = f"{angle}°"
                size = metrics.boundingRect(text).size()
                middle = QPointF(0.70 * radius * sine, -0.74 * radius * cosine)
                place = QRectF(0, 0, size.width() + 8, size.height())
                place.moveCenter(middle)
                painter.setPen(QColor(theme.muted))
                painter.drawText(place, Qt.AlignmentFlag.AlignCenter, text)

    @staticmethod
    def _hand(painter: QPainter, angle_deg: float, length: float, pen: QPen) -> None:
        turn = math.radians(angle_deg)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        painter.drawLine(QPointF(0, 0), QPointF(length * math.sin(turn), -length * math.cos(turn)))
