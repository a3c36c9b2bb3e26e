"""Predictions against the practicum's formulas, against fits, and against simulated sessions."""

from dataclasses import replace

import numpy as np
import pytest

from core.allan.model import NoiseModel
from core.errors import FitError
from core.plans.plan import load_plans
from core.procedures.dividing_head import calibrate
from core.procedures.fourier.readings import run_of_angles
from core.procedures.fourier.tumble import calibrate_tumble
from core.procedures.gyrocompass import find_north, run_of_headings
from core.procedures.prediction.bench import Bench
from core.procedures.prediction.design import Prediction, run_of_plan, stimulus_of_plan
from core.procedures.prediction.propose import predict
from core.procedures.thermal.cycle import calibrate_thermal
from core.samples.run import Conditions

G = 9.8106
PLANS = load_plans()
WHITE = NoiseModel(random_walk=3e-3)
EXACT = Conditions(g_mps2=G)
LAB = Conditions(g_mps2=G, u_g_mps2=1e-4, head_u_arcsec=15.0)


def u_of(found: Prediction, *names: str) -> list[float]:
    return [found.u(name) for name in names]


def test_eight_positions_by_the_formulas_of_the_practicum():
    """U0: s/sqrt 8; axes that lie level in half of them: s/(g sqrt 2); the doubled axis: s/(2g)."""
    s = 3e-3 / np.sqrt(10.0)
    found = predict("positions", PLANS["accelerometer_8"], Bench("accelerometer", WHITE, EXACT))
    expected = [
        s / np.sqrt(8.0),
        1e6 * s / (2.0 * G),
        1e3 * s / (G * np.sqrt(2.0)),
        1e3 * s / (G * np.sqrt(2.0)),
    ]
    names = ("bias", "scale_factor", "cross_axis_x", "cross_axis_y")
    assert u_of(found, *names) == pytest.approx(expected)
    assert (found.rows, found.dof, found.free) == (8, 4, ())
    assert found.parameters[0].limited_by == "white noise"
    assert found.minutes == pytest.approx(8 * (10.0 + 3.0 + 15.0) / 60.0)


def test_four_positions_leave_a_cross_axis_free():
    found = predict("positions", PLANS["accelerometer_4"], Bench("accelerometer", WHITE, EXACT))
    assert found.free == ("cross_axis_x",)
    assert np.isnan(found.u("cross_axis_x"))


def test_head_and_gravity_come_in_as_in_the_fit():
    plan, bench = PLANS["pointer_16"], Bench("accelerometer", WHITE, LAB)
    found = predict("positions", plan, bench)
    stimulus = stimulus_of_plan(plan, bench)
    run = run_of_plan(plan, bench)
    s = 3e-3 / np.sqrt(10.0)
    measured = replace(run, y=stimulus.a[:, [2]], y_se=np.full((16, 1), s))
    fit = calibrate(measured, LAB).fits[0]
    names = ("bias", "scale_factor", "cross_axis_x", "cross_axis_y")
    expected = np.array([fit.u(name) for name in names]) * [1.0, 1e6, 1e3, 1e3]
    assert u_of(found, *names) == pytest.approx(expected, rel=1e-4)
    parameter = found.parameters[1]
    shares = (parameter.noise, parameter.memory, parameter.setting, parameter.gravity)
    assert sum(shares) == pytest.approx(1.0)
    assert parameter.gravity > 0.01
    quiet = Bench("accelerometer", NoiseModel(random_walk=1e-6), LAB)
    cross = predict("positions", plan, quiet).parameters[2]
    assert cross.limited_by == "settings"


def test_a_tumble_is_predicted_as_it_is_fitted():
    head = np.arange(5.0, 401.0, 5.0)
    s = 3e-3 / np.sqrt(5.0)
    u = G * np.sin(np.radians(head))
    run = run_of_angles(head, u, "m/s^2", u_se=np.full(80, s))
    fitted = calibrate_tumble(run, LAB)
    found = predict("tumble", PLANS["fourier_400"], Bench("accelerometer", WHITE, LAB, axis="x"))
    second = fitted.harmonics[1]
    expected = [
        fitted.bias.u,
        1e6 * fitted.sensitivity.u,
        fitted.misalignment.u,
        second.sine.u,
        second.cosine.u,
    ]
    names = ("bias", "scale_factor", "misalignment", "second_sine", "second_cosine")
    assert u_of(found, *names) == pytest.approx(expected, rel=1e-3)


