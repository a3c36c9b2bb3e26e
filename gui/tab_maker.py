"""Makes the tabs: the one on the screen first, the others while the operator looks at it."""

import importlib
from collections.abc import Mapping
from typing import cast

from PySide6.QtCore import QObject, QTimer, Signal

from gui.main_window import MainWindow, Tab, TabModule
from gui.services import Services


class TabMaker(QObject):
    """Puts each tab's page where the window keeps a place for it.

    A tab that is opened or needed before its turn is made at once.

    Parameters
    ----------
    modules : title and module of every tab, in the order of the window
    tabs : filled with the tabs by their titles
    window : has an empty page for each
    services : what tabs are made with
    """

    complete = Signal()
    """All tabs are there."""

    def __init__(
        self,
        modules: Mapping[str, str],
        tabs: dict[str, Tab],
        window: MainWindow,
        services: Services,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._modules = modules
        self._tabs = tabs
        self._window = window
        self._services = services
        self._waiting = list(modules)
        self._next = QTimer(self, singleShot=True, interval=0)
        self._next.timeout.connect(self._make_next)
        window.tabs.currentChanged.connect(self.make_current)

    def make_current(self) -> None:
        """Make the tab that is in front."""
        place = self._window.tabs.currentIndex()
        if place >= 0:
            self._make(list(self._modules)[place])

    def make_rest(self) -> None:
        """Make the others one by one; keys and samples are attended to in between."""
        self._next.start()

    def all(self) -> Mapping[str, Tab]:
        """Return every tab; those that are missing are made at once."""
        for title in self._modules:
            self._make(title)
        return self._tabs

    def stop(self) -> None:
        """Make no more; the window closes."""
        self._next.stop()

    def _make_next(self) -> None:
        if not self._waiting:
            self.complete.emit()
            return
        title = self._waiting.pop(0)
        # First, since a tab that cannot be made must not keep the others away.
        self._next.start()
        self._make(title)

    def _make(self, title: str) -> None:
        if title in self._tabs:
            return
        module = cast("TabModule", importlib.import_module(self._modules[title]))
        tab = module.make_tab(self._services)
        self._tabs[title] = tab
        self._window.put_tab(list(self._modules).index(title), tab.widget, title)
        tab.after_paint()
