"""What helps the operator beside the tabs: distance view, sheet of keys, tour."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject

from gui.distance import Distance
from gui.keys.showing import Keys
from gui.main_window import MainWindow
from gui.measuring.view import MeasuringView
from gui.messages import Messages
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
    page : the tab that the tour shows
    connect : connects the simulated rig, if nothing is connected
    """

    def __init__(
        self,
        window: MainWindow,
        messages: Messages,
        settings: Settings,
        root: Callable[[], Path],
        page: MeasuringView,
        connect: Callable[[], None],
    ) -> None:
        super().__init__(window)
        self.distance = Distance(window, messages)
        self.keys = Keys(window, messages, root)
        self.tour = Tour(window, page, messages, settings, connect)
