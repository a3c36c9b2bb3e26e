"""The window as a whole: how fast it starts, what it remembers, that it stands long use."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDockWidget, QDoubleSpinBox, QWidget
from pytestqt.qtbot import QtBot

from gui.app import TABS, Application, Options
from gui.widgets.theme import current_theme
from tests.gui.window_driver import Driver

ROOT = Path(__file__).parents[2]

_START = """
import json, sys, time
from pathlib import Path
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QApplication
from gui import app as shell
from gui.app import Application, Options

# Each tab answers for itself; the first is what every start shows.
first = next(iter(shell.TABS))
for title in list(shell.TABS):
    if title != first:
        del shell.TABS[title]

class Watch(QObject):
    painted = 0.0
    def eventFilter(self, target, event):
        if event.type() == QEvent.Type.Paint and not Watch.painted:
            Watch.painted = time.process_time()
            Watch.modules = set(sys.modules)
        return False

qt = QApplication([])
app = Application(qt, Options("pointer", Path(sys.argv[1]), Path(sys.argv[1]) / "s.json", True))
watch = Watch()
app.window.centralWidget().installEventFilter(watch)
app.start()
while not Watch.painted:
    qt.processEvents()
early = sorted(m for m in Watch.modules if m.partition(".")[0] in ("scipy", "pyqtgraph"))
deadline = time.monotonic() + 1.0
while time.monotonic() < deadline:
    qt.processEvents()
