"""The tour: offered once, walks over real widgets, holds nothing up, can be left at any time."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from gui.app import Application, Options
from gui.tour.steps import Place, tour_steps
from gui.tour.tour import Tour
from tests.gui.window_driver import Driver


def begun(open_app: Callable[[], Driver]) -> tuple[Driver, Tour]:
    operator = open_app()
    operator.app.window.menu.tour.trigger()
    operator.until(lambda: operator.tab.bench.linked)
    return operator, operator.app.guidance.tour


@pytest.mark.parametrize("size", [QSize(1280, 800), QSize(1920, 1080)])
def test_every_callout_points_at_a_widget_and_does_not_cover_it(
    open_app: Callable[[], Driver], size: QSize
):
    operator, tour = begun(open_app)
    window = operator.app.window
    window.resize(size)
    assert {step.place for step in tour_steps()} == set(Place)
    for number in range(len(tour_steps())):
        assert tour.number == number
        QApplication.processEvents()
        tour._stand()
        assert tour.callout.isVisible()
        assert tour.frame.isVisible(), tour_steps()[number]
        assert window.rect().contains(tour.callout.geometry())
        covered = tour.callout.geometry() & tour.frame.geometry()
        share = covered.width() * covered.height()
        whole = tour.frame.width() * tour.frame.height()
        assert share <= 0.05 * whole, (tour_steps()[number], QRect(covered))
        operator.click(tour.callout.next)
    assert tour.number == -1
    assert not tour.callout.isVisible()
    assert not tour.frame.isVisible()


def test_measuring_goes_on_under_the_tour_and_escape_leaves_it(open_app: Callable[[], Driver]):
    operator, tour = begun(open_app)
    operator.click(tour.callout.next)
    operator.click(tour.callout._back)
    assert tour.number == 0
    operator.press("accumulate")
    operator.until(lambda: operator.tab.sitting.walk.measuring)
    tour.callout.next.setFocus()
    operator.key(Qt.Key.Key_Escape)
    if tour.number >= 0:
        # The first Esc stopped what runs; the second leaves.
        operator.key(Qt.Key.Key_Escape)
    assert tour.number == -1
    assert not tour.callout.isVisible()


def test_enter_goes_on_and_space_measures_under_the_tour(open_app: Callable[[], Driver]):
    operator, tour = begun(open_app)
    operator.key(Qt.Key.Key_Return)
    assert tour.number == 1
    tour.callout._back.setFocus()
    operator.key(Qt.Key.Key_Enter)
    assert tour.number == 0
    operator.key(Qt.Key.Key_Space)
    operator.until(lambda: operator.tab.sitting.walk.measuring)
    assert tour.number == 0


def test_it_is_offered_at_the_first_start_only(qtbot: QtBot, tmp_path: Path):
    offers = []
    for _ in range(2):
        qt = QApplication.instance()
        assert isinstance(qt, QApplication)
        app = Application(qt, Options("", tmp_path / "data", tmp_path / "set.json"))
        app.sounds.set_volume(0.0)
        qtbot.addWidget(app.window)
        with qtbot.waitSignal(app.ready, timeout=30_000):
            app.start()
        banner = app.messages.current
        assert banner is not None
        offers.append(banner.what)
        app.close()
    assert offers == ["New to CalRig?", "No device is connected"]
