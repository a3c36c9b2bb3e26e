"""Bias and scale factor over temperature, told apart; what is refused; coverage."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError, RankDeficient
from core.procedures.dividing_head import calibrate
from core.procedures.thermal.cycle import calibrate_thermal
from core.samples.run import Conditions

CASE = Conditions(g_mps2=9.8106)


def test_every_coefficient_comes_back(make_chamber):
    result = calibrate_thermal(make_chamber(1e-7), CASE, reference_c=27.0)
    x, y, z = result.channels
    assert [(one.bias_order, one.scale_order) for one in (x, y, z)] == [(2, 1), (1, 1), (0, 1)]
    assert x.fit.value("bias_t1") == pytest.approx(0.8, abs=1e-8)
    assert x.fit.value("bias_t2") == pytest.approx(0.004, abs=1e-9)
    assert x.fit.value("scale_factor_t1") == pytest.approx(0.16, abs=1e-9)
    assert y.fit.value("scale_factor") == pytest.approx(810.0, abs=1e-7)
    assert z.fit.value("cross_axis_x") == pytest.approx(-6.0, abs=1e-7)


def test_the_scale_factor_does_not_leak_into_the_bias(make_chamber):
    """One sense of the axis, as in the source, gives the sum of the two instead."""
    run = make_chamber(1e-7, bias=np.array([[40.0, 0, 0], [-25.0, 0, 0], [10.0, 0, 0]]))
    fit = calibrate_thermal(run, CASE, bias_order=1, scale_order=1).channels[2].fit
    assert fit.value("bias_t1") == pytest.approx(0.0, abs=1e-8)
    up = run.rows(np.flatnonzero(run.head_deg == 0.0))
    slope = np.polyfit(up.temperature_c, up.y[:, 2], 1)[0]
    assert slope == pytest.approx(0.05 * 9.8106, rel=1e-6)
    with pytest.raises(RankDeficient, match="felt the same in all rows"):
        calibrate_thermal(up, CASE, bias_order=1, scale_order=1)


def test_at_one_temperature_it_is_the_ordinary_calibration(make_chamber):
    run = make_chamber(1e-7)
    hot = run.rows(range(48, 56))
    alone = calibrate(hot, CASE).triad()
    temperature = float(hot.temperature_c.mean())
    triad = calibrate_thermal(run, CASE).triad_at(temperature)
    assert triad.k == pytest.approx(alone.k, abs=0.1)
    assert triad.bias == pytest.approx(alone.bias, abs=0.5)
    assert np.all(np.isfinite(triad.covariance))
    assert np.all(np.linalg.eigvalsh(triad.covariance) > -1e-12)


def test_beyond_the_measured_temperatures_it_is_refused(make_chamber):
    result = calibrate_thermal(make_chamber(), CASE)
    with pytest.raises(FitError, match=r"90\.0 \.\.\. 90\.0 degC leaves the measured -40\.\d"):
        result.triad_at(90.0)
    assert np.isfinite(result.triad_at(90.0, extrapolate=True).k).all()
    # Another visit to the hottest temperature, some tenths of a degree above the first.
    assert np.isfinite(result.triad_at(result.high_c + 0.9).k).all()
    with pytest.raises(FitError, match="leaves the measured"):
        result.triad_at(result.high_c + 1.1)


def test_few_temperatures(make_chamber):
    with pytest.raises(FitError, match="all rows were measured at 27"):
        calibrate_thermal(make_chamber(temperatures=(27.0,)), CASE)
    two = calibrate_thermal(make_chamber(temperatures=(27.0, 60.0)), CASE)
    assert two.channels[0].bias_order == 1
    assert two.channels[0].scores == ()
    assert "two_temperatures" in [note.subject for note in two.notes]
    three = calibrate_thermal(make_chamber(temperatures=(27.0, -20.0, 60.0)), CASE)
    assert three.channels[0].bias_order == 1
    with pytest.raises(FitError, match=r"order 3 needs 4 temperatures \(5 to test it\)"):
        calibrate_thermal(make_chamber(temperatures=(27.0, -20.0, 60.0)), CASE, bias_order=3)


def test_a_missing_temperature_or_axis_is_refused(make_chamber):
    run = make_chamber()
    gap = run.temperature_c.copy()
    gap[4] = np.nan
    with pytest.raises(FitError, match="row 5: the temperature is missing"):
        calibrate_thermal(replace(run, temperature_c=gap), CASE)
    with pytest.raises(FitError, match="state the case axis"):
        calibrate_thermal(replace(run, axes=("", "y", "z")), CASE)


@pytest.mark.slow
def test_intervals_hold_the_truth(make_chamber):
    truth = {
        "bias": 40.0,
        "bias_t1": 0.8,
        "bias_t2": 0.004,
        "scale_factor": 800.0,
        "scale_factor_t1": 0.16,
        "cross_axis_y": 5.0,
        "cross_axis_z": -3.0,
    }
    trials, hits = 300, dict.fromkeys(truth, 0)
    for seed in range(trials):
        run = make_chamber(2.0, seed=seed)
        only_x = replace(run, channels=("X",), axes=("x",), y=run.y[:, :1], y_se=run.y_se[:, :1])
        fit = (
            calibrate_thermal(only_x, CASE, bias_order=2, scale_order=1, reference_c=27.0)
            .channels[0]
            .fit
        )
        half = fit.expanded()
        for name, value in truth.items():
            hits[name] += abs(fit.value(name) - value) < half[fit.index(name)]
    shares = np.array(list(hits.values())) / trials
    assert 0.93 < shares.mean() < 0.97
    assert shares.min() > 0.91
