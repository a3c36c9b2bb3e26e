"""The simulated cycle brings its own numbers back."""

import pytest

from core.plans.plan import load_plans
from core.procedures.thermal.cycle import calibrate_thermal
from core.procedures.thermal.simulated import BIAS, REFERENCE_C, SCALE, simulated_cycle


def test_its_truth_comes_back():
    run = simulated_cycle(load_plans()["thermal_8"], 3, lag=0.0)
    found = calibrate_thermal(run, run.conditions, reference_c=REFERENCE_C)
    for place, channel in enumerate(found.channels):
        fit = channel.fit
        for name, true in (("bias", BIAS[place, 0]), ("scale_factor_t1", SCALE[place, 1])):
            u = fit.stderr[fit.index(name)]
            assert fit.value(name) == pytest.approx(true, abs=4.0 * u)


def test_its_hysteresis_is_seen():
    run = simulated_cycle(load_plans()["thermal_8"], 3, lag=6.0)
    x, y, _ = calibrate_thermal(run, run.conditions).channels
    assert x.largest_hysteresis == pytest.approx(6.0, abs=2.0)
    assert y.largest_hysteresis < 2.0
