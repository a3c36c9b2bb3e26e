"""The table of the comparison, its doubts and its export."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QStackedWidget, QWidget

from gui.comparison.state import ComparisonState
from gui.widgets.findings_view import FindingsView
from gui.widgets.word_label import WordLabel


class ComparisonContent(QStackedWidget):
    """The table, or what to do while there is none."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        unit = self.fontMetrics().height()
        self.findings = FindingsView()
        self._hint = WordLabel()
        self._hint.setWordWrap(True)
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._hint.setContentsMargins(3 * unit, unit, 3 * unit, unit)
        font = self._hint.font()
        font.setPointSizeF(font.pointSizeF() * 1.2)
        self._hint.setFont(font)
        self.addWidget(self._hint)
        self.addWidget(self.findings)

    def render(self, state: ComparisonState) -> None:
        """Show a state."""
        self._hint.setText(state.hint)
        self.findings.render(state.findings)
        self.setCurrentWidget(self._hint if state.findings is None else self.findings)
