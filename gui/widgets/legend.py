"""Names of curves in a line of their own, where a legend inside the plot would cover it."""

from dataclasses import dataclass
from html import escape

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QLabel, QWidget

from gui.languages.shown import shown
from gui.widgets.theme import current_theme

LINE, DASHES, POINT = "━", "╌", "●"


@dataclass(frozen=True, slots=True)
class LegendEntry:
    """One name.

    Parameters
    ----------
    name : words
    colour : number of the curve colour
    mark : `LINE`, `DASHES` or `POINT`
    """

    name: str
    colour: int
    mark: str = LINE


class Legend(QLabel):
    """Marks in the colours of the curves, each with its name."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._entries: tuple[LegendEntry, ...] = ()
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setWordWrap(True)

    def set_entries(self, entries: tuple[LegendEntry, ...]) -> None:
        """Show these."""
        if entries != self._entries:
            self._entries = entries
            self._wear()

    def _wear(self) -> None:
        colours = current_theme().curves
        self.setText(
            "&nbsp;&nbsp; ".join(
                f'<span style="color:{colours[one.colour % len(colours)]}">{one.mark}</span>'
                f"&nbsp;{escape(shown(one.name)).replace(' ', '&nbsp;')}"
                for one in self._entries
            )
        )

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        other = event.type() in (QEvent.Type.PaletteChange, QEvent.Type.LanguageChange)
        if other and hasattr(self, "_entries"):
            self._wear()
