"""Model vs data: ladder and regressors left, plots middle, findings right, actions below."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QRectF, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import (
    QFileDialog,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QProgressBar,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from gui.discrepancy.findings_view import FindingsView
from gui.discrepancy.ladder_view import LadderView
from gui.discrepancy.presenter import DiscrepancyPresenter
from gui.discrepancy.state import RegressorRow, StoryState
from gui.languages.shown import shown
from gui.widgets.action_bar import ActionBar
from gui.widgets.hint_label import HintLabel
from gui.widgets.icons import paint_tone
from gui.widgets.panes import lay_panes
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel

if TYPE_CHECKING:
    from gui.discrepancy.plots_view import PlotsView


class DiscrepancyView(QWidget):
    """The widget of the tab.

    Parameters
    ----------
    presenter : what clicks call, and what is rendered
    """

    def __init__(self, presenter: DiscrepancyPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._state = presenter.state
        self._rows: tuple[RegressorRow, ...] = ()
        self._rendering = False
        self._dialog: QFileDialog | None = None
        self.plots: PlotsView | None = None
        self.ladder, self.findings = LadderView(), FindingsView()
        self.regressors, self._against = QListWidget(), QLabel()
        self.hint, self.busy, self.progress = HintLabel(), WordLabel(), QProgressBar()
        self.action_bar = ActionBar()
        self._middle = QStackedWidget()
        self._build()
        self._connect()
        self._retranslate()
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        self.regressors.setWordWrap(True)
        self.regressors.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        font = self._against.font()
        font.setBold(True)
        self._against.setFont(font)
        self._against.setContentsMargins(unit // 2, unit // 3, unit // 2, unit // 6)
        lower = QWidget()
        column = QVBoxLayout(lower)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._against)
        column.addWidget(self.regressors, 1)
        left = QSplitter(Qt.Orientation.Vertical)
        left.addWidget(self.ladder)
        left.addWidget(lower)
        left.setChildrenCollapsible(False)
        left.setSizes([30 * unit, 15 * unit])
        self._content = QWidget()
        self._content_column = QVBoxLayout(self._content)
        self._content_column.setContentsMargins(0, 0, 0, 0)
        self._middle.addWidget(self.hint)
        self._middle.addWidget(self._content)
        self.progress.setRange(0, 0)
        self.progress.setTextVisible(False)
        self.progress.setFixedHeight(unit // 3)
        self.busy.setContentsMargins(unit // 2, 0, unit // 2, 0)
        centre = QWidget()
        column = QVBoxLayout(centre)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._middle, 1)
        column.addWidget(self.busy)
        column.addWidget(self.progress)
        self._sides = (left, self.findings)
        panes = ((left, 0, 19), (centre, 3, 36), (self.findings, 1, 28))
        lay_panes(self, panes, self.action_bar)

    def _connect(self) -> None:
        presenter = self._presenter
        self.ladder.undone.connect(presenter.undo_from)
        self.findings.chosen.connect(presenter.choose)
        self.regressors.currentRowChanged.connect(self._on_regressor)
        self.action_bar.triggered.connect(self._on_action)
        presenter.changed.connect(self.render)

    def put_plots(self, plots: "PlotsView") -> None:
        """Put the plots in their place; they are slow to import and come after the window."""
        self.plots = plots
        self._content_column.addWidget(plots)
        plots.channel_chosen.connect(self._presenter.show_channel)
        plots.after_chosen.connect(self._presenter.show_after)
        self.render(self._presenter.state)

    def drop_plots(self) -> None:
        """Close the plots; may be called again."""
        if self.plots is not None:
            plots, self.plots = self.plots, None
            self._middle.setCurrentWidget(self.hint)
            plots.close_plots()

    def render(self, state: StoryState) -> None:
        """Show a state."""
        self._state = state
        left, right = self._sides
        left.setVisible(bool(state.rungs))
        right.setVisible(not state.hint)
        self.hint.setText(state.hint or state.advice)
        drawn = self.plots is not None and state.picture is not None
        self._middle.setCurrentWidget(self._content if drawn else self.hint)
        self.busy.setText(state.busy)
        for widget in (self.busy, self.progress):
            widget.setVisible(bool(state.busy) and not state.hint)
        self.ladder.render(state.rungs)
        self._render_regressors(state)
        self.findings.render(state)
        self.action_bar.render(state.actions)
        if self.plots is not None:
            self.plots.render(state)

    def _render_regressors(self, state: StoryState) -> None:
        self._rendering = True
        if state.regressors != self._rows:
            self._rows = state.regressors
            self.regressors.clear()
            for row in state.regressors:
                item = QListWidgetItem(_sign(row.tone), f"{shown(row.title)}\n{shown(row.detail)}")
                item.setToolTip(f"{shown(row.title)}: {shown(row.detail)}")
                self.regressors.addItem(item)
        keys = [row.key for row in state.regressors]
        self.regressors.setCurrentRow(
            keys.index(state.regressor) if state.regressor in keys else -1
        )
        self._rendering = False

    # --- what the operator does -------------------------------------------------------------------

    def _on_regressor(self, place: int) -> None:
        if not self._rendering and place >= 0:
            self._presenter.against(self._rows[place].key)

    def _on_action(self, key: str) -> None:
        if key == "load":
            self._open_dialog()
        elif key == "report":
            self.findings.foot.export()
        else:
            self._presenter.act(key)

    def _open_dialog(self) -> None:
        """The file dialog; it blocks nothing."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Load Data"))
            dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
            dialog.setNameFilters(
                [self.tr("Measurements (*.run.csv *.txt session.json)"), self.tr("All files (*)")]
            )
            dialog.filesSelected.connect(self._presenter.open)
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
            for place, row in enumerate(getattr(self, "_rows", ())):
                self.regressors.item(place).setIcon(_sign(row.tone))

    def _retranslate(self) -> None:
        self._against.setText(self.tr("Where the residual has structure"))
        self.regressors.setAccessibleName(self._against.text())


def _sign(tone: Tone) -> QIcon:
    """The sign of a tone as an icon; in a chosen row it stands on the colour of the others."""
    theme, icon = current_theme(), QIcon()
    for mode, ground in ((QIcon.Mode.Normal, "transparent"), (QIcon.Mode.Selected, theme.base)):
        picture = QPixmap(32, 32)
        picture.fill(QColor(ground))
        painter = QPainter(picture)
        paint_tone(painter, QRectF(4, 4, 24, 24), tone, theme.tones[tone])
        painter.end()
        icon.addPixmap(picture, mode)
    return icon
