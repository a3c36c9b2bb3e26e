"""Pitch and roll from specific force, by forms that are well conditioned everywhere.

Y longitudinal, X lateral, Z up (2.8). The printed (2.9) takes the arcsine of a_y/|a|, whose error
grows without bound near 90 degrees; the arctangents below are the same angles.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.units import DEG_PER_RAD

_UNDEFINED = 3.0
"""Roll is called undefined when the force across Y is below this many standard uncertainties."""


@dataclass(frozen=True, slots=True, eq=False)
class Attitude:
    """Pitch, roll and in-plane angle, deg, with standard uncertainties.

    Parameters
    ----------
    pitch, u_pitch : (n,) -90 to 90
    roll, u_roll : (n,) above -180, to 180; NaN where the unit stands on its Y axis
    plane, u_plane : (n,) angle of the specific force in the Y-Z plane, above -180 to 180: the
        pitch of a full turn about X
    """

    pitch: FloatArray
    u_pitch: FloatArray
    roll: FloatArray
    u_roll: FloatArray
    plane: FloatArray
    u_plane: FloatArray


def attitude(a: FloatArray, covariance: FloatArray) -> Attitude:
    """Return the attitude of a unit at rest.

    Parameters
    ----------
    a : (n, 3) calibrated specific force, m/s^2
    covariance : (n, 3, 3) its covariance

    Notes
    -----
    theta = atan2(a_y, hypot(a_x, a_z)), (2.9); gamma = atan2(-a_x, a_z), (2.9) and (2.10).
    """
    x, y, z = a.T
    across = np.hypot(x, z)
    norm2 = across**2 + y**2
    in_plane2 = y**2 + z**2
    zero = np.zeros_like(x)
    with np.errstate(divide="ignore", invalid="ignore"):
        pitch_jacobian = np.column_stack(
            [-x * y / (across * norm2), across / norm2, -z * y / (across * norm2)]
        )
        roll_jacobian = np.column_stack([-z / across**2, zero, x / across**2])
        plane_jacobian = np.column_stack([zero, z / in_plane2, -y / in_plane2])
    u_across = np.sqrt((covariance[:, 0, 0] + covariance[:, 2, 2]) / 2.0)
    undefined = across <= _UNDEFINED * u_across
    u_pitch = np.where(across > 0, _propagate(pitch_jacobian, covariance), np.nan)
    return Attitude(
        pitch=np.arctan2(y, across) * DEG_PER_RAD,
        u_pitch=u_pitch,
        roll=np.where(undefined, np.nan, _half_open(np.arctan2(-x, z))),
        u_roll=np.where(undefined, np.nan, _propagate(roll_jacobian, covariance)),
        plane=_half_open(np.arctan2(y, z)),
        u_plane=_propagate(plane_jacobian, covariance),
    )


def _propagate(jacobian: FloatArray, covariance: FloatArray) -> FloatArray:
    with np.errstate(invalid="ignore"):
        return np.sqrt(np.einsum("ni,nij,nj->n", jacobian, covariance, jacobian)) * DEG_PER_RAD


def _half_open(angle_rad: FloatArray) -> FloatArray:
    """Degrees above -180, to 180: (2.10) gives -180 for a_x = +0, which is the same angle."""
    degrees = angle_rad * DEG_PER_RAD
    return np.where(degrees <= -180.0, 180.0, degrees)
