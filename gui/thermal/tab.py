"""The Thermal tab put together."""

from pathlib import Path

from core.errors import StorageError
from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.services import Services
from gui.thermal.exporting import formats
from gui.thermal.library import Library
from gui.thermal.presenter import ThermalPresenter
from gui.thermal.view import ThermalView


class ThermalTab(AnalysisTab):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.library = Library(services.jobs, self)
        self.presenter = ThermalPresenter(
            self.library, services.root, services.jobs, services.messages, self
        )
        self.view = ThermalView(self.presenter)
        self.exporting = export_under(
            self.view.page.findings.foot,
            formats(self._draw),
            lambda: self.library.result,
            services,
            self,
        )
        self.library.changed.connect(self.exporting.renew)

    @property
    def widget(self) -> ThermalView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the plots."""
        from gui.thermal.plots_view import PlotsView

        self.view.put_plots(PlotsView())

    def load(self, path: Path) -> None:
        """Take a session's folder, or a file with positions over temperature."""
        self.presenter.add([str(path)])

    def close(self) -> None:
        """Let go of the plots."""
        self.view.drop_plots()

    def _draw(self, path: Path) -> None:
        from gui.widgets.chart_export import save_chart

        plots = self.view.plots
        if plots is None:
            raise StorageError(f"{path}: there is no plot yet")
        save_chart(plots.paint, plots.size(), path, "Over temperature")


def make_tab(services: Services) -> ThermalTab:
    """Build the tab."""
    return ThermalTab(services)
