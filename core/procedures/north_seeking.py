"""How long to average when seeking north, and how long the heading can be kept afterwards.

From the unit's noise coefficients (an Allan analysis): white noise falls with the averaging time,
flicker does not, a random walk grows with the time between the first and the last heading, so
there is a best time.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError
from core.procedures.earth import level_dps
from core.procedures.slow_noise import RateNoise, combined_covariance, in_turn
from core.units import DEG_PER_RAD, RAD_PER_DEG

QUARTERS = (0.0, 90.0, 180.0, 270.0)
_POSSIBLE_HEADINGS = (0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0)


@dataclass(frozen=True, slots=True)
class Seeking:
    """A way of seeking north.

    Parameters
    ----------
    latitude_deg : where
    headings_deg : readings of the base, in turn
    pause_s : time to turn and settle before each
    """

    latitude_deg: float
    headings_deg: Sequence[float] = QUARTERS
    pause_s: float = 5.0


@dataclass(frozen=True, slots=True, eq=False)
class AveragingAdvice:
    """Uncertainty of the heading against the averaging time at each reading.

    Parameters
    ----------
    seconds, u_deg : (n,) averaging times and standard uncertainties, k = 1
    best_s, best_deg : the best of them
    enough_s : shortest that reaches the target; NaN if none does or none was stated
    """

    seconds: FloatArray
    u_deg: FloatArray
    best_s: float
    best_deg: float
    enough_s: float


def heading_uncertainty(noise: RateNoise, seeking: Seeking, average_s: float) -> float:
    """Standard uncertainty of the heading, deg.

    Parameters
    ----------
    noise : coefficients in deg/s
    seeking : where and how
    average_s : averaging time at each reading

    Raises
    ------
    FitError
        The readings do not determine a heading, or there is no level rate.
    """
    return float(held_uncertainty(noise, seeking, average_s, np.zeros(1))[0])


def averaging_advice(
    noise: RateNoise,
    seeking: Seeking,
    *,
    target_deg: float = np.nan,
    longest_s: float = 1000.0,
) -> AveragingAdvice:
    """Find the best averaging time and the shortest that is enough.

    Parameters
    ----------
    noise : coefficients in deg/s
    seeking : where and how
    target_deg : standard uncertainty wanted
    longest_s : longest averaging time that is practical
    """
    seconds = np.geomspace(0.1, longest_s, 81)
    u = np.array([heading_uncertainty(noise, seeking, float(s)) for s in seconds])
    best = int(np.argmin(u))
    reached = np.flatnonzero(u <= target_deg)
    return AveragingAdvice(
        frozen(seconds),
        frozen(u),
        float(seconds[best]),
        float(u[best]),
        float(seconds[reached[0]]) if reached.size else float("nan"),
    )


def held_uncertainty(
    noise: RateNoise, seeking: Seeking, average_s: float, hold_s: FloatArray
) -> FloatArray:
    """Standard uncertainty (n,) of a heading that was found and then kept, deg.

    With memory in the noise it depends a little on the heading itself; this is the worst.

    Parameters
    ----------
    noise : coefficients in deg/s
    seeking : where and how north was sought
    average_s : averaging time at each reading
    hold_s : (n,) how long the heading was kept by integrating a rate with the same noise, less the
        drift found along with the heading

    Raises
    ------
    FitError
        As `heading_uncertainty`.
    """
    level = level_dps(seeking.latitude_deg)
    delta = np.asarray(seeking.headings_deg, dtype=np.float64) * RAD_PER_DEG
    design = np.column_stack([np.cos(delta), -np.sin(delta), np.ones_like(delta)])
    if np.linalg.matrix_rank(design) < 3:
        raise FitError(
            "these headings do not tell the Earth's rate from drift; use steps of 90 deg"
        )
    if not level > 1e-3 * level_dps(0.0):
        raise FitError(f"at {seeking.latitude_deg:g} deg of latitude a gyro finds no heading")
    inverse = np.linalg.pinv(design)
    starts, lengths = in_turn(len(delta), average_s, seeking.pause_s)
    end = float(starts[-1] + lengths[-1])
    found: list[float] = []
    for hold in hold_s:
        worst = 0.0
        for heading in _POSSIBLE_HEADINGS:
            psi = heading * RAD_PER_DEG
            seek = (np.cos(psi) * inverse[1] - np.sin(psi) * inverse[0]) / level * DEG_PER_RAD
            if hold == 0:
                covariance = combined_covariance(noise, seek[None, :], starts, lengths)
            else:
                weights = np.append(seek - hold * inverse[2], hold)[None, :]
                covariance = combined_covariance(
                    noise, weights, np.append(starts, end), np.append(lengths, hold)
                )
            worst = max(worst, float(covariance[0, 0]))
        found.append(float(np.sqrt(worst)))
    return frozen(found)
