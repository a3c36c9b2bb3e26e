"""Linear slopes and drawn distributions against what is known exactly."""

import numpy as np
import pytest

from core.procedures.propagation import draws_of, jacobian, spread_of


def test_slopes_of_a_smooth_function():
    def function(x: np.ndarray) -> np.ndarray:
        return np.array([x[0] * x[1], np.sin(x[1]), x[0] ** 2])

    at = np.array([3.0, 0.5])
    expected = [[0.5, 3.0], [0.0, np.cos(0.5)], [6.0, 0.0]]
    assert jacobian(function, at, np.ones(2)) == pytest.approx(np.array(expected), abs=1e-8)


def test_draws_have_the_covariance():
    covariance = np.array([[4.0, 1.0], [1.0, 2.0]])
    draws = draws_of(np.array([10.0, -5.0]), covariance, np.inf)
    assert draws.mean(axis=0) == pytest.approx([10.0, -5.0], abs=0.05)
    assert np.cov(draws.T) == pytest.approx(covariance, rel=0.05, abs=0.05)
    again = draws_of(np.array([10.0, -5.0]), covariance, np.inf)
    assert np.array_equal(draws, again)


def test_few_degrees_of_freedom_make_wide_intervals():
    covariance = np.eye(1)
    spread = spread_of(0.0, draws_of(np.zeros(1), covariance, 4.0)[:, 0], "V")
    assert spread.high == pytest.approx(2.776, rel=0.05)
    assert spread.low == pytest.approx(-2.776, rel=0.05)
    normal = spread_of(0.0, draws_of(np.zeros(1), covariance, np.inf)[:, 0], "V")
    assert normal.high == pytest.approx(1.96, rel=0.05)


def test_a_singular_covariance_is_no_obstacle():
    draws = draws_of(np.zeros(2), np.ones((2, 2)), np.inf)
    assert draws[:, 0] == pytest.approx(draws[:, 1])
