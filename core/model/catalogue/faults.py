"""Mistakes of the operator and faults of the data that concern single rows or positions."""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import (
    ALL,
    HEAD,
    column,
    ideal,
    per_head_angle,
    small_gain,
    small_unit,
)
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus
from core.units import RAD_PER_DEG


class _RowFault(Effect):
    """Something at one row."""

    kind = Kind.EVENT
    instant = False
    tests = ALL

    def __init__(self, row: int = 0) -> None:
        self._row = row

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which row, from 1."""
        return ((Parameter("row", "", ""), float(self._row + 1)),)

    def here(self, stimulus: Stimulus) -> FloatArray:
        """1 at the row, else 0."""
        return (np.arange(len(stimulus)) == self._row).astype(np.float64)


def _per_degree(stimulus: Stimulus, sensor: Sensor, about_deg: float) -> FloatArray:
    """Output (n,) per degree of the head: of the chord of an angle, or the slope if it is 0."""
    turn = RAD_PER_DEG * about_deg
    if turn == 0.0:
        return RAD_PER_DEG * per_head_angle(stimulus, sensor)
    back = (np.cos(turn) - 1.0) * ideal(stimulus, sensor)
    return (back + np.sin(turn) * per_head_angle(stimulus, sensor)) / about_deg


class Outlier(_RowFault):
    """One accumulation that was disturbed."""

    id = "outlier"
    name = "Outlier"
    plain = "one accumulation was disturbed"
    equation = "e at one row"
    seen_as = "one row lies off"
    remedy = "look at the raw samples of this row; measure it again"
    confused_with = ("wrong_angle", "positions_swapped")
    alone = True
    typical = {"accelerometer": 1.0, "gyro": 0.1}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg or deg/s."""
        return (Parameter("error", "e", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """1 at the row."""
        return column(small_gain(sensor) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every row."""
        return tuple(Outlier(row) for row in range(len(stimulus)))


class WrongAngle(_RowFault):
    """The head stood at another angle than written, once."""

    id = "wrong_angle"
    name = "Wrong angle"
    plain = "the head stood at another angle than written"
    equation = "U(angle + d) - U(angle) at one row"
    needs = ("head_deg",)
    tests = HEAD
    sensors = ("accelerometer",)
    shared = True
    seen_as = "one row lies off in all sensors, as one angle explains"
    remedy = "correct the angle if it is a whole step of the dial, else measure the row again"
    confused_with = ("outlier", "wrong_stop")
    # The dial is read wrong by whole degrees far more often than by any other angle.
    step = 1.0
    typical = {"accelerometer": 1.0}  # noqa: RUF012

    def __init__(self, row: int = 0, about_deg: float = 0.0) -> None:
        super().__init__(row)
        self._about = about_deg

    def at(self, values: FloatArray) -> Effect:
        """By the chord of that angle instead of the slope."""
        return WrongAngle(self._row, float(values[0]))

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: deg."""
        return (Parameter("angle_error", "d", "deg"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The slope at the row."""
        return column(_per_degree(stimulus, sensor, self._about) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every row."""
        return tuple(WrongAngle(row) for row in range(len(stimulus)))


class WrongStop(Effect):
    """The same wrong angle in every run.

    Parameters
    ----------
    mount, head_deg : the position; mounts are numbered
    """

    id = "wrong_stop"
    name = "Wrong stop"
    plain = "at one position the head stood wrong in every run"
    equation = "U(angle + d) - U(angle) at one position"
    needs = ("head_deg", "mount")
    kind = Kind.EVENT
    instant = False
    tests = HEAD
    sensors = ("accelerometer",)
    shared = True
    seen_as = "all rows of one position lie off alike"
    remedy = "check the stop or the division of the head there"
    confused_with = ("wrong_angle",)
    typical = {"accelerometer": 0.05}  # noqa: RUF012

    def __init__(self, mount: float = 0.0, head_deg: float = 0.0, about_deg: float = 0.0) -> None:
        self._mount, self._head, self._about = mount, head_deg, about_deg

    def at(self, values: FloatArray) -> Effect:
        """By the chord of that angle instead of the slope."""
        return WrongStop(self._mount, self._head, float(values[0]))

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Mounting, from 1, and angle."""
        return (
            (Parameter("mounting", "", ""), self._mount + 1.0),
            (Parameter("at", "", "deg"), self._head),
        )

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: deg."""
        return (Parameter("angle_error", "d", "deg"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The slope at the position."""
        head = np.mod(stimulus.column("head_deg"), 360.0)
        here = (stimulus.column("mount") == self._mount) & (head == self._head)
        return column(_per_degree(stimulus, sensor, self._about) * here)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every position that was visited more than once."""
        head, mount = np.mod(stimulus.column("head_deg"), 360.0), stimulus.column("mount")
        places, counts = np.unique(np.column_stack([mount, head]), axis=0, return_counts=True)
        return tuple(
            WrongStop(float(m), float(h))
            for (m, h), count in zip(places, counts, strict=True)
            if count > 1
        )


class ShortAccumulation(_RowFault):
    """One accumulation began while the output still moved."""

    id = "short_accumulation"
    name = "Short accumulation"
    plain = "one accumulation began too early or was too short"
    equation = "rho * (U_previous - U) at one row"
    needs = ("y_se",)
    seen_as = "one row lies off towards the row before, and its own scatter is large"
    remedy = "look at the raw samples; wait longer; measure the row again"
    confused_with = ("outlier", "settling_lag")
    typical = {"accelerometer": 0.1, "gyro": 0.1}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the missing part of the step, %."""
        return (Parameter("lag", "rho", "%"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The step back to the row before, at the row."""
        u = ideal(stimulus, sensor)
        return column(0.01 * (np.roll(u, 1) - u) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Rows whose own scatter is half as large again as usual."""
        se = stimulus.column("y_se")
        rows = np.flatnonzero(se > 1.5 * np.median(se))
        return tuple(ShortAccumulation(int(row)) for row in rows if row > 0)


class StuckReading(_RowFault):
    """The reading of the row before was stored again."""

    id = "stuck_reading"
    name = "Stuck reading"
    plain = "the reading of the row before was stored again, bit for bit"
    equation = "e at one row"
    needs = ("repeated",)
    together = True
    seen_as = "a row that equals the row before exactly, at another setting"
    remedy = "measure the row again"
    confused_with = ("outlier",)
    typical = {"accelerometer": 1000.0, "gyro": 10.0}  # noqa: RUF012
    # That two readings are equal by chance to the last bit is less likely than this.
    log_odds = 10.0

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: mg or deg/s."""
        return (Parameter("error", "e", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """1 at the row."""
        return column(small_gain(sensor) * self.here(stimulus))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Rows that equal the row before."""
        rows = np.flatnonzero(stimulus.column("repeated") > 0)
        return tuple(StuckReading(int(row)) for row in rows)
