"""k, T and mounting at each temperature."""

from dataclasses import replace

import numpy as np
import pytest

from core.procedures.thermal.simulated import CROSS, SCALE
from core.procedures.thermal.split import splits_of
from core.samples.run import Conditions

CASE = Conditions(g_mps2=9.8106)


def test_the_scale_factor_follows_the_temperature(make_chamber):
    found = splits_of(make_chamber(1e-6), CASE)
    assert [round(one.temperature_c, -1) for one in found] == [
        30,
        -10,
        -40,
        -10,
        30,
        50,
        70,
        50,
        30,
    ]
    assert [one.came for one in found] == [0, -1, -1, 1, 1, 1, 1, -1, -1]
    hot, cold = found[6], found[2]
    slope = (hot.six.triad.k - cold.six.triad.k) / (hot.temperature_c - cold.temperature_c)
    assert np.diag(slope) == pytest.approx(SCALE[:, 1], abs=0.01)
    assert hot.six.triad.k[0, 1] == pytest.approx(CROSS[0, 1], abs=0.1)
    assert hot.six.nine.residual_mg.max() > hot.six.residual_mg.max()


def test_without_temperatures_all_rows_are_one(make_chamber):
    run = make_chamber(temperatures=(27.0,))
    (only,) = splits_of(replace(run, temperature_c=np.full(len(run), np.nan)), CASE)
    assert np.isnan(only.temperature_c)


def test_too_few_positions_give_none(make_chamber):
    run = make_chamber()
    assert splits_of(run.rows(np.flatnonzero(run.head_deg == 0.0)), CASE) == ()
