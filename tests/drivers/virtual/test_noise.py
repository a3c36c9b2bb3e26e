"""The noise of the rig against plain recursions and against the levels that it was asked for."""

import math

import numpy as np
import pytest

from drivers.virtual.noise import Lag, Noise, NoiseLevel


def allan_deviation(y: np.ndarray, m: int) -> float:
    """Overlapping Allan deviation of (n,) samples at m samples, written out plainly."""
    sums = np.concatenate([[0.0], np.cumsum(y - y[0])])
    means = (sums[m:] - sums[:-m]) / m
    return float(np.sqrt(np.mean((means[m:] - means[:-m]) ** 2) / 2.0))


@pytest.mark.parametrize("tau", [0.0, 0.02, 1.0, 1e4])
def test_lag_is_its_recursion(tau):
    rng = np.random.default_rng(1)
    x = rng.standard_normal((500, 3))
    pole = math.exp(-0.01 / tau) if tau else 0.0
    expected, last = [], np.array([1.0, -2.0, 0.5])
    for row in x:
        last = pole * last + (1 - pole) * row
        expected.append(last)
    lag = Lag(tau, 0.01, np.array([1.0, -2.0, 0.5]))
    cuts = [x[:7], x[7:8], x[8:200], x[200:]]
    assert np.allclose(np.concatenate([lag.filtered(part) for part in cuts]), expected, atol=1e-12)
    assert np.allclose(lag.output, expected[-1])


def test_blocks_of_any_length_give_the_same():
    levels = (NoiseLevel(1.0, 0.5, 0.1), NoiseLevel(0.0, 0.0, 0.3), NoiseLevel(2.0, 0.0, 0.0))
    whole = Noise(levels, 100.0, np.random.default_rng(7)).next(1000)
    cut = Noise(levels, 100.0, np.random.default_rng(7))
    pieces = np.concatenate([cut.next(n) for n in (1, 2, 63, 64, 65, 305, 500)])
    assert np.allclose(whole, pieces, rtol=0, atol=1e-9)


def test_white_noise_has_its_density():
    y = Noise((NoiseLevel(0.3, 0.0, 0.0),), 50.0, np.random.default_rng(2)).next(100_000)[:, 0]
    # One-sided density n: deviation n * sqrt(rate / 2).
    assert y.std() == pytest.approx(0.3 * 5.0, rel=0.01)
    assert allan_deviation(y, 500) == pytest.approx(0.3 / math.sqrt(2) / math.sqrt(10.0), rel=0.1)


def test_flicker_has_its_floor_over_decades():
    levels = (NoiseLevel(0.0, 2.0, 0.0),) * 16
    y = Noise(levels, 10.0, np.random.default_rng(3)).next(200_000)
    for m in (100, 1000, 10_000):
        deviations = [allan_deviation(column, m) for column in y.T]
        mean = math.sqrt(float(np.mean(np.square(deviations))))
        assert mean / 0.664 == pytest.approx(2.0, rel=0.12)


def test_random_walk_has_its_coefficient():
    levels = (NoiseLevel(0.0, 0.0, 0.4),) * 16
    y = Noise(levels, 20.0, np.random.default_rng(4)).next(40_000)
    grown = y[-1] - y[0]
    assert grown.std() == pytest.approx(0.4 * math.sqrt(2000.0), rel=0.4)
    tau = 50.0
    deviations = [allan_deviation(column, int(tau * 20)) for column in y.T]
    mean = math.sqrt(float(np.mean(np.square(deviations))))
    assert mean == pytest.approx(0.4 * math.sqrt(tau / 3.0), rel=0.1)


def test_no_noise_is_silence():
    assert (
        not Noise((NoiseLevel(0.0, 0.0, 0.0),) * 3, 100.0, np.random.default_rng(5)).next(9).any()
    )
