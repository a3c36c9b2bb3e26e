"""The Archive tab put together."""

from gui.analysis.tab import AnalysisTab
from gui.archive.exporting import formats
from gui.archive.library import Library
from gui.archive.presenter import SOURCE, ArchivePresenter
from gui.archive.state import ArchiveState
from gui.archive.view import ArchiveView
from gui.exporting import Exporting
from gui.services import Services


class ArchiveTab(AnalysisTab):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._titled = ""
        self.library = Library(services.jobs, services.root, self)
        self.presenter = ArchivePresenter(self.library, services.messages, services.open_file, self)
        self.view = ArchiveView(self.presenter)
        self.exporting = Exporting(
            SOURCE,
            formats(),
            lambda: self.presenter.state.findings,
            lambda: services.root() / "exports",
            services.jobs,
            services.messages,
            self,
        )
        self.exporting.serve(self.view.findings.foot)
        self.presenter.changed.connect(self._on_changed)

    @property
    def widget(self) -> ArchiveView:
        """What is shown."""
        return self.view

    def _on_changed(self, state: ArchiveState) -> None:
        title = "" if state.findings is None else state.findings.title
        if title != self._titled:
            self._titled = title
            self.exporting.renew()

    def after_paint(self) -> None:
        """Load the plot; the archive itself is opened when the tab first comes to the front."""
        from gui.archive.history_view import HistoryPlot

        self.view.put_plot(HistoryPlot())

    def close(self) -> None:
        """Break off what runs; let go of the index and the plot."""
        self.library.close()
        self.view.drop_plot()


def make_tab(services: Services) -> ArchiveTab:
    """Build the tab."""
    return ArchiveTab(services)
