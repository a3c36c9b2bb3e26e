"""The main stage: what to do now, legible from three metres."""

from math import ceil

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPaintEvent,
    QPalette,
    QResizeEvent,
)
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from gui.languages.shown import shown
from gui.widgets.icons import paint_tone
from gui.widgets.position_picture import PositionPicture
from gui.widgets.progress_ring import ProgressRing
from gui.widgets.states import StageState, Tone
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel

LEAST_PX = 48
"""Height of the headline in device-independent pixels that is still read from 3 m."""
_MOST_PX = 84
_DETAIL = (1.7, 1.5, 1.3, 1.15, 1.0)
"""Sizes of the detail, of the window's letters; narrow stages begin with the third."""
_WIDE_PX = 660
_BAR_PX = 8
_LEAST_LINES, _LEAST_WITHOUT = 13, 8
"""Least height of the stage in the window's lines, with a picture or a ring and without."""


class Stage(QWidget):
    """Picture, headline, detail and ring of one `StageState`."""

    rendered = Signal(object)
    """The `StageState` that is now shown."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state = StageState("")
        self._picture = PositionPicture()
        self._headline = _Headline()
        self._detail = WordLabel()
        self._detail.setWordWrap(True)
        self._detail.setTextFormat(Qt.TextFormat.PlainText)
        self._ring = ProgressRing()
        self._next = _Next()
        self._build()
        self.render(self._state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        words = QVBoxLayout()
        words.setSpacing(unit // 2)
        words.addStretch(1)
        words.addWidget(self._headline)
        words.addWidget(self._detail)
        words.addStretch(1)
        upper = QHBoxLayout()
        upper.setSpacing(unit)
        upper.addLayout(words, 1)
        upper.addWidget(self._ring)
        right = QVBoxLayout()
        right.setSpacing(0)
        right.addLayout(upper, 1)
        right.addWidget(self._next, 0, Qt.AlignmentFlag.AlignRight)
        row = QHBoxLayout(self)
        row.setContentsMargins(unit + _BAR_PX, unit, unit, unit)
        row.setSpacing(2 * unit)
        row.addWidget(self._picture, 4)
        row.addLayout(right, 7)
        self._picture.setMaximumSize(28 * unit, 28 * unit)

    def render(self, state: StageState) -> None:
        """Show a state.

        Raises
        ------
        ValueError
            A pose names no mount.
        """
        self._state = state
        self._picture.set_pose(state.pose)
        self._picture.setVisible(state.pose is not None)
        self._headline.set_text(shown(state.headline), state.tone)
        self._detail.setText(state.detail)
        self._detail.setVisible(bool(state.detail))
        self._ring.setVisible(state.progress is not None)
        if state.progress is not None:
            self._ring.set_progress(state.progress, state.remaining_s)
        self._next.render(state)
        self._size_detail()
        self.setAccessibleName(shown(state.headline))
        self.setAccessibleDescription(shown(state.detail))
        self.update()
        self.rendered.emit(state)

    @property
    def state(self) -> StageState:
        """What is shown."""
        return self._state

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self.render(self._state)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            # A new style sheet gives the label its plain font after this event.
            QTimer.singleShot(0, self, self._after_style)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._size_detail()

    def _after_style(self) -> None:
        """Size the detail again, and lay it out: that was done for its plain font meanwhile."""
        self._size_detail()
        layout = self.layout()
        if layout is not None:
            layout.invalidate()
            layout.activate()

    def _size_detail(self) -> None:
        """As large as it stands below the headline, so that no line of it is cut."""
        font, unit = QFont(self.font()), self.fontMetrics().height()
        above = 3 * unit + self._headline.heightForWidth(self._headline.width())
        if not self._next.isHidden():
            above += self._next.sizeHint().height()
        for factor in _DETAIL if self.width() > _WIDE_PX else _DETAIL[2:]:
            font.setPointSizeF(self.font().pointSizeF() * factor)
            if self._height_of_words(font) <= self.height() - above:
                break
        if font != self._detail.font():
            self._detail.setFont(font)
        plain = self._state.pose is None and self._state.progress is None
        least = (_LEAST_WITHOUT if plain else _LEAST_LINES) * unit
        self.setMinimumHeight(max(least, above + self._height_of_words(self.font())))

    def _height_of_words(self, font: QFont) -> int:
        """How high the detail stands in a font."""
        box = QRectF(0, 0, max(self._headline.width(), 1), 0)
        flag = Qt.TextFlag.TextWordWrap
        return ceil(QFontMetricsF(font).boundingRect(box, flag, self._detail.text()).height())

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(theme.tints[self._state.tone]))
        if self._state.tone is not Tone.IDLE:
            bar = self.rect()
            bar.setWidth(_BAR_PX)
            painter.fillRect(bar, QColor(theme.tones[self._state.tone]))
        painter.end()


class _Headline(QWidget):
    """Sign and words, as large as the place allows and never below `LEAST_PX`."""

    def __init__(self) -> None:
        super().__init__()
        self._text = ""
        self._tone = Tone.IDLE
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    def set_text(self, text: str, tone: Tone) -> None:
        if (text, tone) != (self._text, self._tone):
            self._text, self._tone = text, tone
            self.setAccessibleName(text)
            self.updateGeometry()
            self.update()

    def sizeHint(self) -> QSize:
        return QSize(480, self.heightForWidth(480))

    def minimumSizeHint(self) -> QSize:
        font = QFont(self.font())
        font.setBold(True)
        font.setPixelSize(LEAST_PX)
        metrics = QFontMetricsF(font)
        longest = max(map(metrics.horizontalAdvance, self._text.split()), default=0.0)
        return QSize(round(longest + 1.35 * LEAST_PX), round(1.3 * LEAST_PX))

    def heightForWidth(self, width: int) -> int:
        font, lines = self._fit(width)
        return round(QFontMetricsF(font).lineSpacing() * max(1, len(lines))) + 4

    def _fit(self, width: int) -> tuple[QFont, list[str]]:
        """The largest font in which the words stand in one line, else the least, wrapped."""
        font = QFont(self.font())
        font.setBold(True)
        for size in range(_MOST_PX, LEAST_PX - 1, -4):
            font.setPixelSize(size)
            if QFontMetricsF(font).horizontalAdvance(self._text) <= width - 1.25 * size:
                return font, [self._text]
        metrics = QFontMetricsF(font)
        lines: list[str] = []
        for word in self._text.split():
            longer = f"{lines[-1]} {word}" if lines else word
            if lines and metrics.horizontalAdvance(longer) <= width - 1.25 * LEAST_PX:
                lines[-1] = longer
            else:
                lines.append(word)
        return font, lines

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        if not self._text:
            return
        theme = current_theme()
        font, lines = self._fit(self.width())
        metrics = QFontMetricsF(font)
        size = font.pixelSize()
        painter = QPainter(self)
        sign = QRectF(0, 0, 0.8 * size, 0.8 * size)
        sign.moveTop((metrics.lineSpacing() - sign.height()) / 2)
        colour = theme.tones[self._tone]
        paint_tone(painter, sign, self._tone, colour)
        painter.setFont(font)
        painter.setPen(QColor(theme.text if self._tone in (Tone.IDLE, Tone.BUSY) else colour))
        for number, line in enumerate(lines):
            top = number * metrics.lineSpacing()
            painter.drawText(
                QRectF(1.25 * size, top, self.width() - 1.25 * size, metrics.lineSpacing()),
                Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
                line,
            )
        painter.end()


class _Next(QWidget):
    """What comes after, small."""

    def __init__(self) -> None:
        super().__init__()
        self._picture = PositionPicture()
        self._caption = QLabel()
        self._label = WordLabel()
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setVerticalSpacing(0)
        layout.addWidget(self._picture, 0, 1, 2, 1)
        layout.addWidget(self._caption, 0, 0, Qt.AlignmentFlag.AlignBottom)
        layout.addWidget(self._label, 1, 0, Qt.AlignmentFlag.AlignTop)
        self._picture.setFixedSize(64, 64)
        self._caption.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._retranslate()

    def _retranslate(self) -> None:
        self._caption.setText(self.tr("Next"))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def render(self, state: StageState) -> None:
        self.setVisible(bool(state.next_label))
        self._label.setText(state.next_label)
        self._picture.set_pose(state.next_pose)
        self._picture.setVisible(state.next_pose is not None)
