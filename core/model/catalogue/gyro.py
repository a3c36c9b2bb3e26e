"""Effects of gyros."""

from core.arrays import FloatArray
from core.model.effect import AXES, Effect, Parameter, Sensor
from core.model.stimulus import Stimulus


class AccelerationSensitiveDrift(Effect):
    """Acceleration-sensitive drift rate (IEEE 528), g-sensitivity b_ij of (3.3), as output.

    Parameters
    ----------
    axes : the case axes that are looked at, e.g. ``"yz"`` where no position excites x
    """

    id = "g_sensitivity"
    name = "Acceleration-sensitive drift"
    plain = "gravity and acceleration shift the zero of the gyro"
    equation = "b_ix * a_x + b_iy * a_y + b_iz * a_z"

    def __init__(self, axes: str = "xyz") -> None:
        self._axes = tuple(axis for axis in AXES if axis in axes)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One for each axis: output per m/s^2 along it."""
        unit = f"{sensor.unit}/(m/s^2)"
        return tuple(
            Parameter(f"g_sensitivity_{axis}", f"b_{sensor.axis}{axis}", unit)
            for axis in self._axes
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The specific force along these axes."""
        return stimulus.a[:, [AXES.index(axis) for axis in self._axes]]
