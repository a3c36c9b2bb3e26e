"""Outputs of a unit in units of their input, by a calibration."""

from dataclasses import dataclass

from core.arrays import FloatArray, frozen
from core.procedures.calibration import Calibration
from core.procedures.compensation import compensated, has_effects, linear_map, needs_temperature
from core.samples.block import Channel

_PREFIX = {"accelerometer": "acc", "gyro": "rate"}
_UNITS = {"accelerometer": "m/s^2", "gyro": "deg/s"}


@dataclass(frozen=True, slots=True, eq=False)
class Physical:
    """A linear map from some channels to their input.

    Parameters
    ----------
    places : (k,) columns of the channels in the samples
    matrix : (k, k) input per unit of output
    zero : (k,) output at zero input
    unit : of the input
    bent : a calibration with effects beyond the linear map, which are taken out too; None where
        there are none, or where they ask for a temperature
    """

    places: tuple[int, ...]
    matrix: FloatArray
    zero: FloatArray
    unit: str
    bent: Calibration | None = None

    def of(self, data: FloatArray) -> FloatArray:
        """Inputs (n, k) from samples (n, c)."""
        if self.bent is not None:
            return compensated(self.bent, data[:, self.places])
        return frozen((data[:, self.places] - self.zero) @ self.matrix.T)


def physical_of(calibration: Calibration, channels: tuple[Channel, ...]) -> Physical | None:
    """The map for a unit that sends these channels; None where they do not fit."""
    prefix = _PREFIX[calibration.sensor]
    roles = [channel.role for channel in channels]
    wanted = [_role(name, axis, prefix) for name, axis in
              zip(calibration.channels, calibration.axes, strict=True)]  # fmt: skip
    if not wanted or not set(wanted) <= set(roles):
        return None
    places = tuple(roles.index(role) for role in wanted)
    if any(channels[place].unit != calibration.unit for place in places):
        return None
    zero, matrix = linear_map(calibration)
    bent = has_effects(calibration) and not needs_temperature(calibration)
    unit = _UNITS[calibration.sensor]
    return Physical(places, frozen(matrix), frozen(zero), unit, calibration if bent else None)


def _role(name: str, axis: str, prefix: str) -> str:
    """``acc_x`` -> ``acc.x``; the third sensor of an assembly, ``acc_3``, -> ``adc.3``."""
    which = name.rpartition("_")[2]
    return f"adc.{which}" if which.isdecimal() else f"{prefix}.{which if len(which) == 1 else axis}"
