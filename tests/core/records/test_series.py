"""Channels of a record: names, units, the likely one, scale factors."""

import math

import numpy as np
import pytest

from core.errors import FormatError
from core.records.series import Series, distinct, named_channel
from core.samples.block import Channel

CVG = (Channel("GyroOut", "V", "rate.z"), Channel("Temperature", "degC", "temp"))


def series(scale_factor: float = math.nan) -> Series:
    columns = (np.array([1.0, 2.0, 4.0]), np.array([20.0, 21.0, 22.0]))
    return Series("x", "25-143", CVG, columns, 3, rate=10.0, scale_factor=scale_factor)


@pytest.mark.parametrize(
    ("title", "name", "unit", "role"),
    [
        ("Gyro Z [deg/s]", "Gyro Z", "deg/s", "rate.z"),
        ("acc_x_mps2", "acc_x", "m/s^2", "acc.x"),
        ("Temperature, °C", "Temperature", "degC", "temp"),
        ("wx (°/s)", "wx", "deg/s", "rate.x"),
        ("Quadrature", "Quadrature", "code", ""),
    ],
)
def test_the_head_of_a_column_tells_name_unit_and_role(
    title: str, name: str, unit: str, role: str
) -> None:
    assert named_channel(title) == Channel(name, unit, role)


def test_a_channel_is_found_by_name_role_and_number() -> None:
    assert [series().place(key) for key in ("Temperature", "temp", "2", "rate.z")] == [1, 1, 1, 0]
    with pytest.raises(FormatError, match="GyroOut, Temperature"):
        series().place("GyroIn")


def test_the_scale_factor_of_the_file_makes_deg_per_second_of_the_gyro_only() -> None:
    taken = series(0.5).sampled(0)
    assert (taken.unit, taken.scale_factor) == ("deg/s", 0.5)
    np.testing.assert_array_equal(taken.values, [2.0, 4.0, 8.0])
    assert series(0.5).sampled(1).unit == "degC"
    assert series(1.0).sampled(0).unit == "V"
    np.testing.assert_array_equal(series(0.5).sampled(0, scale_factor=2.0).values, [0.5, 1.0, 2.0])


def test_equal_names_are_numbered() -> None:
    assert [c.name for c in distinct((CVG[0], CVG[0]))] == ["GyroOut", "GyroOut 2"]
