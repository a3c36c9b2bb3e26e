"""What a sensor says about itself."""

import numpy as np
import pytest

from core.model.effect import Sensor
from core.model.stimulus import Stimulus


@pytest.mark.parametrize(
    ("axis", "index", "cross"), [("x", 0, ("y", "z")), ("y", 1, ("x", "z")), ("z", 2, ("x", "y"))]
)
def test_axes_of_a_sensor(axis: str, index: int, cross: tuple[str, str]):
    sensor = Sensor("gyro", axis, "code")
    assert (sensor.index, sensor.cross_axes) == (index, cross)


def test_input_of_a_sensor():
    force, rate = np.ones((2, 3)), 2.0 * np.ones((2, 3))
    stimulus = Stimulus(force, rate, force, rate)
    accelerometer, gyro = Sensor("accelerometer", "x", "V"), Sensor("gyro", "x", "V")
    assert accelerometer.input(stimulus) is force
    assert gyro.input(stimulus) is rate
    assert (accelerometer.input_unit, gyro.input_unit) == ("m/s^2", "deg/s")
