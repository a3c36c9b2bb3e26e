"""A label that says English words in the language of the window."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QLabel, QWidget

from gui.languages.shown import shown


class WordLabel(QLabel):
    """A `QLabel` for words of a state; they are translated here, and again in another language."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._said = ""
        self.setText(text)

    def setText(self, text: str) -> None:
        self._said = text
        super().setText(shown(text))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            super().setText(shown(self._said))


def paragraph(text: str, *, bold: bool = False, muted: bool = False) -> WordLabel:
    """Return words that are wrapped and can be copied."""
    label = WordLabel(text)
    label.setWordWrap(True)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    if bold:
        font = label.font()
        font.setBold(True)
        label.setFont(font)
    if muted:
        label.setForegroundRole(label.palette().ColorRole.PlaceholderText)
    return label
