"""The real window, and a board that nobody has seen."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from core.samples.block import Channel
from drivers.checksums import ChecksumSpec, CrcSpec
from drivers.profile_types import FieldSpec
from gui.app import Application, Options
from gui.frames.tab import FramesTab
from tests.drivers.teach.layouts import Layout
from tests.gui.frames.board import Board

TITLE = "Teach a board"


def field(name: str, type_: str, at: int) -> FieldSpec:
    return FieldSpec((Channel(name, "code"),), type_, at, endian="big")


def strange() -> Layout:
    """A header of three bytes, a counter, three int24 and a CRC of an unheard-of polynomial."""
    crc = CrcSpec(16, 0xA097, 0x1D3B, refin=True, refout=True, xorout=0x5AA5)
    names = [("n", "u8"), ("a", "i24"), ("b", "i24"), ("c", "i24"), ("t", "i16")]
    fields, at = [], 3
    for name, type_ in names:
        fields.append(field(name, type_, at))
        at += int(type_[1:]) // 8
    check = ChecksumSpec("crc16", 3, -2, -2, 2, "little", crc=crc)
    return Layout(b"\x9c\xd1\x2e", at + 2, tuple(fields), 0, check, b"", 0.1)


class Operator:
    """Hands and eyes at the window."""

    def __init__(self, app: Application, bot: QtBot) -> None:
        self.app = app
        self.bot = bot
        tab = app.tabs[TITLE]
        assert isinstance(tab, FramesTab)
        self.tab = tab

    def show(self, title: str) -> None:
        self.app.window.tabs.setCurrentWidget(self.app.tabs[title].widget)

    def click(self, widget: object) -> None:
        self.bot.mouseClick(widget, Qt.MouseButton.LeftButton)

    def type(self, line: object, text: str) -> None:
        line.setFocus()
        line.selectAll()
        self.bot.keyClicks(line, text)
        self.bot.keyClick(line, Qt.Key.Key_Return)

    def drag(self, first: int, last: int) -> None:
        """Point at columns of the bytes with the mouse."""
        view = self.tab.view.bytes
        port = view.viewport()
        y = port.height() // 2
        places = [QPoint(view._x(column) + view._cell // 2, y) for column in (first, last)]
        self.bot.mousePress(port, Qt.MouseButton.LeftButton, pos=places[0])
        self.bot.mouseMove(port, places[1])
        view._point(last)
        self.bot.mouseRelease(port, Qt.MouseButton.LeftButton, pos=places[1])

    def until(self, condition: Callable[[], bool], milliseconds: int = 40_000) -> None:
        def come() -> bool:
            assert QApplication.activeModalWidget() is None
            return condition()

        self.bot.waitUntil(come, timeout=milliseconds)


@pytest.fixture
def board() -> Iterator[Board]:
    made = Board(strange())
    yield made
    made.close()


@pytest.fixture
def operator(qtbot: QtBot, tmp_path: Path) -> Iterator[Operator]:
    qt = QApplication.instance()
    assert isinstance(qt, QApplication)
    options = Options(root=tmp_path / "data", settings=tmp_path / "set.json", quiet=True)
    app = Application(qt, options)
    qtbot.addWidget(app.window)
    app.start()
    qtbot.waitUntil(lambda: TITLE in app.tabs, timeout=40_000)
    hands = Operator(app, qtbot)
    hands.show(TITLE)
    yield hands
    app.close()
