"""Fixed frames: the stored frames of each device, limits, counters and bytes accounted for."""

from typing import Any

import numpy as np
import pytest

from core.samples.block import SampleBlock
from core.units import STANDARD_GRAVITY
from drivers.events import BadValues, Lost
from drivers.frame import FrameDecoder
from drivers.profile import load_profiles, parse_profile
from drivers.profile_types import FrameSpec
from tests.drivers.device_texts import GOOD
from tests.drivers.streams import Outcome, bytewise, decode, outcome, stored

PROFILES = load_profiles()

ACEINNA = {
    "xAccel": "acc_x", "yAccel": "acc_y", "zAccel": "acc_z", "xRate": "gyro_x", "yRate": "gyro_y",
    "zRate": "gyro_z", "xMag": "mag_x", "yMag": "mag_y", "zMag": "mag_z", "temp": "temp",
    "xRateTemp": "gyro_temp_x", "yRateTemp": "gyro_temp_y", "zRateTemp": "gyro_temp_z",
    "boardTemp": "board_temp", "counter": "counter", "BITstatus": "bit_status", "time": "time",
    "timeCntr": "time_counter",
}  # fmt: skip
DMU = {
    "count": "count", "rate_x": "gyro_x", "rate_y": "gyro_y", "rate_z": "gyro_z", "acc_x": "acc_x",
    "acc_y": "acc_y", "acc_z": "acc_z", "aux_v": "aux", "temp_c": "temp",
}  # fmt: skip


def decoder(name: str) -> FrameDecoder:
    profile = PROFILES[name]
    assert isinstance(profile.stream, FrameSpec)
    return FrameDecoder(profile.stream, profile.nominal_hz)


def one(name: str, data: bytes) -> dict[str, float]:
    """Decode one frame, whole and byte by byte, among other bytes."""
    whole = decode(decoder(name), [data])
    assert whole.data.shape[0] == 1, whole
    assert (whole.garbage, whole.bad_checksum, whole.lost) == (0, 0, [])
    among = decode(decoder(name), bytewise(b"\x01\xaa" + data + b"\x55\x00"))
    np.testing.assert_array_equal(among.data, whole.data)
    assert among.garbage == 4
    return whole.row()


@pytest.mark.parametrize("number", range(5))
def test_cvgx48(number: int):
    frame = stored("cvg_innalabs")[f"cvgx48_{number}"]
    assert one("cvgx48", frame["bytes"]) == frame["expected"]


def test_a_wrong_word_sum_is_a_bad_checksum():
    got = decode(decoder("cvgx48"), [stored("cvg_innalabs")["cvgx48_badsum"]["bytes"]])
    assert (len(got.data), got.bad_checksum, got.garbage) == (0, 1, 48)


@pytest.mark.parametrize("name", list(stored("aceinna")))
def test_aceinna(name: str):
    frame = stored("aceinna")[name]
    kind = {"dmu_S1": "aceinna_s1", "openimu_z1": "openimu_z1", "openimu_s1": "openimu_s1"}
    got = one(kind[name.rpartition("_")[0]], frame["bytes"])
    expected: dict[str, float] = {ACEINNA[key]: v for key, v in frame["expected"].items()}
    if name.startswith("openimu_z1"):
        expected["time"] *= 1e-6
    assert got == pytest.approx(expected, rel=1e-14, abs=0)


@pytest.mark.parametrize(
    ("name", "frame"), [("dmu30", "dmu30_derived"), ("dmu11", "dmu11_40_derived")]
)
def test_silicon_sensing(name: str, frame: str):
    entry = stored("silicon_sensing_dmu")[frame]
    got = one(name, entry["bytes"])
    for key, value in entry["expected"].items():
        scale = STANDARD_GRAVITY if key.startswith("acc") else 1.0
        assert got[DMU[key]] == pytest.approx(float(np.float32(value)) * scale, rel=1e-14), key


def kvh(rate: list[float], acc: list[float], sequence: int) -> bytes:
    """A KVH frame by its definition."""
    body = b"\xfe\x81\xff\x55" + np.array(rate + acc, dtype=">f4").tobytes()
    body += bytes((0x77, sequence)) + (31).to_bytes(2, "big")
    register = 0xFFFFFFFF
    for byte in body:
        register ^= byte << 24
        for _ in range(8):
            register = (register << 1) ^ (0x04C11DB7 if register >> 31 else 0)
            register &= 0xFFFFFFFF
    return body + register.to_bytes(4, "big")


def test_kvh_turns_radians_and_g_into_degrees_and_metres():
    got = one("kvh1750", kvh([0.5, -0.25, 0.0], [0.0, 1.0, -2.0], 5))
    assert got["gyro_x"] == pytest.approx(np.degrees(0.5), rel=1e-14)
    assert got["acc_z"] == -2 * STANDARD_GRAVITY
    assert (got["status"], got["sequence"], got["temp"]) == (0x77, 5, 31)


