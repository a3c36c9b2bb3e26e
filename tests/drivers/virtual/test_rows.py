"""Rows walked on the bench with a model that was found."""

from dataclasses import replace

import numpy as np
import pytest

from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Sensor
from core.model.sensor_model import SensorModel
from core.samples.run import Conditions, Run
from drivers.virtual.rows import Found, walk_rows
from tests.core.procedures.bent_triad import K2_X, U0, K, bent_run, forces, outputs
from tests.core.procedures.test_added import table_run

LINEAR = ("bias", "scale_factor", "cross_axis")


def triad(run: Run, **changes: object) -> Found:
    models = []
    for i, axis in enumerate("xyz"):
        others = [K[i, j] for j in range(3) if j != i]
        sensor = Sensor("accelerometer", axis, "code", tuple(K[i]))
        effects = tuple(CATALOGUE[name] for name in LINEAR)
        values = [U0[i], K[i, i], *others]
        if axis == "x":
            effects = (*effects, CATALOGUE["second_order_nonlinearity"])
            values.append(K2_X)
        models.append((SensorModel(sensor, effects), np.array(values)))
    n = len(run)
    nothing = np.zeros(3)
    found = Found(models, nothing, nothing, np.zeros(n), np.zeros(n))
    return replace(found, **changes)


def test_without_noise_the_means_are_those_of_the_model():
    run = replace(bent_run(), unit="mV").rows(range(0, 48, 5))
    means = walk_rows(run, triad(run), 1)
    # The product of the axes is not in this model; it vanishes at the quarter turns.
    there = np.isin(run.head_deg, (0.0, 90.0, 180.0, 270.0))
    wanted = outputs_of(run)
    np.testing.assert_allclose(means[there], wanted[there], atol=2e-3)
    np.testing.assert_allclose(means[:, 1:], wanted[:, 1:], atol=2e-3)


def outputs_of(run: Run) -> np.ndarray:
    return outputs(forces(list(run.mount), run.head_deg))


def test_the_noise_of_the_means_is_what_was_asked_for():
    run = replace(bent_run(), unit="mV").rows([4] * 60)
    run = replace(run, t_s=20.0 * np.arange(60), conditions=Conditions(accumulation_s=2.0))
    still = walk_rows(run, triad(run), 1)
    noisy = walk_rows(run, triad(run, white=np.array([0.5, 1.0, 0.0])), 1)
    assert np.std((noisy - still)[:, :2], axis=0) == pytest.approx([0.5, 1.0], rel=0.25)
    assert np.abs((noisy - still)[:, 2]).max() < 1e-6


def test_codes_are_rounded_and_settings_scatter_alike_in_all_outputs():
    run = bent_run().rows(range(16))
    still = walk_rows(run, triad(run), 1)
    assert np.allclose(still, np.rint(still))
    setting = np.full(16, 1e-4)
    moved = walk_rows(replace(run, unit="mV"), triad(run, setting=setting), 1)
    change = moved - walk_rows(replace(run, unit="mV"), triad(run), 1)
    assert 0.02 < np.std(change[:, 1]) < 3.0
    again = walk_rows(replace(run, unit="mV"), triad(run, setting=setting), 1)
    np.testing.assert_array_equal(moved, again)


def test_what_goes_with_time_sees_the_times_of_the_rows():
    run = replace(bent_run(), unit="mV").rows(range(8))
    run = replace(run, t_s=600.0 + 90.0 * np.arange(8), conditions=Conditions(accumulation_s=4.0))
    found = triad(run)
    model, values = found.models[2]
    drifting = model.with_effect(CATALOGUE["bias_drift"])
    models = [*found.models[:2], (drifting, np.array([*values, 100.0]))]
    change = walk_rows(run, replace(found, models=models), 1) - walk_rows(run, found, 1)
    slope = np.polyfit(run.t_s - run.t_s[0], change[:, 2], 1)[0]
    per_hour = 100.0 * K[2, 2] * 9.80665e-3
    assert slope * 3600.0 == pytest.approx(per_hour, rel=1e-3)


def test_a_table_run_turns_the_unit_both_ways():
    run = replace(table_run(0.0), unit="mV")
    model = SensorModel(
        Sensor("gyro", "z", "mV", (0.0, 0.0, -79.4)), (CATALOGUE["bias"], CATALOGUE["scale_factor"])
    )
    n = len(run)
    found = Found(
        [(model, np.array([-438.0, -79.4]))], np.zeros(1), np.zeros(1), np.zeros(n), np.zeros(n)
    )
    means = walk_rows(run, found, 1)
    np.testing.assert_allclose(means[:, 0], -438.0 - 79.4 * run.set_rate_dps, atol=0.05)
