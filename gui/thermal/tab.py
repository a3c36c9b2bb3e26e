"""The Thermal tab put together."""

from pathlib import Path

from PySide6.QtCore import QObject

from core.errors import StorageError
from core.plans.plan import Plan, Step
from gui.services import Services
from gui.thermal.exporting import Exporting
from gui.thermal.library import Library
from gui.thermal.presenter import ThermalPresenter
from gui.thermal.view import ThermalView


class ThermalTab(QObject):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.library = Library(services.jobs, self)
        self.presenter = ThermalPresenter(
            self.library, services.root, services.jobs, services.messages, self
        )
        self.view = ThermalView(self.presenter)
        self.exporting = Exporting(
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
    def widget(self) -> ThermalView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the plots."""
        from gui.thermal.plots_view import PlotsView

        self.view.put_plots(PlotsView())
        self._on_library()

    def why_busy(self) -> str:
        """Why the ports cannot be let go of: nothing here uses them."""
        return ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """Nothing has to be set on the rig."""
        return None

    def load(self, path: Path) -> None:
        """Take a session's folder, or a file with positions over temperature."""
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
        save_chart(plots.paint, plots.size(), path, "Over temperature")


def make_tab(services: Services) -> ThermalTab:
    """Build the tab."""
    return ThermalTab(services)
