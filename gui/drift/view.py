"""The Drift tab: list and settings left, plots middle, findings right, actions below."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QVBoxLayout, QWidget

from gui.drift.presenter import DriftPresenter
from gui.drift.settings_view import SettingsView
from gui.drift.state import DriftState
from gui.widgets.records_page import RecordsPage

if TYPE_CHECKING:
    from gui.drift.plots_view import PlotsView


class DriftView(QWidget):
    """The widget of the tab.

    Parameters
    ----------
    presenter : what clicks call, and what is rendered
    """

    def __init__(self, presenter: DriftPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self.settings = SettingsView()
        self.plots: PlotsView | None = None
        self.page = RecordsPage(
            self.settings,
            [
                self.tr("Turn-ons (*.calrec *.run.csv *.txt *.csv *.dat)"),
                self.tr("All files (*)"),
            ],
        )
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.page)
        self.page.triggered.connect(presenter.act)
        self.page.chosen.connect(presenter.choose)
        self.page.paths_chosen.connect(presenter.add)
        self.settings.decided.connect(presenter.decide)
        self.settings.ambient_stated.connect(presenter.state_ambient)
        presenter.changed.connect(self.render)
        self.render(presenter.state)

    def put_plots(self, plots: "PlotsView") -> None:
        """Put the plots in their place; they are slow to import and come after the window."""
        presenter = self._presenter
        self.plots = plots
        plots.shown.connect(presenter.show)
        plots.snapped.connect(presenter.set_snap)
        plots.curves.dragged.connect(presenter.drag)
        plots.curves.dropped.connect(presenter.drop)
        plots.curves.nudged.connect(presenter.nudge)
        presenter.dragged.connect(plots.render_knots)
        self.page.put_content(plots)
        plots.render(presenter.state)

    def drop_plots(self) -> None:
        """Close the plots; may be called again."""
        if self.plots is not None:
            plots, self.plots = self.plots, None
            self._presenter.dragged.disconnect(plots.render_knots)
            self.page.drop_content()
            plots.close_plots()

    def render(self, state: DriftState) -> None:
        """Show a state."""
        self.page.render(state.page)
        self.settings.render(state.choices)
        if self.plots is not None:
            self.plots.render(state)
