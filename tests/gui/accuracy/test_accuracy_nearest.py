"""The calibration nearest by date and temperature, in the window, from a real archive."""

import re
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from core.plans.plan import load_plans
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from drivers.virtual.session import Order, simulate_session
from gui.accuracy.checking import NEAREST, NONE
from gui.accuracy.tab import AccuracyTab
from tests.core.archive.conftest import SPECIMENS, STATED, calibrated
from tests.gui.window_driver import Driver


@pytest.fixture(scope="module")
def triad() -> Calibration:
    return calibrate(
        read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run(), STATED
    )


@pytest.fixture(scope="module")
def check(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three angles of pitch on the simulated rig, with the unit's temperature."""
    folder = tmp_path_factory.mktemp("checks") / "check"
    plan = replace(load_plans()["pitch_accuracy_3"], accumulation_s=0.3)
    url = "sim://pointer?speed=max&seed=5&name=nearest"
    simulate_session(Order(url, plan, "accelerometer", STATED), folder)
    return folder


class Desk:
    def __init__(self, driver: Driver, check: Path) -> None:
        self.check = check
        self.driver = driver
        tab = driver.app.tabs["Accuracy"]
        assert isinstance(tab, AccuracyTab)
        self.tab = tab
        driver.app.window.tabs.setCurrentWidget(tab.widget)

    def choose(self, calibration: str) -> None:
        box = self.tab._form._calibration
        box.setCurrentIndex(box.findData(calibration))
        box.activated.emit(box.currentIndex())

    def settled(self) -> None:
        self.driver.until(lambda: not self.tab.results.busy and self.tab.results.state is not None)

    @property
    def used(self) -> str:
        state = self.tab.results.state
        assert state is not None
        return state.calibration


@pytest.fixture
def desk(open_app: Callable[[], Driver], tmp_path: Path, triad: Calibration, check: Path) -> Desk:
    """Calibrations of the day before at 60 degC, and of last month, as warm as the check."""
    data, now = tmp_path / "data", datetime.now(UTC)
    for name, days, warmth in (("hot", 1, 60.0), ("alike", 30, 27.0)):
        when = (now - timedelta(days=days)).isoformat(timespec="seconds")
        calibrated(triad, data / name, when=when, temperature_c=warmth, device="PW09")
    calibrated(triad, data / "other", when=now.isoformat(timespec="seconds"), device="PW10")
    return Desk(open_app(), check)


def test_a_check_takes_the_calibration_nearest_by_date_and_temperature(desk: Desk) -> None:
    desk.tab.load(desk.check)
    desk.settled()
    assert re.fullmatch(r"alike \(No\. \d, 30 days earlier, 27\.0 °C\)", desk.used)
    assert (desk.tab._services.root() / "archive.db").exists()


def test_a_check_without_a_calibration_is_offered_the_nearest_by_one_button(desk: Desk) -> None:
    desk.choose(NONE)
    desk.tab.load(desk.check)
    desk.settled()
    assert desk.used == ""
    messages = desk.driver.app.messages
    desk.driver.until(
        lambda: messages.current is not None and "Nearest in the archive" in messages.current.what
    )
    assert messages.current is not None
    assert messages.current.what.endswith("30 days earlier, 27.0 °C")
    assert "only the unit's own angles" in messages.current.meaning
    desk.driver.answer("Use")
    desk.driver.until(lambda: not desk.tab.results.busy and desk.used != "")
    assert desk.used.startswith("alike (No. ")
    assert desk.tab.sitting.settings.calibration == NEAREST
    assert messages.current is None or "Nearest" not in messages.current.what


def test_an_archive_that_cannot_be_asked_costs_no_verdict(desk: Desk) -> None:
    (desk.tab._services.root() / "archive.json").write_text("{", "utf-8")
    desk.tab.load(desk.check)
    desk.settled()
    assert desk.used == "hot", "the folders are looked into: nearest by date alone"
    state = desk.tab.results.state
    assert state is not None
    (note,) = [one for one in state.found.notes if one.subject == "archive_not_asked"]
    assert "archive.json" in note.text
