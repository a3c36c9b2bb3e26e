"""Angles past the end of their turn."""

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.samples.accumulate import Accumulator
from core.samples.block import Channel, SampleBlock
from core.samples.stillness import StillnessDetector
from core.samples.turning import turning_columns, unwrapped, within_turn

CHANNELS = (
    Channel("n", "", "counter"),
    Channel("roll", "deg", "angle.roll"),
    Channel("psi", "rad", "angle.heading"),
)


def about_180(n: int, drift: float = 0.0) -> np.ndarray:
    roll = 180.0 + np.random.default_rng(3).normal(0.0, 0.05, n) + drift * np.arange(n)
    return np.column_stack([np.arange(n), (roll + 180.0) % 360.0 - 180.0, np.zeros(n)])


def block_of(data: np.ndarray) -> SampleBlock:
    return SampleBlock(CHANNELS, frozen_int(np.arange(len(data))), frozen(data), 100.0)


def test_only_angles_in_degrees_turn():
    assert turning_columns(CHANNELS) == [1]
    data = about_180(50)
    assert np.ptp(data[:, 1]) > 300.0
    smooth = unwrapped(data, [1])
    assert np.ptp(smooth[:, 1]) < 1.0
    assert np.array_equal(smooth[:, [0, 2]], data[:, [0, 2]])
    assert unwrapped(data, []) is data


@pytest.mark.parametrize(
    ("mean", "samples", "expected"),
    [
        (180.01, [-179.9, 179.9], -179.99),
        (180.0, [-180.0, 180.0], 180.0),
        (-0.5, [0.5, 359.0], 359.5),
        (-30.0, [-30.0, -30.1], -30.0),
    ],
)
def test_the_turn_that_the_device_counts_in(mean, samples, expected):
    assert within_turn(mean, np.array(samples)) == pytest.approx(expected)


def test_a_unit_that_rests_at_180_degrees_is_at_rest():
    still = StillnessDetector(100.0, "angle.roll")
    still.feed(block_of(about_180(150)))
    assert still.at_rest
    assert abs(still.mean()[0] - 180.0) % 360.0 == pytest.approx(0.0, abs=0.02)
    still.reset()
    still.feed(block_of(about_180(150, drift=0.01)))
    assert not still.at_rest


def test_samples_of_an_accumulation_run_on():
    accumulator = Accumulator(1.0, 100.0)
    accumulator.feed(block_of(about_180(120)))
    assert np.ptp(accumulator.samples()[1][:, 1]) < 1.0
