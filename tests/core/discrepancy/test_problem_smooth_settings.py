"""What is compared: plain models, untested effects, bad input; smoothed regressors."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.problem import Problem
from core.discrepancy.settings import Settings
from core.discrepancy.smooth import smoothed
from core.errors import FitError, RankDeficient
from tests.core.discrepancy.hidden import K, head_run, table_run


def test_the_response_of_the_sensor_is_known_to_the_effects_of_the_rig():
    (model,) = Problem.of(head_run(noise=0.0)).models
    assert model.sensor.sensitivity * 9.81 / K == pytest.approx([0.012, -0.008, 1.0], abs=1e-6)


def test_one_wild_row_does_not_bend_the_response():
    run = head_run()
    y = run.y.copy()
    y[7] += 0.5
    (model,) = Problem.of(replace(run, y=y)).models
    assert model.sensor.sensitivity[2] == pytest.approx(K / 9.81, rel=2e-3)


def test_a_missing_column_keeps_effects_from_being_tested_and_is_named():
    run = head_run()
    problem = Problem.of(replace(run, temperature_c=np.full(len(run), np.nan)))
    assert problem.untested["bias_temperature"] == "temperature_c"
    assert "bias_temperature" not in {effect.id for effect in problem.effects}


def test_effects_belong_to_their_test():
    head = {effect.id for effect in Problem.of(head_run()).effects}
    table = {effect.id for effect in Problem.of(table_run()).effects}
    assert {"head_eccentricity", "cross_coupling"} <= head - table
    assert {"table_slip", "dead_band"} <= table - head


def test_an_output_that_is_no_number_is_named():
    run = head_run()
    y = run.y.copy()
    y[4] = np.nan
    with pytest.raises(FitError, match="row 5"):
        Problem.of(replace(run, y=y))


def test_an_input_that_never_changes_determines_nothing():
    run = head_run(rows=[(1, "X_from", 90.0)] * 6)
    with pytest.raises(RankDeficient, match="does not change"):
        Problem.of(run)


def test_a_reading_that_was_stored_twice_is_seen_only_at_another_setting():
    run = head_run()
    y = run.y.copy()
    y[9] = y[8]
    assert np.flatnonzero(Problem.of(replace(run, y=y)).stimulus.column("repeated")) == [9]
    head = run.head_deg.copy()
    head[9] = head[8]
    again = Problem.of(replace(run, y=y, head_deg=head))
    assert not again.stimulus.column("repeated").any()


def test_rounding_is_smoothed_away_and_a_step_is_not():
    t = np.linspace(0.0, 1.0, 100)
    true = 0.6 * (1.0 - np.exp(-3.0 * t))
    rounded = np.round(true / 0.02) * 0.02
    assert np.std(smoothed(rounded) - true) < 0.5 * np.std(rounded - true)
    step = np.where(t > 0.5, 10.0, 0.0)
    away = np.abs(t - 0.5) > 0.05
    assert np.max(np.abs(smoothed(step) - step)[away]) < 0.5


def test_few_or_constant_values_stay_as_they_are():
    assert np.array_equal(smoothed(np.arange(5.0)), np.arange(5.0))
    assert np.array_equal(smoothed(np.ones(30)), np.ones(30))


def test_a_false_alarm_in_a_hundred_is_the_default():
    assert Settings().alpha == 0.01