later = sorted(m for m in sys.modules if m.partition(".")[0] == "scipy")
app.window.close()
print(json.dumps({"cpu_s": Watch.painted, "early": early, "later": later[:3]}))
"""


def test_the_window_is_painted_within_a_second_of_cpu_and_without_scipy(tmp_path: Path):
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}
    out = subprocess.run(
        [sys.executable, "-c", _START, str(tmp_path)],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    told = json.loads(out.splitlines()[-1])
    assert told["early"] == []
    assert told["later"] == []
    assert told["cpu_s"] < 1.0, told


def test_the_first_tab_is_usable_before_the_others_are_made(qtbot: QtBot, tmp_path: Path):
    qt = QApplication.instance()
    assert isinstance(qt, QApplication)
    app = Application(qt, Options("", tmp_path, tmp_path / "set.json", quiet=True))
    qtbot.addWidget(app.window)
    there: list[list[str]] = []

    def on_usable() -> None:
        there.append(list(app.tabs))
        # Somebody is quicker than the program.
        app.window.tabs.setCurrentIndex(9)
        there.append(list(app.tabs))

    app.usable.connect(on_usable)
    with qtbot.waitSignal(app.ready, timeout=30_000):
        app.start()
    assert there == [["Dividing head"], ["Dividing head", "Archive"]]
    assert app.window.tabs.currentWidget() is app.tabs["Archive"].widget
    assert set(app.tabs) == set(TABS)
    for place, title in enumerate(TABS):
        assert app.window.tabs.widget(place) is app.tabs[title].widget
    app.close()


def test_a_tab_that_cannot_be_made_keeps_no_other_away(
    open_app: Callable[[], Driver], qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setitem(TABS, "Thermal", "gui.no_such_tab")
    with qtbot.captureExceptions() as caught:
        app = open_app().app
    assert [kind for kind, _, _ in caught] == [ModuleNotFoundError]
    assert set(app.tabs) == set(TABS) - {"Thermal"}


def test_keys_go_to_the_tab_when_the_rig_gives_it_its_room(open_app: Callable[[], Driver]):
    operator = open_app()
    app = operator.app
    app.open_simulated("pointer")
    operator.until(lambda: app.window.rig_dock.isVisible())
    panel = app.window.rig_dock.widget()
    assert panel is not None
    next(box for box in panel.findChildren(QDoubleSpinBox)).setFocus()
    app.window.tabs.setCurrentIndex(list(TABS).index("Archive"))
    assert not app.window.rig_dock.isVisible()
    focus = QApplication.focusWidget()
    page = app.tabs["Archive"].widget
    assert focus is page or (focus is not None and page.isAncestorOf(focus))


def test_every_tab_of_the_table_is_there_and_can_be_walked(open_app: Callable[[], Driver]):
    window = open_app().app.window
    assert [window.tabs.tabText(i) for i in range(window.tabs.count())] == list(TABS)
    for place in range(window.tabs.count()):
        window.tabs.setCurrentIndex(place)
        QApplication.processEvents()
        assert window.tabs.currentWidget().isVisible()


def test_look_sound_and_settings_are_remembered(open_app: Callable[[], Driver], tmp_path: Path):
    first = open_app()
    first.app.window.menu.looks["dark"].trigger()
    first.app.window.menu.volumes["off"].trigger()
    # The program may be killed before it is closed.
    kept = json.loads((tmp_path / "set.json").read_text("utf-8"))["window"]
    assert (kept["look"], kept["volume"]) == ("dark", 0.0)
    panel = first.tab.view.settings
    panel._g.setValue(9.8155)
    assert first.tab.sitting.settings.g_mps2 == 9.8155
    first.app.window.close()
    second = open_app()
    assert current_theme().name == "dark"
    assert second.app.sounds.volume == 0.0
    assert second.tab.sitting.settings.g_mps2 == 9.8155
    second.app.window.menu.looks["light"].trigger()
    assert current_theme().name == "light"


def test_damaged_preferences_cost_the_preferences_only(
    open_app: Callable[[], Driver], tmp_path: Path
):
    (tmp_path / "set.json").write_text("{not json", encoding="utf-8")
    driver = open_app()
    assert driver.app.window.isVisible()
    entries = driver.app.window.log._model.entries
    assert any("preferences cannot be read" in entry.text for entry in entries)


def test_the_rig_is_docked_only_beside_a_simulated_port(open_app: Callable[[], Driver]):
    driver = open_app()
    dock = driver.app.window.findChild(QDockWidget, "rig")
    assert dock is not None
    assert not dock.isVisible()
    driver.app.open_simulated("pointer")
    driver.until(lambda: driver.tab.bench.linked)
    assert dock.isVisible()
    driver.app.connection.close()
    assert not dock.isVisible()


def test_a_rig_that_does_not_exist_is_told(open_app: Callable[[], Driver]):
    driver = open_app()
    driver.app.open_simulated("no_such_unit")
    banner = driver.app.messages.current
    assert banner is not None
    assert banner.what == "No such rig"
    assert "clbacc" in banner.meaning


def test_a_hundred_thousand_qt_calls_lose_no_reference(open_app: Callable[[], Driver]):
    driver = open_app()
    driver.app.open_simulated("pointer")
    driver.until(lambda: driver.tab.bench.linked)
    view, state = driver.tab.view, driver.tab.presenter.state
    before = sys.getrefcount(None)
    for _ in range(400):
        view.render(state)
        for widget in view.findChildren(QWidget):
            widget.update()
            widget.setToolTip("")
    QApplication.processEvents()
    assert sys.getrefcount(None) > before - 2000


def test_closing_ends_everything(open_app: Callable[[], Driver]):
    driver = open_app()
    driver.app.open_simulated("pointer")
    driver.until(lambda: driver.tab.bench.linked)
    driver.key(Qt.Key.Key_Space)
    driver.app.window.close()
    assert driver.app.connection.link is None
    assert driver.tab.sitting.keeper.session is None


def test_the_rig_makes_room_where_it_is_of_no_use(open_app: Callable[[], Driver]):
    driver = open_app()
    app, tabs = driver.app, driver.app.window.tabs
    dock = app.window.rig_dock
    app.open_simulated("pointer")
    driver.until(lambda: driver.tab.bench.linked)
    for title in ("Archive", "Thermal", "Live", "Drift", "Dividing head"):
        tabs.setCurrentWidget(app.tabs[title].widget)
        assert dock.isVisible() == (title in ("Live", "Dividing head"))
    # Closed by the operator, it stays closed.
    dock.close()
    tabs.setCurrentWidget(app.tabs["Archive"].widget)
    tabs.setCurrentWidget(app.tabs["Live"].widget)
    assert not dock.isVisible()
