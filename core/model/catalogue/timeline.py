"""Effects of time and temperature: drift, warm-up, jumps, offsets of runs, pick-up."""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import (
    ALL,
    RECORD,
    TABLE,
    column,
    gain,
    grid,
    hours,
    indicators,
    levels,
    numbered,
    own,
    small_gain,
    small_unit,
    warmth,
)
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus

_MINUTES_PER_H = 60.0
_MOST_LINES = 200


class BiasDrift(Effect):
    """Rate ramp of IEEE 952; steady drift of the bias."""

    id = "bias_drift"
    name = "Bias drift"
    plain = "the bias goes steadily with time"
    equation = "D * t"
    kind = Kind.BLOCK
    timed = True
    tests = (*ALL, *RECORD)
    seen_as = "a straight line against time"
    remedy = "wait until it has settled; repeat the first positions at the end"
    confused_with = ("bias_temperature", "warm_up", "run_bias", "remount_bias")
    typical = {"accelerometer": 0.3, "gyro": 0.05}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg/h or (deg/s)/h."""
        return (Parameter("drift", "D", f"{small_unit(sensor)}/h"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Time since the first row."""
        return column(small_gain(sensor) * hours(stimulus))


class BiasTemperature(Effect):
    """Bias temperature sensitivity D_T (IEEE 952)."""

    id = "bias_temperature"
    name = "Bias temperature sensitivity"
    plain = "the bias follows the temperature"
    equation = "bT * (T - T0)"
    needs = ("temperature_c",)
    kind = Kind.BLOCK
    tests = (*ALL, *RECORD)
    seen_as = "a straight line against temperature"
    remedy = "calibrate over temperature; change the temperature on purpose by 10 degrees"
    confused_with = ("bias_drift", "warm_up", "scale_factor_temperature")
    typical = {"accelerometer": 0.3, "gyro": 0.03}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg/degC or (deg/s)/degC."""
        return (Parameter("bias_temperature", "b_T", f"{small_unit(sensor)}/degC"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Temperature from its mean."""
        return column(small_gain(sensor) * warmth(stimulus))


class ScaleFactorTemperature(Effect):
    """Scale-factor temperature sensitivity (IEEE 528)."""

    id = "scale_factor_temperature"
    name = "Scale-factor temperature sensitivity"
    plain = "the sensitivity follows the temperature"
    equation = "k * kT * (T - T0) * x"
    needs = ("temperature_c",)
    kind = Kind.BLOCK
    tests = ALL
    seen_as = "slope of the characteristic changes with temperature"
    remedy = "calibrate over temperature; state T0 with the scale factor"
    confused_with = ("bias_temperature", "third_order_nonlinearity")
    typical = {"accelerometer": 100.0, "gyro": 100.0}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: ppm/degC."""
        return (Parameter("scale_factor_temperature", "k_T", "ppm/degC"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Temperature from its mean times the input."""
        return column(1e-6 * gain(sensor) * warmth(stimulus) * own(stimulus, sensor))


