"""Magnetometers and own angles of an attitude unit on the rig."""

import numpy as np

from core.arrays import FloatArray
from core.model.stimulus import Stimulus
from core.units import DEG_PER_RAD

_LEVEL_NT = 20_000.0
_DOWN_NT = 45_500.0
_HARD_IRON_NT = np.array([310.0, -140.0, 220.0])
OWN_ERROR_DEG = {"heading": 0.4, "pitch": 0.02, "roll": -0.05}
"""What the electronics of the unit add to its own angles."""

MAG_ROLES = ("mag.x", "mag.y", "mag.z")
ANGLE_ROLES = ("angle.heading", "angle.pitch", "angle.roll")


def magnetic_field(stimulus: Stimulus) -> FloatArray:
    """Magnetic flux density (n, 3) on the case axes with the unit's hard iron, nT."""
    up, north = _up(stimulus), _north(stimulus)
    return _LEVEL_NT * north - _DOWN_NT * up + _HARD_IRON_NT


def own_angles(stimulus: Stimulus) -> FloatArray:
    """Heading, pitch and roll (n, 3) as the unit computes them itself, deg.

    Y is the longitudinal axis, X points to the right, Z up (2.8).
    """
    up, north = _up(stimulus), _north(stimulus)
    pitch = np.arctan2(up[:, 1], np.hypot(up[:, 0], up[:, 2]))
    roll = np.arctan2(-up[:, 0], up[:, 2])
    east = np.cross(north, up)
    heading = np.arctan2(east[:, 1], north[:, 1])
    angles = np.column_stack([heading, pitch, roll]) * DEG_PER_RAD + [*OWN_ERROR_DEG.values()]
    angles[:, 0] %= 360.0
    return angles


def _up(stimulus: Stimulus) -> FloatArray:
    return stimulus.a / np.linalg.norm(stimulus.a, axis=1, keepdims=True)


def _north(stimulus: Stimulus) -> FloatArray:
    return np.column_stack([stimulus.column(f"north_{axis}") for axis in "xyz"])
