"""The tab Teach a board: source above, bytes left, description and numbers right."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QSplitter, QVBoxLayout, QWidget

from gui.frames.bytes_view import BytesView
from gui.frames.definition_view import DefinitionView
from gui.frames.fields_view import FieldsView
from gui.frames.presenter import FramesPresenter
from gui.frames.readings import Readings
from gui.frames.source_view import SourceView
from gui.frames.state import FramesState
from gui.widgets.word_label import WordLabel

_HELP = (
    "Drag over columns to point at bytes, Enter makes numbers of them, Delete takes them away."
    " A double click points at a whole part."
)


class FramesView(QWidget):
    """The widget of the tab.

    Parameters
    ----------
    presenter : what clicks call, and what is rendered
    """

    def __init__(self, presenter: FramesPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.source = SourceView(presenter.source)
        self.bytes = BytesView()
        self.definition = DefinitionView(presenter)
        self.fields = FieldsView(presenter)
        self.help = WordLabel(_HELP)
        self.help.setProperty("muted", True)
        self.help.setWordWrap(True)
        unit = self.fontMetrics().height()
        self.help.setContentsMargins(unit, unit // 4, unit, unit // 4)
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.bytes, 1)
        column.addWidget(self.help)
        right = QWidget()
        column = QVBoxLayout(right)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.definition)
        column.addWidget(self.fields, 1)
        across = QSplitter(Qt.Orientation.Horizontal)
        across.addWidget(left)
        across.addWidget(right)
        across.setChildrenCollapsible(False)
        across.setStretchFactor(0, 3)
        across.setStretchFactor(1, 2)
        across.setSizes([41 * unit, 37 * unit])
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.source)
        column.addWidget(across, 1)
        self.source.find_requested.connect(presenter.find)
        self.bytes.selected.connect(presenter.select)
        self.bytes.add_requested.connect(presenter.add_selected)
        self.bytes.remove_requested.connect(presenter.remove_selected)
        presenter.changed.connect(self.render)
        presenter.ticked.connect(self._on_tick)
        self._retranslate()
        self.render(presenter.state)

    def render(self, state: FramesState) -> None:
        """Show what is pointed at."""
        self.bytes.show_selection(state.selection)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.bytes.setAccessibleName(self.tr("Bytes of the stream, one frame a row"))
        self.fields.table.setAccessibleName(self.tr("Numbers of the board"))

    def _on_tick(self, readings: Readings) -> None:
        self.bytes.render(readings.bytes)
