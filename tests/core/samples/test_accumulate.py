"""N seconds by the counter, whole numbers of samples, gaps, stuck and short accumulations."""

import itertools

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.errors import Severity
from core.samples.accumulate import Accumulator, accumulation_of, measures
from core.samples.block import Channel, SampleBlock, chosen_columns

CHANNELS = (Channel("U1", "code", "adc.1"), Channel("T1", "code", "temp.adc.1"))
RATE = 100.0


def block(first: int, data: np.ndarray, index: np.ndarray | None = None) -> SampleBlock:
    rows = np.arange(first, first + len(data)) if index is None else index
    return SampleBlock(CHANNELS, frozen_int(rows), frozen(data), RATE)


def noise(n: int, seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return rng.normal([1000.0, 20.0], [3.0, 0.5], (n, 2))


def test_takes_exactly_the_samples_of_n_seconds_however_the_blocks_fall() -> None:
    data = noise(260)
    results = []
    for cuts in ([0, 260], [0, 7, 150, 199, 201, 260]):
        accumulator = Accumulator(2.0, RATE)
        full = [accumulator.feed(block(500 + a, data[a:b])) for a, b in itertools.pairwise(cuts)]
        assert full[-1]
        assert accumulator.progress == 1.0
        assert accumulator.remaining_s == 0.0
        results.append(accumulator.result())
    for result in results:
        assert (result.n, result.lost, result.first) == (200, 0, 500)
        np.testing.assert_allclose(result.mean, data[:200].mean(axis=0), rtol=1e-12)
        np.testing.assert_allclose(result.std, data[:200].std(axis=0, ddof=1), rtol=1e-12)
        assert result.seconds == pytest.approx(1.99)


def test_a_gap_counts_as_time_and_is_said() -> None:
    index = np.r_[0:80, 100:200]
    accumulator = Accumulator(2.0, RATE)
    assert accumulator.feed(block(0, noise(180), index))
    result = accumulator.result()
    assert (result.n, result.lost) == (180, 20)
    assert [note.subject for note in result.notes] == ["lost_samples"]
    assert "20 of 200" in result.notes[0].text


def test_a_mean_over_a_line_that_lost_most_is_refused() -> None:
    accumulator = Accumulator(2.0, RATE)
    accumulator.feed(block(0, noise(60), np.r_[0:30, 170:200]))
    (note,) = accumulator.result().notes
    assert note.severity is Severity.ERROR
    assert "140 of 200" in note.text


def test_too_short_is_an_error_that_names_the_numbers() -> None:
    accumulator = Accumulator(2.0, RATE)
    accumulator.feed(block(0, noise(120)))
    (note,) = accumulator.result().notes
    assert note.severity is Severity.ERROR
    assert note.subject == "too_short"
    assert "120 of 200" in note.text


def test_nothing_accumulated_has_no_result() -> None:
    with pytest.raises(ValueError, match="nothing"):
        Accumulator(1.0, RATE).result()


def test_a_stuck_channel_is_named_but_not_an_unused_one() -> None:
    channels = (Channel("A", "code", "adc.1"), Channel("B", "code", "adc.2"))
    data = np.tile([517.0, 0.0], (200, 1))
    result = accumulation_of(channels, np.arange(200) / RATE, data)
    (note,) = result.notes
    assert note.subject == "stuck"
    assert note.text.startswith("A:")
    # Rounding to one code is the least that such a mean can be wrong by.
    np.testing.assert_allclose(result.se, 1.0 / np.sqrt(12.0))


def test_a_drift_shows_as_a_slope_with_its_error() -> None:
    t = np.arange(1000) / RATE
    data = noise(1000)
    data[:, 0] += 2.0 * t
    result = accumulation_of(CHANNELS, t, data)
    assert result.slope[0] == pytest.approx(2.0, abs=4 * 3.0 * np.sqrt(12 / 1000) / 10)
    assert abs(result.slope[1]) < 5 * result.slope_se[1]


def test_a_slope_error_is_that_of_a_straight_line() -> None:
    t = np.arange(2000) / RATE
    slopes, errors = [], []
    for seed in range(300):
        result = accumulation_of(CHANNELS, t, noise(2000, seed))
        slopes.append(result.slope[0])
        errors.append(result.slope_se[0])
    assert np.std(slopes) == pytest.approx(np.mean(errors), rel=0.12)


def test_roles_choose_columns() -> None:
    assert chosen_columns(CHANNELS, "adc.") == [0]
    assert measures(CHANNELS[0])
    assert not measures(CHANNELS[1])
    result = accumulation_of(CHANNELS, np.arange(200) / RATE, noise(200))
    assert result.of_role("temp.adc.1") == result.mean[1]
    assert np.isnan(result.of_role("temp"))


@pytest.mark.parametrize(("seconds", "rate"), [(0.0, 100.0), (10.0, 0.0), (-1.0, 5.0)])
def test_impossible_settings_are_refused(seconds: float, rate: float) -> None:
    with pytest.raises(ValueError, match="cannot accumulate"):
        Accumulator(seconds, rate)


@pytest.mark.parametrize(
    ("level", "low", "expected"), [(180.0, -180.0, 180.0), (0.0, 0.0, 0.0), (30.0, -180.0, 30.0)]
)
def test_an_angle_that_passes_the_end_of_its_turn_keeps_its_mean(level, low, expected) -> None:
    # At a roll of 180 deg half of the samples read -180: a plain mean of them would be 0.
    angles = (level + np.random.default_rng(5).normal(0.0, 0.05, 400) - low) % 360.0 + low
    channels = (Channel("roll", "deg", "angle.roll"),)
    result = accumulation_of(channels, np.arange(400) / RATE, angles[:, None])
    off = (result.mean[0] - expected + 180.0) % 360.0 - 180.0
    assert abs(off) < 0.01
    assert low <= result.mean[0] <= low + 360.0
    assert result.std[0] == pytest.approx(0.05, rel=0.2)
    assert abs(result.slope[0]) < 0.01
