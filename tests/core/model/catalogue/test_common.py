"""Bias, scale factor and cross axes: columns and names for every axis."""

import numpy as np
import pytest

from core.model.catalogue.common import Bias, CrossAxis, ScaleFactor
from core.model.effect import Sensor
from core.model.stimulus import Stimulus

A = np.arange(6.0).reshape(2, 3)
W = 10.0 + A
STIMULUS = Stimulus(A, W, 0.0 * A, 0.0 * A)


def test_bias_is_a_column_of_ones():
    sensor = Sensor("gyro", "x", "V")
    assert np.array_equal(Bias().columns(STIMULUS, sensor), [[1.0], [1.0]])
    assert Bias().parameters(sensor)[0].unit == "V"


@pytest.mark.parametrize(("kind", "acts"), [("accelerometer", A), ("gyro", W)])
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_scale_factor_and_cross_axes_take_the_input_of_their_axes(
    kind: str, acts: np.ndarray, axis: int
):
    sensor = Sensor(kind, "xyz"[axis], "code")
    others = [i for i in range(3) if i != axis]
    assert np.array_equal(ScaleFactor().columns(STIMULUS, sensor)[:, 0], acts[:, axis])
    assert np.array_equal(CrossAxis().columns(STIMULUS, sensor), acts[:, others])
    names = [parameter.name for parameter in CrossAxis().parameters(sensor)]
    assert names == [f"cross_axis_{'xyz'[i]}" for i in others]


def test_cross_axes_that_nothing_excites_are_left_out():
    sensor = Sensor("gyro", "z", "code")
    assert np.array_equal(CrossAxis("y").columns(STIMULUS, sensor), W[:, [1]])
    assert [p.symbol for p in CrossAxis("y").parameters(sensor)] == ["k_zy"]
    assert CrossAxis("").columns(STIMULUS, sensor).shape == (2, 0)
