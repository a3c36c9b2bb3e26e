"""Effects of long records: temperature with memory, and the channels of a vibratory gyro.

The channels are those of a Coriolis vibratory gyro under force to rebalance; the equations follow
its error model (quadrature leaks by the error of the demodulation phase, damping anisotropy goes
with the excitation, the period of the resonator is a thermometer of its own).
"""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import RECORD, column, grid, hours, small_gain, small_unit
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus

_SECONDS_PER_H = 3600.0
_S_PER_MIN = 60.0
_WIDEST_C = 10.0


def lagged(values: FloatArray, t_s: FloatArray, tau_s: float) -> FloatArray:
    """What a body of time constant tau makes of a temperature (n,); in balance at the start.

    Exact for a temperature that goes in straight lines from row to row.
    """
    steps = np.diff(t_s) / tau_s
    keep = np.exp(-steps)
    ramp = -np.expm1(-steps) / np.maximum(steps, 1e-300)
    added = (ramp - keep) * values[:-1] + (1.0 - ramp) * values[1:]
    now = float(values[0])
    found = [now]
    for k, more in zip(keep.tolist(), added.tolist(), strict=True):
        now = k * now + more
        found.append(now)
    return np.array(found)


def branch(values: FloatArray, width: float, start: float) -> FloatArray:
    """Where a play operator of that width stands (n,): -1 and 1 on its two branches."""
    half = 0.5 * width
    memory = float(values[0]) - start * half
    found: list[float] = []
    for value in values.tolist():
        memory = min(max(memory, value - half), value + half)
        found.append((value - memory) / half)
    return np.array(found)


class _Thermal(Effect):
    """Something that goes with the temperature."""

    kind = Kind.BLOCK
    tests = RECORD
    needs = ("temperature_c",)


