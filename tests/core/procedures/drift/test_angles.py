"""The source's own way: its formulas, its slips corrected, and what it cannot do."""

import numpy as np
import pytest

from core.procedures.drift.angles import corner_angles, sharpest_knots, temperature_slopes


def test_angles_of_known_triangles():
    assert corner_angles(np.array([0.0, 0.0, 1.0]), 1.0) == pytest.approx([135.0])
    assert corner_angles(np.array([1.0, 0.0, 1.0]), 1.0) == pytest.approx([90.0])
    assert corner_angles(np.array([0.0, 0.5, 1.0]), 1.0) == pytest.approx([180.0])


def test_the_angle_depends_on_the_spacing_that_is_arbitrary():
    spike = np.array([0.0, 0.01, 0.0])
    assert corner_angles(spike, 1e-3) == pytest.approx([11.42], abs=0.01)
    assert corner_angles(spike, 0.1) == pytest.approx([168.58], abs=0.01)


def test_the_sharpest_points_are_taken():
    y = np.interp(np.arange(41.0), [0, 10, 22, 40], [0, 10, 6, 7])
    assert sharpest_knots(y, 4).tolist() == [0, 10, 22, 40]


def test_the_sum_of_temperature_steps_is_the_difference_of_the_ends():
    rng = np.random.default_rng(4)
    temperature = np.cumsum(rng.uniform(0.0, 0.1, 400))
    knots = np.array([20, 180, 399])
    values = np.array([0.0, 2.0, -1.0])
    slopes, notes = temperature_slopes(values, temperature[knots], 0.01)
    at_knots = temperature[knots]
    assert slopes == pytest.approx(np.diff(values) / np.diff(at_knots))
    assert notes == ()
    # As printed, (2) takes one step too many: the one that leads to the first knot.
    steps = np.diff(temperature, prepend=0.0)
    printed = steps[20 : 180 + 1].sum()
    assert printed - (at_knots[1] - at_knots[0]) == pytest.approx(steps[20])
    assert steps[20] > 1e-3


def test_the_plateau_has_no_slope_against_temperature():
    temperature = np.array([20.0, 28.0, 30.0, 30.02, 30.02])
    values = np.array([0.0, 0.4, 0.6, 0.65, 0.7])
    slopes, (note,) = temperature_slopes(values, temperature, 0.05)
    assert slopes[:2] == pytest.approx([0.05, 0.1])
    assert np.isnan(slopes[2:]).all()
    assert note.subject == "temperature_plateau"
    assert "segments 3, 4" in note.text
    exact, _ = temperature_slopes(values, temperature, 0.0)
    assert np.isnan(exact[3])
