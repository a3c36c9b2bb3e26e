"""g-sensitivity of (3.3)."""

import numpy as np

from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.effect import Sensor
from core.model.stimulus import Stimulus

A = np.arange(6.0).reshape(2, 3)
STIMULUS = Stimulus(A, 0.0 * A, 0.0 * A, 0.0 * A)
SENSOR = Sensor("gyro", "z", "code")


def test_three_responses_to_the_specific_force():
    effect = AccelerationSensitiveDrift()
    assert np.array_equal(effect.columns(STIMULUS, SENSOR), A)
    assert [p.symbol for p in effect.parameters(SENSOR)] == ["b_zx", "b_zy", "b_zz"]
    assert {p.unit for p in effect.parameters(SENSOR)} == {"code/(m/s^2)"}


def test_axes_that_no_position_excites_are_left_out():
    effect = AccelerationSensitiveDrift("zy")
    assert np.array_equal(effect.columns(STIMULUS, SENSOR), A[:, [1, 2]])
    assert [p.symbol for p in effect.parameters(SENSOR)] == ["b_zy", "b_zz"]
