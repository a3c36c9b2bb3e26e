"""What helps the operator beside the tabs: distance view, sheet of keys, preferences, tour."""

from collections.abc import Callable, Mapping
from pathlib import Path

from PySide6.QtCore import QObject

from gui.distance import Distance
from gui.keys.showing import Keys
from gui.main_window import MainWindow, Tab
from gui.measuring.view import MeasuringView
from gui.messages import Messages
from gui.preferences.presenter import Preferences
from gui.preferences.view import PreferencesView
from gui.settings import Settings
from gui.tour.tour import Tour


class Guidance(QObject):
    """Makes the helps and keeps them.

    Parameters
    ----------
    window : of the program
    messages : banner and log
    settings : what is remembered
    root : returns the folder of all sessions
    tabs : by their titles; the first is the one that the tour shows
    connect : connects the simulated rig, if nothing is connected
    """

    def __init__(
        self,
        window: MainWindow,
        messages: Messages,
        settings: Settings,
        root: Callable[[], Path],
        tabs: Mapping[str, Tab],
        connect: Callable[[], None],
    ) -> None:
        super().__init__(window)
        self.distance = Distance(window, messages)
        self.keys = Keys(window, messages, root)
        self.preferences = Preferences(settings, tabs.values(), root(), self)
        panel = PreferencesView(self.preferences, window.menu)
        window.put_preferences(panel)
        page = next(tab.widget for tab in tabs.values() if isinstance(tab.widget, MeasuringView))
        self.tour = Tour(window, page, messages, settings, connect)
