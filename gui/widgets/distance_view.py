"""The current step over the whole window, to be read from three metres while the hands work."""

from PySide6.QtCore import QEvent, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QWidget

from core.errors import Severity
from gui.languages.shown import shown
from gui.widgets.icons import paint_severity, paint_tone, tone_of_severity
from gui.widgets.position_picture import paint_pose
from gui.widgets.progress_ring import seconds_text
from gui.widgets.states import BannerState, StageState, Tone
from gui.widgets.theme import current_theme

LEAST_SHARE = 0.055
"""Height of the least lettering above the foot, of the height of the view: at 3 m a letter has to
be 9 mm high or more, which is a twentieth of the smallest laptop's screen."""
_MOST_SHARE = 0.24
_FOOT_SHARE = 0.075
_WRAPPED = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class DistanceView(QWidget):
    """Picture, order, seconds left and verdict, as large as the screen allows.

    It takes all keys: Esc leaves, and every other key does what it does in the tab below.
    """

    left = Signal()
    typed = Signal(QKeyEvent)
    """A key that has to reach the list of steps of the tab below."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._stage = StageState("")
        self._doubt: BannerState | None = None
        self._place = ""
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    def set_place(self, title: str) -> None:
        """Name the tab whose step is shown."""
        self._place = title
        self.update()

    def render(self, stage: StageState) -> None:
        """Show a step."""
        self._stage = stage
        self._name()

    def doubt(self, banner: BannerState | None) -> None:
        """Show what is wrong in place of the step's own words; None for nothing."""
        calm = banner is None or banner.severity is Severity.INFO
        self._doubt = None if calm else banner
        self._name()

    def _name(self) -> None:
        self.setAccessibleName(shown(self._stage.headline))
        self.setAccessibleDescription(self._words())
        self.update()

    def _words(self) -> str:
        if self._doubt is None:
            return shown(self._stage.detail)
        return f"{shown(self._doubt.what)}. {shown(self._doubt.remedy)}".strip()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and _is_escape(event):
            # Here Esc leaves; once outside it stops, as in every tab.
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
        else:
            self.typed.emit(event)

    def focusNextPrevChild(self, next: bool) -> bool:  # noqa: ARG002
        """Keep the keys: what lies below cannot be seen."""
        return True

    def mouseDoubleClickEvent(self, event: object) -> None:  # noqa: ARG002
        self.left.emit()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        stage = self._stage
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(theme.tints[stage.tone]))
        if stage.tone is not Tone.IDLE:
            bar = QRectF(0, 0, 0.012 * self.width(), self.height())
            painter.fillRect(bar, QColor(theme.tones[stage.tone]))
        gap = 0.035 * self.height()
        body = QRectF(self.rect()).adjusted(2 * gap, gap, -gap, -_FOOT_SHARE * self.height())
        if stage.pose is not None:
            side = min(0.42 * body.width(), body.height())
            picture = QRectF(body.left(), 0, side, side)
            picture.moveCenter(body.center())
            picture.moveLeft(body.left())
            paint_pose(painter, picture, stage.pose, theme)
            body.setLeft(picture.right() + 1.5 * gap)
        self._paint_words(painter, body)
        self._paint_foot(painter, gap)
        painter.end()

    def _paint_words(self, painter: QPainter, body: QRectF) -> None:
        theme, stage = current_theme(), self._stage
        timed = stage.progress is not None
        upper = QRectF(body)
        upper.setHeight(body.height() * (0.34 if timed else 0.5))
        lower = QRectF(body)
        lower.setTop(upper.bottom())
        if timed:
            side = min(0.52 * body.height(), 0.6 * body.width())
            ring = QRectF(body.right() - side, body.bottom() - side, side, side)
            self._paint_ring(painter, ring)
            lower.setRight(ring.left() - 0.02 * self.width())
        colour = theme.tones[stage.tone]
        sign = QRectF(upper.left(), 0, 0.13 * self.height(), 0.13 * self.height())
        sign.moveCenter(upper.center())
        sign.moveLeft(upper.left())
        paint_tone(painter, sign, stage.tone, colour)
        calm = stage.tone in (Tone.IDLE, Tone.BUSY)
        upper.setLeft(sign.right() + 0.02 * self.width())
        ink = theme.text if calm else colour
        self._write(painter, upper, shown(stage.headline), ink, bold=True)
        if self._doubt is not None:
            tone = theme.tones[tone_of_severity(self._doubt.severity)]
            mark = QRectF(lower.left(), lower.top(), 0.07 * self.height(), 0.07 * self.height())
            paint_severity(painter, mark, self._doubt.severity, tone)
            lower.setLeft(mark.right() + 0.015 * self.width())
        self._write(painter, lower, self._words(), theme.text, bold=False)

    def _write(
        self, painter: QPainter, rect: QRectF, text: str, colour: str, *, bold: bool
    ) -> None:
        """Words as large as their place allows; what would be too small to read is left out."""
        font, fitting = self._fit(rect, text, bold=bold)
        painter.setFont(font)
        painter.setPen(QColor(colour))
        painter.drawText(rect, _WRAPPED, fitting)

    def _fit(self, rect: QRectF, text: str, *, bold: bool) -> tuple[QFont, str]:
        """The largest font that the whole text fits in, else as many sentences as fit."""
        font = QFont(self.font())
        font.setBold(bold)
        most, least = (round(x * self.height()) for x in (_MOST_SHARE, LEAST_SHARE))
        sentences = text.split(". ")
        for count in range(len(sentences), 0, -1):
            fitting = ". ".join(sentences[:count])
            for size in range(most if bold else round(1.7 * least), least - 1, -2):
                font.setPixelSize(size)
                metrics = QFontMetricsF(font)
                widest = max(map(metrics.horizontalAdvance, fitting.split()), default=0.0)
                height = metrics.boundingRect(rect, _WRAPPED, fitting).height()
                if widest <= rect.width() and height <= rect.height():
                    return font, fitting
        return font, sentences[0]

    def _paint_ring(self, painter: QPainter, place: QRectF) -> None:
        theme, stage = current_theme(), self._stage
        width = 0.09 * place.width()
        circle = place.adjusted(width, width, -width, -width)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(QColor(theme.grid), width))
        painter.drawEllipse(circle)
        arc = QPen(QColor(theme.accent), width)
        arc.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(arc)
        painter.drawArc(circle, 90 * 16, -round((stage.progress or 0.0) * 360 * 16))
        if stage.remaining_s is not None:
            digits = seconds_text(stage.remaining_s)
            font = QFont(self.font())
            font.setBold(True)
            share = 0.46 if len(digits) < 3 else 0.34 if len(digits) < 4 else 0.27
            font.setPixelSize(round(share * place.width()))
            painter.setFont(font)
            painter.setPen(QColor(theme.text))
            painter.drawText(circle, Qt.AlignmentFlag.AlignCenter, digits)

    def _paint_foot(self, painter: QPainter, gap: float) -> None:
        theme = current_theme()
        height = _FOOT_SHARE * self.height()
        foot = QRectF(2 * gap, self.height() - height, self.width() - 3 * gap, height)
        font = QFont(self.font())
        font.setPixelSize(round(0.5 * height))
        painter.setFont(font)
        painter.setPen(QColor(theme.muted))
        middle = Qt.AlignmentFlag.AlignVCenter
        left = shown(self._place)
        if self._stage.next_label:
            following = self.tr("Next: {step}").format(step=shown(self._stage.next_label))
            left = f"{left}   {following}"
        painter.drawText(foot, Qt.AlignmentFlag.AlignLeft | middle, left)
        painter.drawText(foot, Qt.AlignmentFlag.AlignRight | middle, self.tr("Esc leaves"))


def _is_escape(event: QEvent) -> bool:
    return isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
