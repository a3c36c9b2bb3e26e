"""Sources and what is found in them, without the window."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from core.errors import Severity
from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.profile import load_profiles
from gui.devices.connection import Connection
from gui.frames.presenter import FramesPresenter
from gui.frames.source import Source
from gui.jobs import Jobs
from gui.messages import Messages
from tests.drivers.teach.layouts import frames_of
from tests.gui.frames.board import Board
from tests.gui.frames.conftest import strange


class Desk:
    """All that the tab has but its widgets."""

    def __init__(self, root: Path) -> None:
        self.busy = ""
        self.messages = Messages()
        self.jobs = Jobs()
        self.connection = Connection(load_profiles, lambda: root / "raw", self.messages)
        self.source = Source(
            self.connection, self.jobs, self.messages, lambda: root, lambda: self.busy
        )
        self.presenter = FramesPresenter(
            self.source, self.connection, self.jobs, self.messages, load_profiles, lambda: root,
            lambda: self.busy,
        )  # fmt: skip


@pytest.fixture
def desk(qtbot: QtBot, tmp_path: Path) -> Iterator[Desk]:
    made = Desk(tmp_path)
    yield made
    made.source.stop()
    made.connection.close()
    made.jobs.close()


@pytest.fixture
def taught(desk: Desk, qtbot: QtBot, tmp_path: Path) -> Desk:
    path = tmp_path / "strange.bin"
    path.write_bytes(frames_of(strange(), np.random.default_rng(2), 0, 400).tobytes())
    desk.source.load(path)
    qtbot.waitUntil(lambda: desk.presenter.state.sure, timeout=20_000)
    return desk


def test_a_file_is_understood_by_itself(taught: Desk):
    state = taught.presenter.state
    assert (state.sync, state.length, state.check) == ("9C D1 2E", 17, 0)
    assert "fits 100 %" in state.verdict
    assert taught.source.state.heard == "6800 bytes"
    assert state.fields[0].hint == "counts by 1"
    assert state.doubt == "Give the board a name"


def test_a_length_given_by_hand_is_tried_and_told(taught: Desk, qtbot: QtBot):
    taught.presenter.set_frame("9C D1 2E", 16)
    qtbot.waitUntil(lambda: not taught.presenter.state.sure, timeout=20_000)
    # What was known stays until something better is found.
    assert taught.presenter.state.length == 17
    taught.presenter.set_frame("9C D1", 17)
    qtbot.waitUntil(lambda: taught.presenter.state.sync == "9C D1", timeout=20_000)
    assert taught.presenter.state.check == 0


@pytest.mark.parametrize(("sync", "length"), [("9C D", 17), ("", 17), ("9C D1", 2)])
def test_an_impossible_header_is_refused(taught: Desk, sync: str, length: int):
    taught.presenter.set_frame(sync, length)
    assert not taught.presenter.state.sure
    assert not taught.source.state.busy


def test_both_readings_of_a_length_byte_are_shown(desk: Desk, qtbot: QtBot, tmp_path: Path):
    profile = load_profiles()["openimu_z1"]
    channels = make_decoder(profile).channels
    data = np.random.default_rng(1).normal(size=(300, len(channels)))
    path = tmp_path / "z1.bin"
    path.write_bytes(encode(profile, np.arange(300), data))
    desk.source.load(path)
    qtbot.waitUntil(lambda: desk.presenter.state.sure, timeout=20_000)
    total, payload = desk.presenter.state.readings
    assert (total.length, total.fits, payload.length, payload.fits) == (40, False, 47, True)
    # The wrong one may be tried; it finds nothing and says so.
    desk.presenter.choose_reading(0)
    qtbot.waitUntil(lambda: not desk.presenter.state.sure, timeout=20_000)
    assert desk.presenter.state.length == 47


def test_held_bytes_stand_still(desk: Desk, qtbot: QtBot):
    board = Board(strange())
    try:
        desk.source.set_port(board.port)
        desk.source.listen()
        qtbot.waitUntil(lambda: desk.presenter.state.sure, timeout=20_000)
        desk.source.hold(True)
        before = desk.source.tail
        total = desk.source.heard.total
        qtbot.waitUntil(lambda: desk.source.heard.total > total + 500, timeout=20_000)
        assert desk.source.tail == before
        desk.source.hold(False)
        assert desk.source.tail != before
        # The bytes are on the disk as well.
        desk.source.stop()
        (log,) = (desk.source.raw_folder).glob("*_teach.calrec")
        assert log.stat().st_size > total
        assert not desk.source.state.listening
    finally:
        board.close()


def test_the_speed_is_found_and_listened_at(desk: Desk, qtbot: QtBot):
    board = Board(strange())
    try:
        desk.source.set_port(board.port)
        desk.source.find_speed()
        assert desk.source.state.busy
        qtbot.waitUntil(lambda: desk.source.state.listening, timeout=20_000)
        # A pty passes bytes on at any speed: the first one makes sense already.
        assert desk.source.state.baud == 115200
        qtbot.waitUntil(lambda: desk.presenter.state.sure, timeout=20_000)
    finally:
        desk.source.stop()
        board.close()


def test_a_port_that_cannot_be_opened_is_told(desk: Desk, qtbot: QtBot, tmp_path: Path):
    desk.source.set_port(str(tmp_path / "no-port"))
    desk.source.listen()
    qtbot.waitUntil(lambda: desk.messages.current is not None, timeout=20_000)
    assert desk.messages.current.severity is Severity.ERROR
    assert not desk.source.state.listening


def test_without_a_port_nothing_is_opened(desk: Desk):
    desk.source.listen()
    assert not desk.source.state.listening
    assert desk.source.state.heard == "Choose a port first"


def test_a_measurement_keeps_its_port(taught: Desk):
    taught.busy = "Position 3 is being measured"
    taught.source.set_port("/dev/nothing")
    taught.presenter.describe("Board", "imu")
    taught.presenter.use()
    assert "Position 3" in taught.messages.current.meaning
    assert taught.connection.link is None


def test_scales_may_be_expressions_and_nonsense_is_told(taught: Desk):
    taught.presenter.rescale(1, "20*9.80665/65536", "0")
    assert taught.presenter.state.fields[1].scale == pytest.approx(20 * 9.80665 / 65536)
    taught.presenter.rescale(1, "twelve", "0")
    assert "twelve" in taught.presenter.state.doubt


def test_the_file_is_named_and_written(taught: Desk, tmp_path: Path):
    presenter = taught.presenter
    assert presenter.save() is None
    presenter.describe("CVGx48", "gyro")
    assert "another name" in presenter.state.doubt
    presenter.describe("New board", "gyro")
    path = presenter.save()
    assert path is not None
    assert presenter.state.saved == str(path)
    assert 'kind = "gyro"' in path.read_text("utf-8")
    assert list(load_profiles(path.parent))  # read as any other
    # A change after saving is not saved yet.
    presenter.rename(1, "acc_x", "m/s^2", "acc.x")
    assert presenter.state.saved == ""
