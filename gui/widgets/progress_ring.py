"""A ring that fills while something is timed, with the seconds left inside."""

import math

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from gui.widgets.theme import current_theme


class ProgressRing(QWidget):
    """Share done as an arc from twelve o'clock, seconds left as digits."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._share = 0.0
        self._digits = ""
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def set_progress(self, share: float, remaining_s: float | None) -> None:
        """Show a share of 0 to 1 and the seconds left; None leaves the digits out."""
        share = min(1.0, max(0.0, share))
        # Rounded up: the last second is shown as 1, and 0 only when all is done.
        digits = "" if remaining_s is None else seconds_text(remaining_s)
        if (share, digits) != (self._share, self._digits):
            self._share, self._digits = share, digits
            self.setAccessibleName(f"{share:.0%}, {digits}" if digits else f"{share:.0%}")
            self.update()

    def sizeHint(self) -> QSize:
        side = round(self.fontMetrics().height() * 8.5)
        return QSize(side, side)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        side = min(self.width(), self.height())
        width = side * 0.085
        circle = QRectF(0, 0, side - width - 1, side - width - 1)
        circle.moveCenter(QPointF(self.width() / 2, self.height() / 2))
        painter.setPen(QPen(QColor(theme.grid), width))
        painter.drawEllipse(circle)
        arc = QPen(QColor(theme.accent), width)
        arc.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(arc)
        painter.drawArc(circle, 90 * 16, -round(self._share * 360 * 16))
        font = QFont(self.font())
        font.setPixelSize(round(side * (0.36 if len(self._digits) < 4 else 0.25)))
        font.setBold(True)
        painter.setFont(font)
        painter.setPen(QColor(theme.text))
        painter.drawText(circle, Qt.AlignmentFlag.AlignCenter, self._digits)
        painter.end()


def seconds_text(seconds: float) -> str:
    """Return a time left as digits: ``7``, ``59``, ``2:05``."""
    whole = max(0, math.ceil(seconds - 1e-6))
    return str(whole) if whole < 100 else f"{whole // 60}:{whole % 60:02d}"
