"""The Drift tab put together."""

from pathlib import Path

from core.errors import StorageError
from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.drift.exporting import formats, page_of
from gui.drift.library import Library
from gui.drift.presenter import DriftPresenter
from gui.drift.view import DriftView
from gui.services import Services


class DriftTab(AnalysisTab):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.library = Library(services.jobs, self)
        self.presenter = DriftPresenter(self.library, services.messages, self)
        self.view = DriftView(self.presenter)
        self.exporting = export_under(
            self.view.page.findings.foot,
            formats(self._draw),
            lambda: page_of(self.presenter, self.library),
            services,
            self,
        )
        self.library.changed.connect(self.exporting.renew)

    @property
    def widget(self) -> DriftView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the plots."""
        from gui.drift.plots_view import PlotsView

        self.view.put_plots(PlotsView())

    def load(self, path: Path) -> None:
        """Take the record of a turn-on, or a folder of them."""
        self.presenter.add([str(path)])

    def close(self) -> None:
        """Let go of the plots."""
        self.view.drop_plots()

    def _draw(self, path: Path) -> None:
        from gui.widgets.chart_export import save_chart

        plots = self.view.plots
        if plots is None:
            raise StorageError(f"{path}: there is no plot yet")
        save_chart(plots.paint, plots.size(), path, "Drift after switching on")


def make_tab(services: Services) -> DriftTab:
    """Build the tab."""
    return DriftTab(services)
