"""Nonlinearity of the sensors: powers, products, asymmetry, saturation, dead band."""

import itertools

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import (
    ALL,
    HEAD,
    TABLE,
    column,
    gain,
    levels,
    own,
    scaled,
    small_gain,
    small_unit,
)
from core.model.catalogue.terms import sign as sign_of
from core.model.effect import AXES, Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus

_PAIRS = ((0, 1), (0, 2), (1, 2))


class SecondOrder(Effect):
    """K2 of IEEE 1293; of gyros the even scale-factor error, and what centrifugal force does."""

    id = "second_order_nonlinearity"
    name = "Second-order nonlinearity K2"
    plain = "the output bends the same way at both ends of the range"
    equation = "k * K2 * x^2"
    kind = Kind.BLOCK
    tests = ALL
    seen_as = "a parabola against the input; second harmonic of the head angle"
    remedy = "calibrate with the square term; on a rate table also try another radius"
    confused_with = ("scale_factor_asymmetry", "head_eccentricity", "cross_axis_nonlinearity")
    typical = {"accelerometer": 0.5, "gyro": 4e-6}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg/g^2, or (deg/s)/(deg/s)^2."""
        return (Parameter("second_order", "K2", small_unit(sensor, 2)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The square of the input."""
        return column(small_gain(sensor) * own(stimulus, sensor) ** 2)


class ThirdOrder(Effect):
    """K3 of IEEE 1293."""

    id = "third_order_nonlinearity"
    name = "Third-order nonlinearity K3"
    plain = "the output bends in opposite ways at the two ends of the range"
    equation = "k * K3 * x^3"
    kind = Kind.BLOCK
    tests = ALL
    seen_as = "an S against the input; third harmonic of the head angle"
    remedy = "calibrate with the cubic term"
    confused_with = ("head_ellipticity", "odd_quadratic_nonlinearity", "saturation", "table_slip")
    typical = {"accelerometer": 0.3, "gyro": 1e-7}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg/g^3, or (deg/s)/(deg/s)^3."""
        return (Parameter("third_order", "K3", small_unit(sensor, 3)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The cube of the input."""
        return column(small_gain(sensor) * own(stimulus, sensor) ** 3)


class OddQuadratic(Effect):
    """Kodd of IEEE 1293."""

    id = "odd_quadratic_nonlinearity"
    name = "Odd quadratic nonlinearity"
    plain = "the sensitivity grows with the size of the input, alike to both sides"
    equation = "k * Ko * x * |x|"
    kind = Kind.BLOCK
    tests = HEAD
    sensors = ("accelerometer",)
    seen_as = "an S against the input that is steeper in the middle than a cube"
    remedy = "calibrate with the term x|x|; more than 1 g tells it from the cube"
    confused_with = ("third_order_nonlinearity", "head_ellipticity")
    typical = {"accelerometer": 0.3}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg/g^2."""
        return (Parameter("odd_quadratic", "Ko", small_unit(sensor, 2)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The input times its size."""
        x = own(stimulus, sensor)
        return column(small_gain(sensor) * x * np.abs(x))


class CrossAxisSquare(Effect):
    """Koo, Kpp of IEEE 1293.

    Parameters
    ----------
    axis : cross axis whose square acts; empty for both
    """

    id = "cross_axis_nonlinearity"
    name = "Cross-axis nonlinearity Koo, Kpp"
    plain = "the square of the acceleration across the input axis shifts the output"
    equation = "k * (Kxx * a_x^2 + Kyy * a_y^2)"
    kind = Kind.BLOCK
    tests = HEAD
    sensors = ("accelerometer",)
    # The cross axis of one sensor of a unit is the own axis of another.
    alone = True
    seen_as = "the bias depends on which cross axis is vertical"
    remedy = "calibrate with the square of the cross axis; mount another axis along the shaft"
    confused_with = ("second_order_nonlinearity", "head_eccentricity")
    typical = {"accelerometer": 0.3}  # noqa: RUF012

    def __init__(self, axis: str = "") -> None:
        self._axis = axis

    def _acting(self, sensor: Sensor) -> tuple[str, ...]:
        return (self._axis,) if self._axis else sensor.cross_axes

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One a cross axis: mg/g^2."""
        return tuple(
            Parameter(f"cross_square_{axis}", f"K{axis}{axis}", small_unit(sensor, 2))
            for axis in self._acting(sensor)
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The squares of the cross inputs."""
        a = scaled(stimulus, sensor)
        return small_gain(sensor) * column(
            *(a[:, AXES.index(axis)] ** 2 for axis in self._acting(sensor))
        )

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Each axis alone; both together are the square of the own axis, for a^2 is constant."""
        return tuple(CrossAxisSquare(axis) for axis in sensor.cross_axes)


class CrossCoupling(Effect):
    """Kio, Kip, Kpo of IEEE 1293; the vibropendulous term of the tumble.

    Parameters
    ----------
    axes : the two axes whose product acts, e.g. ``"xz"``; empty for all three products
    """

    id = "cross_coupling"
    name = "Cross-coupling Kio, Kip, Kpo"
    plain = "the product of the accelerations along two axes shifts the output"
    equation = "k * (kxy * a_x a_y + kxz * a_x a_z + kyz * a_y a_z)"
    kind = Kind.BLOCK
    tests = HEAD
    sensors = ("accelerometer",)
    seen_as = "second harmonic of the head angle, largest between the quarter turns"
    remedy = "calibrate with the product term; quarter turns alone never show it"
    confused_with = ("head_eccentricity",)
    typical = {"accelerometer": 0.5}  # noqa: RUF012

    def __init__(self, axes: str = "") -> None:
        self._axes = axes

    def _acting(self) -> list[tuple[int, int]]:
        return [(i, j) for i, j in _PAIRS if self._axes in ("", AXES[i] + AXES[j])]

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One a product: mg/g^2."""
        names = [AXES[i] + AXES[j] for i, j in self._acting()]
        unit = small_unit(sensor, 2)
        return tuple(Parameter(f"product_{name}", f"k{name}", unit) for name in names)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The products of the inputs."""
        a = scaled(stimulus, sensor)
        return small_gain(sensor) * column(*(a[:, i] * a[:, j] for i, j in self._acting()))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Each product alone."""
        return tuple(CrossCoupling(AXES[i] + AXES[j]) for i, j in _PAIRS)


