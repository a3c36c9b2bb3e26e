"""The Drift tab put together."""

from pathlib import Path

from PySide6.QtCore import QObject

from core.errors import StorageError
from core.plans.plan import Plan, Step
from gui.drift.exporting import Exporting
from gui.drift.library import Library
from gui.drift.presenter import DriftPresenter
from gui.drift.view import DriftView
from gui.services import Services


class DriftTab(QObject):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.library = Library(services.jobs, self)
        self.presenter = DriftPresenter(self.library, services.messages, self)
        self.view = DriftView(self.presenter)
        self.exporting = Exporting(
            self.presenter,
            self.library,
            self._draw,
            services.root,
            services.jobs,
            services.messages,
            self,
        )
        findings = self.view.page.findings
        findings.set_formats(self.exporting.formats)
        findings.format_chosen.connect(self._propose)
        findings.export_requested.connect(self.exporting.export)
        self.library.changed.connect(self._on_library)

    @property
    def widget(self) -> DriftView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the plots."""
        from gui.drift.plots_view import PlotsView

        self.view.put_plots(PlotsView())
        self._on_library()

    def why_busy(self) -> str:
        """Why the ports cannot be let go of: nothing here uses them."""
        return ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """Nothing has to be set on the rig."""
        return None

    def load(self, path: Path) -> None:
        """Take the record of a turn-on, or a folder of them."""
        self.presenter.add([str(path)])

    def close(self) -> None:
        """Let go of the plots."""
        self.view.drop_plots()

    def _on_library(self) -> None:
        self._propose(self.view.page.findings.chosen_format)

    def _propose(self, key: str) -> None:
        self.view.page.findings.show_name(self.exporting.propose(key))

    def _draw(self, path: Path) -> None:
        from gui.widgets.chart_export import save_chart

        plots = self.view.plots
        if plots is None:
            raise StorageError(f"{path}: there is no plot yet")
        save_chart(plots.paint, plots.size(), path, "Drift after switching on")


def make_tab(services: Services) -> DriftTab:
    """Build the tab."""
    return DriftTab(services)
