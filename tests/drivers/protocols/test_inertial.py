"""Inertial Labs messages: stored frames, replies, unknown messages, user-defined data."""

import numpy as np
import pytest

from core.units import STANDARD_GRAVITY
from drivers.checksums import Checksum
from drivers.profile import Profile, load_profile, load_profiles
from drivers.protocols.inertial import CHECKSUM, InertialDecoder
from tests.drivers.streams import Outcome, bytewise, decode, same, stored

FRAMES = stored("inertiallabs")
COMMANDS = [name for name in FRAMES if name.startswith("cmd_")]
MEASURED = [name for name in FRAMES if "kg" in FRAMES[name]]


def profile(kg: float = 10, ka: float = 4000) -> Profile:
    """The packaged profile for a unit with these ranges."""
    from importlib import resources
    from pathlib import Path

    path = Path(str(resources.files("resources"))) / "devices" / "inertiallabs_ahrs.toml"
    return load_profile(path, {"KG": kg, "KA": ka})


def run(data: bytes, kg: float = 10, ka: float = 4000) -> Outcome:
    whole = decode(InertialDecoder(profile(kg, ka)), [data])
    same(decode(InertialDecoder(profile(kg, ka)), bytewise(data)), whole)
    return whole


def message(kind: int, id_: int, payload: bytes) -> bytes:
    """A message with length and checksum."""
    head = b"\xaa\x55" + bytes((kind, id_)) + (len(payload) + 6).to_bytes(2, "little")
    row = np.frombuffer(head + payload + b"\0\0", dtype=np.uint8).reshape(1, -1).copy()
    Checksum(CHECKSUM).stamp(row)
    return row.tobytes()


@pytest.mark.parametrize("name", MEASURED)
def test_stored_measurements(name: str):
    frame = FRAMES[name]
    got = run(frame["bytes"], frame["kg"], frame["ka"])
    assert (len(got.data), got.garbage) == (1, 0)
    row, expected = got.row(), frame["expected"]
    for key, prefix, scale in (
        ("gyro_dps", "gyro", 1.0), ("acc_g", "acc", STANDARD_GRAVITY), ("mag_nT", "mag", 1.0),
    ):  # fmt: skip
        if key in expected:
            values = [row[f"{prefix}_{axis}"] for axis in "xyz"]
            assert values == pytest.approx([v * scale for v in expected[key]], rel=1e-12), key
    for key, column in (
        ("heading", "heading"), ("pitch", "pitch"), ("roll", "roll"), ("vsup", "vsup"),
        ("temp_c", "temp"),
    ):  # fmt: skip
        if key in expected:
            assert row[column] == pytest.approx(expected[key], rel=1e-12), key


@pytest.mark.parametrize("name", COMMANDS)
def test_stored_commands_are_whole_messages(name: str):
    got = run(FRAMES[name]["bytes"])
    ((kind, payload, _),) = got.messages
    assert kind == f"command 0x{FRAMES[name]['expected']['payload'].upper()}"
    assert payload == FRAMES[name]["bytes"]
    assert got.garbage == 0


def test_device_information():
    got = run(FRAMES["devinfo_0x12"]["bytes"])
    assert got.messages[0][0] == "reply"
    assert got.messages[0][2] == {"serial": "A1234567", "firmware": "MiniAhrs v1.0"}


def test_other_replies():
    stream = (
        message(1, 0x1F, b"PW09 v2.1".ljust(50, b"\0")) + message(1, 0x33, b"\1\0")
        + message(1, 0x33, bytes(50)) + message(1, 0x95, bytes(128))
    )  # fmt: skip
    assert [(kind, fields) for kind, _, fields in run(stream).messages] == [
        ("reply", {"firmware": "PW09 v2.1"}),
        ("reply", {"ack": "0x33"}),
        ("alignment report", {}),
        ("alignment report", {}),
    ]


