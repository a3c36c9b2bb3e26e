"""The Archive tab put together."""

from PySide6.QtCore import QObject

from core.plans.plan import Plan, Step
from gui.archive.exporting import Exporting
from gui.archive.library import Library
from gui.archive.presenter import ArchivePresenter
from gui.archive.state import ArchiveState
from gui.archive.view import ArchiveView
from gui.services import Services


class ArchiveTab(QObject):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._titled = ""
        self.library = Library(services.jobs, services.root, self)
        self.presenter = ArchivePresenter(self.library, services.messages, services.open_file, self)
        self.view = ArchiveView(self.presenter)
        self.exporting = Exporting(self.presenter, services.root, services.messages, self)
        findings = self.view.findings
        findings.set_formats(self.exporting.formats)
        findings.export_requested.connect(self.exporting.export)
        self.presenter.changed.connect(self._on_changed)

    @property
    def widget(self) -> ArchiveView:
        """What is shown."""
        return self.view

    def _on_changed(self, state: ArchiveState) -> None:
        title = "" if state.findings is None else state.findings.title
        if title != self._titled:
            self._titled = title
            self.view.findings.show_name(self.exporting.propose())

    def after_paint(self) -> None:
        """Load the plot; the archive itself is opened when the tab first comes to the front."""
        from gui.archive.history_view import HistoryPlot

        self.view.put_plot(HistoryPlot())

    def why_busy(self) -> str:
        """Why the ports cannot be let go of: never, it has nothing to do with them."""
        return ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """Nothing has to be set on the rig."""
        return None

    def close(self) -> None:
        """Break off what runs; let go of the index and the plot."""
        self.library.close()
        self.view.drop_plot()


def make_tab(services: Services) -> ArchiveTab:
    """Build the tab."""
    return ArchiveTab(services)
