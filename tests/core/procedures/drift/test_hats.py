"""Hat functions, their least squares, and knots moved to where they belong."""

import numpy as np
import pytest

from core.procedures.drift.hats import cost, hat_basis, ordinates, refine

KNOTS = np.array([0.0, 10.0, 25.0, 60.0])


def test_hats_interpolate_and_are_held_beyond_the_ends():
    t = np.array([-5.0, 0.0, 4.0, 10.0, 17.5, 60.0, 80.0])
    values = np.array([1.0, 3.0, -3.0, 4.0])
    assert hat_basis(t, KNOTS) @ values == pytest.approx(np.interp(t, KNOTS, values))
    assert hat_basis(t, KNOTS).sum(axis=1) == pytest.approx(np.ones(7))


def test_ordinates_are_the_least_squares():
    rng = np.random.default_rng(2)
    t = np.arange(61.0)
    curves = rng.normal(size=(4, 61))
    found = ordinates(t, curves, KNOTS)
    expected = np.linalg.lstsq(hat_basis(t, KNOTS), curves.T, rcond=None)[0].T
    assert found == pytest.approx(expected, abs=1e-12)
    residual = curves - found @ hat_basis(t, KNOTS).T
    assert cost(t, curves, KNOTS) == pytest.approx(float(np.sum(residual**2)))


def test_a_knot_without_points_costs_infinitely():
    assert cost(np.arange(5.0), np.ones((1, 5)), np.array([0.0, 1.2, 1.4, 1.6, 4.0])) == np.inf


def test_knots_move_off_the_grid_to_the_bends():
    t = np.arange(120) + 0.5
    truth = np.array([0.0, 30.25, 71.75, 120.0])
    curves = np.array([hat_basis(t, truth) @ [0, 3, -2, 1], hat_basis(t, truth) @ [0, -1, 2, 2]])
    start = np.array([0.0, 28.5, 74.5, 120.0])
    found = refine(t, curves, start)
    assert found == pytest.approx(truth, abs=0.01)
    assert start.tolist() == [0.0, 28.5, 74.5, 120.0]
