"""Pictures of the window in all its states: ``python tests/gui/window_pictures.py FOLDER``.

Every picture is made twice, light and dark, as ``NAME-SIZE-LOOK.png``.
"""

import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QEventLoop, QSize, QTimer
from PySide6.QtWidgets import QApplication

from drivers.virtual.address import rig_of
from drivers.virtual.rig import Rig
from gui.app import Application, Options
from gui.dividing_head.tab import HeadTab
from gui.widgets.colours import THEMES
from gui.widgets.theme import apply_theme

SIZES = (QSize(1280, 800), QSize(1920, 1080))
_PATIENCE_S = 30.0


class Studio:
    """One window on one rig, posed and drawn.

    Parameters
    ----------
    device : on the rig; empty for a window without a device
    folder : where pictures go
    speed : how fast the rig's time goes while positions are walked
    """

    def __init__(self, qt: QApplication, device: str, folder: Path, speed: int = 20) -> None:
        self.qt = qt
        self.folder = folder
        self._temporary = tempfile.TemporaryDirectory()
        root = Path(self._temporary.name)
        self.url = f"sim://{device}?speed={speed}&name={root.name}" if device else ""
        self.app = Application(qt, Options(self.url, root, root / "settings.json", quiet=True))
        ready: list[bool] = []
        self.app.ready.connect(lambda: ready.append(True))
        self.app.start()
        self.until(lambda: bool(ready))
        tab = self.app.tabs["Dividing head"]
        if not isinstance(tab, HeadTab):
            raise TypeError("the first tab is not the dividing head's")
        self.tab = tab
        if device:
            self.until(lambda: tab.bench.linked)
            self.wait(0.6)

    @property
    def rig(self) -> Rig:
        """The rig behind the port."""
        return rig_of(self.url)

    def walk(self, positions: int) -> None:
        """Have so many positions measured, hands-free, by the rig's own operator."""
        self.tab.presenter.set_hands_free(True)
        self.app.rig.set_operator(True)
        self.until(lambda: len(self.tab.sitting.keeper.positions) >= positions)
        self.app.rig.set_operator(False)

    def draw(self, name: str) -> None:
        """Save the window in both sizes and looks."""
        for size in SIZES:
            self.app.window.resize(size)
            for look in THEMES:
                apply_theme(self.qt, look)
                self.wait(0.15)
                path = self.folder / f"{name}-{size.width()}-{look}.png"
                if not self.app.window.grab().save(str(path)):
                    raise OSError(f"{path}: the picture could not be written")

    def until(self, condition: Callable[[], bool]) -> None:
        """Let the program run until something is so."""
        deadline = time.monotonic() + _PATIENCE_S
        while not condition():
            if time.monotonic() > deadline:
                raise TimeoutError("the window never came to the pose")
            self.wait(0.02)

    def wait(self, seconds: float) -> None:
        """Let the program run."""
        loop = QEventLoop()
        QTimer.singleShot(round(1000 * seconds), loop.quit)
        loop.exec()

    def close(self) -> None:
        """End the program."""
        self.app.window.close()
        self.app.window.deleteLater()
        self._temporary.cleanup()


def empty(studio: Studio) -> None:
    """Before anything is connected."""
    studio.draw("empty")
    studio.app.window.toggle_devices()
    studio.until(lambda: bool(studio.app.devices.state.ports))
    studio.draw("devices")


def session(studio: Studio, prefix: str) -> None:
    """Ready, measuring, a wrong position, a lost link, results."""
    studio.draw(f"{prefix}-ready")
    studio.walk(3)
    studio.tab.presenter.set_hands_free(False)
    _stand(studio, 3)
    settings = studio.tab.sitting.settings
    # Long enough to be drawn four times.
    studio.tab.presenter.set_settings(replace(settings, accumulation_s=400.0))
    studio.tab.presenter.act("accumulate")
    studio.wait(4.0)
    studio.draw(f"{prefix}-measuring")
    studio.tab.presenter.act("stop")
    studio.tab.presenter.set_settings(settings)
    _stand(studio, 0)
    studio.tab.taking.choose(studio.tab.sitting.plan.steps[3].number)
    studio.tab.presenter.act("accumulate")
    studio.until(lambda: studio.tab.taking.pending is not None)
    studio.draw(f"{prefix}-wrong")
    studio.tab.taking.drop()
    studio.rig.unplug()
    studio.until(lambda: not studio.tab.bench.linked)
    studio.draw(f"{prefix}-lost")
    studio.rig.plug_in()
    studio.until(lambda: studio.tab.bench.linked)
    studio.walk(8)
    studio.tab.presenter.act("process")
    studio.until(lambda: studio.tab.results.state is not None)
    studio.wait(0.5)
    studio.draw(f"{prefix}-results")


def _stand(studio: Studio, place: int) -> None:
    """Turn the rig to a step of the plan."""
    step = studio.tab.sitting.plan.steps[place]
    studio.rig.remount(step.mount)
    studio.rig.turn(step.head_deg)
    studio.wait(1.0)


def main(folder: Path) -> None:
    """Draw all pictures."""
    folder.mkdir(parents=True, exist_ok=True)
    qt = QApplication.instance() or QApplication([])
    if not isinstance(qt, QApplication):
        raise TypeError("there is an application without widgets")
    studio = Studio(qt, "", folder)
    empty(studio)
    studio.close()
    for device in ("pointer", "clbacc"):
        studio = Studio(qt, device, folder)
        session(studio, device)
        studio.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
