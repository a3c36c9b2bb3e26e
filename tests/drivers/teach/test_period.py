"""Lengths and constant bytes of a stream."""

import numpy as np

from drivers.teach.period import (
    alignments,
    boundary_evidence,
    constant_runs,
    likely_lengths,
    recurrence,
)


def stream(length: int, count: int, garbage: float, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    rows = rng.integers(0, 256, (count, length), np.uint8)
    rows[:, :2] = 0xA1, 0x5C
    pieces = []
    for row in rows:
        pieces.append(row)
        if rng.random() < garbage:
            pieces.append(rng.integers(0, 256, int(rng.integers(1, 9)), np.uint8))
    return np.concatenate(pieces)


def test_the_length_stands_out_and_its_multiples_are_left_out():
    data = stream(23, 300, 0.0)
    assert recurrence(data).argmax() % 23 == 0
    lengths = likely_lengths(data)
    assert lengths[0] == 23
    assert 46 not in lengths


def test_noise_repeats_nothing_for_long():
    noise = np.random.default_rng(1).integers(0, 256, 9000, np.uint8)
    assert recurrence(noise).max() < 0.02


def test_anchors_line_up_a_stream_with_garbage():
    data = stream(23, 300, 0.3)
    best = next(iter(alignments(data)))
    assert best.length == 23
    assert np.all(data[best.places] == 0xA1)
    assert [int(value) for value in best.constant if value >= 0] == [0xA1, 0x5C]
    # Across the header's own beginning nothing is disturbed, one byte later it is.
    assert boundary_evidence(best, 0) > 0.99 > boundary_evidence(best, 1) + 0.05


def test_runs_go_around_the_cycle():
    constant = np.array([5, -1, -1, 7, -1, 9])
    assert constant_runs(constant) == [(5, 2), (3, 1)]
    assert constant_runs(np.array([1, 2])) == []