class ScaleFactorAsymmetry(Effect):
    """K1' of IEEE 1293, scale-factor asymmetry of IEEE 528."""

    id = "scale_factor_asymmetry"
    name = "Scale-factor asymmetry"
    plain = "the sensitivity to the positive side is another one than to the negative side"
    equation = "k * K1' * |x| / 2"
    kind = Kind.BLOCK
    tests = ALL
    seen_as = "a V against the input, its kink at zero"
    remedy = "calibrate the two sides apart; dense points near zero tell it from K2"
    confused_with = ("second_order_nonlinearity", "head_eccentricity")
    typical = {"accelerometer": 0.5, "gyro": 300.0}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: difference of the two sensitivities, mg/g or ppm."""
        unit = "mg/g" if sensor.kind == "accelerometer" else "ppm"
        return (Parameter("asymmetry", "K1'", unit),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Half the size of the input."""
        small = 1e-3 if sensor.kind == "accelerometer" else 1e-6
        return column(gain(sensor) * small * np.abs(own(stimulus, sensor)) / 2.0)


class BiasAsymmetry(Effect):
    """K0' of IEEE 1293."""

    id = "bias_asymmetry"
    name = "Bias asymmetry K0'"
    plain = "the bias on the positive side is another one than on the negative side"
    equation = "k * K0' * sign(x) / 2"
    kind = Kind.BLOCK
    tests = HEAD
    sensors = ("accelerometer",)
    seen_as = "a jump where the input changes its sign"
    remedy = "look for a dead band of the electronics; measure close to zero"
    confused_with = ("hysteresis", "third_order_nonlinearity")
    typical = {"accelerometer": 0.1}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: difference of the two biases, mg."""
        return (Parameter("bias_asymmetry", "K0'", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Half the sign of the input."""
        return column(small_gain(sensor) * sign_of(own(stimulus, sensor)) / 2.0)


class DeadBand(Effect):
    """Threshold, dead band, lost motion of a drive."""

    id = "dead_band"
    name = "Dead band"
    plain = "small rates are not answered, and all larger ones by so much too little"
    equation = "-k * D * sign(w)"
    kind = Kind.BLOCK
    tests = TABLE
    sensors = ("gyro",)
    seen_as = "a step at zero rate"
    remedy = "look for lost motion in the drive of the table; measure small rates"
    confused_with = ("third_order_nonlinearity", "table_slip")
    typical = {"gyro": 0.02}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: half width of the band, deg/s."""
        return (Parameter("dead_band", "D", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The sign of the input, 0 at rest."""
        return column(-small_gain(sensor) * sign_of(own(stimulus, sensor)))


class Saturation(Effect):
    """Clipping by the sensor, its electronics or the converter.

    Parameters
    ----------
    level : where it begins, g or deg/s
    side : 1, -1, or 0 for both sides
    """

    id = "saturation"
    name = "Saturation"
    plain = "beyond a level the output grows less than it should"
    equation = "-k * s * (|x| - c) beyond c"
    kind = Kind.BLOCK
    tests = ALL
    seen_as = "flat ends of the characteristic"
    remedy = "keep the input below the level; look at the limits of the converter"
    confused_with = ("third_order_nonlinearity", "scale_factor_asymmetry", "table_slip")
    alone = True
    typical = {"accelerometer": 10.0, "gyro": 10.0}  # noqa: RUF012

    def __init__(self, level: float = 0.9, side: int = 1, step: float = 0.05) -> None:
        self._level, self._side, self._step = level, side, step

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Level and side."""
        return (
            (Parameter("level", "c", ""), self._level),
            (Parameter("side", "", ""), float(self._side)),
        )

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the lost part of what is beyond the level, %."""
        return (Parameter("lost", "s", "%"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """What is beyond the level."""
        x = own(stimulus, sensor)
        high, low = np.maximum(x - self._level, 0.0), np.minimum(x + self._level, 0.0)
        return column(-0.01 * gain(sensor) * (high * (self._side >= 0) + low * (self._side <= 0)))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Levels between the largest inputs, at either side and both."""
        x = own(stimulus, sensor)
        found: list[Effect] = []
        for side in (1, -1, 0):
            reached = x * side if side else np.abs(x)
            sizes = levels(reached[reached > 0].round(6))[-6:]
            step = sizes[-1] / 20.0 if sizes else 0.0
            found += [
                Saturation(0.5 * (low + high), side, step)
                for low, high in itertools.pairwise(sizes)
            ]
        return tuple(found)

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """A little lower and higher."""
        step = fraction * self._step
        return (
            Saturation(self._level - step, self._side, self._step),
            Saturation(self._level + step, self._side, self._step),
        )
