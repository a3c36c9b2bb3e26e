"""Effects that every inertial sensor has: bias, scale factor, cross-axis sensitivity."""

import numpy as np

from core.arrays import FloatArray
from core.model.effect import AXES, Effect, Parameter, Sensor
from core.model.stimulus import Stimulus


class Bias(Effect):
    """Output at zero input, K0 (IEEE 1293) or D_F (IEEE 952), in units of the output."""

    id = "bias"
    name = "Bias"
    plain = "the output does not vanish at zero input"
    equation = "U0"

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the output at zero input."""
        return (Parameter("bias", "U0", sensor.unit),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """A column of ones."""
        return np.ones((len(stimulus), 1))


class ScaleFactor(Effect):
    """Change of output per unit of input along the nominal input axis, K1; its sign is free."""

    id = "scale_factor"
    name = "Scale factor"
    plain = "how much the output changes per unit of input"
    equation = "k_i * input_i"

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the scale factor."""
        unit = f"{sensor.unit}/({sensor.input_unit})"
        return (Parameter("scale_factor", f"k_{sensor.axis}", unit),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The input along the nominal axis."""
        return sensor.input(stimulus)[:, [sensor.index]]


class CrossAxis(Effect):
    """Response to input along the other case axes: misalignment, in the model (2.1).

    Parameters
    ----------
    axes : the case axes whose response is known to matter or can be determined
    """

    id = "cross_axis"
    name = "Cross-axis sensitivity"
    plain = "the sensor also feels the two other axes, mostly because it stands askew"
    equation = "k_ij * input_j + k_ik * input_k"

    def __init__(self, axes: str = "xyz") -> None:
        self._axes = axes

    def _others(self, sensor: Sensor) -> list[str]:
        return [axis for axis in sensor.cross_axes if axis in self._axes]

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One for each of the other axes."""
        unit = f"{sensor.unit}/({sensor.input_unit})"
        return tuple(
            Parameter(f"cross_axis_{axis}", f"k_{sensor.axis}{axis}", unit)
            for axis in self._others(sensor)
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The input along the other axes."""
        return sensor.input(stimulus)[:, [AXES.index(axis) for axis in self._others(sensor)]]
