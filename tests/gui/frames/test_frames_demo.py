"""The demonstration teaches a board and finds every number where it stands."""

from collections.abc import Callable
from pathlib import Path

from drivers.profile import load_profile
from gui.frames.demo import play
from tests.gui.frames.conftest import Operator


class Desk:
    """The window as a demonstration handles it; of pictures only the names are kept."""

    def __init__(self, operator: Operator) -> None:
        self._operator = operator
        self.kept: list[Path] = []
        self.pictures: list[str] = []

    def show(self, title: str) -> object:
        self._operator.show(title)
        return self._operator.app.tabs[title]

    def until(self, done: Callable[[], bool], otherwise: str) -> None:
        self._operator.until(done)

    def picture(self, name: str) -> None:
        self.pictures.append(name)

    def keep(self, path: Path) -> None:
        self.kept.append(path)


def test_the_demonstration_finds_all_that_it_hid(operator: Operator):
    desk = Desk(operator)
    told = play(desk)
    assert [row.symbol for row in told.parameters if not row.covered] == []
    assert len(told.parameters) == 5
    assert desk.pictures == ["teach-found", "teach-named"]
    profile = load_profile(desk.kept[0])
    assert (profile.name, profile.nominal_hz) == ("Invented board", 200.0)
