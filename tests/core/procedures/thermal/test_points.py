"""Plateaus by themselves; heating against cooling."""

import numpy as np
import pytest

from core.procedures.thermal.cycle import calibrate_thermal
from core.samples.run import Conditions

CASE = Conditions(g_mps2=9.8106)


def test_each_plateau_gives_bias_and_scale_factor(make_chamber):
    result = calibrate_thermal(make_chamber(1e-6), CASE, bias_order=2, scale_order=1)
    points = result.channels[0].points
    assert [point.came for point in points] == [0, -1, -1, 1, 1, 1, 1, -1, -1]
    for point in points:
        t = point.temperature_c - 27.0
        assert point.bias.value == pytest.approx(40.0 + 0.8 * t + 0.004 * t**2, abs=0.01)
        assert point.scale_factor.value == pytest.approx(800.0 + 0.16 * t, abs=1e-3)
    assert points[0].bias.unit == "code"


def test_hysteresis_is_measured(make_chamber):
    quiet = Conditions(g_mps2=9.8106, repeatability=np.nan)
    result = calibrate_thermal(make_chamber(0.5, hysteresis=20.0), quiet)
    x, y, _ = result.channels
    assert [round(one.temperature_c) for one in x.hysteresis] == pytest.approx([-10, 27, 50], abs=1)
    assert [one.bias.value for one in x.hysteresis] == pytest.approx([20.0] * 3, abs=1.5)
    assert x.largest_hysteresis == pytest.approx(20.0, abs=1.5)
    assert y.largest_hysteresis < 2.0
    (note,) = (note for note in result.notes if note.subject == "hysteresis")
    assert note.text.startswith("X: at ")
    still = calibrate_thermal(make_chamber(0.5), CASE)
    assert "hysteresis" not in [note.subject for note in still.notes]


def test_one_sense_of_an_axis_gives_no_scale_factor(make_chamber):
    run = make_chamber(0.1)
    # At the second plateau Z only stands up.
    second = range(8, 16)
    kept = [row for row in range(72) if row not in second or run.head_deg[row] == 0.0]
    result = calibrate_thermal(run.rows(kept), CASE)
    assert np.isnan(result.channels[2].points[1].scale_factor.value)
    assert np.isfinite(result.channels[2].points[0].scale_factor.value)
    assert "one_sense" in [note.subject for note in result.notes]
