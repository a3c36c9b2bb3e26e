"""Device Properties: rows, scanning, asking, opening."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.records.names import NO_NAME
from drivers.profile import load_profiles
from gui.devices.connection import Connection
from gui.devices.presenter import DevicesPresenter
from gui.devices.setup import DeviceSetup
from gui.jobs import Jobs
from gui.messages import Messages


class Desk:
    """Presenter with everything that it uses."""

    def __init__(self, raw: Path) -> None:
        self.messages, self.jobs = Messages(), Jobs()
        self.busy = ""
        self.connection = Connection(load_profiles, lambda: raw, self.messages)
        self.presenter = DevicesPresenter(
            self.connection, load_profiles, self.jobs, self.messages, lambda: self.busy
        )

    @property
    def row(self) -> DeviceSetup:
        return self.presenter.state.rows[0]


@pytest.fixture
def desk(qapp: object, tmp_path: Path) -> Iterator[Desk]:
    made = Desk(tmp_path)
    yield made
    made.connection.close()
    made.jobs.close()


def scanned(desk: Desk, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not desk.presenter.state.busy, timeout=30_000)


def test_ports_are_listed_in_a_worker_and_the_likeliest_is_taken(desk: Desk, qtbot: QtBot):
    desk.presenter.refresh()
    qtbot.waitUntil(lambda: bool(desk.presenter.state.ports))
    urls = [port.url for port in desk.presenter.state.ports]
    assert "sim://pointer" in urls
    assert desk.row.url == urls[0]
    assert ("pw09_raw" in dict(desk.presenter.state.profiles)) is True


def test_scan_listens_then_asks_only_when_told(desk: Desk, qtbot: QtBot):
    presenter = desk.presenter
    presenter.set_port(0, "sim://pointer?name=scanned")
    assert desk.row.name == NO_NAME
    presenter.scan()
    scanned(desk, qtbot)
    assert desk.row.profile_id == "pw09_raw"
    assert desk.row.name != "PW09"
    assert "Ask for the names" in presenter.state.question
    presenter.ask()
    scanned(desk, qtbot)
    assert desk.row.name == "PW09"
    assert presenter.state.question == ""
    accepted: list[bool] = []
    presenter.accepted.connect(lambda: accepted.append(True))
    presenter.ok()
    assert accepted == [True]
    link = desk.connection.link
    assert link is not None
    assert link.setup.name == "PW09"


def test_the_question_can_be_declined(desk: Desk, qtbot: QtBot):
    desk.presenter.set_port(0, "sim://pointer?name=declined")
    desk.presenter.scan()
    scanned(desk, qtbot)
    desk.presenter.decline()
    assert desk.presenter.state.question == ""


def test_ok_scans_first_where_the_profile_is_unknown(desk: Desk, qtbot: QtBot):
    desk.presenter.set_port(0, "sim://cvg25?name=auto")
    desk.presenter.ok()
    qtbot.waitUntil(lambda: desk.connection.link is not None, timeout=30_000)
    assert desk.row.profile_id == "cvgx48"


def test_a_port_that_is_not_there_is_reported(desk: Desk, qtbot: QtBot):
    desk.presenter.set_port(0, "/dev/no_such_port")
    desk.presenter.ok()
    scanned(desk, qtbot)
    assert desk.connection.link is None
    assert "no such port" in desk.presenter.state.report


def test_several_devices_need_several_ports(desk: Desk):
    presenter = desk.presenter
    presenter.set_count(2)
    assert presenter.state.why_not_ok == "Choose a port for every device"
    presenter.set_port(0, "COM4")
    presenter.set_port(1, "COM4")
    assert presenter.state.why_not_ok == "Two devices have the same port"
    presenter.set_port(1, "COM5")
    assert presenter.state.why_not_ok == ""
    presenter.set_count(99)
    assert len(presenter.state.rows) == 16
    presenter.set_count(0)
    assert len(presenter.state.rows) == 1


def test_a_profile_brings_its_baud_rate(desk: Desk):
    profiles = load_profiles()
    other = next(p for p in profiles.values() if p.port.bauds[0] != 115200)
    desk.presenter.set_profile(0, other.id)
    assert desk.row.baud == other.port.bauds[0]
    desk.presenter.set_baud(0, 19200)
    assert desk.row.baud == 19200
    desk.presenter.set_profile(0, "")
    assert desk.row.baud == 19200


def test_ports_in_use_are_not_let_go_of(desk: Desk):
    desk.presenter.set_port(0, "sim://pointer?name=used")
    desk.presenter.set_profile(0, "pw09_raw")
    desk.busy = "An accumulation is running."
    desk.presenter.scan()
    desk.presenter.ok()
    assert desk.connection.link is None
    assert desk.messages.current is not None
    assert desk.messages.current.meaning == "An accumulation is running."


def test_scanning_nothing_says_so_and_a_scan_can_be_stopped(desk: Desk, qtbot: QtBot):
    desk.presenter.scan()
    assert "Choose a port" in desk.presenter.state.report
    desk.presenter.set_port(0, "sim://clbdus?name=stopped&speed=0.0001")
    desk.presenter.scan()
    desk.presenter.cancel()
    scanned(desk, qtbot)
    assert desk.row.profile_id == ""
