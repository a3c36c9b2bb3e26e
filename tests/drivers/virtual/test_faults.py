"""Faults of the line: as often as asked, and accounted for."""

import numpy as np
import pytest

from drivers.virtual.faults import Faults, Line


def line() -> Line:
    return Line(np.random.default_rng(3))


FRAMES = b"".join(bytes([k % 251]) * 20 for k in range(4000))


def test_perfect_line_changes_nothing():
    assert line().carry(FRAMES, 0, 4000, Faults()) is FRAMES


def test_dropped_frames_are_those_that_it_names():
    one = line()
    carried = one.carry(FRAMES, 100, 4000, Faults(drop=0.1))
    (dropped,) = one.damaged
    assert len(dropped) == pytest.approx(400, abs=60)
    kept = np.delete(np.frombuffer(FRAMES, np.uint8).reshape(4000, 20), dropped - 100, axis=0)
    assert carried == kept.tobytes()


def test_bits_flip_at_their_rate():
    one = line()
    carried = one.carry(FRAMES, 0, 4000, Faults(bit_error=1e-3))
    flipped = np.unpackbits(np.frombuffer(carried, np.uint8) ^ np.frombuffer(FRAMES, np.uint8))
    assert int(flipped.sum()) == pytest.approx(640, abs=100)
    hit = np.flatnonzero(flipped.reshape(4000, -1).any(axis=1))
    assert np.array_equal(hit, one.damaged[0])


def test_half_frames_and_garbage():
    one = line()
    halved = one.carry(FRAMES, 0, 4000, Faults(half=0.05))
    missing = len(FRAMES) - len(halved)
    assert missing == pytest.approx(len(one.damaged[0]) * 10, rel=0.2)
    noisy = line()
    longer = noisy.carry(FRAMES, 0, 4000, Faults(garbage=0.1))
    assert len(longer) - len(FRAMES) == pytest.approx(400 * 20, rel=0.2)
    assert not np.concatenate(noisy.damaged).size


def test_lines_of_any_length_are_frames_too():
    text = b"".join(b"%d,%d\r\n" % (k, k * k) for k in range(1000))
    one = line()
    carried = one.carry(text, 0, 1000, Faults(drop=0.5))
    lines = text.splitlines(keepends=True)
    assert carried == b"".join(np.delete(np.array(lines, dtype=object), one.damaged[0]))


def test_blocks_of_any_length_give_the_same():
    faults = Faults(bit_error=1e-4, drop=0.02, half=0.02, garbage=0.02)
    whole, cut = line(), line()
    expected = whole.carry(FRAMES, 0, 4000, faults)
    pieces = [cut.carry(FRAMES[20 * a : 20 * b], a, b - a, faults) for a, b in
              ((0, 1), (1, 500), (500, 4000))]  # fmt: skip
    assert b"".join(pieces) == expected
    assert np.array_equal(np.concatenate(whole.damaged), np.concatenate(cut.damaged))


def test_stuck_channels_hold_their_value_until_mended():
    one = line()
    first, second = np.arange(12.0).reshape(4, 3), 100 + np.arange(6.0).reshape(2, 3)
    one.freeze(first, Faults(stuck=(1,)))
    one.freeze(second, Faults(stuck=(1,)))
    assert first[:, 1].tolist() == [1.0] * 4
    assert second.tolist() == [[100.0, 1.0, 102.0], [103.0, 1.0, 105.0]]
    third = np.array([[7.0, 8.0, 9.0]])
    one.freeze(third, Faults())
    assert third.tolist() == [[7.0, 8.0, 9.0]]