def test_a_temperature_cycle_is_predicted_as_it_is_fitted():
    plan, bench = PLANS["thermal_8"], Bench("accelerometer", WHITE, EXACT)
    run = run_of_plan(plan, bench)
    stimulus = stimulus_of_plan(plan, bench)
    s = 3e-3 / np.sqrt(10.0)
    measured = replace(run, y=stimulus.a[:, [2]], y_se=np.full((72, 1), s))
    fit = calibrate_thermal(measured, EXACT, bias_order=2, scale_order=1).channels[0].fit
    found = predict("thermal", plan, bench)
    assert found.u("bias_t1") == pytest.approx(fit.u("bias_t1"), rel=1e-6)
    assert found.u("scale_factor_t1") == pytest.approx(1e6 * fit.u("scale_factor_t1"), rel=1e-6)
    units = {one.name: one.unit for one in found.parameters}
    assert units["scale_factor_t1"] == "ppm/degC"
    assert units["bias_t2"] == "m/s^2/degC^2"


def test_rates_settings_dominate_on_a_worn_table():
    worn = Conditions(g_mps2=G, rate_u_dps=0.02)
    bench = Bench("gyro", NoiseModel(random_walk=1e-3), worn)
    found = predict("rate_table", PLANS["rate_table_100"], bench)
    rates = np.arange(-100.0, 101.0, 20.0)
    by_hand = 1e6 * np.hypot(0.02, 1e-3 / np.sqrt(30.0)) / np.sqrt(np.sum(rates**2))
    assert found.u("scale_factor") == pytest.approx(by_hand, rel=1e-6)
    assert found.parameters[1].limited_by == "settings"
    assert found.free == ("cross_axis_x", "cross_axis_y")


def test_a_gyrocompass_is_predicted_as_it_is_fitted():
    noise = NoiseModel(random_walk=2e-5)
    kyiv = Conditions(latitude_deg=50.45)
    plan = PLANS["gyrocompass_4"]
    found = predict("gyrocompass", plan, Bench("gyro", noise, kyiv))
    headings = np.array([step.head_deg for step in plan.steps])
    level = 15.041067 * np.cos(np.radians(50.45))
    se = np.full(5, 2e-5 / np.sqrt(10.0)) * 3600.0
    run = run_of_headings(headings, level * np.cos(np.radians(headings)), "deg/h", se=se)
    fitted = find_north(run, kyiv)
    assert found.u("heading") == pytest.approx(fitted.heading.u, rel=0.02)
    assert found.u("drift") == pytest.approx(fitted.drift.u, rel=1e-6)


def test_memory_is_counted():
    memory = NoiseModel(random_walk=3e-3, bias_instability=3e-3, rate_random_walk=3e-5)
    plan = PLANS["accelerometer_8"]
    white = predict("positions", plan, Bench("accelerometer", WHITE, EXACT))
    both = predict("positions", plan, Bench("accelerometer", memory, EXACT))
    assert all(both.u(one.name) > one.u for one in white.parameters)
    assert both.parameters[1].limited_by == "noise with memory"


def test_what_is_not_known_is_asked_for():
    with pytest.raises(FitError, match="state the white noise"):
        predict("positions", PLANS["pointer_8"], Bench("accelerometer", NoiseModel(), EXACT))
    with pytest.raises(FitError, match="gravity"):
        predict("positions", PLANS["pointer_8"], Bench("accelerometer", WHITE, Conditions()))


@pytest.mark.slow
def test_predictions_hold_for_simulated_sessions():
    """White noise and a random walk through the whole session, made step by step."""
    rng = np.random.default_rng(14)
    noise = NoiseModel(random_walk=3e-3, rate_random_walk=2e-4)
    plan = PLANS["accelerometer_8"]
    bench = Bench("accelerometer", noise, EXACT, pause_s=7.0)
    found = predict("positions", plan, bench)
    stimulus = stimulus_of_plan(plan, bench)
    dt, trials = 0.1, 2000
    walk = np.cumsum(2e-4 * np.sqrt(dt) * rng.standard_normal((trials, 1600)), axis=1)
    output = walk + 3e-3 / np.sqrt(dt) * rng.standard_normal((trials, 1600))
    starts = [round((20.0 * k + 10.0) / dt) for k in range(8)]
    means = np.column_stack([output[:, a : a + 100].mean(axis=1) for a in starts])
    design = np.column_stack([np.ones(8), stimulus.a[:, [2, 0, 1]]])
    values = means @ np.linalg.pinv(design).T
    values[:, 0] -= walk[:, starts[0] : starts[-1] + 100].mean(axis=1)
    names = ("bias", "scale_factor", "cross_axis_x", "cross_axis_y")
    expected = np.array(u_of(found, *names)) / [1.0, 1e6, 1e3, 1e3]
    assert values.std(axis=0) == pytest.approx(expected, rel=0.06)
