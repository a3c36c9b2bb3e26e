"""Inputs by a calibration with effects, against forces that were set."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.nonlinear import CrossCoupling
from core.procedures.added import Added
from core.procedures.compensation import (
    added_output,
    compensated,
    has_effects,
    needs_temperature,
)
from core.procedures.dividing_head import calibrate
from core.procedures.physical import physical_of
from core.samples.block import Channel
from tests.core.procedures.bent_triad import STATED, bent_run, outputs
from tests.core.procedures.test_added import FOUND

A = np.array([[1.0, -2.0, 9.0], [-9.0, 3.0, 1.0], [5.0, 6.0, -5.0], [0.0, 0.0, 9.81]])


def test_forces_come_back():
    bent = calibrate(bent_run(noise=1e-6), STATED, added=FOUND)
    assert has_effects(bent)
    np.testing.assert_allclose(compensated(bent, outputs(A)), A, atol=1e-5)
    plain = bent.triad().calibrated(outputs(A))
    assert np.abs(plain - A).max() > 0.02


def test_without_effects_it_is_the_linear_map():
    plain = calibrate(bent_run(), STATED)
    assert not has_effects(plain)
    u = outputs(A)
    np.testing.assert_allclose(compensated(plain, u), plain.triad().calibrated(u), rtol=1e-12)


def test_sensors_in_another_order_and_alone():
    run = bent_run(noise=1e-6)
    turned = replace(
        run,
        y=run.y[:, [2, 0, 1]],
        y_se=run.y_se[:, [2, 0, 1]],
        channels=("acc_z", "acc_x", "acc_y"),
        axes=("z", "x", "y"),
    )
    found = calibrate(turned, STATED, added=FOUND)
    np.testing.assert_allclose(
        compensated(found, outputs(A)[:, [2, 0, 1]]), A[:, [2, 0, 1]], atol=1e-5
    )
    alone = replace(run, y=run.y[:, :1], y_se=run.y_se[:, :1], channels=("acc_x",), axes=("x",))
    one = calibrate(alone, STATED, added=Added((("", CATALOGUE["second_order_nonlinearity"]),)))
    along = np.array([[7.0, 0.0, 0.0]])
    assert abs(compensated(one, outputs(along)[:, :1])[0, 0] - 7.0) < 1e-2


def test_effects_of_temperature_ask_for_it():
    run = replace(bent_run(noise=1e-6), temperature_c=np.linspace(20.0, 34.0, 48))
    per_c = 3.0 * (run.temperature_c - run.temperature_c.mean())
    y = run.y.copy()
    y[:, 2] += per_c
    added = Added((*FOUND.effects, ("acc_z", CATALOGUE["bias_temperature"])))
    found = calibrate(replace(run, y=y), STATED, added=added)
    assert needs_temperature(found)
    with pytest.raises(FitError, match="state the temperature"):
        compensated(found, outputs(A))
    u = outputs(A)
    u[:, 2] += 3.0 * (30.0 - run.temperature_c.mean())
    np.testing.assert_allclose(compensated(found, u, np.full(4, 30.0)), A, atol=1e-4)
    extra = added_output(found, np.zeros((1, 3)), np.array([30.0]))
    assert extra[0, 2] == pytest.approx(3.0 * (30.0 - run.temperature_c.mean()), rel=1e-4)


def test_faults_of_the_test_are_not_taken_out():
    added = Added((("", CrossCoupling("xy")), ("acc_x", CATALOGUE["head_eccentricity"])))
    found = calibrate(bent_run(), STATED, added=added)
    assert [one.in_use for one in found.effects[0]] == [True, False]
    assert np.isfinite(compensated(found, outputs(A))).all()


def test_the_live_values_have_them_taken_out():
    bent = calibrate(bent_run(noise=1e-6), STATED, added=FOUND)
    channels = tuple(Channel(f"a{axis}", "code", f"acc.{axis}") for axis in "xyz")
    physical = physical_of(bent, channels)
    assert physical is not None
    np.testing.assert_allclose(physical.of(outputs(A)), A, atol=1e-5)
