"""VectorNav text: stored lines, every header, both checksums, replies and damage."""

import math

import numpy as np
import pytest

from core.units import DEG_PER_RAD
from drivers.lines import crc16_sum, xor_sum
from drivers.profile import load_profiles
from drivers.protocols.vectornav_ascii import VectorNavAsciiDecoder
from tests.drivers.streams import Outcome, bytewise, decode, same, stored

FRAMES = stored("vectornav")
PROFILES = load_profiles()
COLUMNS = {
    "yaw_deg": "yaw", "pitch_deg": "pitch", "roll_deg": "roll", "mag_x_gauss": "mag_x",
    "mag_y_gauss": "mag_y", "mag_z_gauss": "mag_z", "acc_x": "acc_x", "acc_y": "acc_y",
    "acc_z": "acc_z", "gyro_x_rad_s": "gyro_x", "gyro_y_rad_s": "gyro_y", "gyro_z_rad_s": "gyro_z",
}  # fmt: skip
COUNTS = {
    "YPR": 3, "QTN": 4, "QMR": 13, "MAG": 3, "ACC": 3, "GYR": 3, "MAR": 9, "YMR": 12, "YBA": 9,
    "YIA": 9, "IMU": 11, "DTV": 7,
}  # fmt: skip


def vn() -> VectorNavAsciiDecoder:
    return VectorNavAsciiDecoder(PROFILES["vectornav_ascii"])


def run(data: bytes) -> Outcome:
    whole = decode(vn(), [data])
    same(decode(vn(), bytewise(data)), whole)
    return whole


def line(body: str, end: str = "\r\n") -> bytes:
    return f"${body}*{xor_sum(body):02X}{end}".encode("ascii")


@pytest.mark.parametrize("name", [name for name in FRAMES if name.startswith("ymr")])
def test_stored_measurements(name: str):
    got = run(FRAMES[name]["bytes"])
    assert (got.garbage, got.bad_checksum, got.messages) == (0, 0, [])
    expected = {
        COLUMNS[key]: value * (DEG_PER_RAD if key.endswith("rad_s") else 1.0)
        for key, value in FRAMES[name]["expected"].items()
    }
    assert got.row() == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("name", [name for name in FRAMES if name.startswith("rrg")])
def test_stored_replies(name: str):
    ((kind, _, fields),) = run(FRAMES[name]["bytes"]).messages
    (value,) = fields.values()
    assert kind == "reply"
    wanted = {k: str(v) for k, v in FRAMES[name]["expected"].items() if k != "reg"}
    assert value == next(iter(wanted.values()))
    names = {"hw": "hardware", "fw": "firmware"}
    assert set(fields) == {names.get(key, key) for key in wanted}


@pytest.mark.parametrize("name", [name for name in FRAMES if name.startswith("cmd")])
def test_stored_commands_have_right_checksums(name: str):
    assert run(FRAMES[name]["bytes"]).bad_checksum == 0


@pytest.mark.parametrize("header", COUNTS)
def test_every_header(header: str):
    numbers = [f"{0.25 * n:+08.3f}" for n in range(1, COUNTS[header] + 1)]
    got = run(line(f"VN{header}," + ",".join(numbers)))
    assert len(got.names) == COUNTS[header]
    scales = [DEG_PER_RAD if name.startswith("gyro") else 1.0 for name in got.names]
    wanted = [0.25 * n * scale for n, scale in enumerate(scales, 1)]
    np.testing.assert_allclose(got.data[0], wanted, rtol=1e-14)
    short = run(line(f"VN{header}," + ",".join(numbers[:-1])))
    assert len(short.data) == 0
    assert [kind for kind, _, _ in short.messages] == ["text"]


def test_status_and_count_may_be_appended():
    got = run(line("VNYPR,1,2,3,S00A1,T4711") + line("VNYPR,1,2,3,T4712"))
    assert got.names == ("yaw", "pitch", "roll", "status", "count")
    assert got.column("count").tolist() == [4711, 4712]
    assert got.column("status")[0] == 0xA1
    assert math.isnan(got.column("status")[1])
    assert len(run(line("VNYPR,1,2,3,Q1")).data) == 0


def test_four_digits_are_a_crc():
    body = "VNYPR,+010.071,+000.278,-002.026"
    good = f"${body}*{crc16_sum(body):04X}\r\n".encode("ascii")
    assert run(good).row()["yaw"] == 10.071
    assert run(good.replace(b"071", b"072")).bad_checksum == 1


def test_two_headers_in_turn_share_the_columns():
    got = run((line("VNYPR,1,2,3") + line("VNACC,4,5,6")) * 3)
    assert got.names == ("yaw", "pitch", "roll", "acc_x", "acc_y", "acc_z")
    assert got.index.tolist() == list(range(6))
    assert np.isnan(got.column("yaw")).tolist() == [False, True] * 3


def test_a_damaged_line_is_a_bad_checksum_and_a_lost_sample():
    lines = [line(f"VNYPR,{n},2,3") for n in range(6)]
    lines[3] = lines[3].replace(b"3,2,3", b"3,2,4")
    got = run(b"".join(lines))
    assert got.bad_checksum == 1
    assert got.lost == [(1, 4)]
    assert got.column("yaw").tolist() == [0, 1, 2, 4, 5]


def test_errors_are_told_in_words():
    got = run(line("VNERR,03") + line("VNERR,C") + line("VNERR,7F"))
    assert [fields["error"] for _, _, fields in got.messages] == [
        "invalid checksum", "insufficient baud rate", "code 7F",
    ]  # fmt: skip


def test_other_lines_are_text():
    got = run(
        b"hello\r\n" + line("GPGGA,1,2") + b"\r\n" + line("VNWRG,07,200") + b"\xff\xfe*00\r\n"
    )
    assert [kind for kind, _, _ in got.messages] == ["text", "text", "reply", "text"]
    assert got.messages[2][2] == {"register 07": "200"}


@pytest.mark.parametrize("value", ["nan", "inf", "1e999", "", "0x1", "1_0", "\u0661"])
def test_no_number_is_ever_made_up(value: str):
    body = f"VNYPR,1,{value},3"
    data = f"${body}*{xor_sum(body):02X}\r\n".encode()
    assert len(decode(vn(), [data]).data) == 0
