"""Effects of gyros."""

from core.arrays import FloatArray
from core.model.effect import AXES, Effect, Parameter, Sensor
from core.model.stimulus import Stimulus


class AccelerationSensitiveDrift(Effect):
    """Acceleration-sensitive drift rate (IEEE 528), g-sensitivity b_ij of (3.3), as output."""

    id = "g_sensitivity"
    name = "Acceleration-sensitive drift"
    plain = "gravity and acceleration shift the zero of the gyro"
    equation = "b_ix * a_x + b_iy * a_y + b_iz * a_z"

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Three: output per m/s^2 along each case axis."""
        unit = f"{sensor.unit}/(m/s^2)"
        return tuple(
            Parameter(f"g_sensitivity_{axis}", f"b_{sensor.axis}{axis}", unit) for axis in AXES
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The specific force."""
        return stimulus.a
