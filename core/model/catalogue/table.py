"""Effects of the rate table and of gyros turning on it."""

import itertools

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import TABLE, column, gain, levels, own, small_gain, small_unit
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus
from core.units import RAD_PER_DEG


class TableSlip(Effect):
    """The drive slips above a rate.

    Parameters
    ----------
    rate_dps : where it begins
    """

    id = "table_slip"
    name = "Table slip"
    plain = "above a rate the drive of the table slips"
    equation = "-k * s * (|w| - w_s) * sign(w) above w_s"
    kind = Kind.BLOCK
    tests = TABLE
    sensors = ("gyro",)
    shared = True
    seen_as = "both ends of the characteristic turn towards zero"
    remedy = "measure the period of the table; tighten the belt"
    confused_with = ("third_order_nonlinearity", "saturation")
    typical = {"gyro": 0.5}  # noqa: RUF012

    def __init__(self, rate_dps: float = 50.0) -> None:
        self._rate = rate_dps

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The rate where it begins."""
        return ((Parameter("slips_from", "w_s", "deg/s"), self._rate),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the lost part of what is above, %."""
        return (Parameter("slip", "s", "%"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """What is above the rate."""
        w = own(stimulus, sensor)
        beyond = np.sign(w) * np.maximum(np.abs(w) - self._rate, 0.0)
        return column(-0.01 * gain(sensor) * beyond)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Between the rates."""
        sizes = levels(np.abs(own(stimulus, sensor)).round(6))
        middle = [0.5 * (a + b) for a, b in itertools.pairwise(sizes)]
        return tuple(TableSlip(rate) for rate in sorted({*sizes[1:-1], *middle}))

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """A little lower and higher."""
        step = 0.04 * fraction * self._rate
        return (TableSlip(self._rate - step), TableSlip(self._rate + step))


class WrongRate(Effect):
    """The table runs at another speed than set, at one setting.

    Parameters
    ----------
    rate_dps : the setting
    """

    id = "wrong_rate"
    name = "Wrong speed at one setting"
    plain = "at one setting the table runs at another speed than it says"
    equation = "k * e at that setting"
    needs = ("set_rate_dps",)
    kind = Kind.EVENT
    tests = TABLE
    sensors = ("gyro",)
    shared = True
    seen_as = "all rows of one set rate lie off"
    remedy = "measure the period of the table at this setting"
    confused_with = ("outlier",)
    typical = {"gyro": 0.1}  # noqa: RUF012

    def __init__(self, rate_dps: float = 0.0) -> None:
        self._rate = rate_dps

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The setting."""
        return ((Parameter("set_rate", "", "deg/s"), self._rate),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: deg/s."""
        return (Parameter("rate_error", "e", "deg/s"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The response at that setting."""
        here = stimulus.column("set_rate_dps") == self._rate
        return column(stimulus.dw_drate @ sensor.sensitivity * here)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every set rate that was visited more than once."""
        rates = stimulus.column("set_rate_dps")
        return tuple(WrongRate(rate) for rate in levels(rates) if np.sum(rates == rate) > 1)


class Wobble(Effect):
    """The axis of the table is tilted, and the accumulations are no whole turns."""

    id = "wobble"
    name = "Wobble of the table"
    plain = "the axis of the table is tilted; what swings round does not average out"
    equation = "b * mean of sin and cos(w t) over the accumulation"
    needs = ("accumulation_s",)
    kind = Kind.BLOCK
    instant = False
    tests = TABLE
    sensors = ("gyro",)
    seen_as = "residuals at small rates that depend on the length of the accumulation"
    remedy = "accumulate over whole turns; level the table"
    confused_with = ("third_order_nonlinearity",)
    typical = {"gyro": 0.01}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Two, deg/s."""
        unit = small_unit(sensor)
        return (Parameter("wobble_sine", "b_s", unit), Parameter("wobble_cosine", "b_c", unit))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Means of sine and cosine of the turned angle."""
        turned = RAD_PER_DEG * own(stimulus, sensor) * stimulus.column("accumulation_s")
        turning = np.abs(turned) > 1e-6
        angle = np.where(turning, turned, 1.0)
        sine = np.where(turning, (1.0 - np.cos(angle)) / angle, 0.0)
        cosine = np.where(turning, np.sin(angle) / angle, 1.0)
        return small_gain(sensor) * column(sine, cosine)


class AmplitudeScaleFactor(Effect):
    """The scale factor of a vibratory gyro follows its amplitude."""

    id = "amplitude_scale_factor"
    name = "Scale factor with amplitude"
    plain = "the sensitivity of the vibratory gyro follows its drive amplitude"
    equation = "k * s * (A - A0) / A0 * w"
    needs = ("AntiNodeAmplitude",)
    kind = Kind.BLOCK
    instant = False
    tests = TABLE
    sensors = ("gyro",)
    seen_as = "slope of the characteristic changes with the amplitude"
    remedy = "look at the amplitude control; calibrate with the amplitude"
    confused_with = ("scale_factor_temperature",)
    typical = {"gyro": 1.0}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: relative change of the scale factor per relative change of the amplitude."""
        return (Parameter("amplitude_scale_factor", "s", "1"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Relative amplitude times the input."""
        amplitude = stimulus.column("AntiNodeAmplitude")
        relative = amplitude / amplitude.mean() - 1.0
        return column(gain(sensor) * relative * own(stimulus, sensor))
