"""An effect whose parameters are polynomials of the temperature."""

import numpy as np

from core.arrays import FloatArray
from core.model.effect import Effect, Parameter, Sensor
from core.model.stimulus import Stimulus


class OverTemperature(Effect):
    """Another effect with each parameter p replaced by p + p_T1 t + p_T2 t^2 + ...

    Parameters
    ----------
    effect : whose parameters change with temperature
    order : of the polynomials; 0 leaves them constant
    reference_c : t is the temperature less this
    """

    name = "Temperature sensitivity"
    plain = "parameters change with the temperature"
    equation = "p + p_T1 (T - T0) + p_T2 (T - T0)^2 + ..."
    needs = ("temperature_c",)

    def __init__(self, effect: Effect, order: int, reference_c: float) -> None:
        self.id = f"{effect.id}_over_temperature"
        self._effect = effect
        self._order = order
        self._reference_c = reference_c

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Those of the effect, then their coefficients of t, of t^2, ..."""
        return tuple(
            Parameter(
                p.name if power == 0 else f"{p.name}_t{power}",
                p.symbol if power == 0 else f"{p.symbol}_T{power}",
                p.unit if power == 0 else f"{p.unit}/degC{'' if power == 1 else f'^{power}'}",
            )
            for power in range(self._order + 1)
            for p in self._effect.parameters(sensor)
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The effect's columns times the powers of t."""
        columns = self._effect.columns(stimulus, sensor)
        if self._order == 0:
            return columns
        t = (stimulus.column("temperature_c") - self._reference_c)[:, None]
        return np.hstack([columns * t**power for power in range(self._order + 1)])
