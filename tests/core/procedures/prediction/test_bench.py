"""The sensor of a bench answers in units of its input."""

import pytest

from core.allan.model import NoiseModel
from core.procedures.prediction.bench import TOOLS, Bench
from core.samples.run import Conditions


@pytest.mark.parametrize(("kind", "unit"), [("accelerometer", "m/s^2"), ("gyro", "deg/s")])
def test_the_sensor_has_a_scale_factor_of_one(kind: str, unit: str):
    bench = Bench(kind, NoiseModel(random_walk=1e-3), Conditions(g_mps2=9.81), axis="y")
    assert (bench.sensor.kind, bench.sensor.axis, bench.sensor.unit) == (kind, "y", unit)
    assert bench.tools == set(TOOLS)
