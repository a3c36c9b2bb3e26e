"""The Allan tab put together."""

from pathlib import Path

from core.errors import LabError, Severity, StorageError
from gui.allan.exporting import formats
from gui.allan.library import Library
from gui.allan.live import LiveRecord
from gui.allan.presenter import SOURCE, AllanPresenter
from gui.allan.view import AllanView
from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.services import Services


class AllanTab(AnalysisTab):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self.library = Library(services.jobs, self)
        self.live = LiveRecord(services.connection, services.jobs, self)
        self.presenter = AllanPresenter(
            self.library, self.live, services.connection, services.messages, self
        )
        self.view = AllanView(self.presenter)
        self.exporting = export_under(
            self.view.findings.foot,
            formats(self._draw),
            lambda: self.library.studies,
            services,
            self,
        )
        self.library.changed.connect(self.exporting.renew)

    @property
    def widget(self) -> AllanView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the plot, and what the first curve needs, so that it comes without a pause."""
        from gui.allan.plot_view import AllanPlot

        self.view.put_plot(AllanPlot())
        self.exporting.renew()
        self._services.jobs.start("scipy", _warm_up, self._on_warm, self._on_failed)

    def load(self, path: Path) -> None:
        """Analyse a record."""
        self.presenter.add([str(path)])

    def close(self) -> None:
        """End the live curve; let go of the plot."""
        self.live.stop()
        self.view.drop_plot()

    def _draw(self, path: Path) -> None:
        from gui.widgets.chart_export import save_chart

        plot = self.view.plot
        if plot is None or self.presenter.state.picture is None:
            raise StorageError(f"{path}: there is no plot yet")
        save_chart(plot.paint, plot.size(), path, "Allan deviation")

    def _on_warm(self, result: object) -> None:
        """Nothing follows: the imports were the work."""

    def _on_failed(self, error: LabError) -> None:
        self._services.messages.log(Severity.WARNING, str(error), SOURCE)


def _warm_up() -> None:
    """Import what the confidence of a curve needs; it takes half a second."""
    import scipy.special

    scipy.special.chdtri(1.0, 0.5)


def make_tab(services: Services) -> AllanTab:
    """Build the tab."""
    return AllanTab(services)
