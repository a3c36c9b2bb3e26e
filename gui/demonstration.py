"""The scripted demonstration: the real window measures a whole session on the simulated rig.

Nothing is told to the window but what an operator would do: hands-free on, Process Data, Export.
The hidden truth of the rig is looked at only afterwards.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QApplication

from core.errors import LinkError
from core.procedures.measuring import Phase
from core.records.session.events import Position
from drivers.virtual.address import rig_of
from drivers.virtual.truth import Compared, compare
from gui.app import Application, Options
from gui.dividing_head.tab import HeadTab
from gui.widgets.theme import apply_theme

_SIZE = QSize(1280, 800)
_PATIENCE_S = 240.0
_SPEED = 20
_TAB = "Dividing head"
_PAUSE_S = 0.005


@dataclass(frozen=True, slots=True)
class Outcome:
    """What the demonstration left.

    Parameters
    ----------
    parameters : every estimate beside its truth
    session : folder of the session
    files : exports and pictures
    """

    parameters: tuple[Compared, ...]
    session: Path
    files: tuple[Path, ...]


def demonstrate(out: Path, device: str, seed: int) -> Outcome:
    """Measure, process and export in the window; leave files and pictures in `out`.

    Raises
    ------
    LinkError
        The session did not come to its end.
    """
    existing = QApplication.instance()
    qt = existing if isinstance(existing, QApplication) else QApplication(["calrig"])
    out.mkdir(parents=True, exist_ok=True)
    url = f"sim://{device}?speed={_SPEED}&seed={seed}&name=demo{time.time_ns()}"
    application = Application(
        qt,
        Options(simulated=url, root=out / "sessions", settings=out / "settings.json", quiet=True),
    )
    try:
        return _Scene(qt, application, out, url).play()
    finally:
        application.close()
        application.window.close()


class _Scene:
    def __init__(self, qt: QApplication, application: Application, out: Path, url: str) -> None:
        self._qt = qt
        self._application = application
        self._out = out
        self._url = url
        self._files: list[Path] = []

    def play(self) -> Outcome:
        application, url = self._application, self._url
        window = application.window
        window.resize(_SIZE)
        application.start()
        self._until(lambda: _TAB in application.tabs, "the tabs did not come")
        head = application.tabs[_TAB]
        if not isinstance(head, HeadTab):
            raise TypeError("the first tab is the dividing head")
        sitting = head.sitting
        self._until(lambda: sitting.walk.status is not None, "the rig did not answer")
        self._picture("1-connected")
        head.presenter.set_hands_free(True)
        application.rig.set_operator(True)
        self._until(lambda: self._phase(head) is Phase.MEASURING, "no accumulation began")
        self._until(lambda: len(self._positions(head)) >= 3, "no position was accepted")
        self._until(lambda: self._phase(head) is Phase.MEASURING, "no accumulation began")
        self._picture("2-measuring")
        self._until(lambda: self._phase(head) is Phase.FINISHED, "the plan was not finished")
        head.presenter.process()
        self._until(lambda: head.results.state is not None, "nothing was processed")
        self._picture("3-results")
        results = head.results.state
        if results is None:
            raise LinkError(url, "the demonstration stopped: the results were closed")
        for key in ("json", "c", "mat", "csv"):
            name = head.exporting.propose(key)
            head.exporting.export(key, name)
            self._files.append(Path(name))
            self._until(Path(name).exists, f"{name} was not written")
        session = Path(head.presenter.state.folder)
        return Outcome(compare(results.calibration, rig_of(url)), session, tuple(self._files))

    def _phase(self, head: HeadTab) -> Phase | None:
        status = head.sitting.walk.status
        return None if status is None else status.phase

    def _positions(self, head: HeadTab) -> tuple[Position, ...]:
        session = head.sitting.keeper.session
        return () if session is None else session.positions

    def _until(self, done: Callable[[], bool], otherwise: str) -> None:
        """Let the window work until something is done."""
        end = time.monotonic() + _PATIENCE_S
        while not done():
            if time.monotonic() > end:
                raise LinkError(self._url, f"the demonstration stopped: {otherwise}")
            self._qt.processEvents()
            time.sleep(_PAUSE_S)

    def _picture(self, name: str) -> None:
        """Take a picture in both looks."""
        for look in ("dark", "light"):
            apply_theme(self._qt, look)
            for _ in range(5):
                self._qt.processEvents()
            path = self._out / f"{name}-{look}.png"
            self._application.window.grab().save(str(path))
            self._files.append(path)
