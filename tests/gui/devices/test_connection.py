"""The links: opened, drained, silent, lost, refused; over real simulated ports."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.errors import StorageError
from core.samples.block import SampleBlock
from drivers.events import Message
from drivers.profile import load_profiles
from drivers.rawlog import rawlog_header
from drivers.virtual.address import rig_of
from gui.devices.connection import Connection
from gui.devices.setup import DeviceSetup, setups_of_section, setups_to_section
from gui.messages import LogEntry, Messages
from gui.widgets.states import DeviceStripState, LinkMark


@pytest.fixture
def messages(qapp: object) -> Messages:
    return Messages()


@pytest.fixture
def connection(messages: Messages, tmp_path: Path) -> Iterator[Connection]:
    made = Connection(load_profiles, lambda: tmp_path / "raw", messages)
    yield made
    made.close()


def pw09(name: str, **query: object) -> DeviceSetup:
    text = "&".join(f"{key}={value}" for key, value in {**query, "name": name}.items())
    return DeviceSetup(f"sim://pointer?{text}", 115200, "pw09_raw", "PW09")


def test_samples_counters_and_raw_bytes(
    connection: Connection, messages: Messages, tmp_path: Path, qtbot: QtBot
):
    blocks: list[SampleBlock] = []
    strips: list[DeviceStripState] = []
    connection.blocks.connect(blocks.append)
    connection.strip.connect(strips.append)
    connection.open([pw09("count", speed=10)])
    qtbot.waitUntil(lambda: bool(strips) and strips[-1].link is LinkMark.STREAMING)
    qtbot.waitUntil(lambda: strips[-1].frames > 500)
    link = connection.link
    assert link is not None
    assert link.raw_path is not None
    connection.close()
    assert sum(len(block.index) for block in blocks) >= 500
    assert strips[-1].devices == ("No Name",)
    (path,) = (tmp_path / "raw").iterdir()
    assert rawlog_header(path)["profile"] == "pw09_raw"
    assert path.stat().st_size > 500 * 72


def test_only_the_current_device_is_passed_on(connection: Connection, qtbot: QtBot):
    connection.open([pw09("one", speed=5), pw09("two", speed=5)])
    blocks: list[SampleBlock] = []
    connection.blocks.connect(blocks.append)
    first = connection.link
    qtbot.waitUntil(lambda: bool(blocks))
    connection.select(1)
    assert connection.link is not first
    count = len(blocks)
    qtbot.waitUntil(lambda: len(blocks) > count)
    connection.select(7)
    assert connection.link is not first


def test_a_pulled_cable_is_told_and_comes_back_by_itself(
    connection: Connection, messages: Messages, qtbot: QtBot
):
    setup = pw09("pulled")
    told: list[str] = []
    connection.interrupted.connect(lambda: told.append("interrupted"))
    connection.resumed.connect(lambda: told.append("resumed"))
    connection.open([setup])
    link = connection.link
    assert link is not None
    qtbot.waitUntil(lambda: link.mark is LinkMark.STREAMING)
    rig_of(setup.url).unplug()
    qtbot.waitUntil(lambda: told == ["interrupted"])
    assert messages.current is not None
    assert messages.current.what == "Link lost: sim://pointer"
    assert link.mark is LinkMark.LOST
    rig_of(setup.url).plug_in()
    qtbot.waitUntil(lambda: told == ["interrupted", "resumed"])
    assert messages.current is None


def test_a_port_that_does_not_open_offers_to_try_again(
    connection: Connection, messages: Messages, qtbot: QtBot
):
    connection.open([DeviceSetup("/dev/no_such_port", 115200, "pw09_raw", "PW09")])
    qtbot.waitUntil(lambda: messages.current is not None)
    banner = messages.current
    assert banner is not None
    assert banner.what == "No link: /dev/no_such_port"
    assert "no such port" in banner.meaning
    wanted: list[bool] = []
    connection.properties_wanted.connect(lambda: wanted.append(True))
    messages.press("properties")
    assert wanted == [True]
    messages.press("retry")
    qtbot.waitUntil(lambda: messages.current is not None)


def test_bytes_of_another_device_are_told_as_such(
    connection: Connection, messages: Messages, qtbot: QtBot
):
    setup = DeviceSetup("sim://cvg25?name=foreign", 115200, "pw09_raw", "PW09")
    connection.open([setup])
    qtbot.waitUntil(lambda: messages.current is not None, timeout=8000)
    assert messages.current is not None
    assert "can be read" in messages.current.what
    assert "scan the port" in messages.current.remedy


def test_a_folder_that_refuses_costs_the_raw_bytes_only(
    messages: Messages, tmp_path: Path, qtbot: QtBot
):
    (tmp_path / "file").write_text("", encoding="utf-8")
    connection = Connection(load_profiles, lambda: tmp_path / "file", messages)
    blocks: list[SampleBlock] = []
    connection.blocks.connect(blocks.append)
    connection.open([pw09("noraw")])
    assert messages.current is not None
    assert messages.current.what == "Bytes are not recorded"
    qtbot.waitUntil(lambda: bool(blocks))
    connection.close()


def test_setups_survive_the_settings_and_nonsense_is_left_out():
    setups = (DeviceSetup("COM4", 9600, "cvgx48", "25-143"), DeviceSetup())
    assert setups_of_section(setups_to_section(setups)) == setups
    assert setups_of_section({"devices": ["x", {"url": 3, "baud": "fast"}]}) == (DeviceSetup(),)
    assert setups_of_section({}) == ()


def test_a_raw_log_that_went_away_costs_no_sample(
    connection: Connection, tmp_path: Path, qtbot: QtBot
):
    blocks: list[SampleBlock] = []
    connection.blocks.connect(blocks.append)
    connection.open([pw09("gone", speed=5)])
    qtbot.waitUntil(lambda: bool(blocks))
    (path,) = (tmp_path / "raw").iterdir()
    path.unlink()
    count = len(blocks)
    qtbot.waitUntil(lambda: len(blocks) > count + 3)
    link = connection.link
    assert link is not None
    with pytest.raises(StorageError, match="not safe on disk"):
        link.sync()


def test_last_bytes_that_found_no_room_are_told(
    connection: Connection, messages: Messages, monkeypatch: pytest.MonkeyPatch, qtbot: QtBot
):
    blocks: list[SampleBlock] = []
    connection.blocks.connect(blocks.append)
    connection.open([pw09("full", speed=5)])
    qtbot.waitUntil(lambda: bool(blocks))
    link = connection.link
    assert link is not None
    assert link._log is not None

    def refuse() -> None:
        raise StorageError("the disk is full")

    monkeypatch.setattr(link._log._file, "close", refuse)
    connection.close()
    assert messages.current is not None
    assert messages.current.what == "The last bytes are not recorded"


def test_a_sleep_of_the_computer_stands_in_the_log(connection: Connection, messages: Messages):
    lines: list[LogEntry] = []
    messages.logged.connect(lines.append)
    connection.open([pw09("sleep")])
    link = connection.link
    assert link is not None
    connection._on_event(link, Message("paused", b"", {"gap_s": "7.250"}))
    assert "stood still for 7.2 s" in lines[-1].text
