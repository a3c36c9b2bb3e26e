"""View ADC Data and Stop Device, on the simulated unit and in the window."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from pytestqt.qtbot import QtBot

from core.plans.plan import Step
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import write_calibration
from core.records.legacy.reader import read_legacy
from core.samples.run import Conditions
from drivers.profile import load_profiles
from drivers.virtual.address import rig_of
from gui.devices.adc import AdcPresenter
from gui.devices.adc_view import AdcPanel
from gui.devices.connection import Connection
from gui.devices.setup import DeviceSetup
from gui.devices.stopping import Stopping
from gui.jobs import Jobs
from gui.messages import Messages
from gui.nearest import NearestCalibrations
from gui.widgets.states import BannerState, LinkMark
from tests.gui.fake_bench import FakeConnection

LEGACY = Path(__file__).parents[2] / "data" / "legacy"


@pytest.fixture
def messages(qapp: object) -> Messages:
    return Messages()


@pytest.fixture
def connection(messages: Messages, tmp_path: Path) -> Iterator[Connection]:
    made = Connection(load_profiles, lambda: tmp_path / "raw", messages)
    yield made
    made.close()


def test_the_numbers_of_a_unit_that_stands_still(
    connection: Connection, qtbot: QtBot, tmp_path: Path
):
    jobs = Jobs()
    presenter = AdcPresenter(connection, jobs, NearestCalibrations(lambda: tmp_path).find)
    panel = AdcPanel(presenter)
    qtbot.addWidget(panel)
    connection.open([DeviceSetup("sim://pointer?speed=5&name=adc", 115200, "pw09_raw", "PW09")])
    panel.show()
    assert "first sample" in presenter.state().hint
    qtbot.waitUntil(lambda: presenter._all.moments.n > 400, timeout=10_000)
    panel.refresh()
    table = presenter.state().table
    assert table.header[:5] == ("Channel", "Unit", "Now", "Mean, 1 s", "STD, 1 s")
    rows = {row[0]: row for row in table.rows}
    assert "counter" not in rows
    # Numbers stand flush under their headings, whatever the decimals of other units are.
    shown = [panel.table.model().index(row, 2).data() for row in range(len(table.rows))]
    assert all(text == text.strip("\N{FIGURE SPACE} ") for text in shown)
    # Level: Z feels g; Table 2.2 gives 1334.9765 * 9.8106 - 229.76 code.
    assert float(rows["acc_z"][5]) == pytest.approx(12867.0, abs=10.0)
    assert 5.0 < float(rows["acc_z"][6]) < 25.0
    presenter.clear()
    assert presenter._all.moments.n < 400
    qtbot.waitUntil(lambda: presenter._all.moments.n > 10, timeout=5_000)
    panel.refresh()
    panel.copy()
    copied = QGuiApplication.clipboard().text().splitlines()
    assert copied[0].startswith("Channel\tUnit\tNow")
    assert len(copied) == len(rows) + 1
    panel.hide()
    seen = presenter._all.moments.n
    qtbot.wait(200)
    assert presenter._all.moments.n == seen
    jobs.close()


def test_codes_stand_beside_physical_units_once_the_unit_was_calibrated(
    qtbot: QtBot, tmp_path: Path
):
    positions = next(
        path
        for path in sorted(LEGACY.rglob("OpticalDividingHead_*.txt"))
        if read_legacy(path).layout.id == "pointer"
    )
    made = calibrate(read_legacy(positions).to_run(), Conditions(g_mps2=9.8106))
    (tmp_path / "session").mkdir()
    write_calibration(made, tmp_path / "session" / "calibration.cal.json")
    jobs = Jobs()
    connection = FakeConnection()
    presenter = AdcPresenter(connection, jobs, NearestCalibrations(lambda: tmp_path).find)
    presenter.set_open(True)
    connection.plug(made.provenance.device)
    feed_level(connection)
    qtbot.waitUntil(lambda: bool(presenter.state().calibration), timeout=5_000)
    feed_level(connection)
    state = presenter.state()
    assert state.calibration == "No. 1, the same day"
    row = next(row for row in state.table.rows if row[0] == "acc_z")
    # The fake unit is another one than that of Table 2.2, but of its kind.
    assert float(row[9]) == pytest.approx(9.81, abs=0.05)
    assert row[11] == "m/s^2"
    jobs.close()


def feed_level(connection: FakeConnection) -> None:
    connection.stand(Step(1, "", "X_from", 0.0), 2.0)


def test_a_device_that_knows_a_stop_command_is_stopped_by_it(
    connection: Connection, messages: Messages, qtbot: QtBot
):
    url = "sim://pointer?speed=2&name=stopped"
    connection.open([DeviceSetup(url, 115200, "pw09_raw", "PW09")])
    stopping = Stopping(connection, messages, lambda: "")
    shown: list[BannerState | None] = []
    messages.shown.connect(shown.append)
    qtbot.waitUntil(lambda: _mark(connection) is LinkMark.STREAMING, timeout=5_000)
    stopping.stop()
    qtbot.waitUntil(lambda: not rig_of(url).state.streaming, timeout=5_000)
    assert shown[-1] is not None
    assert "told to stop" in shown[-1].what
    qtbot.waitUntil(lambda: _mark(connection) is LinkMark.SILENT, timeout=8_000)
    # The silence that was asked for is no trouble.
    qtbot.wait(1500)
    assert "told to stop" in shown[-1].what


def test_a_device_without_a_stop_command_loses_its_port_and_gets_it_back(
    connection: Connection, messages: Messages, qtbot: QtBot
):
    connection.open([DeviceSetup("sim://clbacc?name=gentle", 115200, "adc_board9", "A")])
    assert "stop" not in load_profiles()["adc_board9"].commands
    stopping = Stopping(connection, messages, lambda: "")
    stopping.stop()
    assert connection.link is None
    stopping.start()
    qtbot.waitUntil(lambda: _mark(connection) is LinkMark.STREAMING, timeout=5_000)


def test_nothing_is_stopped_while_an_accumulation_runs(
    connection: Connection, messages: Messages, qtbot: QtBot
):
    connection.open([DeviceSetup("sim://clbacc?name=busy", 115200, "adc_board9", "A")])
    shown: list[BannerState | None] = []
    messages.shown.connect(shown.append)
    Stopping(connection, messages, lambda: "An accumulation is running.").stop()
    assert connection.link is not None
    assert shown[-1] is not None
    assert shown[-1].meaning == "An accumulation is running."


def _mark(connection: Connection) -> LinkMark:
    return LinkMark.OFFLINE if connection.link is None else connection.link.mark


def test_the_panel_opens_in_the_window_over_every_tab(open_app: Callable[[], object]):
    driver = open_app()
    window = driver.app.window
    assert not window._adc.isVisible()
    window._adc.toggleViewAction().trigger()
    assert window._adc.isVisible()
    for place in range(window.tabs.count()):
        window.tabs.setCurrentIndex(place)
        assert window._adc.isVisible()
    assert [action.text() for action in window.strip.menu.actions() if action.text()] == [
        "View ADC Data",
        "Stop Device",
        "Start Device",
    ]
    assert window._adc.features() & window._adc.DockWidgetFeature.DockWidgetFloatable
    driver.bot.keyClick(window, Qt.Key.Key_D, Qt.KeyboardModifier.ControlModifier)
    assert not window._adc.isVisible()
