"""The scripted demonstration: the real window measures whole sessions on the simulated rig.

Nothing is told to the window but what an operator would do: hands-free on, Process Data, Export.
The hidden truth of the rig is looked at only afterwards. What is played stands with each tab, in
its ``demo`` module; `STEPS` lists them.
"""

import importlib
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlencode

from PySide6.QtCore import QEvent, QSize
from PySide6.QtWidgets import QApplication

from core.errors import LinkError
from drivers.virtual.address import rig_of
from drivers.virtual.rig import Rig
from drivers.virtual.truth import Compared
from gui.app import Application, Options
from gui.measuring.demonstrating import Told
from gui.widgets.theme import apply_theme

STEPS: tuple[str, ...] = (
    "gui.dividing_head.demo",
    "gui.rate_table.demo",
    "gui.accuracy.demo",
    "gui.live.demo",
    "gui.allan.demo",
    "gui.thermal.demo",
    "gui.drift.demo",
    "gui.frames.demo",
    "gui.certificate.demo",
)
"""Modules with ``play(stage) -> Told``, in the order of playing."""

_SIZE = QSize(1280, 800)
_PATIENCE_S = 240.0
_SPEED = 20
_PAUSE_S = 0.005


@dataclass(frozen=True, slots=True)
class Outcome:
    """What the demonstration left.

    Parameters
    ----------
    parts : what each tab told
    files : exports and pictures
    """

    parts: tuple[Told, ...]
    files: tuple[Path, ...]

    @property
    def parameters(self) -> tuple[Compared, ...]:
        """Every estimate of all parts beside its truth."""
        return tuple(row for part in self.parts for row in part.parameters)


def demonstrate(out: Path, steps: tuple[str, ...], seed: int) -> Outcome:
    """Measure, process and export in the window; leave files and pictures in `out`.

    Parameters
    ----------
    out : folder, made if need be
    steps : modules of `STEPS`
    seed : of the units and their noise

    Raises
    ------
    LinkError
        A session did not come to its end.
    """
    existing = QApplication.instance()
    qt = existing if isinstance(existing, QApplication) else QApplication(["calrig"])
    out.mkdir(parents=True, exist_ok=True)
    application = Application(
        qt, Options(root=out / "sessions", settings=out / "settings.json", quiet=True)
    )
    scene = _Scene(qt, application, out, seed)
    try:
        scene.open()
        parts = tuple(importlib.import_module(step).play(scene) for step in steps)
        return Outcome(parts, tuple(scene.files))
    finally:
        application.close()
        application.window.close()
        # What is connected to the window keeps it alive until Qt lets go of it.
        application.window.deleteLater()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


class _Scene:
    """The window as the parts handle it."""

    def __init__(self, qt: QApplication, application: Application, out: Path, seed: int) -> None:
        self._qt = qt
        self._application = application
        self._out = out
        self._seed = seed
        self.files: list[Path] = []

    def open(self) -> None:
        """Show the window."""
        application = self._application
        ready: list[bool] = []
        application.ready.connect(lambda: ready.append(True))
        application.window.resize(_SIZE)
        application.start()
        self.until(lambda: bool(ready), "the tabs did not come")

    def connect(self, device: str, **changes: object) -> Rig:
        query = {"speed": _SPEED, "seed": self._seed, "name": f"demo{time.time_ns()}", **changes}
        url = f"sim://{device}?{urlencode(query)}"
        connection = self._application.connection
        self._application.open_simulated(url)
        self.until(lambda: connection.link is not None, "the rig could not be opened")
        # What the tabs before say of the new device belongs to no picture of this one.
        messages = self._application.messages
        while messages.current is not None:
            messages.dismiss()
        return rig_of(url)

    def show(self, title: str) -> object:
        tab = self._application.tabs[title]
        self._application.window.tabs.setCurrentWidget(tab.widget)
        return tab

    def set_operator(self, on: bool) -> None:
        self._application.rig.set_operator(on)

    def until(self, done: Callable[[], bool], otherwise: str) -> None:
        end = time.monotonic() + _PATIENCE_S
        while not done():
            if time.monotonic() > end:
                link = self._application.connection.link
                port = "sim://" if link is None else link.setup.url
                raise LinkError(port, f"the demonstration stopped: {otherwise}")
            self._qt.processEvents()
            time.sleep(_PAUSE_S)

    def keep(self, path: Path) -> None:
        self.files.append(path)

    def picture(self, name: str) -> None:
        for look in ("dark", "light"):
            apply_theme(self._qt, look)
            for _ in range(5):
                self._qt.processEvents()
            path = self._out / f"{name}-{look}.png"
            self._application.window.grab().save(str(path))
            self.files.append(path)
