"""The tab Methods put together; a page is made when it is opened."""

import importlib
from typing import Protocol, cast

from PySide6.QtCore import QObject

from core.plans.plan import Plan, Step
from gui.methods.view import MethodsView, Page
from gui.services import Services

PAGES: dict[str, str] = {
    "advisor": "gui.advisor.page",
    "tumble": "gui.tumble.page",
    "gyrocompass": "gui.gyrocompass.page",
    "comparison": "gui.comparison.page",
}
"""Every page: its key and the module that makes it."""


class PageModule(Protocol):
    """The module of a page, named in the table of pages."""

    def make_page(self, services: Services) -> Page:
        """Build the page."""
        ...


class MethodsTab(QObject):
    """Makes the pages when they are opened, and speaks for them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self.pages: dict[str, Page] = {}
        self.view = MethodsView(tuple(PAGES))
        self.view.chosen.connect(self.open)

    @property
    def widget(self) -> MethodsView:
        """What is shown."""
        return self.view

    def open(self, key: str) -> None:
        """Show a page."""
        if key not in self.pages:
            module = cast("PageModule", importlib.import_module(PAGES[key]))
            self.pages[key] = module.make_page(self._services)
        self.view.put(self.pages[key])
        self.view.choose(key)

    def after_paint(self) -> None:
        """Nothing: the first page comes when the tab is seen."""

    def why_busy(self) -> str:
        """Why the ports cannot be let go of."""
        return next((why for page in self.pages.values() if (why := page.why_busy())), "")

    def wanted(self) -> tuple[Plan, Step] | None:
        """What the page on the screen wants to be set."""
        shown = self.view.list.currentRow()
        page = self.pages.get(list(PAGES)[shown]) if shown >= 0 else None
        return None if page is None else page.wanted()

    def close(self) -> None:
        """End what runs."""
        for page in self.pages.values():
            page.close()


def make_tab(services: Services) -> MethodsTab:
    """Build the tab."""
    return MethodsTab(services)
