"""Effects that runs have as well, in the wider form that a long record can show."""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import RECORD, small_gain, small_unit
from core.model.catalogue.timeline import BiasTemperature, Pickup
from core.model.effect import Effect, Parameter, Sensor
from core.model.stimulus import Stimulus

_HIGHEST = 3
_WIDE_C = 15.0
_SLOWEST, _FASTEST, _APART = 3.0, 20.0, 0.4


class BiasCurve(BiasTemperature):
    """Bias over temperature as a polynomial, D_T and D_T2 of IEEE 952.

    Parameters
    ----------
    degree : highest power of T - T0
    """

    tests = RECORD
    equation = "bT * (T - T0) + bT2 * (T - T0)^2 ..."

    def __init__(self, degree: int = 1) -> None:
        self._degree = degree

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One a power."""
        unit, first = small_unit(sensor), super().parameters(sensor)[0]
        return (
            first,
            *(
                Parameter(f"bias_temperature_{k}", f"b_T{k}", f"{unit}/degC^{k}")
                for k in range(2, self._degree + 1)
            ),
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Powers of the temperature from its mean."""
        t = stimulus.column("temperature_c")
        powers = (t - t.mean())[:, None] ** np.arange(1, self._degree + 1)
        return small_gain(sensor) * powers

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """A straight line; curves where the temperature goes far enough."""
        wide = float(np.ptp(stimulus.column("temperature_c"))) > _WIDE_C
        return tuple(BiasCurve(degree) for degree in range(1, (_HIGHEST if wide else 2) + 1))


class SlowPickup(Pickup):
    """A line too slow for the spectrum of the samples.

    Parameters
    ----------
    cycles : periods over the whole record
    """

    tests = RECORD

    def __init__(self, cycles: float = 10.0) -> None:
        super().__init__(cycles)
        self._slow = cycles

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Up to twenty periods, closer than the lines can be told apart."""
        return tuple(SlowPickup(float(c)) for c in np.arange(_SLOWEST, _FASTEST, _APART))

    def near(self, fraction: float = 1.0) -> tuple[Effect, ...]:
        """A little slower and faster."""
        step = 0.15 * fraction
        return (SlowPickup(self._slow - step), SlowPickup(self._slow + step))
