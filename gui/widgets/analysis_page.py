"""The frame of an analysis page: picture in the middle, findings right, actions below."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFileDialog, QStackedWidget, QWidget

from gui.languages.shown import shown
from gui.widgets.action_bar import ActionBar
from gui.widgets.findings_view import FindingsView
from gui.widgets.hint_label import HintLabel
from gui.widgets.panes import lay_panes
from gui.widgets.states import ActionBarState, FindingsState

LOAD = "load"
EXPORT = "export"


@dataclass(frozen=True, slots=True)
class AnalysisState:
    """What the frame shows.

    Parameters
    ----------
    hint : instead of the picture while there is nothing to draw; empty if there is
    findings : the right-hand side; None to leave it away
    actions : the row of buttons
    """

    hint: str
    findings: FindingsState | None
    actions: ActionBarState


class AnalysisPage(QWidget):
    """The frame; a page puts its picture into it.

    Parameters
    ----------
    content : the picture
    filters : of the file dialog, in words
    widths : of picture and findings, in heights of a line
    """

    triggered = Signal(str)
    """Key of an action; those of the file dialog and of the export are not told."""
    file_chosen = Signal(str)

    def __init__(
        self,
        content: QWidget,
        filters: Sequence[str],
        widths: tuple[int, int] = (33, 34),
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._filters = list(filters)
        self._dialog: QFileDialog | None = None
        self.hint = HintLabel()
        self.findings = FindingsView()
        self.action_bar = ActionBar()
        self._middle = QStackedWidget()
        self._content = content
        self._middle.addWidget(self.hint)
        self._middle.addWidget(content)
        panes = ((self._middle, 3, widths[0]), (self.findings, 2, widths[1]))
        lay_panes(self, panes, self.action_bar)
        self.action_bar.triggered.connect(self._on_action)

    def render(self, state: AnalysisState) -> None:
        """Show a state."""
        self.hint.setText(state.hint)
        self._middle.setCurrentWidget(self.hint if state.hint else self._content)
        self.findings.render(state.findings)
        self.findings.setVisible(state.findings is not None)
        self.action_bar.render(state.actions)

    def _on_action(self, key: str) -> None:
        if key == LOAD:
            self._open_dialog()
        elif key == EXPORT:
            self.findings.foot.export()
        else:
            self.triggered.emit(key)

    def _open_dialog(self) -> None:
        """The file dialog; it blocks nothing."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.action_bar.button(LOAD).text())
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
            dialog.setNameFilters([shown(one) for one in self._filters])
            dialog.fileSelected.connect(self.file_chosen)
            self._dialog = dialog
        self._dialog.show()
