"""The frame of an analysis of several records: list left, picture middle, findings right."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import (
    QFileDialog,
    QListWidget,
    QListWidgetItem,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown
from gui.widgets.action_bar import ActionBar
from gui.widgets.findings_view import FindingsView
from gui.widgets.hint_label import HintLabel
from gui.widgets.panes import lay_panes
from gui.widgets.side_scroll import SideScroll
from gui.widgets.states import ActionBarState, FindingsState

ADD, FOLDER, EXPORT = "add", "folder", "export"


@dataclass(frozen=True, slots=True)
class ListRow:
    """One record of the list.

    Parameters
    ----------
    key : by which it is meant
    title, detail : two lines
    trouble : why it cannot be used; empty if it can
    """

    key: int
    title: str
    detail: str
    trouble: str = ""


@dataclass(frozen=True, slots=True)
class RecordsState:
    """What the frame shows.

    Parameters
    ----------
    rows : the list
    current : key of the chosen row; 0 for none
    hint : instead of the picture while there is nothing to draw; empty if there is
    findings : the right-hand side; None to leave it away
    actions : the row of buttons
    """

    rows: tuple[ListRow, ...]
    current: int
    hint: str
    findings: FindingsState | None
    actions: ActionBarState


class RecordsPage(QWidget):
    """The frame; a tab gives it its settings, and its picture once that has been imported.

    Parameters
    ----------
    settings : below the list
    filters : of the file dialog, in words
    """

    triggered = Signal(str)
    """Key of an action; adding files and exporting are not told."""
    chosen = Signal(int)
    """Key of a row."""
    paths_chosen = Signal(list)
    """Files, or one folder."""

    def __init__(
        self, settings: QWidget, filters: Sequence[str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._filters = list(filters)
        self._rendering = False
        self._rows: tuple[ListRow, ...] = ()
        self._dialogs: dict[str, QFileDialog] = {}
        self._state: RecordsState | None = None
        self._content: QWidget | None = None
        self.list = QListWidget()
        self.hint = HintLabel()
        self.findings = FindingsView()
        self.action_bar = ActionBar()
        self._middle = QStackedWidget()
        self._build(settings)
        self.list.currentRowChanged.connect(self._on_row)
        self.action_bar.triggered.connect(self._on_action)
        self._retranslate()

    def _build(self, settings: QWidget) -> None:
        unit = self.fontMetrics().height()
        self.list.setWordWrap(True)
        self.list.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setMinimumHeight(5 * unit)
        self._middle.addWidget(self.hint)
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.list, 2)
        column.addWidget(SideScroll(settings), 3)
        panes = ((left, 0, 17), (self._middle, 3, 35), (self.findings, 1, 29))
        lay_panes(self, panes, self.action_bar)

    def put_content(self, content: QWidget) -> None:
        """Put the picture in its place."""
        self._content = content
        self._middle.addWidget(content)
        self._show_middle()

    def drop_content(self) -> None:
        """Take the picture away."""
        if self._content is not None:
            self._middle.setCurrentWidget(self.hint)
            self._middle.removeWidget(self._content)
            self._content = None

    def render(self, state: RecordsState) -> None:
        """Show a state."""
        self._state = state
        self._rendering = True
        self._render_rows(state)
        self._rendering = False
        self.hint.setText(state.hint)
        self._show_middle()
        self.findings.render(state.findings)
        self.findings.setVisible(state.findings is not None)
        self.action_bar.render(state.actions)

    def _show_middle(self) -> None:
        if self._content is None or self.hint.text():
            self._middle.setCurrentWidget(self.hint)
        else:
            self._middle.setCurrentWidget(self._content)

    def _render_rows(self, state: RecordsState) -> None:
        if state.rows != self._rows:
            self.list.clear()
            for row in state.rows:
                words = f"{shown(row.title)}\n{shown(row.detail)}"
                trouble = shown(row.trouble)
                item = QListWidgetItem(f"{shown(row.title)}\n{trouble}" if trouble else words)
                item.setToolTip(trouble or words)
                self.list.addItem(item)
            self._rows = state.rows
        keys = [row.key for row in state.rows]
        self.list.setCurrentRow(keys.index(state.current) if state.current in keys else -1)

    def _on_row(self, place: int) -> None:
        if not self._rendering and place >= 0:
            self.chosen.emit(self._rows[place].key)

    def _on_action(self, key: str) -> None:
        if key in (ADD, FOLDER):
            self._open_dialog(key)
        elif key == EXPORT:
            self.findings.foot.export()
        else:
            self.triggered.emit(key)

    def _open_dialog(self, key: str) -> None:
        """The file dialog; it blocks nothing."""
        if key not in self._dialogs:
            dialog = QFileDialog(self, self.action_bar.button(key).text())
            if key == FOLDER:
                dialog.setFileMode(QFileDialog.FileMode.Directory)
            else:
                dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
                dialog.setNameFilters([shown(one) for one in self._filters])
            dialog.filesSelected.connect(self.paths_chosen)
            self._dialogs[key] = dialog
        self._dialogs[key].show()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.list.setAccessibleName(self.tr("Records"))
        self._dialogs = {}
        if self._state is not None:
            self._rows = ()
            self.render(self._state)
