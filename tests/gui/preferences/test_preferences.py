"""Preferences: stated once, taken by every measuring tab, kept from one start to the next."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from drivers.virtual.address import rig_of
from gui.measuring.site import Site, site_of
from gui.measuring.tab import MeasuringTab
from gui.settings import Settings, folder_of
from gui.widgets.theme import current_theme
from tests.gui.window_driver import Driver

CONTROL = Qt.KeyboardModifier.ControlModifier


def test_gravity_and_latitude_reach_every_measuring_tab_and_the_next_start(
    open_app: Callable[[], Driver],
):
    first = open_app()
    first.key(Qt.Key.Key_Comma, CONTROL)
    panel = first.app.window.preferences
    assert panel.isVisible()
    panel._g.setValue(9.81812)
    panel._latitude.setValue(50.45)
    measuring = [tab for tab in first.app.tabs.values() if isinstance(tab, MeasuringTab)]
    assert len(measuring) == 3
    for tab in measuring:
        assert tab.sitting.settings.g_mps2 == 9.81812
    assert first.app.tabs["Rate table"].sitting.settings.latitude_deg == 50.45
    first.key(Qt.Key.Key_Escape)
    assert not panel.isVisible()
    first.app.window.close()
    second = open_app()
    assert second.app.guidance.preferences.state.site == Site("", 9.81812, 0.0005, 50.45)
    assert second.tab.sitting.settings.g_mps2 == 9.81812


def test_a_session_states_its_operator_and_keeps_its_gravity(open_app: Callable[[], Driver]):
    operator = open_app()
    url = "sim://pointer?speed=20&seed=8&name=preferences"
    operator.app.open_simulated(url)
    operator.until(lambda: operator.tab.bench.linked)
    operator.key(Qt.Key.Key_Comma, CONTROL)
    panel = operator.app.window.preferences
    operator.bot.keyClicks(panel._operator, "O. Shevchenko")
    operator.key(Qt.Key.Key_Return)
    rig_of(url).remount(operator.step.mount)
    operator.bot.wait(300)
    operator.press("accumulate")
    operator.until(lambda: operator.count == 1)
    session = operator.tab.sitting.keeper.session
    assert session is not None
    assert session.record.start.operator == "O. Shevchenko"
    panel._g.setValue(9.80)
    assert operator.tab.sitting.settings.g_mps2 == 9.8106
    assert operator.app.tabs["Accuracy"].sitting.settings.g_mps2 == 9.80


def test_look_and_sounds_are_those_of_the_menu(open_app: Callable[[], Driver]):
    app = open_app().app
    app.window.toggle_preferences()
    panel = app.window.preferences
    panel._look.setCurrentIndex(panel._look.findData("dark"))
    panel._look.activated.emit(panel._look.currentIndex())
    QApplication.processEvents()
    assert current_theme().name == "dark"
    panel._sounds.setCurrentIndex(panel._sounds.findData("off"))
    panel._sounds.activated.emit(panel._sounds.currentIndex())
    assert app.sounds.volume == 0.0
    app.window.menu.looks["light"].trigger()


def test_the_language_is_that_of_the_menu_and_changes_at_once(open_app: Callable[[], Driver]):
    operator = open_app()
    app = operator.app
    app.window.toggle_preferences()
    panel = app.window.preferences
    for code, title in (("uk", "Налаштування"), ("en", "Preferences")):
        panel._language.setCurrentIndex(panel._language.findData(code))
        panel._language.activated.emit(panel._language.currentIndex())
        operator.until(lambda title=title: panel._title.text() == title)
        assert app.languages.choice == code
        assert app.window.menu.languages[code].isChecked()
        assert panel._language.currentData() == code
        assert panel._language.accessibleName() == ("Мова" if code == "uk" else "Language")


def test_another_folder_is_told_and_used_at_the_next_start(
    open_app: Callable[[], Driver], tmp_path: Path
):
    app = open_app().app
    panel = app.window.preferences
    app.window.toggle_preferences()
    app.guidance.preferences.set_folder(str(tmp_path / "elsewhere"))
    assert "next start" in panel._hint.text()
    app.window.close()
    assert folder_of(Settings(tmp_path / "set.json")) == tmp_path / "elsewhere"
    app.guidance.preferences.set_folder("not a whole path")
    assert folder_of(app.settings) is None


def test_what_is_impossible_takes_its_default():
    assert site_of({"g_mps2": 3.0, "latitude_deg": 123.0, "operator": 7}) == Site()
    assert site_of(Site("A", 9.79, 0.001, -12.5).to_section()) == Site("A", 9.79, 0.001, -12.5)
