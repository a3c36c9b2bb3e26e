"""STIM300: all stored datagrams, self-configuration, replies, the counter's step."""

from typing import Any

import numpy as np
import pytest

from core.units import STANDARD_GRAVITY
from drivers.checksums import Checksum
from drivers.profile import Profile, load_profiles, parse_profile
from drivers.protocols.stim300 import CHECKSUM, Stim300Decoder
from tests.drivers.streams import bytewise, decode, same, stored

FRAMES = stored("stim300")
CRC = Checksum(CHECKSUM)
MEASURED = [name for name in FRAMES if name.startswith(("normal", "captured", "vortex"))]
TRIPLES = {
    "gyro_dps": ("gyro", 1.0), "accel_g": ("acc", STANDARD_GRAVITY),
    "incl_g": ("incl", STANDARD_GRAVITY), "gyro_temp_c": ("gyro_temp", 1.0),
    "accel_temp_c": ("acc_temp", 1.0), "incl_temp_c": ("incl_temp", 1.0),
}  # fmt: skip
SINGLES = {
    "gyro_status": "gyro_status", "accel_status": "acc_status", "incl_status": "incl_status",
    "counter": "counter", "latency_us": "latency", "pps_filtered": "pps",
}  # fmt: skip


def profile(range_g: int = 10) -> Profile:
    text = f"""
schema = 1
[device]
name = "S"
kind = "imu"
[port]
baud = [921600]
[protocol]
name = "stim300"
acc_range_g = {range_g}
"""
    return parse_profile(text, "s")


def datagram(first: int, payload: bytes) -> bytes:
    """A datagram with its checksum."""
    row = np.frombuffer(bytes((first,)) + payload + bytes(4), dtype=np.uint8).reshape(1, -1).copy()
    CRC.stamp(row)
    return row.tobytes()


def configuration(
    rate: int = 4, ranges: int = 0, gyro: int = 0, acc: int = 0, pps: int = 0
) -> bytes:
    payload = bytearray(21)
    payload[0], payload[1], payload[2] = ord("E"), 31, rate << 5
    payload[4], payload[7], payload[10], payload[12] = 0x70 | gyro, 0x70 | acc, 0x70, pps
    payload[16], payload[17] = ranges << 4 | ranges, ranges << 4
    return datagram(0xBC, bytes(payload))


def compare(got: dict[str, float], expected: dict[str, Any]) -> int:
    seen = 0
    for key, (name, scale) in TRIPLES.items():
        if key in expected:
            values = [got[f"{name}_{axis}"] for axis in "xyz"]
            assert values == pytest.approx([v * scale for v in expected[key]], rel=1e-14), key
            seen += 3
    for key, name in SINGLES.items():
        if key in expected:
            assert got[name] == expected[key], key
            seen += 1
    return seen


@pytest.mark.parametrize("name", MEASURED)
def test_stored_datagrams(name: str):
    frame = FRAMES[name]
    expected = frame["expected"]
    if isinstance(expected, str):
        expected = FRAMES["captured_full_aux_af"]["expected"]
    stim = Stim300Decoder(profile((expected or {}).get("accel_range_g", 10)))
    got = decode(stim, [frame["bytes"]])
    same(decode(Stim300Decoder(profile(stim_range(expected))), bytewise(frame["bytes"])), got)
    if not frame["crc_ok"]:
        assert (len(got.data), got.bad_checksum, got.garbage) == (0, 1, 63)
        return
    assert (got.garbage, got.bad_checksum, len(got.data)) == (0, 0, 1)
    assert compare(got.row(), expected) >= 2
    if "aux_raw_bytes" in expected:
        raw = int.from_bytes(bytes(expected["aux_raw_bytes"]), "big", signed=True)
        assert got.row()["aux"] == raw


def stim_range(expected: dict[str, Any] | None) -> int:
    return (expected or {}).get("accel_range_g", 10)


