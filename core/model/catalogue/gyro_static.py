"""Effects on gyros at rest beyond g-sensitivity: the Earth, magnetic field, squares of g."""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import column, numbered, small_gain, small_unit
from core.model.effect import AXES, Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus


class MagneticSensitivity(Effect):
    """The field of the building acts on the gyro."""

    id = "magnetic_sensitivity"
    name = "Magnetic sensitivity"
    plain = "the magnetic field of the building shifts the output"
    equation = "m_s * (own axis along the shaft) + m_l * (own axis level across it)"
    kind = Kind.BLOCK
    tests = ("static_positions",)
    sensors = ("gyro",)
    seen_as = "the harmonics of g-sensitivity, but fixed to the building"
    remedy = "turn the head by 180 degrees in azimuth; shield the unit"
    confused_with = ("g_sensitivity", "earth_rate", "remount_bias")
    typical = {"gyro": 0.02}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Along the shaft and level across it, deg/s."""
        return numbered("magnetic", "m", small_unit(sensor), 2)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Direction of the own axis in the building."""
        size = np.linalg.norm(stimulus.a, axis=1)[:, None]
        up, level = stimulus.a / size, stimulus.da_dhead / size
        shaft = np.cross(up, level)
        return small_gain(sensor) * column(shaft[:, sensor.index], level[:, sensor.index])


class GSquared(Effect):
    """Anisoelastic drift (IEEE 528).

    Parameters
    ----------
    axes : the two axes whose product acts, e.g. ``"xx"``, ``"yz"``
    """

    id = "g_squared_sensitivity"
    name = "g-squared-sensitive drift"
    plain = "the square of the acceleration shifts the zero of the gyro"
    equation = "b_ij * a_i * a_j"
    kind = Kind.BLOCK
    tests = ("static_positions",)
    sensors = ("gyro",)
    seen_as = "second harmonic of the head angle"
    remedy = "measure between the quarter turns; calibrate with the products"
    confused_with = ("bias_drift",)
    typical = {"gyro": 0.01}  # noqa: RUF012

    def __init__(self, axes: str = "zz") -> None:
        self._axes = axes

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: (deg/s)/g^2."""
        return (Parameter(f"g_squared_{self._axes}", f"b_{self._axes}", "(deg/s)/g^2"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The product of two accelerations."""
        size = np.linalg.norm(stimulus.a, axis=1)
        i, j = (AXES.index(axis) for axis in self._axes)
        return column(small_gain(sensor) * stimulus.a[:, i] * stimulus.a[:, j] / size**2)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """All products of two axes."""
        return tuple(GSquared(axes) for axes in ("xx", "yy", "zz", "xy", "xz", "yz"))


class EarthRate(Effect):
    """Rate of the Earth that the stated model left out."""

    id = "earth_rate"
    name = "Earth rate"
    plain = "the gyro feels the rotation of the Earth"
    equation = "k * (W_up * up + W_north * north)"
    needs = ("mount",)
    kind = Kind.BLOCK
    tests = ("static_positions",)
    sensors = ("gyro",)
    seen_as = "exactly what g-sensitivity looks like, as long as the head keeps its azimuth"
    remedy = "compute it from the latitude; turn the head by 180 degrees in azimuth"
    confused_with = ("g_sensitivity", "magnetic_sensitivity")
    typical = {"gyro": 0.0032}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Along the plumb line, and level across the shaft, deg/s."""
        return (
            Parameter("earth_up", "W_up", "deg/s"),
            Parameter("earth_level", "W_l", "deg/s"),
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Up and level across the shaft on the case axes."""
        size = np.linalg.norm(stimulus.a, axis=1)[:, None]
        response = sensor.sensitivity
        return column(stimulus.a / size @ response, stimulus.da_dhead / size @ response)
