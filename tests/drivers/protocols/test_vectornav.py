"""VectorNav binary messages: stored ones, all groups, roles, time."""

import numpy as np
import pytest

from core.units import DEG_PER_RAD
from drivers.checksums import Checksum
from drivers.profile import load_profiles
from drivers.protocols.vectornav import CHECKSUM, VectorNavDecoder
from tests.drivers.streams import Outcome, bytewise, decode, same, stored

FRAMES = stored("vectornav")
PROFILES = load_profiles()
CRC = Checksum(CHECKSUM)
SIZES = {
    0: (8, 8, 8, 12, 16, 12, 24, 12, 12, 24, 20, 28, 2, 4, 8),
    1: (8, 8, 8, 2, 8, 8, 8, 4, 4, 1),
    2: (2, 12, 12, 12, 4, 4, 16, 12, 12, 12, 12, 2),
    3: (8, 8, 2, 1, 1, 24, 24, 12, 12, 12, 4, 4, 2, 28),
    4: (0, 12, 16, 36, 12, 12, 12, 12, 12),
    5: (2, 24, 24, 12, 12, 12, 12, 12, 12, 4, 4),
    6: (8, 8, 2, 1, 1, 24, 24, 12, 12, 12, 4, 4, 2, 28),
}
"""Bytes of each field by group and bit, as the vendor's documentation lists them."""


def vn() -> VectorNavDecoder:
    return VectorNavDecoder(PROFILES["vectornav_binary"])


def run(data: bytes) -> Outcome:
    whole = decode(vn(), [data])
    same(decode(vn(), bytewise(data)), whole)
    return whole


def message(masks: dict[int, int], payload: bytes) -> bytes:
    """A binary message with its checksum."""
    groups = sum(1 << group for group in masks)
    words = b"".join(masks[group].to_bytes(2, "little") for group in sorted(masks))
    whole = b"\xfa" + bytes((groups,)) + words + payload + b"\0\0"
    row = np.frombuffer(whole, dtype=np.uint8).reshape(1, -1).copy()
    CRC.stamp(row)
    return row.tobytes()


def floats(*values: float) -> bytes:
    return np.array(values, dtype="<f4").tobytes()


def test_the_example_of_the_manual():
    frame = FRAMES["bin_common_ypr"]
    expected = frame["expected"]
    assert run(frame["bytes"]).row() == {
        "yaw": expected["yaw_deg"],
        "pitch": expected["pitch_deg"],
        "roll": expected["roll_deg"],
    }
    bad = run(FRAMES["bin_common_ypr_badcrc"]["bytes"])
    assert (len(bad.data), bad.bad_checksum, bad.garbage) == (0, 1, 18)


def test_two_groups():
    frame = FRAMES["bin_time_imu_derived"]
    expected = frame["expected"]
    row = run(frame["bytes"]).row()
    assert row["time_startup"] == pytest.approx(expected["time_startup_ns"] * 1e-9, rel=1e-14)
    for axis, acc, gyro in zip("xyz", expected["accel"], expected["gyro"], strict=True):
        assert row[f"uncomp_acc_{axis}"] == float(np.float32(acc))
        rate = float(np.float32(gyro)) * DEG_PER_RAD
        assert row[f"uncomp_gyro_{axis}"] == pytest.approx(rate, rel=1e-14)
    assert row["temp"] == expected["temp_c"]


@pytest.mark.parametrize(
    ("group", "bit"), [(g, b) for g, sizes in SIZES.items() for b, size in enumerate(sizes) if size]
)
def test_every_field_has_its_size(group: int, bit: int):
    # A pressure in a group behind, or a pitch in one before, is right only if the size is.
    size = SIZES[group][bit]
    if group < 4:
        data = message({group: 1 << bit, 4: 1 << 1}, bytes(size) + floats(1.5, 2.5, 3.5))
    else:
        data = message({0: 1 << 3, group: 1 << bit}, floats(1.5, 2.5, 3.5) + bytes(size))
    got = run(data)
    assert (len(got.data), got.garbage) == (1, 0)
    assert got.row()["pitch"] == (0.0 if (group, bit) == (0, 3) else 2.5)


def test_all_fields_of_fixed_size_at_once():
    masks = {g: sum(1 << b for b, size in enumerate(sizes) if size) for g, sizes in SIZES.items()}
    payload = bytes(sum(sum(sizes) for sizes in SIZES.values()))
    got = run(message(masks, payload) * 3)
    assert (len(got.data), got.garbage) == (3, 0)
    assert len(set(got.names)) == len(got.names) > 150


@pytest.mark.parametrize(("group", "mask"), [(3, 1 << 14), (2, 1 << 15), (0, 1 << 15), (4, 1)])
def test_messages_whose_length_is_not_told_are_garbage(group: int, mask: int):
    got = run(message({group: mask}, bytes(20)))
    assert len(got.data) == 0
    assert got.garbage == 26


def test_uncompensated_sensors_get_the_roles():
    got = vn()
    masks = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 8 | 1 << 9 | 1 << 10
    got.feed(message({2: masks}, bytes(72)))
    roles = {channel.role: channel.name for channel in got.channels if channel.role}
    assert roles["acc.x"] == "uncomp_acc_x"
    assert roles["rate.z"] == "uncomp_gyro_z"
    assert roles["mag.y"] == "uncomp_mag_y"
    assert {c.name for c in got.channels if not c.role} == {
        f"{sensor}_{axis}" for sensor in ("acc", "gyro", "mag") for axis in "xyz"
    }
    alone = vn()
    alone.feed(message({2: 1 << 9}, bytes(12)))
    assert [channel.role for channel in alone.channels] == ["acc.x", "acc.y", "acc.z"]


def test_time_since_start_counts_samples():
    def at(n: int) -> bytes:
        return message({0: 1 | 1 << 8}, (5_000_123 * n).to_bytes(8, "little") + floats(0, 0, n))

    frames = [at(n) for n in range(80)]
    device = vn()
    got = decode(device, [b"".join(frames[:40] + frames[45:])])
    assert got.lost == [(5, 45)]
    assert device.rate == pytest.approx(200.0, rel=1e-3)
    assert np.diff(got.column("time_startup"))[0] == pytest.approx(5.000123e-3, rel=1e-9)


def test_two_messages_that_alternate_share_the_columns():
    one, two = message({0: 1 << 3}, floats(1, 2, 3)), message({2: 1 << 4}, floats(25.0))
    got = run((one + two) * 4)
    assert got.names == ("yaw", "pitch", "roll", "temp")
    assert np.isnan(got.column("temp")).tolist() == [True, False] * 4
