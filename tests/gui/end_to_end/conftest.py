"""The real window against a rig in a process of its own, behind a real pseudo-terminal."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from drivers.virtual.pty_process import PtyProcess
from gui.app import Application, Options
from tests.gui.window_driver import SPEED, Driver


@pytest.fixture
def rig(tmp_path: Path) -> Iterator[PtyProcess]:
    """PW09 on the rig, at a port whose name outlasts unplugging."""
    if sys.platform == "win32":
        pytest.fail("the pseudo-terminal needs Linux; run this file there")
    with PtyProcess(f"sim://pointer?speed={SPEED}&seed=5", tmp_path / "port") as process:
        yield process


@pytest.fixture
def open_app(qtbot: QtBot, tmp_path: Path) -> Iterator[Callable[[], Driver]]:
    """Start the program as often as a test wants, always on the same folder of sessions."""
    drivers: list[Driver] = []

    def start() -> Driver:
        qt = QApplication.instance()
        assert isinstance(qt, QApplication)
        options = Options(root=tmp_path / "data", settings=tmp_path / "set.json", quiet=True)
        driver = Driver(Application(qt, options), qtbot)
        qtbot.addWidget(driver.app.window)
        driver.app.start()
        driver.app.window.activateWindow()
        qtbot.waitUntil(driver.app.window.isActiveWindow)
        drivers.append(driver)
        return driver

    yield start
    for driver in drivers:
        driver.app.close()
