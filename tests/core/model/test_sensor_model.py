"""A model is the sum of its effects, in the order of its parameters."""

import numpy as np

from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus

RNG = np.random.default_rng(8)
A, W, NONE = RNG.normal(size=(6, 3)), RNG.normal(size=(6, 3)), np.zeros((6, 3))
STIMULUS = Stimulus(A, W, NONE, NONE)


def full() -> SensorModel:
    effects = ("bias", "scale_factor", "cross_axis", "g_sensitivity")
    return SensorModel(Sensor("gyro", "y", "V"), tuple(CATALOGUE[name] for name in effects))


def test_the_model_3_3_written_out():
    bias, k, k_x, k_z, b_x, b_y, b_z = values = np.array([0.3, -2.0, 0.01, 0.02, 4.0, 5.0, 6.0])
    by_hand = [
        bias + k * w[1] + k_x * w[0] + k_z * w[2] + b_x * a[0] + b_y * a[1] + b_z * a[2]
        for a, w in zip(STIMULUS.a, STIMULUS.w, strict=True)
    ]
    assert np.allclose(full().predict(STIMULUS, values), by_hand)
    assert full().design(STIMULUS).shape == (6, 7)


def test_parameters_follow_the_columns():
    symbols = [parameter.symbol for parameter in full().parameters]
    assert symbols == ["U0", "k_y", "k_yx", "k_yz", "b_yx", "b_yy", "b_yz"]
    units = {parameter.unit for parameter in full().parameters}
    assert units == {"V", "V/(deg/s)", "V/(m/s^2)"}


def test_each_effect_has_its_places_among_the_parameters():
    effects = tuple(CATALOGUE[name] for name in ("bias", "scale_factor", "cross_axis"))
    model = SensorModel(Sensor("accelerometer", "y", "code"), effects)
    assert model.places == (slice(0, 1), slice(1, 2), slice(2, 4))
    for effect, place in zip(model.effects, model.places, strict=True):
        assert model.parameters[place] == effect.parameters(model.sensor)
    assert SensorModel(model.sensor, ()).places == ()


def test_one_more_effect():
    small = SensorModel(Sensor("gyro", "y", "V"), (CATALOGUE["bias"],))
    larger = small.with_effect(CATALOGUE["scale_factor"])
    assert [p.symbol for p in larger.parameters] == ["U0", "k_y"]
    assert [p.symbol for p in small.parameters] == ["U0"]
