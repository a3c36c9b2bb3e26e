"""Angles that begin anew after a full turn: their samples jump from 180 to -180, or from 360 to 0.

Means, scatter and stillness are those of the angle without the jump.
"""

from collections.abc import Sequence

import numpy as np

from core.arrays import FloatArray
from core.samples.block import Channel

_TURN_DEG = 360.0


def turning_columns(channels: Sequence[Channel]) -> list[int]:
    """Columns that hold such an angle: role ``angle.*``, in degrees."""
    return [
        place
        for place, channel in enumerate(channels)
        if channel.role.startswith("angle.") and channel.unit == "deg"
    ]


def unwrapped(data: FloatArray, columns: list[int]) -> FloatArray:
    """Samples (n, c) without the jumps of these columns."""
    if not columns or not len(data):
        return data
    smooth = data.copy()
    smooth[:, columns] = np.unwrap(data[:, columns], period=_TURN_DEG, axis=0)
    return smooth


def within_turn(mean: float, samples: FloatArray) -> float:
    """A mean in the turn that its samples (n,) count in: above -180 to 180, or from 0 to 360."""
    turned = mean % _TURN_DEG
    if samples.min() < 0.0 and turned > _TURN_DEG / 2.0:
        return turned - _TURN_DEG
    return turned