class TemperatureRate(_Thermal):
    """Temperature-rate sensitivity (IEEE 952).

    Parameters
    ----------
    tau_s : time over which the rate is taken
    least_s : shorter ones tell nothing more, for rows are not closer
    """

    id = "temperature_rate"
    name = "Temperature-rate sensitivity"
    plain = "the bias follows how fast the temperature changes"
    equation = "bR * dT/dt"
    seen_as = "an offset while it warms, the opposite one while it cools"
    remedy = "change the temperature more slowly, or compensate by dT/dt"
    confused_with = ("thermal_lag", "warm_up")
    typical = {"accelerometer": 0.1, "gyro": 0.01}  # noqa: RUF012

    def __init__(self, tau_s: float = 30.0, least_s: float = 0.0) -> None:
        self._tau, self._least = tau_s, least_s

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The time over which the rate is taken."""
        return ((Parameter("tau", "tau", "s"), self._tau),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg or deg/s per degC/min."""
        return (Parameter("temperature_rate", "b_R", f"{small_unit(sensor)}/(degC/min)"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Rate of the temperature, weighted over about two tau on both sides."""
        t = _SECONDS_PER_H * hours(stimulus)
        away = (t[:, None] - t[None, :]) / self._tau
        weight = np.exp(-0.5 * away**2)
        warm = stimulus.column("temperature_c")
        # Slope of a weighted straight line about each row.
        total = weight.sum(axis=1)
        middle = weight @ t / total
        spread = weight @ t**2 - total * middle**2
        slope = (weight @ (t * warm) - middle * (weight @ warm)) / np.maximum(spread, 1e-12)
        return column(small_gain(sensor) * _S_PER_MIN * slope)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """From neighbours in time to a twentieth of the record."""
        times = _times(stimulus, 1.5, 0.05, 4)
        return tuple(TemperatureRate(tau, times[0]) for tau in times)

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """Over a little less and more time; none below what rows can show."""
        step = 1.25**fraction
        shorter = max(self._tau / step, self._least)
        return (
            TemperatureRate(shorter, self._least),
            TemperatureRate(self._tau * step, self._least),
        )


class ThermalLag(_Thermal):
    """Lag behind the temperature of the thermometer.

    Parameters
    ----------
    tau_s : time constant
    """

    id = "thermal_lag"
    name = "Thermal lag"
    plain = "the bias follows a part whose temperature lags behind the thermometer's"
    equation = "bL * (T lagged by tau)"
    seen_as = "a loop against temperature, wider when it changes faster"
    remedy = "wait for balance; compensate by the lagged temperature; move the thermometer"
    confused_with = ("bias_temperature", "thermal_hysteresis", "warm_up")
    typical = {"accelerometer": 0.3, "gyro": 0.03}  # noqa: RUF012

    def __init__(self, tau_s: float = 300.0) -> None:
        self._tau = tau_s

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The time constant."""
        return ((Parameter("tau", "tau", "s"), self._tau),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg/degC or (deg/s)/degC."""
        return (Parameter("thermal_lag", "b_L", f"{small_unit(sensor)}/degC"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The lagged temperature from its mean."""
        t_s = _SECONDS_PER_H * hours(stimulus)
        warm = lagged(stimulus.column("temperature_c"), t_s, self._tau)
        return column(small_gain(sensor) * (warm - warm.mean()))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """From a few rows to a third of the record."""
        return tuple(ThermalLag(tau) for tau in _times(stimulus, 4.0, 0.35, 9))

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """A little faster and slower."""
        return (ThermalLag(self._tau / 1.25**fraction), ThermalLag(self._tau * 1.25**fraction))


class ThermalHysteresis(_Thermal):
    """Hysteresis over temperature that does not depend on its rate.

    Parameters
    ----------
    width : change of temperature that leads from one branch to the other, degC
    start : branch on which the record begins, -1 to 1
    """

    id = "thermal_hysteresis"
    name = "Thermal hysteresis"
    plain = "warming and cooling leave another bias at the same temperature, however slowly"
    equation = "bH * (T - play(T)) / half width"
    seen_as = "two branches against temperature that slow changes do not close"
    remedy = "approach temperatures from one side; state the two branches"
    confused_with = ("thermal_lag", "bias_jump", "telegraph")
    typical = {"accelerometer": 0.1, "gyro": 0.02}  # noqa: RUF012

    def __init__(self, width: float = 1.0, start: float = 0.0) -> None:
        self._width, self._start = width, start

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The width of the loop, and where it begins."""
        width = Parameter("width", "w", "degC")
        return ((width, self._width), (Parameter("start", "", ""), self._start))

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: half the distance of the branches, mg or deg/s."""
        return (Parameter("thermal_hysteresis", "b_H", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """-1 on the branch of cooling, 1 on that of warming."""
        warm = stimulus.column("temperature_c")
        return column(small_gain(sensor) * branch(warm, self._width, self._start))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Widths up to ten degrees, for wider ones are lags; from either branch or between."""
        span = float(np.ptp(stimulus.column("temperature_c")))
        return tuple(
            ThermalHysteresis(width, start)
            for width in grid(0.02 * span, min(0.33 * span, _WIDEST_C), 9)
            for start in (-1.0, 0.0, 1.0)
        )

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """A little narrower and wider."""
        step = 1.2**fraction
        return (
            ThermalHysteresis(self._width / step, self._start),
            ThermalHysteresis(self._width * step, self._start),
        )


class _Channel(Effect):
    """Something that goes with a channel of the gyro."""

    kind = Kind.BLOCK
    tests = RECORD
    sensors = ("gyro",)
    seen_as = "residuals follow this channel"
    symbol = "b"
    per = "V"

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: deg/s per unit of the channel."""
        return (Parameter(self.id, self.symbol, f"{small_unit(sensor)}/{self.per}"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The channel from its mean."""
        x = stimulus.column(self.needs[0])
        return column(small_gain(sensor) * (x - x.mean()))


class QuadratureLeakage(_Channel):
    """Quadrature leaks into the rate by an error of the demodulation phase that stands."""

    id = "quadrature_leakage"
    name = "Quadrature leakage"
    plain = "a part of the quadrature signal gets into the rate"
    equation = "bQ * (Q - Q0)"
    needs = ("QuadratureAmpl",)
    symbol = "b_Q"
    remedy = "adjust the phase of the demodulator; compensate by the quadrature channel"
    confused_with = ("phase_error", "bias_temperature")
    typical = {"gyro": 0.1}  # noqa: RUF012


class PhaseError(_Channel):
    """The demodulation phase moves and lets quadrature through."""

    id = "phase_error"
    name = "Demodulation phase error"
    plain = "the phase of the demodulator moves and lets quadrature through"
    equation = "bF * (phi - phi0) * Q"
    needs = ("ExcitationDelay", "QuadratureAmpl")
    symbol = "b_F"
    per = "(us*V)"
    remedy = "stabilise the phase loop; reduce the quadrature; compensate by the product"
    confused_with = ("quadrature_leakage",)
    typical = {"gyro": 0.1}  # noqa: RUF012

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Deviation of the delay times the quadrature."""
        delay, q = (stimulus.column(name) for name in self.needs)
        return column(small_gain(sensor) * (delay - delay.mean()) * q)


class DampingAnisotropy(_Channel):
    """Damping differs by direction; what holds the vibration up drives the rate."""

    id = "damping_anisotropy"
    name = "Damping anisotropy"
    plain = "damping differs by direction, so that the excitation gets into the rate"
    equation = "bE * (E - E0)"
    needs = ("ExcitationAmpl",)
    symbol = "b_E"
    remedy = "compensate by the excitation channel; stabilise the temperature"
    confused_with = ("bias_temperature", "amplitude_error")
    typical = {"gyro": 0.1}  # noqa: RUF012


class ResonatorFrequency(_Channel):
    """The bias follows the temperature of the resonator itself, of which its period tells."""

    id = "resonator_frequency"
    name = "Resonator frequency"
    plain = "the bias follows the period of the resonator, a thermometer inside it"
    equation = "bP * (P - P0)"
    needs = ("AntiNodePeriod",)
    symbol = "b_P"
    per = "us"
    remedy = "compensate by the period instead of the thermometer"
    confused_with = ("thermal_lag", "bias_temperature")
    typical = {"gyro": 10.0}  # noqa: RUF012


class AmplitudeError(_Channel):
    """The control of the amplitude leaves an error."""

    id = "amplitude_error"
    name = "Amplitude error"
    plain = "the amplitude of the vibration is not held, and the bias follows it"
    equation = "bA * (A - A0)"
    needs = ("AntiNodeAmplitude",)
    symbol = "b_A"
    remedy = "look at the amplitude control; compensate by the amplitude channel"
    confused_with = ("damping_anisotropy", "bias_temperature")
    typical = {"gyro": 0.1}  # noqa: RUF012


class Telegraph(Effect):
    """The bias goes to and fro between two levels (random telegraph signal).

    Parameters
    ----------
    paths : rows at which it changes, one tuple for each way in which the data could be read
    log_odds : of one path among all that could be, natural logarithm
    """

    id = "telegraph"
    name = "Random telegraph bias"
    plain = "the bias jumps to and fro between two levels"
    equation = "J * s(t), s = 0 or 1"
    kind = Kind.EVENT
    tests = RECORD
    seen_as = "two levels against time"
    remedy = "look for a loose contact, popcorn noise of an amplifier, a latching loop"
    confused_with = ("bias_jump", "rate_random_walk")
    typical = {"accelerometer": 0.3, "gyro": 0.05}  # noqa: RUF012

    def __init__(
        self, paths: tuple[tuple[int, ...], ...] = (), log_odds: tuple[float, ...] = ()
    ) -> None:
        self._paths = paths
        self._odds = log_odds
        if len(log_odds) == 1:
            self.log_odds = log_odds[0]

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The first row after each change, from 1."""
        path = self._paths[0] if self._paths else ()
        return tuple((Parameter("from_row", "", ""), float(row + 1)) for row in path)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg or deg/s."""
        return (Parameter("telegraph", "J", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """0 and 1 in turn."""
        level = np.zeros(len(stimulus))
        for row in self._paths[0] if self._paths else ():
            level[row:] = 1.0 - level[row:]
        return column(small_gain(sensor) * level)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every path; none before the data were looked at."""
        return tuple(
            Telegraph((path,), (odds,)) for path, odds in zip(self._paths, self._odds, strict=True)
        )


def _times(stimulus: Stimulus, rows: float, share: float, count: int) -> list[float]:
    """Times from so many rows to a share of the record, s."""
    t = _SECONDS_PER_H * hours(stimulus)
    step = float(np.median(np.diff(t))) if len(t) > 1 else 0.0
    low, high = rows * step, share * float(np.ptp(t))
    return grid(low, high, count) if high > low > 0.0 else []
