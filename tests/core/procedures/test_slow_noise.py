"""Variances of combinations against the Allan variance, and against noise made step by step."""

import numpy as np
import pytest

from core.allan.model import NoiseModel
from core.procedures.slow_noise import combined_covariance, in_turn

ONE = NoiseModel(random_walk=0.3, bias_instability=0.2, rate_random_walk=0.05)


@pytest.mark.parametrize("term", ["random_walk", "bias_instability", "rate_random_walk"])
@pytest.mark.parametrize("tau", [0.2, 1.0, 7.0])
def test_neighbouring_means_differ_by_the_allan_variance(term: str, tau: float):
    noise = NoiseModel(**{term: 0.4})
    starts, lengths = in_turn(2, tau, 0.0)
    variance = combined_covariance(noise, np.array([[1.0, -1.0]]), starts, lengths)[0, 0]
    assert variance == pytest.approx(2.0 * noise.variance(np.array([tau]))[0])


def test_windows_apart_against_a_simulated_walk():
    rng = np.random.default_rng(6)
    dt, n, trials = 0.05, 1200, 3000
    walk = NoiseModel(random_walk=0.2, rate_random_walk=0.1)
    rate = np.cumsum(0.1 * np.sqrt(dt) * rng.standard_normal((trials, n)), axis=1)
    rate += 0.2 / np.sqrt(dt) * rng.standard_normal((trials, n))
    starts, lengths = in_turn(4, 10.0, 5.0)
    means = np.column_stack(
        [rate[:, round(a / dt) : round((a + 10.0) / dt)].mean(axis=1) for a in starts]
    )
    weights = np.array([[0.5, 0.0, -0.5, 0.0], [0.25, 0.25, 0.25, -0.75]])
    expected = combined_covariance(walk, weights, starts, lengths)
    assert np.cov(weights @ means.T) == pytest.approx(expected, rel=0.08, abs=1e-4)


def test_a_mean_is_taken_against_the_session():
    """Flicker and walk do not move the mean of the whole session from itself."""
    starts, lengths = np.array([0.0, 10.0]), np.array([10.0, 10.0])
    both = np.array([[0.5, 0.5]])
    slow = NoiseModel(bias_instability=0.2, rate_random_walk=0.05)
    assert combined_covariance(slow, both, starts, lengths)[0, 0] == pytest.approx(0.0, abs=1e-12)
    white = NoiseModel(random_walk=0.3)
    variance = combined_covariance(white, both, starts, lengths)[0, 0]
    assert variance == pytest.approx(0.3**2 / 20.0)
    first = combined_covariance(ONE, np.array([[1.0, 0.0]]), starts, lengths)[0, 0]
    assert first > 0.3**2 / 10.0


def test_the_unit_of_time_does_not_matter():
    weights = np.array([[1.0, -2.0, 1.0]])
    starts, lengths = in_turn(3, 60.0, 30.0)
    in_s = combined_covariance(NoiseModel(bias_instability=0.2), weights, starts, lengths)
    in_min = combined_covariance(
        NoiseModel(bias_instability=0.2), weights, starts / 60, lengths / 60
    )
    assert in_s == pytest.approx(in_min)


def test_accumulations_in_turn():
    starts, lengths = in_turn(3, 10.0, 5.0)
    assert starts.tolist() == [5.0, 20.0, 35.0]
    assert lengths.tolist() == [10.0] * 3
