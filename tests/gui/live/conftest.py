"""The real window on a folder of its own, with a CVG that sends."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from gui.app import Application, Options
from gui.live.state import Phase
from gui.live.tab import LiveTab


class Operator:
    """Hands at the window, on the Live tab."""

    def __init__(self, app: Application, bot: QtBot) -> None:
        self.app = app
        self.bot = bot
        tab = app.tabs["Live"]
        assert isinstance(tab, LiveTab)
        self.tab = tab

    def click(self, widget: object) -> None:
        self.bot.mouseClick(widget, Qt.MouseButton.LeftButton)

    def until(self, condition: Callable[[], bool], milliseconds: int = 20_000) -> None:
        def come() -> bool:
            assert QApplication.activeModalWidget() is None
            return condition()

        self.bot.waitUntil(come, timeout=milliseconds)

    def answer(self, text: str) -> None:
        """A button of the banner."""

        def buttons() -> list[QPushButton]:
            found = self.app.window.banner.findChildren(QPushButton)
            return [b for b in found if b.isVisible() and b.text() == text]

        self.until(lambda: bool(buttons()))
        self.click(buttons()[0])


@pytest.fixture
def driver(qtbot: QtBot, tmp_path: Path) -> Iterator[Operator]:
    qt = QApplication.instance()
    assert isinstance(qt, QApplication)
    options = Options(root=tmp_path / "data", settings=tmp_path / "set.json", quiet=True)
    app = Application(qt, options)
    qtbot.addWidget(app.window)
    app.start()
    qtbot.waitUntil(lambda: "Live" in app.tabs, timeout=20_000)
    operator = Operator(app, qtbot)
    app.window.tabs.setCurrentWidget(operator.tab.widget)
    app.window.activateWindow()
    qtbot.waitUntil(app.window.isActiveWindow)
    app.open_simulated(f"cvg25?speed=20&seed=3&name={tmp_path.name}")
    operator.until(lambda: operator.tab.presenter.phase is Phase.WATCHING)
    yield operator
    app.close()
