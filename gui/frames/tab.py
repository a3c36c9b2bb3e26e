"""The tab Teach a board put together."""

from pathlib import Path

from PySide6.QtCore import QObject

from core.plans.plan import Plan, Step
from gui.frames.presenter import FramesPresenter
from gui.frames.source import Source
from gui.frames.view import FramesView
from gui.services import Services


class FramesTab(QObject):
    """Source, presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.source = Source(
            services.connection,
            services.jobs,
            services.messages,
            services.root,
            services.why_busy,
            self,
        )
        self.presenter = FramesPresenter(
            self.source,
            services.connection,
            services.jobs,
            services.messages,
            services.profiles,
            services.root,
            services.why_busy,
            self,
        )
        self.view = FramesView(self.presenter)

    @property
    def widget(self) -> FramesView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """List the ports."""
        self.source.refresh()

    def why_busy(self) -> str:
        """Why the ports cannot be let go of; listening is no measurement."""
        return ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """Nothing has to be set on the rig."""
        return None

    def load(self, path: Path) -> None:
        """Take the bytes of a file."""
        self.source.load(path)

    def close(self) -> None:
        """Let go of the port."""
        self.source.stop()


def make_tab(services: Services) -> FramesTab:
    """Build the tab."""
    return FramesTab(services)