def test_an_unknown_message_is_skipped_whole_and_named():
    head = FRAMES["capture_prefix_9d"]["bytes"][6:]
    unknown = message(1, 0x9D, head.ljust(38, b"\xaa"))
    measured = FRAMES["imu_orientation_0x33"]["bytes"]
    got = run(measured + unknown + unknown + measured)
    assert [kind for kind, _, _ in got.messages] == ["unknown 0x9D"] * 2
    assert (len(got.data), got.garbage, got.lost) == (2, 0, [])


def test_imu_messages():
    raw = np.array([1, -2, 3, 4, -5, 6, 7, -8, 9], dtype="<i2").tobytes()
    clb = message(
        1, 0x8D, raw + bytes(8) + (1234).to_bytes(2, "little") + (250).to_bytes(2, "little")
    )
    row = run(clb).row()
    assert (row["gyro_y"], row["mag_z"]) == (-0.2, 90.0)
    assert row["acc_x"] == pytest.approx(4 / 4000 * STANDARD_GRAVITY, rel=1e-14)
    assert (row["vsup"], row["temp"]) == (12.34, 25.0)
    wide = np.array([123456, -7, 0, 1_000_000, 2, -3], dtype="<i4").tobytes()
    row = run(message(1, 0x8F, wide + bytes(4) + b"\x10\0\x0a\0")).row()
    assert row["gyro_x"] == pytest.approx(1.23456, rel=1e-14)
    assert row["acc_x"] == pytest.approx(STANDARD_GRAVITY, rel=1e-14)
    assert (row["vsup"], row["temp"]) == (0.16, 1.0)


ITEMS = {
    0x01: 4, 0x07: 6, 0x08: 12, 0x09: 8, 0x10: 12, 0x12: 12, 0x20: 6, 0x21: 12, 0x22: 6, 0x23: 12,
    0x24: 6, 0x25: 6, 0x26: 7, 0x3C: 2, 0x41: 1, 0x50: 2, 0x51: 2, 0x52: 2, 0x53: 2,
}  # fmt: skip


@pytest.mark.parametrize("item", ITEMS)
def test_user_defined_items_have_their_sizes(item: int):
    # The temperature behind the item is only right if the item's size is.
    items = (item, 0x52) if item != 0x52 else (0x53, 0x52)
    size = ITEMS[items[0]]
    payload = bytes((2, *items)) + bytes(size) + (-105).to_bytes(2, "little", signed=True)
    got = run(message(1, 0x95, payload))
    assert got.row()["temp"] == -10.5
    assert len(got.names) > 1


def test_user_defined_data_with_an_unknown_item_is_a_message():
    got = run(message(1, 0x95, bytes((2, 0x52, 0xEE)) + bytes(6)))
    assert [kind for kind, _, _ in got.messages] == ["unknown 0x95"]
    short = run(message(1, 0x95, bytes((1, 0x21)) + bytes(6)))
    assert [kind for kind, _, _ in short.messages] == ["unknown 0x95"]


def test_the_time_of_user_defined_data_counts_the_samples():
    def sample(n: int) -> bytes:
        return message(1, 0x95, bytes((2, 0x01, 0x52)) + (5 * n).to_bytes(4, "little") + b"\0\0")

    frames = [sample(n) for n in range(50)]
    got = run(b"".join(frames[:20] + frames[24:]))
    assert got.lost == [(4, 24)]


def test_expected_channels_before_the_first_message():
    names = [
        channel.name for channel in InertialDecoder(load_profiles()["inertiallabs_ahrs"]).channels
    ]
    assert names[:4] == ["heading", "pitch", "roll", "gyro_x"]


def test_another_message_brings_its_own_columns():
    device = InertialDecoder(profile())
    device.feed(message(1, 0x8F, bytes(32)))
    assert [channel.name for channel in device.channels] == [
        "gyro_x", "gyro_y", "gyro_z", "acc_x", "acc_y", "acc_z", "vsup", "temp",
    ]  # fmt: skip
