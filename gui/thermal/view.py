"""The Thermal tab: list and settings left, plots middle, findings right, actions below."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QVBoxLayout, QWidget

from gui.thermal.presenter import ThermalPresenter
from gui.thermal.settings_view import SettingsView
from gui.thermal.state import ThermalState
from gui.widgets.records_page import RecordsPage

if TYPE_CHECKING:
    from gui.thermal.plots_view import PlotsView


class ThermalView(QWidget):
    """The widget of the tab.

    Parameters
    ----------
    presenter : what clicks call, and what is rendered
    """

    def __init__(self, presenter: ThermalPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self.settings = SettingsView()
        self.plots: PlotsView | None = None
        self.page = RecordsPage(
            self.settings,
            [
                self.tr(
                    "Positions and records (*.run.csv *.txt *.csv *.dat *.calrec session.json)"
                ),
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
        presenter.changed.connect(self.render)
        self.render(presenter.state)

    def put_plots(self, plots: "PlotsView") -> None:
        """Put the plots in their place; they are slow to import and come after the window."""
        presenter = self._presenter
        self.plots = plots
        plots.shown.connect(presenter.show)
        self.page.put_content(plots)
        plots.render(presenter.state)

    def drop_plots(self) -> None:
        """Close the plots; may be called again."""
        if self.plots is not None:
            plots, self.plots = self.plots, None
            self.page.drop_content()
            plots.close_plots()

    def render(self, state: ThermalState) -> None:
        """Show a state."""
        self.page.render(state.page)
        self.settings.render(state.settings)
        if self.plots is not None:
            self.plots.render(state)
