"""Errors of angles against set ones: full turns, cross angles, mounting, statistics.

Pitch is limited to +-90 degrees, so past them a full turn is compared by the angle of the specific
force in the Y-Z plane; roll covers the full turn by itself. What a unit reports as heading, pitch
and roll is turned back into the direction of its specific force first.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.units import DEG_PER_RAD, RAD_PER_DEG

PITCH, ROLL = "pitch", "roll"
_QUARTER = 90.0
_UPRIGHT = 5.0
"""Within this of +-90 degrees of pitch, roll and heading turn about the same axis, deg."""


@dataclass(frozen=True, slots=True)
class Statistics:
    """What Pointer shows below its graph, deg.

    Parameters
    ----------
    minimum, maximum : smallest and largest error
    half_span : half their difference, the (+/-)
    rms : root mean square error
    noise_std : standard deviation of single samples at rest, root mean square over the rows; NaN
        where it was not kept
    """

    minimum: float
    maximum: float
    half_span: float
    rms: float
    noise_std: float

    @classmethod
    def of(cls, errors: FloatArray, noise: FloatArray) -> "Statistics":
        """Summarise errors (n,), NaN where undefined, and the noise (n,) of their rows."""
        known = errors[np.isfinite(errors)]
        low, high = float(known.min()), float(known.max())
        quiet = noise[np.isfinite(noise)]
        return cls(
            minimum=low,
            maximum=high,
            half_span=(high - low) / 2.0,
            rms=float(np.sqrt(np.mean(known**2))),
            noise_std=float(np.sqrt(np.mean(quiet**2))) if quiet.size else float("nan"),
        )


def wrapped(degrees: FloatArray) -> FloatArray:
    """The same angles above -180, to 180."""
    turned = np.mod(degrees, 360.0)
    return np.where(turned > 180.0, turned - 360.0, turned)


def is_full_turn(kind: str, set_deg: FloatArray) -> bool:
    """Whether pitch alone cannot follow the set angles."""
    return kind == PITCH and bool(np.any(np.abs(wrapped(set_deg)) >= _QUARTER))


def direction(pitch: FloatArray, roll: FloatArray) -> FloatArray:
    """Direction (n, 3) of the specific force of a unit at rest with this pitch and roll, (2.8)."""
    theta, gamma = pitch * RAD_PER_DEG, roll * RAD_PER_DEG
    return np.column_stack(
        [-np.cos(theta) * np.sin(gamma), np.sin(theta), np.cos(theta) * np.cos(gamma)]
    )


def set_direction(kind: str, set_deg: FloatArray) -> FloatArray:
    """Direction (n, 3) of the specific force at the set pitch or roll."""
    zero = np.zeros_like(set_deg)
    if kind == PITCH:
        s, c = np.sin(set_deg * RAD_PER_DEG), np.cos(set_deg * RAD_PER_DEG)
        return np.column_stack([zero, s, c])
    return direction(zero, set_deg)


def main_angle(kind: str, force: FloatArray, *, full_turn: bool) -> FloatArray:
    """The angle (n,) that is compared, deg: pitch, in-plane angle of a full turn, or roll.

    Parameters
    ----------
    kind : `PITCH` or `ROLL`
    force : (n, 3) specific force of any length
    full_turn : see `is_full_turn`
    """
    x, y, z = force.T
    if kind == ROLL:
        return np.arctan2(-x, z) * DEG_PER_RAD
    across = z if full_turn else np.hypot(x, z)
    return np.arctan2(y, across) * DEG_PER_RAD


def cross_error(kind: str, set_deg: FloatArray, force: FloatArray) -> FloatArray:
    """Error (n,) of the other angle, deg: roll while pitch is set, pitch while roll is set.

    Beyond +-90 degrees of pitch a right unit reports a roll of 180; near them roll is undefined.
    """
    x, y, z = force.T
    if kind == ROLL:
        return np.arctan2(y, np.hypot(x, z)) * DEG_PER_RAD
    set_angle = wrapped(set_deg)
    expected = np.where(np.abs(set_angle) > _QUARTER, 180.0, 0.0)
    error = wrapped(np.arctan2(-x, z) * DEG_PER_RAD - expected)
    return np.where(np.abs(np.abs(set_angle) - _QUARTER) < _UPRIGHT, np.nan, error)


def heading_error(kind: str, set_deg: FloatArray, heading: FloatArray) -> FloatArray:
    """Change (n,) of the heading against the first row, deg; a head at rest turns no heading.

    Beyond +-90 degrees of pitch a right unit reports the opposite heading.
    """
    if kind == ROLL:
        return wrapped(heading - heading[0])
    set_angle = wrapped(set_deg)
    over = np.where(np.abs(set_angle) > _QUARTER, 180.0, 0.0)
    error = wrapped(heading - over - (heading[0] - over[0]))
    return np.where(np.abs(np.abs(set_angle) - _QUARTER) < _UPRIGHT, np.nan, error)


def aligned(kind: str, set_deg: FloatArray, force: FloatArray) -> FloatArray:
    """Specific force (n, 3) with the mounting of the unit on the head taken out.

    The one rotation that brings the measured directions closest to the set ones (Wahba's problem,
    by singular values).
    """
    measured = force / np.linalg.norm(force, axis=1)[:, None]
    u, _, vt = np.linalg.svd(set_direction(kind, set_deg).T @ measured)
    rotation = u @ np.diag([1.0, 1.0, np.linalg.det(u) * np.linalg.det(vt)]) @ vt
    return frozen(force @ rotation.T)
