"""How a unit stands on the dividing head, and what it feels there.

Three right-handed frames:

base
    s along the shaft, away from the head; v up when the base plate is level; l = v x s.
level
    s horizontal at azimuth psi, v along the plumb line.
case
    the unit's own X, Y, Z.

A mount names the case axis that lies along the shaft and its sense: ``X_from`` (away from the
head), ``X_to`` (towards it), the same for Y and Z; ``X_from@90`` stands for the unit re-indexed
on the dial by 90 degrees. At head angle zero Z is up, for Z along the shaft X is up. The
practicum's Tables 1.1, 2.1 and 3.1 hold ``X_from`` and ``Y_from``; the senses "to" and the Z
mounts follow by the same rule (the head turns the same way, the axis along it is reversed).
"""

import math
import re
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from core.arrays import FloatArray, frozen
from core.units import ARCMIN_PER_DEG, EARTH_RATE_DPS, RAD_PER_DEG

_MOUNT = re.compile(r"([XYZ])_(from|to)(?:@(-?\d+(?:\.\d*)?))?")

# Rows are the case axes in the base frame (s, l, v) at head angle zero.
_AT_ZERO: dict[str, tuple[tuple[int, int, int], ...]] = {
    "X_from": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "X_to": ((-1, 0, 0), (0, -1, 0), (0, 0, 1)),
    "Y_from": ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    "Y_to": ((0, 1, 0), (-1, 0, 0), (0, 0, 1)),
    "Z_from": ((0, 0, 1), (0, -1, 0), (1, 0, 0)),
    "Z_to": ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
}


@dataclass(frozen=True, slots=True)
class Mount:
    """A unit bolted on the head.

    Parameters
    ----------
    axis : case axis along the shaft, ``"X"``, ``"Y"`` or ``"Z"``
    sense : ``"from"`` or ``"to"`` the head
    reindex_deg : turn of the unit on the dial, in the sense of the head angle
    """

    axis: str
    sense: str
    reindex_deg: float

    @classmethod
    def parse(cls, text: str) -> "Mount":
        """Read ``X_from``, ``Y_to@90``...

        Raises
        ------
        ValueError
            The text names no mount.
        """
        match = _MOUNT.fullmatch(text.strip())
        if match is None:
            raise ValueError(
                f"unknown mount {text!r}; expected X_from, X_to, Y_from, Y_to, Z_from or Z_to,"
                " optionally with a re-index angle such as X_from@90"
            )
        return cls(match[1], match[2], float(match[3] or 0.0))

    @property
    def key(self) -> str:
        """The mount without its re-index angle."""
        return f"{self.axis}_{self.sense}"


def turn(axis: str, angle_deg: float) -> FloatArray:
    """Rotation matrix about a coordinate axis, right-handed: ``turn("Z", 90) @ x = y``."""
    c, s = _cos_sin(angle_deg)
    first = "XYZ".index(axis)
    j, k = (first + 1) % 3, (first + 2) % 3
    matrix = np.eye(3)
    matrix[j, j] = matrix[k, k] = c
    matrix[j, k], matrix[k, j] = -s, s
    return matrix


def _cos_sin(angle_deg: float) -> tuple[float, float]:
    """Cosine and sine, exact at the quarter turns so that cardinal positions hold true zeros."""
    quarters, rest = divmod(angle_deg, 90.0)
    if rest == 0.0:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarters) % 4]
    return math.cos(angle_deg * RAD_PER_DEG), math.sin(angle_deg * RAD_PER_DEG)


@dataclass(frozen=True, slots=True)
class BaseOrientation:
    """How the head's base plate stands (Pointer's "Base orientation"; meanings inferred).

    Parameters
    ----------
    alpha_arcmin : elevation of the shaft's free end above the horizon
    beta_arcmin : roll of the plate about the shaft, in the sense of the head angle
    gamma_deg : the same in whole degrees, e.g. of a plate bolted on turned
    psi_deg : azimuth of the shaft's free end from true north, clockwise from above
    """

    alpha_arcmin: float = 0.0
    beta_arcmin: float = 0.0
    gamma_deg: float = 0.0
    psi_deg: float = 0.0

    def base_from_level(self) -> FloatArray:
        """Rotation (3, 3) that takes components in the level frame to the base frame."""
        roll = self.beta_arcmin / ARCMIN_PER_DEG + self.gamma_deg
        return turn("X", roll) @ turn("Y", self.alpha_arcmin / ARCMIN_PER_DEG)


LEVEL = BaseOrientation()
NO_TILT = (0.0, 0.0, 0.0)
"""Yaw, pitch and roll of a tilter at rest, deg."""


@lru_cache(maxsize=4096)
def case_from_base(mount: str, head_deg: float) -> FloatArray:
    """Return the rotation (3, 3) whose rows are the case axes X, Y, Z in the base frame (s, l, v).

    Practicum, Tables 1.1 and 2.1: the columns of ``a`` there are this matrix times (0, 0, g).
    """
    parsed = Mount.parse(mount)
    angle = head_deg + parsed.reindex_deg
    if parsed.sense == "to":
        angle = -angle
    return frozen(turn(parsed.axis, angle) @ np.array(_AT_ZERO[parsed.key], dtype=float))


def tilter_rotation(psi_deg: float, theta_deg: float, gamma_deg: float) -> FloatArray:
    """Rotation (3, 3) that a tilter adds between plate and case: yaw psi, pitch theta, roll gamma.

    Axes as in (2.8): Y longitudinal, X lateral, Z up; positive pitch lifts Y, positive roll
    lowers X.
    """
    return turn("Y", -gamma_deg) @ turn("X", -theta_deg) @ turn("Z", -psi_deg)


def specific_force_in_base(g: float, base: BaseOrientation = LEVEL) -> FloatArray:
    """Specific force (3,) on the base axes (s, l, v) at rest, m/s^2: a = -g (2.3)."""
    return base.base_from_level() @ np.array([0.0, 0.0, g])


def specific_force(
    mount: str, head_deg: float, g: float, base: BaseOrientation = LEVEL
) -> FloatArray:
    """Specific force (3,) on the case axes at rest, m/s^2: +g on an axis that points up (2.3)."""
    return case_from_base(mount, head_deg) @ specific_force_in_base(g, base)


def earth_rate(
    mount: str, head_deg: float, latitude_deg: float, base: BaseOrientation = LEVEL
) -> FloatArray:
    """Rate of the Earth (3,) on the case axes, deg/s, for a unit at rest.

    Parameters
    ----------
    latitude_deg : geodetic latitude, positive north, -90 to 90
    base : its psi is the azimuth of the shaft
    """
    up = EARTH_RATE_DPS * math.sin(latitude_deg * RAD_PER_DEG)
    north = EARTH_RATE_DPS * math.cos(latitude_deg * RAD_PER_DEG)
    c, s = _cos_sin(base.psi_deg)
    # North seen from a shaft at azimuth psi: cos psi along it, sin psi along l (to the left).
    level = np.array([north * c, north * s, up])
    return case_from_base(mount, head_deg) @ base.base_from_level() @ level
