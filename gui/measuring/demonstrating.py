"""What the demonstration of a measuring tab is made of; each tab has its own ``demo`` module."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from core.procedures.measuring import Phase
from drivers.virtual.rig import Rig
from drivers.virtual.truth import Compared
from gui.measuring.tab import MeasuringTab


class Stage(Protocol):
    """The window on the simulated rig, as a demonstration handles it."""

    @property
    def sessions(self) -> Path:
        """The folder of all sessions."""
        ...

    def connect(self, device: str, **changes: object) -> Rig:
        """Open another simulated device; `changes` are keys of its address, such as ``speed``."""
        ...

    def show(self, title: str) -> object:
        """Bring a tab to the front."""
        ...

    def until(self, done: Callable[[], bool], otherwise: str) -> None:
        """Let the window work until something is done; `otherwise` says what was not."""
        ...

    def rest(self, seconds: float) -> None:
        """Let the window work for some time."""
        ...

    def set_operator(self, on: bool) -> None:
        """Let the operator of the rig do what the stage of the tab asks."""
        ...

    def picture(self, name: str) -> None:
        """Take a picture of the window in both looks."""
        ...

    def drawing(self, name: str, save: Callable[[str], bool]) -> None:
        """Keep a picture of what has one look, such as paper; `save` writes it to a path."""
        ...

    def keep(self, path: Path) -> None:
        """Count a file among those that the demonstration left."""
        ...


@dataclass(frozen=True, slots=True)
class Told:
    """What the part of one tab left.

    Parameters
    ----------
    title : of the tab
    parameters : every estimate beside its truth
    session : folder of the session
    """

    title: str
    parameters: tuple[Compared, ...]
    session: Path


def walk(stage: Stage, tab: MeasuringTab[Any], picture: str = "") -> Path:
    """Measure the whole plan hands-free; return the folder of the session.

    Parameters
    ----------
    picture : name of the picture that is taken in the middle of an accumulation; empty for none
    """
    sitting = tab.sitting
    stage.until(lambda: sitting.walk.status is not None, "the rig did not answer")
    tab.presenter.set_hands_free(True)
    stage.set_operator(True)
    if picture:
        stage.until(lambda: len(sitting.keeper.positions) >= 3, "no position was accepted")
        stage.until(lambda: _phase(tab) is Phase.MEASURING, "no accumulation began")
        stage.picture(picture)
    stage.until(lambda: _phase(tab) is Phase.FINISHED, "the plan was not finished")
    stage.set_operator(False)
    tab.presenter.set_hands_free(False)
    return Path(tab.presenter.state.folder)


def process(stage: Stage, tab: MeasuringTab[Any], picture: str, formats: Sequence[str]) -> None:
    """Process what was measured, take a picture of the results, and export them."""
    before = tab.results.page
    tab.presenter.process()
    stage.until(lambda: tab.results.page not in (None, before), "nothing was processed")
    if picture:
        stage.picture(picture)
    for key in formats:
        path = Path(tab.exporting.propose(key))
        tab.exporting.export(key, str(path))
        stage.until(path.exists, f"{path.name} was not written")
        stage.keep(path)


def _phase(tab: MeasuringTab[Any]) -> Phase | None:
    status = tab.sitting.walk.status
    return None if status is None else status.phase
