"""The Live tab: settings left, Charts and Table in the middle, statistics below them."""

from pathlib import Path

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QColor, QPalette, QShowEvent
from PySide6.QtWidgets import (
    QFileDialog,
    QFrame,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QSplitter,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown
from gui.live.charts_view import ChartsView
from gui.live.exporting import PICTURES, Exporting
from gui.live.means import Means, MeansState
from gui.live.means_view import MeansView
from gui.live.presenter import LivePresenter
from gui.live.settings_view import SettingsView
from gui.live.state import LiveState, LiveStatus
from gui.live.table_view import SampleTable
from gui.live.tools_view import ToolsView
from gui.widgets.action_bar import ActionBar
from gui.widgets.fields import ChoiceField
from gui.widgets.number_text import grouped
from gui.widgets.result_table import ResultTable
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel

FRAME_MS = 33
_SLOW_EVERY = 8


class LiveView(QWidget):
    """The widget of the tab.

    Parameters
    ----------
    presenter : what clicks call, and what is rendered
    exporting : knows the formats, draws the pictures
    means : what the page Means shows
    """

    def __init__(
        self,
        presenter: LivePresenter,
        exporting: Exporting,
        means: Means,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._exporting = exporting
        self._means = means
        self.settings = SettingsView()
        self.tools = ToolsView()
        self.charts = ChartsView()
        self.table = SampleTable()
        self.means = MeansView()
        self.pages = QTabWidget()
        self.statistics = ResultTable()
        self.action_bar = ActionBar()
        self.headline, self.status, self.hint = WordLabel(), WordLabel(), WordLabel()
        self.export_row = QWidget()
        self.format, self.export_name = ChoiceField(), QLineEdit()
        self.export_button = QPushButton()
        self._dialog: QFileDialog | None = None
        self._wanted = "load"
        self._ticks = 0
        self._build()
        self._connect()
        self._retranslate()
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._on_tick)
        self._timer.start(FRAME_MS)
        self._on_trace()
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        font = self.headline.font()
        font.setBold(True)
        font.setPointSizeF(1.3 * font.pointSizeF())
        self.headline.setFont(font)
        self.status.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.status.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.pages.addTab(self.charts, "")
        self.pages.addTab(self.table, "")
        self.pages.addTab(self.means, "")
        self.pages.setDocumentMode(True)
        scroll = QScrollArea()
        scroll.setWidget(self.statistics)
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setMinimumHeight(6 * unit)
        self._stack = QSplitter(Qt.Orientation.Vertical)
        self._stack.addWidget(self.pages)
        self._stack.addWidget(scroll)
        self._stack.setStretchFactor(0, 1)
        self._stack.setChildrenCollapsible(False)
        self._panes = [40 * unit, 9 * unit]
        self._scroll = scroll
        row = QHBoxLayout(self.export_row)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.format)
        row.addWidget(self.export_name, 1)
        row.addWidget(self.export_button)
        self.export_row.hide()
        for key, title in self._exporting.formats:
            self.format.addItem(shown(title), key)
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, 0)
        column.setSpacing(unit // 3)
        self.hint.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        for part in (self.headline, self._stack, self.hint, self.export_row, self.status):
            column.addWidget(part, 1 if part is self._stack else 0)
        left = QWidget()
        panel = QVBoxLayout(left)
        panel.setContentsMargins(unit // 2, unit // 2, 0, 0)
        panel.addWidget(self.settings, 1)
        panel.addWidget(self.tools)
        left.setMinimumWidth(19 * unit)
        across = QSplitter(Qt.Orientation.Horizontal)
        across.addWidget(left)
        across.addWidget(middle)
        across.setStretchFactor(0, 0)
        across.setStretchFactor(1, 1)
        across.setSizes([19 * unit, 60 * unit])
        across.setChildrenCollapsible(False)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.setSpacing(0)
        outer.addWidget(across, 1)
        outer.addWidget(self.action_bar)

    def _connect(self) -> None:
        presenter, measures = self._presenter, self._presenter.measures
        presenter.changed.connect(self.render)
        presenter.trace_changed.connect(self._on_trace)
        measures.averaged.connect(self._show_means)
        self.action_bar.triggered.connect(self._on_action)
        for panel in (self.settings, self.tools):
            panel.edited.connect(presenter.set_settings)
        self.settings.file_named.connect(presenter.set_file)
        self.settings.channel_shown.connect(presenter.show_channel)
        self.means.folder_wanted.connect(self._on_folder)
        self.means.selection_wanted.connect(measures.average)
        self.means.kind_chosen.connect(self._means.set_kind)
        self.means.given.connect(self._means.give)
        self.means.handed_over.connect(self._means.hand_over)
        self._means.changed.connect(self._on_means)
        self.charts.tail_set.connect(self.tools.set_tail)
        self.charts.marked.connect(presenter.mark)
        self.charts.edit.connect(self._on_edit)
        self.charts.charts.cursors_changed.connect(self._on_cursors)
        self.charts.charts.interval_selected.connect(measures.add_interval)
        self.pages.currentChanged.connect(self._on_page)
        self.format.activated.connect(self._on_format)
        self.export_button.clicked.connect(self._on_export)

    # --- what is shown ----------------------------------------------------------------------------

    def render(self, state: LiveState) -> None:
        """Show a state."""
        self._state = state
        self.headline.setText(state.headline)
        palette = self.headline.palette()
        tone = current_theme().tones[state.tone]
        palette.setColor(QPalette.ColorRole.WindowText, QColor(tone))
        self.headline.setPalette(palette)
        self.settings.render(state)
        self.tools.render(state.settings)
        shown = self._presenter.shown()
        self.charts.show_channels(shown)
        self.charts.render(state, self._presenter.overlays)
        key = (id(self._presenter.trace), tuple(shown), state.settings.decimation)
        if key != self._table_key:
            self._table_key = key
            self.table.take(self._presenter.trace, shown, state.settings.decimation)
        self._render_statistics(state)
        self.action_bar.render(state.actions)

    def _render_statistics(self, state: LiveState) -> None:
        """The charts have all the room until there is something between the cursors."""
        filled = bool(state.statistics.rows)
        if filled != self._filled:
            sizes = self._stack.sizes()
            if self._filled:
                self._panes = sizes
            self._filled = filled
            self._show_figures()
            if filled:
                self._stack.setSizes(self._panes)
        self.hint.setText("" if filled else state.statistics.equation)
        self.statistics.render(state.statistics)

    def _show_figures(self) -> None:
        charted = self.pages.currentWidget() is not self.means
        self._scroll.setVisible(charted and bool(self._filled))
        self.hint.setVisible(charted and not self._filled)

    _filled: bool | None = None
    _table_key: tuple[int, tuple[int, ...], int] = (0, (), 0)

    def _on_trace(self) -> None:
        self._table_key = (0, (), 0)
        self.charts.take(self._presenter.trace, self._presenter.shown())

    def _on_tick(self) -> None:
        if not self.isVisible() or self.window().isMinimized():
            return
        self._ticks += 1
        if self.pages.currentWidget() is self.charts:
            self.charts.refresh()
        elif self._ticks % _SLOW_EVERY == 0:
            self.table.refresh()
        if self._ticks % _SLOW_EVERY == 0:
            self._show_status(self._presenter.status())
            if self._state.actions != self._presenter.state.actions:
                self.render(self._presenter.state)

    def _show_status(self, status: LiveStatus) -> None:
        rate = "—" if status.rate_hz is None else f"{status.rate_hz:.1f} Hz"
        minutes, seconds = divmod(status.seconds, 60.0)
        hours, minutes = divmod(int(minutes), 60)
        parts = [
            status.port,
            self.tr("Packed count {n}").format(n=grouped(status.packed)),
            f"{hours}:{minutes:02d}:{seconds:04.1f}",
            rate,
            f"CEP / CWV {status.cep} / {status.cwv}",
            self.tr("lost {n}").format(n=status.lost),
        ]
        if status.stored:
            parts.append(self.tr("on disk {mb} MB").format(mb=f"{status.stored / 1e6:.1f}"))
        if status.lasting:
            parts.append(self.tr("disk lasts {time}").format(time=status.lasting))
        text = "  ·  ".join(part for part in parts if part)
        self.status.setText(text)
        self.status.setToolTip(self.status.text())

    # --- what the operator does -------------------------------------------------------------------

    def _on_action(self, key: str) -> None:
        if key == "load":
            self._ask("load", folder=False)
        elif key == "export":
            self.export_row.setVisible(not self.export_row.isVisible())
            self._on_format()
        else:
            # A field that is locked now must not pass the focus on to one that takes Space.
            self.charts.charts.setFocus()
            self._presenter.act(key)

    def _on_edit(self, key: str) -> None:
        measures = self._presenter.measures
        if key == "overlay":
            self._ask("overlay", folder=False)
        elif key == "no_overlay":
            self._presenter.clear_overlays()
        elif key in ("select_all", "deselect_all"):
            measures.select_all(key == "select_all")
        elif key == "remove":
            measures.remove_intervals()
        elif key == "means":
            measures.average()

    def _on_cursors(self) -> None:
        self._presenter.measures.set_cursors(*self.charts.charts.cursors)

    def _on_page(self) -> None:
        self.table.refresh()
        self._show_figures()

    def _show_means(self) -> None:
        self.pages.setCurrentWidget(self.means)

    def _on_means(self, state: MeansState) -> None:
        self.means.render(state)

    def _on_format(self) -> None:
        measures = self._presenter.measures
        self.export_name.setText(measures.proposed_export(self.format.currentData()))

    def _on_export(self) -> None:
        key, name = self.format.currentData(), self.export_name.text()
        if key in PICTURES:
            charts = self.charts.charts
            self._exporting.picture(charts.paint, charts.size(), Path(name).expanduser())
        else:
            self._presenter.measures.export_samples(key, name)
        self.export_row.hide()

    def _on_folder(self) -> None:
        self._ask("means", folder=True)

    def _ask(self, wanted: str, *, folder: bool) -> None:
        """Choose a file or folder, in a window that does not block the others."""
        if self._dialog is not None:
            self._dialog.deleteLater()
        self._wanted = wanted
        dialog = QFileDialog(self, self.tr("Records"), self._state.folder)
        dialog.setModal(False)
        if folder:
            dialog.setFileMode(QFileDialog.FileMode.Directory)
        else:
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
            dialog.setNameFilters([self.tr("Records (*.calrec *.txt)"), self.tr("All files (*)")])
        dialog.fileSelected.connect(self.choose)
        self._dialog = dialog
        dialog.show()

    def come_to_front(self) -> None:
        """Show this tab instead of the one that is shown."""
        parent = self.parentWidget()
        while parent is not None and not isinstance(parent, QTabWidget):
            parent = parent.parentWidget()
        if parent is not None:
            parent.setCurrentWidget(self)

    def choose(self, name: str) -> None:
        """Take a file or folder that was chosen."""
        path = Path(name)
        if self._wanted == "means":
            self._presenter.measures.average_folder(path)
        else:
            self._presenter.load(path, beneath=self._wanted == "overlay")

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        # Not on a field, into which Space would be typed.
        self.charts.charts.setFocus()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
        elif event.type() == QEvent.Type.PaletteChange and hasattr(self, "_state"):
            self.render(self._state)

    def _retranslate(self) -> None:
        self.pages.setTabText(0, self.tr("Charts"))
        self.pages.setTabText(1, self.tr("Table"))
        self.pages.setTabText(2, self.tr("Means"))
        for place, (_, title) in enumerate(self._exporting.formats):
            self.format.setItemText(place, shown(title))
        self.export_button.setText(self.tr("Save"))
        self.format.setAccessibleName(self.tr("Format"))
        self.export_name.setAccessibleName(self.tr("File to save"))
        self.status.setAccessibleName(self.tr("Status"))
