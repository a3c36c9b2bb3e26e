"""What to do, in large words where a picture will stand."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from gui.widgets.word_label import WordLabel


class HintLabel(WordLabel):
    """Centred words with room round them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("", parent)
        unit = self.fontMetrics().height()
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setTextFormat(Qt.TextFormat.PlainText)
        font = self.font()
        font.setPointSizeF(font.pointSizeF() * 1.2)
        self.setFont(font)
        self.setContentsMargins(3 * unit, unit, 3 * unit, unit)
