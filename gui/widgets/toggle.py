"""A switch with its words beside it."""

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QCheckBox, QSizePolicy, QWidget

from gui.widgets.theme import current_theme


class Toggle(QCheckBox):
    """A check box drawn as a switch; on is told by place and fill, not by colour alone."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        height = round(1.8 * metrics.height())
        return QSize(
            self._track().toRect().width()
            + metrics.height()
            + metrics.horizontalAdvance(self.text()),
            height,
        )

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def hitButton(self, pos: object) -> bool:
        return self.rect().contains(pos)  # type: ignore[call-overload]

    def _track(self) -> QRectF:
        unit = self.fontMetrics().height()
        track = QRectF(1, 0, 2.0 * unit, 1.1 * unit)
        track.moveTop((self.height() - track.height()) / 2)
        return track

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        track = self._track()
        radius = track.height() / 2
        on = self.isChecked()
        painter.setPen(QColor(theme.accent if on or self.hasFocus() else theme.muted))
        painter.setBrush(QColor(theme.accent if on and self.isEnabled() else theme.base))
        painter.drawRoundedRect(track, radius, radius)
        knob = QRectF(0, 0, track.height() - 5, track.height() - 5)
        knob.moveTop(track.top() + 2.5)
        knob.moveLeft(track.right() - knob.width() - 2.5 if on else track.left() + 2.5)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme.on_accent if on else theme.muted))
        painter.drawEllipse(knob)
        painter.setPen(QColor(theme.text if self.isEnabled() else theme.disabled))
        left = track.right() + 0.5 * self.fontMetrics().height()
        words = QRectF(left, 0, self.width() - left, self.height())
        painter.drawText(words, Qt.AlignmentFlag.AlignVCenter, self.text())
        if self.hasFocus():
            line = words.bottom() - 3
            painter.setPen(QColor(theme.accent))
            painter.drawLine(QPointF(words.left(), line), QPointF(words.right(), line))
        painter.end()
