"""Inline message: what happened, what it means, what to do. Never a modal dialog."""

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown
from gui.widgets.icons import paint_severity, tone_of_severity
from gui.widgets.states import BannerAction, BannerState
from gui.widgets.theme import current_theme
from gui.widgets.word_label import paragraph


class Banner(QWidget):
    """One message above or below the work; hidden while there is none."""

    action = Signal(str)
    """Key of the pressed button."""
    closed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state: BannerState | None = None
        unit = self.fontMetrics().height()
        self._what, self._rest = paragraph("", bold=True), paragraph("")
        self._buttons = QHBoxLayout()
        self._buttons.setSpacing(unit // 2)
        self._close = QToolButton()
        self._close.setText("✕")
        self._close.setAutoRaise(True)
        self._close.clicked.connect(self._on_close)
        words = QVBoxLayout()
        words.setSpacing(unit // 6)
        words.addStretch(1)
        words.addWidget(self._what)
        words.addWidget(self._rest)
        words.addStretch(1)
        row = QHBoxLayout(self)
        row.setContentsMargins(3 * unit, unit // 2, unit // 2, unit // 2)
        row.setSpacing(unit)
        row.addLayout(words, 1)
        row.addLayout(self._buttons)
        row.addWidget(self._close, 0, Qt.AlignmentFlag.AlignVCenter)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
        self._retranslate()
        self.render(None)

    def render(self, state: BannerState | None) -> None:
        """Show a message, or hide if there is none."""
        if state is not None and state == self._state:
            self.show()
            return
        self._state = state
        self.setVisible(state is not None)
        if state is None:
            return
        self._what.setText(state.what)
        rest = " ".join(part for part in (state.meaning, state.remedy) if part)
        self._rest.setText(rest)
        self._rest.setVisible(bool(rest))
        self._close.setVisible(state.closable)
        self._set_buttons(state.actions)
        self.setAccessibleName(self._what.text())
        self.setAccessibleDescription(self._rest.text())
        self.update()

    def _set_buttons(self, actions: tuple[BannerAction, ...]) -> None:
        while item := self._buttons.takeAt(0):
            if (old := item.widget()) is not None:
                old.hide()
                old.deleteLater()
        for wanted in actions:
            button = QPushButton(shown(wanted.text))
            button.setProperty("key", wanted.key)
            button.clicked.connect(self._on_button)
            self._buttons.addWidget(button)

    def _on_button(self) -> None:
        self.action.emit(self.sender().property("key"))

    def _on_close(self) -> None:
        self._state = None
        self.hide()
        self.closed.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self._state is not None and self._state.closable:
            self._on_close()
            return
        super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        if self._state is not None:
            self._set_buttons(self._state.actions)
            self.setAccessibleName(self._what.text())
            self.setAccessibleDescription(self._rest.text())
        self._close.setAccessibleName(self.tr("Close this message"))
        self._close.setToolTip(self.tr("Close this message"))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        if self._state is None:
            return
        theme = current_theme()
        tone = tone_of_severity(self._state.severity)
        colour = theme.tones[tone]
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(theme.tints[tone]))
        painter.fillRect(0, 0, 4, self.height(), QColor(colour))
        painter.setPen(QColor(theme.line))
        painter.drawLine(0, 0, self.width(), 0)
        unit = self.fontMetrics().height()
        sign = QRectF(unit, 0, 1.3 * unit, 1.3 * unit)
        sign.moveTop((self.height() - sign.height()) / 2)
        paint_severity(painter, sign, self._state.severity, colour)
        painter.end()

    def minimumSizeHint(self) -> QSize:
        return QSize(20 * self.fontMetrics().averageCharWidth(), super().minimumSizeHint().height())
