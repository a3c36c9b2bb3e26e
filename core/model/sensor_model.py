"""A sensor is a list of effects."""

from dataclasses import dataclass, replace
from itertools import accumulate, pairwise

import numpy as np

from core.arrays import FloatArray
from core.model.effect import Effect, Parameter, Sensor
from core.model.stimulus import Stimulus


@dataclass(frozen=True, slots=True)
class SensorModel:
    """Output of one sensor, linear in the parameters of its effects.

    Parameters
    ----------
    sensor : whose output
    effects : what acts in it, in the order of the parameters
    """

    sensor: Sensor
    effects: tuple[Effect, ...]

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All parameters (p,), in the order of the design's columns."""
        return tuple(p for effect in self.effects for p in effect.parameters(self.sensor))

    @property
    def places(self) -> tuple[slice, ...]:
        """Where the parameters of each effect stand among all."""
        ends = list(accumulate(len(effect.parameters(self.sensor)) for effect in self.effects))
        return tuple(slice(start, end) for start, end in pairwise((0, *ends)))

    def design(self, stimulus: Stimulus) -> FloatArray:
        """Return (n, p): the output that one unit of each parameter adds in each row."""
        return np.hstack([effect.columns(stimulus, self.sensor) for effect in self.effects])

    def predict(self, stimulus: Stimulus, values: FloatArray) -> FloatArray:
        """Return the output (n,) for parameter values (p,)."""
        return self.design(stimulus) @ values

    def with_effect(self, effect: Effect) -> "SensorModel":
        """The same model with one more effect."""
        return replace(self, effects=(*self.effects, effect))
