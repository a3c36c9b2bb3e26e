"""The Live tab put together."""

from pathlib import Path

from PySide6.QtCore import QObject

from core.plans.plan import Plan, Step
from gui.live.exporting import Exporting
from gui.live.interrupted import Interrupted
from gui.live.keeper import Keeper
from gui.live.loading import Loading
from gui.live.means import Means
from gui.live.measures import Measures
from gui.live.presenter import LivePresenter
from gui.live.state import Phase
from gui.live.view import LiveView
from gui.services import Services


class LiveTab(QObject):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        messages, jobs = services.messages, services.jobs
        self.keeper = Keeper(services.root, jobs, messages, self)
        self.loading = Loading(jobs, messages, self)
        self.exporting = Exporting(jobs, messages, self)
        self.means = Means(messages, self)
        self.measures = Measures(self.keeper, self.exporting, self.means, self)
        self._root = services.root
        self.presenter = LivePresenter(
            services.connection,
            self.keeper,
            self.loading,
            self.measures,
            messages,
            services.settings,
            self,
        )
        self.interrupted = Interrupted(jobs, messages, services.settings, self)
        self.interrupted.chosen.connect(self._on_interrupted)
        self.view = LiveView(self.presenter, self.exporting, self.means)

    @property
    def widget(self) -> LiveView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Look for records that a crash interrupted."""
        self.interrupted.look(self._root())

    def _on_interrupted(self, path: Path) -> None:
        self.presenter.load(path)
        self.view.come_to_front()

    def why_busy(self) -> str:
        """Why the ports cannot be let go of."""
        return "A record is running." if self.presenter.phase is Phase.RECORDING else ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """The rig is free."""
        return None

    def close(self) -> None:
        """End the record; its file is whole."""
        self.keeper.close()


def make_tab(services: Services) -> LiveTab:
    """Build the tab."""
    return LiveTab(services)
