"""The Allan tab: records left, plot middle, findings right, actions below."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import (
    QFileDialog,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QSizePolicy,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from gui.allan.presenter import LIVE_KEY, AllanPresenter
from gui.allan.settings_view import SettingsView
from gui.allan.state import AllanState, RecordRow
from gui.languages.shown import shown
from gui.widgets.action_bar import ActionBar
from gui.widgets.findings_view import FindingsView
from gui.widgets.hint_label import HintLabel
from gui.widgets.panes import lay_panes
from gui.widgets.theme import current_theme
from gui.widgets.toggle import Toggle
from gui.widgets.word_label import WordLabel

if TYPE_CHECKING:
    from gui.allan.plot_view import AllanPlot

_KEY = Qt.ItemDataRole.UserRole


class AllanView(QWidget):
    """The widget of the tab.

    Parameters
    ----------
    presenter : what clicks call, and what is rendered
    """

    """The action Export: the name in the field may need to be proposed first."""

    def __init__(self, presenter: AllanPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._state: AllanState | None = None
        self._rows: tuple[RecordRow, ...] = ()
        self._rendering = False
        self.list = QListWidget()
        self.settings = SettingsView()
        self.findings = FindingsView()
        self.action_bar = ActionBar()
        self.band, self.terms = Toggle(), Toggle()
        self.reading, self.hint = WordLabel(), HintLabel()
        self.plot: AllanPlot | None = None
        self._dialog: QFileDialog | None = None
        self._middle = QStackedWidget()
        self._build()
        self._connect()
        self._retranslate()
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        self.list.setIconSize(QSize(unit, unit))
        self.list.setWordWrap(True)
        self.list.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.list, 1)
        column.addWidget(self.settings)
        self.reading.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        # Its words come and go: they must not move the panes.
        self.reading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.reading.setMinimumHeight(round(1.6 * unit))
        self._page = QWidget()
        self._plot_column = QVBoxLayout(self._page)
        self._plot_column.setContentsMargins(unit // 2, unit // 2, 0, 0)
        self._plot_column.setSpacing(unit // 4)
        switches = QHBoxLayout()
        switches.setSpacing(unit)
        switches.addWidget(self.band)
        switches.addWidget(self.terms)
        switches.addStretch(1)
        self._plot_column.addLayout(switches)
        self._plot_column.addWidget(self.reading)
        self._middle.addWidget(self.hint)
        self._middle.addWidget(self._page)
        panes = ((left, 0, 12), (self._middle, 3, 18), (self.findings, 1, 36))
        lay_panes(self, panes, self.action_bar)

    def _connect(self) -> None:
        presenter = self._presenter
        self.list.currentRowChanged.connect(self._on_row)
        self.list.itemChanged.connect(self._on_item)
        self.settings.decided.connect(presenter.decide)
        self.band.toggled.connect(presenter.draw_band)
        self.terms.toggled.connect(presenter.draw_terms)
        self.action_bar.triggered.connect(self._on_action)
        presenter.changed.connect(self.render)

    def put_plot(self, plot: "AllanPlot") -> None:
        """Put the plot in its place; it is slow to import, so that it comes after the window."""
        self.plot = plot
        self._plot_column.insertWidget(1, plot, 1)
        plot.read.connect(self.reading.setText)
        self._render_plot()

    def drop_plot(self) -> None:
        """Close the plot: panels of pyqtgraph would outlive it as windows; may be called again."""
        if self.plot is not None:
            plot, self.plot = self.plot, None
            self._middle.setCurrentWidget(self.hint)
            plot.close()

    def render(self, state: AllanState) -> None:
        """Show a state."""
        self._state = state
        self._rendering = True
        self._render_rows(state)
        self.band.setChecked(state.band)
        self.terms.setChecked(state.terms)
        self._rendering = False
        self.settings.render(state.choices)
        self.settings.setVisible(state.choices is not None)
        self.hint.setText(state.hint)
        self.findings.render(state.findings)
        self.findings.setVisible(state.findings is not None)
        self.action_bar.render(state.actions)
        self._render_plot()

    def _render_plot(self) -> None:
        state = self._state
        drawn = state is not None and state.picture is not None and self.plot is not None
        self._middle.setCurrentWidget(self._page if drawn else self.hint)
        if state is not None and state.picture is not None and self.plot is not None:
            self.plot.render_picture(state.picture, band=state.band, terms=state.terms)

    def _render_rows(self, state: AllanState) -> None:
        while self.list.count() > len(state.rows):
            self.list.takeItem(self.list.count() - 1)
        while self.list.count() < len(state.rows):
            self.list.addItem(QListWidgetItem())
        same = len(self._rows) == len(state.rows)
        for place, row in enumerate(state.rows):
            if not same or self._rows[place] != row:
                self._render_row(self.list.item(place), row)
            if row.key == state.current and self.list.currentRow() != place:
                self.list.setCurrentRow(place)
        if not any(row.key == state.current for row in state.rows):
            self.list.setCurrentRow(-1)
        self._rows = state.rows

    def _render_row(self, item: QListWidgetItem, row: RecordRow) -> None:
        item.setData(_KEY, row.key)
        words = f"{shown(row.title)}\n{shown(row.detail)}"
        item.setText(words)
        item.setToolTip(shown(row.trouble) or words)
        item.setIcon(_sign(row))
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if row.key != LIVE_KEY:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
            check = Qt.CheckState.Checked if row.shown else Qt.CheckState.Unchecked
            item.setData(Qt.ItemDataRole.CheckStateRole, check)
        else:
            item.setData(Qt.ItemDataRole.CheckStateRole, None)
        item.setFlags(flags)

    # --- what the operator does -------------------------------------------------------------------

    def _on_row(self, place: int) -> None:
        if not self._rendering and place >= 0:
            self._presenter.choose(self.list.item(place).data(_KEY))

    def _on_item(self, item: QListWidgetItem) -> None:
        if not self._rendering and item.data(_KEY) != LIVE_KEY:
            checked = item.checkState() is Qt.CheckState.Checked
            self._presenter.show(item.data(_KEY), checked)

    def _on_action(self, key: str) -> None:
        if key == "add":
            self._open_dialog()
        elif key == "export":
            self.findings.foot.export()
        else:
            self._presenter.act(key)

    def _open_dialog(self) -> None:
        """The file dialog; it blocks nothing, so that a running curve goes on."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Add Records"))
            dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
            dialog.setNameFilters(
                [
                    self.tr("Records (*.calrec *.txt *.csv *.dat)"),
                    self.tr("All files (*)"),
                ]
            )
            dialog.filesSelected.connect(self._presenter.add)
            self._dialog = dialog
        self._dialog.show()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self._rows, self._dialog = (), None
            if self._state is not None:
                self.render(self._state)
        elif event.type() == QEvent.Type.PaletteChange:
            self._rendering = True
            for place, row in enumerate(getattr(self, "_rows", ())):
                self.list.item(place).setIcon(_sign(row))
            self._rendering = False

    def _retranslate(self) -> None:
        self.band.setText(self.tr("Confidence"))
        self.band.setToolTip(self.tr("Bands of one sigma, from the equivalent degrees of freedom"))
        self.terms.setText(self.tr("Fitted terms"))
        self.terms.setToolTip(self.tr("Terms of the chosen record with their slopes"))
        self.list.setAccessibleName(self.tr("Records"))


def _sign(row: RecordRow) -> QIcon:
    """A square in the colour of the curve."""
    theme = current_theme()
    picture = QPixmap(16, 16)
    picture.fill(QColor(theme.curves[row.colour % len(theme.curves)]))
    icon = QIcon(picture)
    icon.addPixmap(picture, QIcon.Mode.Selected)
    return icon
