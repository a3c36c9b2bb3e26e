"""The window as the parts of the demonstration handle it."""

import time
from collections.abc import Callable
from pathlib import Path
from urllib.parse import urlencode

from PySide6.QtCore import QSize, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from core.errors import LinkError, StorageError
from drivers.virtual.address import rig_of
from drivers.virtual.rig import Rig
from gui.app import Application
from gui.widgets.colours import THEMES
from gui.widgets.theme import apply_theme, current_theme

SESSIONS = "CalRig"
"""Folder of the sessions within that of the demonstration."""

_SIZE = QSize(1280, 800)
_PATIENCE_S = 240.0
_SPEED = 20
_PAUSE_S = 0.005
_STILL_S, _STILL_TURNS = 0.4, 8
"""So long, and through so many turns, a window is left to itself before its picture is taken."""


class WindowStage:
    """The window on the simulated rig.

    Parameters
    ----------
    qt : Qt's application
    application : whose window is played
    out : folder of the pictures; that of the sessions stands in it
    seed : of the units and their noise
    """

    def __init__(self, qt: QApplication, application: Application, out: Path, seed: int) -> None:
        self._qt = qt
        self.application = application
        self._out = out
        self._seed = seed
        self.files: list[Path] = []

    @property
    def sessions(self) -> Path:
        return self._out / SESSIONS

    def open(self) -> None:
        """Show the window."""
        application = self.application
        ready: list[bool] = []
        application.ready.connect(lambda: ready.append(True))
        application.window.resize(_SIZE)
        application.start()
        self.until(lambda: bool(ready), "the tabs did not come")
        self.hush()

    def connect(self, device: str, **changes: object) -> Rig:
        query = {"speed": _SPEED, "seed": self._seed, "name": f"demo{time.time_ns()}", **changes}
        url = f"sim://{device}?{urlencode(query)}"
        connection = self.application.connection
        self.application.open_simulated(url)
        self.until(lambda: connection.link is not None, "the rig could not be opened")
        self.hush()
        return rig_of(url)

    def hush(self) -> None:
        """Close what tabs said before: it belongs to no picture of what comes now."""
        messages = self.application.messages
        while messages.current is not None:
            messages.dismiss()

    def show(self, title: str) -> object:
        tab = self.application.tabs[title]
        self.hush()
        self.application.window.tabs.setCurrentWidget(tab.widget)
        return tab

    def set_operator(self, on: bool) -> None:
        self.application.rig.set_operator(on)

    def until(self, done: Callable[[], bool], otherwise: str) -> None:
        end = time.monotonic() + _PATIENCE_S
        while not done():
            if time.monotonic() > end:
                link = self.application.connection.link
                port = "sim://" if link is None else link.setup.url
                raise LinkError(port, f"the demonstration stopped: {otherwise}")
            self._turn()

    def rest(self, seconds: float) -> None:
        """Let the window work for some time."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self._turn()

    def keep(self, path: Path) -> None:
        self.files.append(path)

    def picture(self, name: str) -> None:
        self.picture_of(self.application.window, name)

    def picture_of(self, widget: QWidget, name: str) -> None:
        """Take a picture of a window in both looks, which show the same moment."""
        drained = self.application.connection.findChild(QTimer)
        waiting = drained is not None and drained.isActive()
        if drained is not None:
            drained.stop()
        # A change of look costs as much as all the rest: the look that is worn comes first.
        for look in sorted(THEMES, key=lambda name: THEMES[name] is not current_theme()):
            if THEMES[look] is not current_theme():
                apply_theme(self._qt, look)
            self.rest(_STILL_S)
            for _ in range(_STILL_TURNS):
                self._turn()
            self.drawing(f"{name}-{look}", widget.grab().save)
        if drained is not None and waiting:
            drained.start()

    def drawing(self, name: str, save: Callable[[str], bool]) -> None:
        path = self._out / f"{name}.png"
        if not save(str(path)):
            raise StorageError(f"{path}: the picture could not be written")
        self.files.append(path)

    def _turn(self) -> None:
        self._qt.processEvents()
        time.sleep(_PAUSE_S)