def test_kvh_counts_to_127():
    frames = [kvh([0.0] * 3, [0.0] * 3, n % 128) for n in (125, 126, 127, 0, 1, 4)]
    got = decode(decoder("kvh1750"), [b"".join(frames)])
    assert got.index.tolist() == [0, 1, 2, 3, 4, 7]
    assert got.lost == [(2, 7)]


def cvg(*values: float) -> bytes:
    """A CVGx48 frame by its definition."""
    payload = np.array([*values, *[1.0] * (11 - len(values))], dtype="<f4").tobytes()
    total = int(np.frombuffer(payload, dtype="<u2").sum()) % 65536
    return b"\xaa\x55" + payload + total.to_bytes(2, "little")


def test_impossible_values_are_counted_and_leave_a_gap():
    frames = [cvg(0.1), cvg(1e5), cvg(float("nan")), cvg(0.4), cvg(float("-inf")), cvg(-99999.0)]
    got = decode(decoder("cvgx48"), [b"".join(frames)])
    assert got.column("GyroOut").tolist() == np.float32([0.1, 0.4, -99999.0]).tolist()
    assert got.index.tolist() == [0, 3, 5]
    assert (got.bad_values, got.lost) == (3, [])
    events = decoder("cvgx48").feed(cvg(1e6))
    assert events == [BadValues(1)]


def test_without_a_counter_whole_missing_frames_are_seen_in_the_garbage():
    frames = [cvg(n / 8) for n in range(10)]
    stream = b"".join(frames[:3]) + frames[3][:40] + frames[4][20:] + b"".join(frames[5:])
    got = decode(decoder("cvgx48"), [stream])
    # 68 bytes of two torn frames are one frame length and a bit.
    assert got.lost == [(1, 4)]
    assert got.garbage == 68
    assert got.index.tolist() == [0, 1, 2, *range(4, 9)]
    bytes_missing = b"".join(frames[:3]) + frames[3][:20] + frames[3][21:] + b"".join(frames[4:])
    assert decode(decoder("cvgx48"), [bytes_missing]).lost == [(1, 4)]
    short = b"".join(frames[:3]) + b"noise" + b"".join(frames[3:])
    assert decode(decoder("cvgx48"), [short]).lost == []


def test_a_counter_tells_the_true_loss_whatever_the_garbage():
    profile = parse_profile(GOOD.replace("reject_abs = 5", ""), "x")
    spec = profile.stream
    assert isinstance(spec, FrameSpec)

    def frame(count: int) -> bytes:
        body = bytes((0xAA, 9, 0x55, 2 * count % 256, 0, 4, 0xFF, 0xFC, 0, 0b110, 0))
        return body + bytes((sum(body[3:]) % 256,))

    frames = [frame(n) for n in range(300)]
    stream = b"".join(frames[:4] + frames[7:250] + [b"\0" * 60] + frames[250:])
    got = decode(FrameDecoder(spec, 50.0), [stream])
    assert got.lost == [(3, 7)]
    assert got.index.tolist() == [n for n in range(300) if n not in (4, 5, 6)]
    assert got.row() == {"x": 2.0, "y": 0.0, "flags": 3.0}


def test_every_byte_is_a_frame_garbage_or_carried():
    rng = np.random.default_rng(2)
    stream = b"".join(
        cvg(*rng.normal(size=3)) if rng.random() < 0.8 else rng.bytes(int(rng.integers(70)))
        for _ in range(400)
    )
    for size in (1, 7, 48, 1000, len(stream)):
        cvg48 = decoder("cvgx48")
        fed = 0
        events: list[Any] = []
        for at in range(0, len(stream), size):
            events += cvg48.feed(stream[at : at + size])
            fed += len(stream[at : at + size])
            if size > 7:
                got: Outcome = outcome(events)
                assert (len(got.data) + got.bad_values) * 48 + got.garbage + cvg48.carried == fed
                assert cvg48.carried < 48
        got = outcome(events)
        assert (len(got.data) + got.bad_values) * 48 + got.garbage + cvg48.carried == fed


def test_blocks_carry_channels_and_the_declared_rate():
    cvg48 = decoder("cvgx48")
    (block,) = cvg48.feed(cvg(1.0) * 3)
    assert isinstance(block, SampleBlock)
    assert block.rate == cvg48.rate == 200.0
    assert block.channels == cvg48.channels
    assert block.column("rate.z") is not None
    assert block.column("temp") is not None


def test_a_first_frame_out_of_step_is_no_loss():
    got = decode(decoder("cvgx48"), [cvg(1.0)[7:] + cvg(2.0) + cvg(3.0)])
    assert got.index.tolist() == [0, 1]
    assert not any(isinstance(event, Lost) for event in got.lost)
    assert got.garbage == 41
