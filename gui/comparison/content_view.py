"""The table of the comparison, its doubts and its export."""

from PySide6.QtWidgets import QStackedWidget, QWidget

from gui.comparison.state import ComparisonState
from gui.widgets.findings_view import FindingsView
from gui.widgets.hint_label import HintLabel


class ComparisonContent(QStackedWidget):
    """The table, or what to do while there is none."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.findings = FindingsView()
        self._hint = HintLabel()
        self.addWidget(self._hint)
        self.addWidget(self.findings)

    def render(self, state: ComparisonState) -> None:
        """Show a state."""
        self._hint.setText(state.hint)
        self.findings.render(state.findings)
        self.setCurrentWidget(self._hint if state.findings is None else self.findings)
