"""The callout of the tour, and the frame around what it speaks of."""

from PySide6.QtCore import QEvent, QPoint, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from gui.languages.shown import shown
from gui.widgets.theme import current_theme

_EDGE = 3
_ENTER = "\N{RETURN SYMBOL}"


class Frame(QWidget):
    """A line around a widget; the mouse goes through it."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def surround(self, area: QRect) -> None:
        """Stand around an area of the window."""
        whole = area.adjusted(-_EDGE, -_EDGE, _EDGE, _EDGE)
        self.setGeometry(whole.intersected(self.window().rect()))
        self.show()
        self.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(current_theme().accent), _EDGE))
        half = _EDGE / 2
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(half, half, -half, -half), 5, 5)
        painter.end()


class Callout(QWidget):
    """Title, words, and how to go on, back, or away; it holds nothing up."""

    onward = Signal()
    back = Signal()
    left = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        unit = self.fontMetrics().height()
        self._step: tuple[str, str, int, int] | None = None
        self._title, self._text, self._count = QLabel(), QLabel(), QLabel()
        font = self._title.font()
        font.setBold(True)
        font.setPointSizeF(font.pointSizeF() * 1.2)
        self._title.setFont(font)
        self._text.setWordWrap(True)
        self._count.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._leave, self._back, self.next = QPushButton(), QPushButton(), QPushButton()
        self.next.setProperty("primary", True)
        self._leave.clicked.connect(self.left)
        self._back.clicked.connect(self.back)
        self.next.clicked.connect(self.onward)
        row = QHBoxLayout()
        row.addWidget(self._count)
        row.addStretch(1)
        for button in (self._leave, self._back, self.next):
            row.addWidget(button)
        column = QVBoxLayout(self)
        self._margin = unit
        column.setContentsMargins(unit, unit, unit, unit)
        column.addWidget(self._title)
        column.addWidget(self._text)
        column.addSpacing(unit // 2)
        column.addLayout(row)
        self._retranslate()
        self.setFixedWidth(28 * unit)
        self.setAutoFillBackground(True)
        self.hide()

    def show_step(self, title: str, text: str, number: int, count: int) -> None:
        """Show the words of a step.

        Parameters
        ----------
        number, count : which step, from 1, of how many
        """
        self._step = (title, text, number, count)
        title, text = shown(title), shown(text)
        self._title.setText(title)
        self._text.setText(text)
        self._count.setText(self.tr("{number} of {count}").format(number=number, count=count))
        self._back.setVisible(number > 1)
        self._leave.setVisible(number < count)
        self._retranslate()
        self.setAccessibleName(title)
        self.setAccessibleDescription(text)
        # Wrapped words need the width to know their height.
        self._text.setFixedHeight(self._text.heightForWidth(self.width() - 2 * self._margin))
        self.adjustSize()
        self.show()
        self.raise_()

    def _retranslate(self) -> None:
        self._leave.setText(self.tr("Leave the tour"))
        self._back.setText(self.tr("Back"))
        last = self._leave.isHidden() and not self.isHidden()
        words = self.tr("Done") if last else self.tr("Next")
        self.next.setText(f"{words}  {_ENTER}")
        self.next.setAccessibleName(words)

    def stand_beside(self, area: QRect) -> None:
        """Go where the area is not covered: below, above, right or left of it."""
        room = self.window().rect().adjusted(8, 8, -8, -8)
        gap = 3 * _EDGE
        x = min(max(area.left(), room.left()), room.right() - self.width())
        y = min(max(area.top(), room.top()), room.bottom() - self.height())
        for spot in (
            QPoint(x, area.bottom() + gap),
            QPoint(x, area.top() - gap - self.height()),
            QPoint(area.right() + gap, y),
            QPoint(area.left() - gap - self.width(), y),
        ):
            if room.contains(QRect(spot, self.size())):
                self.move(spot)
                return
        self.move(room.right() - self.width(), y)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        # Space stays the key that measures, also under the tour.
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            focus = self.focusWidget()
            (focus if isinstance(focus, QPushButton) else self.next).click()
        else:
            super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.update()
        elif event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._step is not None and not self.isHidden():
                self.show_step(*self._step)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(theme.raised))
        painter.setPen(QPen(QColor(theme.accent), 2))
        painter.drawRect(self.rect().adjusted(1, 1, -1, -1))
        painter.end()
