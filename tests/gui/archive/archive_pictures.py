"""Pictures of the Archive tab: ``python tests/gui/archive/archive_pictures.py FOLDER``.

Every picture is made light and dark, in two sizes, as ``archive-NAME-SIZE-LOOK.png``.
"""

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PySide6.QtCore import QEventLoop, QSize, QTimer
from PySide6.QtWidgets import QApplication

from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from gui.app import Application, Options
from gui.archive.tab import ArchiveTab
from gui.widgets.colours import THEMES
from gui.widgets.theme import apply_theme
from tests.core.archive.conftest import SPECIMENS, STATED, calibrated, measured

SIZES = (QSize(1280, 800), QSize(1920, 1080))
LIMITS = '[[limit]]\nparameter = "bias"\nunit = "code"\nlow = -395\nhigh = -360\n'


def wait(seconds: float) -> None:
    """Let the program run."""
    loop = QEventLoop()
    QTimer.singleShot(round(1000 * seconds), loop.quit)
    loop.exec()


def until(condition: Callable[[], bool]) -> None:
    """Let the program run until something is so, for half a minute at most."""
    for _ in range(600):
        if condition():
            return
        wait(0.05)
    raise TimeoutError("the window never came to the pose")


def fill(root: Path) -> None:
    """Fourteen calibrations of one unit whose bias drifts, and a damaged file."""
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    triad = calibrate(run, STATED)
    rng = np.random.default_rng(2)
    for n in range(14):
        when = f"{2023 + n // 5}-{1 + n * 7 % 12:02d}-1{n % 9}T09:30:00+00:00"
        folder = root / f"{when[:10].replace('-', '')}_0930_PW09_pointer_8"
        measured(folder, started=when, operator="Олена" if n % 3 else "Іван", positions=8)
        bias, warmth = float(rng.normal(n, 4.0)), 24.0 + float(rng.normal())
        calibrated(triad, folder, when=when, bias=bias, temperature_c=warmth)
    measured(root / "open", device="PW10", finish=False, started="2026-03-01T10:00:00+02:00")
    damaged = calibrated(triad, root / "damaged")
    damaged.write_text(damaged.read_text("utf-8")[:500], "utf-8")
    (root / "limits.toml").write_text(LIMITS, "utf-8")


class Studio:
    """The window with the tab in front."""

    def __init__(self, qt: QApplication, root: Path, folder: Path) -> None:
        self.qt, self.folder = qt, folder
        self.app = Application(qt, Options("", root, root.parent / "settings.json", quiet=True))
        ready: list[bool] = []
        self.app.ready.connect(lambda: ready.append(True))
        self.app.start()
        until(lambda: bool(ready))
        tab = self.app.tabs["Archive"]
        if not isinstance(tab, ArchiveTab):
            raise TypeError("the tab is not the archive's")
        self.tab = tab
        wait(0.5)
        self.app.messages.clear("welcome")
        self.app.window.tabs.setCurrentWidget(tab.widget)
        self.settle()

    def settle(self) -> None:
        """Wait until nothing is asked any more."""
        wait(0.1)
        until(lambda: self.tab.library.idle)
        wait(0.2)

    def choose(self, kind: str, *places: int) -> None:
        """Choose entries of a kind by their places among those."""
        rows = [row.id for row in self.tab.presenter.state.rows if row.cells[1] == kind]
        self.tab.presenter.choose([rows[place] for place in places])
        self.settle()

    def draw(self, name: str) -> None:
        """Save the window in both sizes and looks."""
        for size in SIZES:
            self.app.window.resize(size)
            for look in THEMES:
                apply_theme(self.qt, look)
                wait(0.2)
                path = self.folder / f"archive-{name}-{size.width()}-{look}.png"
                if not self.app.window.grab().save(str(path)):
                    raise OSError(f"{path}: the picture could not be written")


def main(folder: Path) -> None:
    """Draw all pictures."""
    folder.mkdir(parents=True, exist_ok=True)
    qt = QApplication.instance() or QApplication([])
    if not isinstance(qt, QApplication):
        raise TypeError("there is an application without widgets")
    with tempfile.TemporaryDirectory() as temporary:
        root = Path(temporary) / "CalRig"
        root.mkdir()
        studio = Studio(qt, root, folder)
        studio.draw("empty")
        fill(root)
        studio.tab.presenter.act("refresh")
        studio.settle()
        studio.tab.presenter.import_folder(str(SPECIMENS))
        studio.settle()
        studio.draw("import")
        studio.choose("calibration", 3)
        studio.draw("one")
        studio.choose("calibration", 3, 9)
        studio.draw("two")
        studio.choose("session", 3)
        studio.draw("session")
        studio.app.window.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
