"""Frames are described by hand as well as found."""

import numpy as np

from drivers.checksums import Checksum, ChecksumSpec
from drivers.teach.frames import checks_of, describe, propose_frames

CHECK = ChecksumSpec("sum16", 2, -2, -2, 2, "big")


def frames(count: int = 300) -> np.ndarray:
    rng = np.random.default_rng(6)
    rows = np.zeros((count, 11), np.uint8)
    rows[:, :2] = 0xC3, 0x9D
    rows[:, 2] = np.arange(count) % 256
    codes = rng.integers(-900, 900, (count, 3)).astype(">i2")
    rows[:, 3:9] = codes.view(np.uint8).reshape(count, 6)
    Checksum(CHECK).stamp(rows)
    return rows


def test_the_whole_of_a_stream_is_proposed():
    proposal = propose_frames(frames().tobytes())
    spec = proposal.spec
    assert (spec.sync, spec.length, spec.endian) == ((0xC3, 0x9D), 11, "big")
    assert spec.checksum.algorithm == "sum16"
    assert (proposal.share, proposal.frames) == (1.0, 300)
    assert (spec.counter.field, spec.counter.bits, spec.counter.step) == ("counter", 8, 1)
    shown = [(field.at, field.type) for field in spec.fields if not field.hide]
    assert shown == [(3, "i16"), (5, "i16"), (7, "i16")]


def test_a_header_and_a_length_given_by_hand_lead_to_the_checksum():
    data = frames().tobytes()
    fits = checks_of(data, (0xC3, 0x9D), 11)
    assert fits[0].spec.algorithm == "sum16"
    assert fits[0].share == 1.0
    proposal = describe(data, (0xC3, 0x9D), 11, fits[0])
    assert proposal.spec.checksum == fits[0].spec


def test_a_wrong_length_finds_no_frames():
    assert describe(frames().tobytes(), (0xC3, 0x9D), 10, None) is None
    assert checks_of(frames().tobytes(), (0xC3, 0x9D), 10) == []
    assert checks_of(b"ab", (0xC3,), 10) == []


def test_what_does_not_repeat_is_not_proposed():
    noise = np.random.default_rng(1).integers(0, 256, 4000, np.uint8)
    found = propose_frames(noise.tobytes())
    assert found is None or found.share < 0.3
