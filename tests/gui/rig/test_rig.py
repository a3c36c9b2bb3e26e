"""The dock of the simulated rig: the dial, orders, the operator who turns for the user."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from drivers.virtual.address import rig_of
from gui.rig.dial_view import Dial
from gui.rig.view import RigPanel
from tests.gui.window_driver import Driver


@pytest.fixture
def dial(qtbot: QtBot) -> Dial:
    made = Dial()
    made.resize(200, 200)
    qtbot.addWidget(made)
    made.show()
    return made


def angles(dial: Dial) -> list[float]:
    came: list[float] = []
    dial.turned.connect(came.append)
    return came


@pytest.mark.parametrize(
    ("at", "angle"),
    [((100, 20), 0.0), ((180, 100), 90.0), ((100, 180), 180.0), ((20, 100), 270.0)],
)
def test_a_click_turns_there_by_the_shortest_scale(
    dial: Dial, qtbot: QtBot, at: tuple[int, int], angle: float
):
    came = angles(dial)
    qtbot.mousePress(dial, Qt.MouseButton.LeftButton, pos=QPoint(*at))
    assert came == []
    qtbot.mouseRelease(dial, Qt.MouseButton.LeftButton, pos=QPoint(*at))
    assert came == [angle]


def test_keys_and_wheel_turn_in_steps(dial: Dial, qtbot: QtBot):
    came = angles(dial)
    qtbot.keyClick(dial, Qt.Key.Key_Right)
    qtbot.keyClick(dial, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    qtbot.keyClick(dial, Qt.Key.Key_PageUp)
    qtbot.keyClick(dial, Qt.Key.Key_Home)
    qtbot.keyClick(dial, Qt.Key.Key_Left)
    assert came == [15.0, 16.0, 106.0, 0.0, 345.0]
    wheel = QWheelEvent(
        QPointF(100, 20),
        QPointF(100, 20),
        QPoint(0, 0),
        QPoint(0, -120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(dial, wheel)
    assert came[-1] == 0.0


def test_orders_reach_the_rig_and_its_faults_are_seen(open_app: Callable[[], Driver]):
    driver = open_app()
    url = "sim://pointer?speed=20&name=dock"
    driver.app.open_simulated(url)
    driver.until(lambda: driver.tab.bench.linked)
    rig, dock = rig_of(url), driver.app.rig
    dock.turn(90.0)
    dock.remount("Y_from")
    dock.heat(50.0)
    driver.until(lambda: rig.state.head_deg == 90.0 and rig.state.mount == "Y_from")
    driver.until(lambda: abs(rig.state.case_c - 50.0) < 0.01)
    panel = driver.app._rig_panel
    assert isinstance(panel, RigPanel)
    driver.until(lambda: "Y from ODH, at rest, 50.0" in panel._words.text())
    assert panel._mount.currentData() == "Y_from"

    link = driver.app.connection.link
    assert link is not None
    dock.set_fault("noise")
    driver.until(lambda: link.counters.bad_checksum > 0)
    dock.set_fault("")
    dock.burst()
    driver.click(panel._plug)
    driver.until(lambda: not driver.tab.bench.linked)
    assert panel._plug.text() == "Plug in"
    driver.click(panel._plug)
    driver.until(lambda: driver.tab.bench.linked)


def test_the_operator_sets_what_the_test_wants(open_app: Callable[[], Driver]):
    driver = open_app()
    driver.app.open_simulated("sim://pointer?speed=20&name=operator")
    driver.until(lambda: driver.tab.bench.linked)
    panel = driver.app._rig_panel
    assert isinstance(panel, RigPanel)
    driver.click(panel.operator)
    driver.tab.presenter.set_hands_free(True)
    driver.until(lambda: driver.count == 3, 30_000)
    driver.click(panel.operator)
    assert not panel.operator.isChecked()
