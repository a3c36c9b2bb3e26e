"""A doubt about a result, with its sign."""

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QWidget

from core.errors import Note
from gui.widgets.icons import paint_severity, tone_of_severity
from gui.widgets.theme import current_theme
from gui.widgets.word_label import paragraph


class NoteLine(QWidget):
    """The words of a `Note`, wrapped, and the sign of its severity before them."""

    def __init__(self, note: Note, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._note = note
        unit = self.fontMetrics().height()
        words = note.text[:1].upper() + note.text[1:]
        text = paragraph(words if words[-1:] in ".!?" else f"{words}.")
        row = QHBoxLayout(self)
        row.setContentsMargins(round(1.8 * unit), 0, 0, 0)
        row.addWidget(text, 1)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        unit = self.fontMetrics().height()
        painter = QPainter(self)
        tone = tone_of_severity(self._note.severity)
        sign = QRectF(0.2 * unit, 0.1 * unit, 1.1 * unit, 1.1 * unit)
        paint_severity(painter, sign, self._note.severity, current_theme().tones[tone])
        painter.end()
