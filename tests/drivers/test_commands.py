"""Commands and answers, on units of the rig and on scripted ones."""

import threading
import time
from dataclasses import replace

import pytest

from drivers.commands import answer_in, ask, identify, send
from drivers.profile import Profile, load_profiles, parse_profile
from drivers.transport import open_port
from drivers.virtual.address import rig_of

PROFILES = load_profiles()

TEXT_DEVICE = """
schema = 1
[device]
name = "text"
kind = "imu"
[port]
baud = [115200]
[line]
columns = ["x"]
[[command]]
name = "stop"
ascii = "S\\n"
repeat = 3
gap_ms = 20
[[command]]
name = "start"
ascii = "G\\n"
[[command]]
name = "identify"
ascii = "?\\n"
wait_ms = 300
expect = 'ID=(?P<serial>\\w+) FW=(?P<firmware>[\\d.]+)'
"""


class Talker:
    """A device of text lines: streams unless stopped, answers `?`."""

    port = "talker"
    patient = False

    def __init__(self) -> None:
        self.heard = b""
        self.streaming = True
        self._answers = b""

    def read(self) -> bytes:
        time.sleep(0.005)
        said, self._answers = self._answers, b""
        return said + (b"1.0\r\n" if self.streaming else b"")

    def write(self, data: bytes) -> None:
        self.heard += data
        if data == b"S\n":
            self.streaming = False
        if data == b"G\n":
            self.streaming = True
        if data == b"?\n":
            self._answers += b"ID=A17 FW=2.10\r\n"

    def cancel(self) -> None: ...

    def close(self) -> None: ...


@pytest.fixture
def text_profile() -> Profile:
    return parse_profile(TEXT_DEVICE, "text.toml")


def test_device_is_stopped_asked_and_started_again(text_profile):
    talker = Talker()
    assert identify(talker, text_profile) == {"serial": "A17", "firmware": "2.10"}
    assert talker.heard == b"S\nS\nS\n?\nG\n"
    assert talker.streaming


def test_what_cannot_be_started_again_is_not_stopped(text_profile):
    commands = {k: v for k, v in text_profile.commands.items() if k != "start"}
    talker = Talker()
    said = identify(talker, replace(text_profile, commands=commands))
    assert said == {"serial": "A17", "firmware": "2.10"}
    assert talker.heard == b"?\n"


def test_profile_without_questions_sends_nothing():
    talker = Talker()
    assert identify(talker, PROFILES["cvgx48"]) == {}
    assert talker.heard == b""


def test_silence_is_an_empty_answer_after_the_time_of_the_profile(text_profile):
    question = replace(text_profile.commands["identify"], data=b"nobody knows this\n")
    began = time.monotonic()
    assert ask(Talker(), question) == {}
    assert time.monotonic() - began == pytest.approx(0.3, abs=0.1)


def test_cancel_ends_the_waiting(text_profile):
    cancel = threading.Event()
    cancel.set()
    began = time.monotonic()
    assert ask(Talker(), replace(text_profile.commands["identify"], wait_ms=5000), cancel) == {}
    talker = Talker()
    send(talker, replace(text_profile.commands["stop"], gap_ms=5000), cancel)
    assert talker.heard == b"S\n"
    assert time.monotonic() - began < 1.0


def test_unit_of_the_rig_tells_its_name():
    url = "sim://pointer?name=commands"
    transport = open_port(url)
    said = identify(transport, rig_of(url).profile)
    assert said == {"serial": "PW09", "firmware": "MiniAhrs 2.12"}
    transport.close()


@pytest.mark.parametrize(
    ("where", "raw", "expected"),
    [
        ("{ at = 2, type = 'ascii', size = 4 }", b"AB  ", "AB"),
        ("{ at = 2, type = 'hex', size = 2 }", b"\x01\xfe", "01fe"),
        ("{ at = 2, type = 'uint', size = 2 }", b"\x01\x02", "513"),
        ("{ at = 2, type = 'uint', size = 2, endian = 'big' }", b"\x01\x02", "258"),
    ],
)
def test_pieces_of_binary_answers(where, raw, expected):
    text = TEXT_DEVICE.partition("[[command]]")[0] + (
        f"[[command]]\nname = 'id'\nhex = '01'\nexpect_hex = 'F0 0F'\n"
        f"[command.capture]\nserial = {where}\n"
    )
    command = parse_profile(text, "binary.toml").commands["id"]
    assert answer_in(command, b"junk\xf0\x0f" + raw) == {"serial": expected}
    assert answer_in(command, b"junk\xf0\x0f" + raw[:-1]) == {}
    assert answer_in(command, raw) == {}


def test_a_chance_likeness_in_the_stream_is_passed_over():
    command = PROFILES["pw09_raw"].commands["identify"]
    false = bytes.fromhex("AA550112") + bytes(range(1, 60))
    true = bytes.fromhex("AA550112AC00") + b"PW09\0\0\0\0" + b"MiniAhrs".ljust(40, b"\0")
    assert answer_in(command, false + true) == {"serial": "PW09", "firmware": "MiniAhrs"}