class WarmUp(Effect):
    """The bias settles after switching on.

    Parameters
    ----------
    tau_min : time constant, min
    """

    id = "warm_up"
    name = "Warm-up"
    plain = "after switching on the bias settles exponentially"
    equation = "W * exp(-t / tau)"
    kind = Kind.BLOCK
    timed = True
    tests = (*ALL, *RECORD)
    seen_as = "the first rows lie off and come closer"
    remedy = "switch on earlier; begin when the temperature stands"
    confused_with = ("bias_drift", "bias_temperature")
    typical = {"accelerometer": 1.0, "gyro": 0.1}  # noqa: RUF012

    def __init__(self, tau_min: float = 5.0) -> None:
        self._tau = tau_min

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The time constant."""
        return ((Parameter("tau", "tau", "min"), self._tau),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the shift at the first row, mg or deg/s."""
        return (Parameter("warm_up", "W", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The exponential from the first row on."""
        decay: FloatArray = np.exp(hours(stimulus) * (-_MINUTES_PER_H / self._tau)).astype(
            np.float64
        )
        return column(small_gain(sensor) * decay)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Time constants that these rows could tell from a jump and from a line."""
        minutes = _MINUTES_PER_H * hours(stimulus)
        span = float(minutes[-1] - minutes[0])
        step = float(np.median(np.diff(minutes))) if len(minutes) > 1 else 0.0
        if not span > step > 0.0:
            return ()
        return tuple(WarmUp(tau) for tau in grid(2.0 * step, max(0.6 * span, 2.1 * step), 9))

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """A little faster and slower."""
        return (WarmUp(self._tau / 1.2**fraction), WarmUp(self._tau * 1.2**fraction))


class BiasJump(Effect):
    """The bias jumped.

    Parameters
    ----------
    row : first row after the jump
    """

    id = "bias_jump"
    name = "Bias jump"
    plain = "the bias jumped once and stayed"
    equation = "J from one row on"
    kind = Kind.EVENT
    instant = False
    tests = (*ALL, *RECORD)
    seen_as = "a step against time"
    remedy = "repeat the test; look for a knock, a re-start, a change of the supply"
    confused_with = ("run_bias", "remount_bias", "bias_drift")
    typical = {"accelerometer": 0.3, "gyro": 0.05}  # noqa: RUF012

    def __init__(self, row: int = 0) -> None:
        self._row = row

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """The first row after it, from 1."""
        return ((Parameter("from_row", "", ""), float(self._row + 1)),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg or deg/s."""
        return (Parameter("jump", "J", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Ones from that row on."""
        after = (np.arange(len(stimulus)) >= self._row).astype(np.float64)
        return column(small_gain(sensor) * after)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """After every row; after the first, or before the last, it looks like one bad row."""
        return tuple(BiasJump(row) for row in range(1, len(stimulus)))


class _OfRuns(Effect):
    """Something that is another one in some runs.

    Parameters
    ----------
    runs : numbers of the runs
    """

    needs = ("run",)
    kind = Kind.BLOCK
    instant = False

    def __init__(self, *runs: float) -> None:
        self._runs = runs or (0.0,)

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which run."""
        return tuple((Parameter("run", "", ""), run) for run in self._runs)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every run, if there are several, and all but the first together."""
        runs = levels(stimulus.column("run"))
        if len(runs) < 2:
            return ()
        together = [type(self)(*runs[1:])] if len(runs) > 2 else []
        return (*(type(self)(run) for run in runs), *together)


class RunBias(_OfRuns):
    """Turn-on repeatability of the bias."""

    id = "run_bias"
    name = "Run-to-run bias"
    plain = "the bias is another one in one run"
    equation = "b in that run"
    tests = ALL
    seen_as = "one run lies off"
    remedy = "leave the unit powered between runs; state the turn-on repeatability"
    confused_with = ("bias_drift", "bias_jump", "remount_bias")
    typical = {"accelerometer": 0.5, "gyro": 0.05}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One a run: mg or deg/s."""
        return numbered("run_bias", "b", small_unit(sensor), len(self._runs))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Ones in that run."""
        return small_gain(sensor) * indicators(stimulus.column("run"), self._runs)


class RunScaleFactor(_OfRuns):
    """Turn-on repeatability of the scale factor."""

    id = "run_scale_factor"
    name = "Run-to-run scale factor"
    plain = "the sensitivity is another one in one run"
    equation = "k * s * x in that run"
    tests = TABLE
    sensors = ("gyro",)
    seen_as = "one run has another slope"
    remedy = "leave the unit powered between runs; check the speed of the table"
    confused_with = ("scale_factor_temperature",)
    typical = {"gyro": 300.0}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One a run: ppm."""
        return numbered("run_scale_factor", "s", "ppm", len(self._runs))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The input in that run."""
        here = indicators(stimulus.column("run"), self._runs)
        return 1e-6 * gain(sensor) * own(stimulus, sensor)[:, None] * here


class Pickup(Effect):
    """A line of mains or motor, folded into the accumulations.

    Parameters
    ----------
    cycles : periods over the whole test
    """

    id = "pickup"
    name = "Periodic pick-up"
    plain = "something periodic in time is picked up"
    equation = "A * sin(2 pi f t + phase)"
    kind = Kind.BLOCK
    instant = False
    tests = (*ALL, *RECORD)
    seen_as = "a sine against time"
    remedy = "look for mains and motors; reverse a run, which tells it from an error of the head"
    confused_with = ("head_periodic_error",)
    typical = {"accelerometer": 0.1, "gyro": 0.02}  # noqa: RUF012

    def __init__(self, cycles: float = 10.0) -> None:
        self._cycles = cycles

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Periods over the whole test."""
        return ((Parameter("cycles", "f", "1/test"), self._cycles),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Sine and cosine part, mg or deg/s."""
        unit = small_unit(sensor)
        return (Parameter("pickup_sine", "A_s", unit), Parameter("pickup_cosine", "A_c", unit))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Sine and cosine of time."""
        t = hours(stimulus)
        span = float(np.ptp(t))
        angle = 2.0 * np.pi * self._cycles * t / (span if span > 0.0 else 1.0)
        return small_gain(sensor) * column(np.sin(angle), np.cos(angle))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """From three periods to the fold of the usual pause, half a period apart.

        Where the unit was bolted anew the test stood still, so that there are more periods in it
        than half its rows.
        """
        t = hours(stimulus)
        pause = float(np.median(np.diff(t))) if len(t) > 1 else 0.0
        if pause <= 0.0:
            return ()
        fastest = 0.5 * float(np.ptp(t)) / pause
        if fastest < 4.0:
            return ()
        step = max(0.5, (fastest - 3.0) / _MOST_LINES)
        return tuple(Pickup(float(cycles)) for cycles in np.arange(3.0, fastest - 0.25, step))

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """A little slower and faster."""
        step = 0.2 * fraction
        return (Pickup(self._cycles - step), Pickup(self._cycles + step))
