"""Test turns (4), (5), (8), (11) and their uncertainties."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.fourier.pairs import turn_pairs
from core.procedures.fourier.readings import run_of_angles
from core.samples.run import Conditions

G = 9.8106
CASE = Conditions(g_mps2=G)


def six(repeats: int, noise: float, seed: int = 0, se: float = np.nan):
    """Sensor x in +-x, +-y, +-z by mounts of the head."""
    places = [("Z_to@-90", 90.0, "x", 1), ("Z_to@-90", 270.0, "x", -1)]
    places += [("Z_to@-90", 0.0, "y", 1), ("Z_to@-90", 180.0, "y", -1)]
    places += [("X_from", 0.0, "z", 1), ("X_from", 180.0, "z", -1)]
    k = {"x": 0.1, "y": 0.002, "z": -0.003}
    rng = np.random.default_rng(seed)
    rows = places * repeats
    u = np.array([2.5 + k[axis] * sense * G for _, _, axis, sense in rows])
    u += noise * rng.standard_normal(len(u))
    run = run_of_angles([head for _, head, _, _ in rows], u, "V", u_se=np.full(len(u), se))
    return replace(run, mount=tuple(mount for mount, *_ in rows))


def test_bias_and_responses():
    pairs = {pair.axis: pair for pair in turn_pairs(six(2, 0.0), CASE)}
    assert set(pairs) == {"x", "y", "z"}
    assert [pairs[axis].bias.value for axis in "xyz"] == pytest.approx([2.5] * 3)
    assert [pairs[axis].response.value for axis in "xyz"] == pytest.approx([0.1, 0.002, -0.003])
    assert pairs["x"].response.unit == "V/(m/s^2)"


def test_uncertainties_are_those_of_means():
    known = turn_pairs(six(5, 1e-3, se=1e-3), CASE)[0]
    assert known.bias.u == pytest.approx(1e-3 / np.sqrt(10.0))
    assert known.response.u == pytest.approx(1e-3 / np.sqrt(10.0) / G)
    assert known.bias.dof == np.inf
    scatter = turn_pairs(six(50, 1e-3), CASE)[0]
    assert scatter.bias.u == pytest.approx(1e-3 / 10.0, rel=0.1)
    assert scatter.bias.dof == 6 * 49
    lonely = turn_pairs(six(1, 1e-3), CASE)[0]
    assert np.isnan(lonely.bias.u)
    unsure = turn_pairs(six(5, 0.0, se=1e-9), Conditions(g_mps2=G, u_g_mps2=1e-3))[0]
    assert unsure.response.u == pytest.approx(0.1 * 1e-3 / G, rel=1e-3)


def test_turning_to_the_largest_output_finds_another_number():
    """What the source proposes against a tilted axis measures hypot(k_x, k_y)."""
    alpha = np.radians(np.arange(0.0, 360.0, 0.01))
    u = 0.1 * G * np.sin(alpha) + 0.02 * G * np.cos(alpha)
    largest = (u.max() - u.min()) / (2.0 * G)
    assert largest == pytest.approx(np.hypot(0.1, 0.02), rel=1e-6)


def test_what_is_missing_is_said():
    run = six(1, 0.0)
    with pytest.raises(FitError, match="no axis stood up and down"):
        turn_pairs(run.rows([0, 2, 4]), CASE)
    broken = np.array(run.y)
    broken[3] = np.nan
    with pytest.raises(FitError, match="row 4: the output is not a number"):
        turn_pairs(replace(run, y=broken), CASE)
    with pytest.raises(FitError, match="gravity"):
        turn_pairs(run, Conditions())


@pytest.mark.slow
def test_intervals_hold_the_truth():
    hits, trials = np.zeros(2), 1000
    for seed in range(trials):
        pair = turn_pairs(six(3, 1e-3, seed), CASE)[1]
        hits += [
            abs(pair.bias.value - 2.5) < pair.bias.expanded(),
            abs(pair.response.value - 0.002) < pair.response.expanded(),
        ]
    assert np.all((hits / trials > 0.93) & (hits / trials < 0.97))
