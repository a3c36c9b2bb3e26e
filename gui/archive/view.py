"""Search and list left, history middle, findings right, actions below."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtGui import QKeySequence, QShortcut, QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QLineEdit,
    QSizePolicy,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from core.archive.entry import KINDS
from gui.archive.entries_view import EntryTable
from gui.archive.presenter import ArchivePresenter
from gui.archive.state import ArchiveState
from gui.languages.shown import shown
from gui.widgets.action_bar import ActionBar
from gui.widgets.findings_view import FindingsView
from gui.widgets.hint_label import HintLabel
from gui.widgets.panes import lay_panes
from gui.widgets.word_label import WordLabel

if TYPE_CHECKING:
    from gui.archive.history_view import HistoryPlot


class ArchiveView(QWidget):
    """Shows an `ArchiveState`."""

    def __init__(self, presenter: ArchivePresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._state: ArchiveState | None = None
        self._header: tuple[str, ...] = ()
        self.search, self.kind = QLineEdit(), QComboBox()
        self.status, self.hint = WordLabel(), HintLabel()
        self.table = EntryTable()
        self.parameter, self.temperature = QComboBox(), QComboBox()
        self.findings = FindingsView()
        self.action_bar = ActionBar()
        self.plot: HistoryPlot | None = None
        self._parameters: tuple[str, ...] = ()
        self._temperatures: tuple[str, ...] = ()
        self._dialog: QFileDialog | None = None
        self._middle = QStackedWidget()
        self._build()
        self._retranslate()
        self._connect()
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        self.search.setClearButtonEnabled(True)
        self.status.setContentsMargins(unit // 2, unit // 4, unit // 2, unit // 4)
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(unit // 2, unit // 2, 0, 0)
        column.setSpacing(unit // 4)
        top = QHBoxLayout()
        top.setSpacing(unit // 2)
        top.addWidget(self.search, 1)
        top.addWidget(self.kind)
        column.addLayout(top)
        column.addWidget(self.table, 1)
        column.addWidget(self.status)
        self._page = QWidget()
        self._plot_column = QVBoxLayout(self._page)
        self._plot_column.setContentsMargins(unit // 2, unit // 2, 0, 0)
        self._plot_column.setSpacing(unit // 4)
        self.parameter.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        followed = QHBoxLayout()
        followed.setSpacing(unit // 2)
        followed.addWidget(self.parameter, 1)
        followed.addWidget(self.temperature)
        self._plot_column.addLayout(followed)
        self._middle.addWidget(self.hint)
        self._middle.addWidget(self._page)
        panes = ((left, 2, 29), (self._middle, 2, 22), (self.findings, 1, 30))
        lay_panes(self, panes, self.action_bar)

    def _connect(self) -> None:
        presenter = self._presenter
        self.search.textChanged.connect(self._on_search)
        self.kind.activated.connect(self._on_search)
        self.table.chosen.connect(presenter.choose)
        self.table.opened.connect(self._on_opened)
        self.parameter.activated.connect(presenter.follow)
        self.temperature.activated.connect(presenter.at)
        self.action_bar.triggered.connect(self._on_action)
        presenter.changed.connect(self.render)
        find = QShortcut(QKeySequence(QKeySequence.StandardKey.Find), self)
        find.activated.connect(self._on_find)

    def put_plot(self, plot: "HistoryPlot") -> None:
        """Put the plot in its place; it is slow to import, so that it comes after the window."""
        self.plot = plot
        self._plot_column.addWidget(plot, 1)
        self._render_plot()

    def drop_plot(self) -> None:
        """Close the plot: panels of pyqtgraph would outlive it as windows; may be called again."""
        if self.plot is not None:
            plot, self.plot = self.plot, None
            self._middle.setCurrentWidget(self.hint)
            plot.close()

    def render(self, state: ArchiveState) -> None:
        """Show a state."""
        self._state = state
        self.table.render_rows(state.rows, self._header, state.chosen)
        self.status.setText(state.status)
        self.hint.setText(state.hint)
        self._render_parameters(state)
        self.findings.render(state.findings)
        self.findings.setVisible(state.findings is not None)
        self.action_bar.render(state.actions)
        self._render_plot()

    def _render_parameters(self, state: ArchiveState) -> None:
        if state.parameters != self._parameters:
            self._parameters = state.parameters
            self.parameter.clear()
            self.parameter.addItems([shown(name) for name in state.parameters])
        if self.parameter.currentIndex() != state.parameter:
            self.parameter.setCurrentIndex(state.parameter)
        if state.temperatures != self._temperatures:
            self._temperatures = state.temperatures
            self.temperature.clear()
            self.temperature.addItems([shown(words) for words in state.temperatures])
        self.temperature.setCurrentIndex(state.temperature)
        self.temperature.setEnabled(len(state.temperatures) > 1)

    def _render_plot(self) -> None:
        state = self._state
        if state is None or state.history is None or self.plot is None:
            self._middle.setCurrentWidget(self.hint)
            return
        self._middle.setCurrentWidget(self._page)
        self.plot.render_history(state.history)

    # --- what the operator does -------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if not event.spontaneous():
            self._presenter.shown()

    def _on_search(self) -> None:
        self._presenter.look_for(self.search.text(), self.kind.currentData() or "")

    def _on_find(self) -> None:
        self.search.setFocus()
        self.search.selectAll()

    def _on_opened(self) -> None:
        self._presenter.act("open")

    def _on_action(self, key: str) -> None:
        if key == "import":
            self._open_dialog()
        else:
            self._presenter.act(key)

    def _open_dialog(self) -> None:
        """The folder dialog; it blocks nothing."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Import Folder"))
            dialog.setFileMode(QFileDialog.FileMode.Directory)
            dialog.setOption(QFileDialog.Option.ShowDirsOnly, True)
            dialog.fileSelected.connect(self._presenter.import_folder)
            self._dialog = dialog
        self._dialog.show()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self._dialog, self._parameters, self._temperatures = None, (), ()
            self.render(self._presenter.state)

    def _retranslate(self) -> None:
        self.search.setPlaceholderText(
            self.tr("Serial number, date, plan, operator, verdict … (Ctrl+F)")
        )
        self.search.setAccessibleName(self.tr("Search the archive"))
        self.kind.setAccessibleName(self.tr("Kind of entries"))
        self.parameter.setAccessibleName(self.tr("Parameter that is followed"))
        self.temperature.setAccessibleName(self.tr("Temperature of what counts"))
        self.temperature.setToolTip(
            self.tr("Only calibrations at about this temperature count; the others are shown")
        )
        self.table.setAccessibleName(self.tr("Entries"))
        self._header = (
            self.tr("Serial no."),
            self.tr("Kind"),
            self.tr("Measured"),
            self.tr("Verdict"),
            "°C",
            self.tr("Operator"),
            self.tr("Plan or procedure"),
        )
        chosen = self.kind.currentIndex()
        self.kind.clear()
        self.kind.addItem(self.tr("all kinds"), "")
        for kind in KINDS:
            self.kind.addItem(_kind(kind), kind)
        self.kind.setCurrentIndex(max(chosen, 0))


def _kind(kind: str) -> str:
    words = {
        "session": QCoreApplication.translate("ArchiveView", "sessions"),
        "calibration": QCoreApplication.translate("ArchiveView", "calibrations"),
        "run": QCoreApplication.translate("ArchiveView", "run files"),
        "legacy": QCoreApplication.translate("ArchiveView", "old files"),
        "record": QCoreApplication.translate("ArchiveView", "records"),
        "means": QCoreApplication.translate("ArchiveView", "means"),
        "noise": QCoreApplication.translate("ArchiveView", "noise"),
    }
    return words[kind]
