"""Effects of what came before: hysteresis and settling."""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import (
    ALL,
    MEMORIES,
    column,
    ideal,
    own,
    previous,
    small_gain,
    small_unit,
)
from core.model.catalogue.terms import sign as sign_of
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus


class Hysteresis(Effect):
    """Hysteresis (IEEE 528): the output remembers from which side it came.

    Parameters
    ----------
    memory : which rows come from the row before them, see `terms.previous`
    by_turning : the side is that in which the input moved at the end of the turn, else that of
        the last input
    first : side from which the very first row was reached, 1 or -1; 0 leaves it out
    """

    id = "hysteresis"
    name = "Hysteresis"
    plain = "the output depends on whether the input rose or fell before"
    equation = "k * h * sign(x - x_previous)"
    kind = Kind.BLOCK
    instant = False
    tests = ALL
    needs = ("order",)
    seen_as = "runs with rising and with falling input lie apart"
    remedy = "approach all positions from one side, or state the two branches"
    confused_with = ("settling_lag", "bias_asymmetry")
    typical = {"accelerometer": 0.1, "gyro": 0.02}  # noqa: RUF012

    def __init__(
        self, memory: str = "mounting", *, by_turning: bool = False, first: float = 0.0
    ) -> None:
        self._memory, self._turning, self._first = memory, by_turning, first

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: half the width of the loop, mg or deg/s."""
        return (Parameter("hysteresis", "h", small_unit(sensor)),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """1 after a rise, -1 after a fall, 0 where it is not known; kept where nothing moved."""
        before = previous(stimulus, self._memory)
        x = own(stimulus, sensor)
        change = x - x[before]
        if self._turning and "head_deg" in stimulus.columns:
            head = stimulus.columns["head_deg"]
            turn = (head - head[before] + 180.0) % 360.0 - 180.0
            change = stimulus.da_dhead[:, sensor.index] * turn
        side = sign_of(change)
        side[0] = self._first
        for row in range(1, len(side)):
            if side[row] == 0.0 and before[row] != row:
                side[row] = side[row - 1]
        return column(small_gain(sensor) * side)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """All ways in which the side can be meant."""
        ways = (False, True) if np.any(stimulus.da_dhead) else (False,)
        return tuple(
            Hysteresis(memory, by_turning=turning, first=first)
            for memory in MEMORIES
            for turning in ways
            for first in (0.0, 1.0, -1.0)
        )


class SettlingLag(Effect):
    """The accumulation began before the output had settled.

    Parameters
    ----------
    memory : which rows come from the row before them, see `terms.previous`
    part : missing part for which the column is right; the row before is late itself
    """

    id = "settling_lag"
    name = "Settling lag"
    plain = "a part of the way from the position before is still missing"
    equation = "rho * (U_previous - U)"
    kind = Kind.BLOCK
    instant = False
    tests = ALL
    needs = ("order",)
    seen_as = "residuals follow the step from the position before"
    remedy = "wait longer before each accumulation"
    confused_with = ("hysteresis", "short_accumulation")
    typical = {"accelerometer": 0.1, "gyro": 0.1}  # noqa: RUF012

    def __init__(self, memory: str = "mounting", *, part: float = 0.0) -> None:
        self._memory, self._part = memory, part

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the missing part, %."""
        return (Parameter("lag", "rho", "%"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The step back to what the row before has reached."""
        u = ideal(stimulus, sensor)
        before = previous(stimulus, self._memory)
        reached = u.copy()
        for row, came_from in enumerate(before):
            reached[row] += self._part * (reached[came_from] - u[row])
        return column(0.01 * (reached[before] - u))

    def at(self, values: FloatArray) -> Effect:
        """The missing part of one sensor in rows that are late themselves."""
        if len(values) > 1:
            return self
        return SettlingLag(self._memory, part=float(np.clip(0.01 * values[0], -0.5, 0.5)))

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """With all memories."""
        return tuple(SettlingLag(memory) for memory in MEMORIES)
