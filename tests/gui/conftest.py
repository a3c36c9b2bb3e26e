"""The real window on a folder of its own; faults in methods that Qt calls fail the test."""

import gc
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from gui.widgets.override_guard import guard_overrides

# Before any class of the window is defined.
guard_overrides()

if TYPE_CHECKING:
    from gui.services import Services
    from tests.gui.window_driver import Driver


@pytest.fixture(autouse=True)
def _garbage_stays_in_this_thread() -> Iterator[None]:
    """A worker that collects a dead widget of an earlier test would crash, as in the program."""
    gc.disable()
    yield
    gc.collect()
    # What is left are modules and their caches: to walk through them after each of a thousand
    # tests would take a minute.
    gc.freeze()
    gc.enable()


@pytest.fixture
def services(qapp: QApplication, tmp_path: Path) -> "Iterator[Services]":
    """What the window gives a tab, with real jobs; sessions are in the folder of the test."""
    from drivers.profile import load_profiles
    from gui.devices.connection import Connection
    from gui.jobs import Jobs
    from gui.messages import Messages
    from gui.services import Services
    from gui.settings import Settings

    jobs, messages = Jobs(), Messages()
    connection = Connection(load_profiles, lambda: tmp_path, messages)
    settings = Settings(tmp_path / "settings.json")
    yield Services(
        connection, jobs, messages, settings, load_profiles, lambda: tmp_path, lambda _: None
    )
    connection.close()
    jobs.close()


@pytest.fixture
def show_tab(qtbot: QtBot, services: "Services") -> "Iterator[Callable[[Any], None]]":
    """Show tabs as the window does after its first paint; close them at last."""
    shown: list[Any] = []

    def show(tab: Any) -> None:
        qtbot.addWidget(tab.view)
        tab.view.resize(1280, 700)
        tab.view.show()
        tab.after_paint()
        shown.append(tab)

    yield show
    for tab in shown:
        tab.close()


@pytest.fixture
def open_app(qtbot: QtBot, tmp_path: Path) -> "Iterator[Callable[[], Driver]]":
    """Start the program as often as a test wants, always on the same folder of sessions."""
    from gui.app import Application, Options
    from tests.gui.window_driver import Driver

    drivers: list[Driver] = []

    def start() -> Driver:
        qt = QApplication.instance()
        assert isinstance(qt, QApplication)
        options = Options(root=tmp_path / "data", settings=tmp_path / "set.json", quiet=True)
        app = Application(qt, options)
        qtbot.addWidget(app.window)
        # The first start of a process imports everything, beside other work.
        with qtbot.waitSignal(app.ready, timeout=30_000):
            app.start()
        app.window.activateWindow()
        qtbot.waitUntil(app.window.isActiveWindow)
        driver = Driver(app, qtbot)
        drivers.append(driver)
        return driver

    yield start
    for driver in drivers:
        driver.app.close()
