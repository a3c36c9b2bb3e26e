"""F11: the step of the tab over the whole window, with all its keys."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication

from core.errors import Severity
from drivers.virtual.address import rig_of
from gui.widgets.states import BannerState
from tests.gui.window_driver import Driver


def test_a_position_is_measured_in_the_distance_view(open_app: Callable[[], Driver]):
    operator = open_app()
    url = "sim://pointer?speed=20&seed=8&name=distance"
    operator.app.open_simulated(url)
    operator.until(lambda: operator.tab.bench.linked)
    window, view = operator.app.window, operator.app.guidance.distance.view
    operator.key(Qt.Key.Key_F11)
    operator.until(view.isVisible)
    assert window.isFullScreen()
    assert view.size() == window.size()
    assert view.accessibleName() == operator.tab.presenter.state.stage.headline

    # Digits and arrows reach the list of steps, Space the row of actions.
    operator.key(Qt.Key.Key_3)
    assert operator.step.number == 3
    operator.key(Qt.Key.Key_1)
    rig_of(url).remount(operator.step.mount)
    rig_of(url).turn(operator.step.head_deg)
    operator.bot.wait(300)
    operator.key(Qt.Key.Key_Space)
    operator.until(lambda: operator.tab.sitting.walk.measuring)
    assert "Measuring" in view.accessibleName()
    operator.until(lambda: operator.count == 1)

    # A message stands below it, and large in it; Esc leaves and stops nothing.
    banner = BannerState(Severity.WARNING, "Something is wrong", "", "Look.")
    operator.app.messages.show("test", banner)
    QApplication.processEvents()
    assert view.geometry().bottom() < window.banner.mapTo(window, QPoint()).y()
    assert "Something is wrong" in view.accessibleDescription()
    operator.app.messages.clear("test")
    operator.key(Qt.Key.Key_Space)
    operator.until(lambda: operator.tab.sitting.walk.measuring)
    operator.key(Qt.Key.Key_Escape)
    assert not view.isVisible()
    assert not window.isFullScreen()
    assert operator.tab.sitting.walk.measuring
    operator.key(Qt.Key.Key_Escape)
    assert not operator.tab.sitting.walk.measuring


@pytest.mark.parametrize("title", ["Dividing head", "Rate table", "Accuracy"])
def test_every_measuring_tab_has_it_and_others_cannot_open_it(
    open_app: Callable[[], Driver], title: str
):
    app = open_app().app
    tabs = app.window.tabs
    tabs.setCurrentWidget(app.tabs[title].widget)
    assert app.window.menu.distance.isEnabled()
    app.guidance.distance.enter()
    assert app.guidance.distance.view.isVisible()
    tabs.setCurrentWidget(app.tabs["Archive"].widget)
    assert not app.guidance.distance.view.isVisible()
    assert not app.window.menu.distance.isEnabled()