def test_the_configuration_sets_rate_ranges_and_units_from_its_place_on():
    frame = FRAMES["normal_91_range80g"]["bytes"]
    stream = frame + configuration(rate=3, ranges=6) + frame + configuration(gyro=1, acc=1) + frame
    stim = Stim300Decoder(profile())
    assert stim.rate == 0.0
    events = stim.feed(stream)
    assert stim.rate == 2000.0
    got = decode(Stim300Decoder(profile()), [stream])
    same(decode(Stim300Decoder(profile()), bytewise(stream)), got)
    raw = np.array([0x199A, -0x3333, 0x0CCD]) * STANDARD_GRAVITY
    acc = got.data[:, [got.names.index(f"acc_{axis}") for axis in "xyz"]]
    np.testing.assert_allclose(acc[0], raw * 2.0**-19, rtol=1e-14)
    np.testing.assert_allclose(acc[1], raw * 2.0**-16, rtol=1e-14)
    np.testing.assert_allclose(acc[2], raw / STANDARD_GRAVITY * 2.0**-22, rtol=1e-14)
    assert got.column("gyro_x").tolist() == [1.0, 1.0, 2.0**-7]
    assert got.units[got.names.index("gyro_x")] == "deg"
    assert got.units[got.names.index("acc_x")] == "m/s"
    rates = [block.rate for block in events if hasattr(block, "rate")]
    assert rates == [0.0, 1000.0, 2000.0]
    assert [fields["rate_hz"] for _, _, fields in got.messages] == ["1000", "2000"]
    assert got.messages[0][2]["acc_range_g"] == "80 80 80"


def test_time_since_pps_is_signed_microseconds():
    frame = FRAMES["normal_f1"]["bytes"]
    got = decode(Stim300Decoder(profile()), [frame + configuration(pps=2) + frame])
    assert got.column("pps").tolist() == [0.5, 2.0**21]


def test_replies_tell_serial_part_and_the_rest():
    serial = datagram(0xB5, b"N" + bytes.fromhex("25581846020027") + bytes(7))
    part = datagram(0xB1, bytes.fromhex("0845792D1700062D00000000000000")[:14] + b"K")
    error = datagram(0xBE, bytes(16))
    got = decode(Stim300Decoder(profile()), [serial + part + error])
    assert [fields for _, _, fields in got.messages] == [
        {"serial": "25581846020027"},
        {"model": "84579-170006", "revision": "K"},
        {"datagram": "0xBE", "content": "00" * 16},
    ]
    assert got.garbage == 0


def measurement(count: int, datagram_id: int = 0x90) -> bytes:
    return datagram(datagram_id, bytes(10) + bytes((count % 256,)) + bytes(2))


@pytest.mark.parametrize(
    ("step", "rate"), [(1, 2000.0), (2, 1000.0), (4, 500.0), (8, 250.0), (16, 125.0)]
)
@pytest.mark.parametrize("end", [b"", b"\r\n"])
def test_the_counter_steps_by_internal_samples(step: int, rate: float, end: bytes):
    frames = [measurement(step * n) + end for n in range(600)]
    del frames[300:303]
    stim = Stim300Decoder(profile())
    got = decode(stim, [b"".join(frames)])
    assert stim.rate == rate
    assert got.lost == [(3, 303)]
    assert got.garbage == 0
    assert got.index.tolist() == [n for n in range(600) if not 300 <= n < 303]


def test_a_reply_costs_the_measurement_that_it_replaces():
    frames = [measurement(n) for n in range(40)]
    frames[20] = configuration(rate=4)
    got = decode(Stim300Decoder(profile()), [b"".join(frames)])
    assert got.lost == [(1, 21)]


def test_identifiers_within_data_mislead_nobody():
    rng = np.random.default_rng(4)
    frames = [
        datagram(0x91, rng.choice([0x90, 0x91, 0xAF, 0xF7], 20).astype(np.uint8).tobytes()
                 + bytes((n % 256,)) + bytes(2))
        for n in range(300)
    ]  # fmt: skip
    stream = b"".join(frames)
    got = decode(Stim300Decoder(profile()), [stream[5:]])
    assert len(got.data) == 299
    assert got.garbage == 23
    same(decode(Stim300Decoder(profile()), bytewise(stream[5:])), got)


def test_the_expected_channels_are_those_of_the_profile():
    stim = Stim300Decoder(load_profiles()["stim300"])
    assert [c.role for c in stim.channels[:3]] == ["rate.x", "rate.y", "rate.z"]
    stim.feed(measurement(0, 0x90))
    assert [c.name for c in stim.channels] == [
        "gyro_x", "gyro_y", "gyro_z", "gyro_status", "counter", "latency",
    ]  # fmt: skip
