"""The rate of the Earth where nobody stated it: when it matters, and what it does then."""

import math

from core.errors import Note, Severity
from core.units import DPH_PER_DPS, EARTH_RATE_DPS, RAD_PER_DEG


def vertical_dps(latitude_deg: float) -> float:
    """Part of the Earth's rate along the plumb line, deg/s; NaN latitude gives NaN."""
    return EARTH_RATE_DPS * math.sin(latitude_deg * RAD_PER_DEG)


def level_dps(latitude_deg: float) -> float:
    """Part of the Earth's rate towards north, deg/s; NaN latitude gives NaN."""
    return EARTH_RATE_DPS * math.cos(latitude_deg * RAD_PER_DEG)


def feels(uncertainty_dps: float, missing_dps: float, stability_dps: float) -> bool:
    """Whether a gyro is good enough to feel a rate that the stimulus leaves out.

    Parameters
    ----------
    uncertainty_dps : expanded uncertainty of the number that it would go into
    missing_dps : the rate left out
    stability_dps : stated stability of the gyro's zero, NaN if none is
    """
    if math.isfinite(stability_dps):
        return stability_dps < missing_dps
    return uncertainty_dps < missing_dps


def latitude_missing(goes_into: str, remedy: str) -> Note:
    """The latitude was not stated, and this gyro is good enough to feel the Earth."""
    return Note(
        Severity.WARNING,
        "earth_rate",
        "this gyro feels the rotation of the Earth, and no latitude was stated: up to"
        f" {EARTH_RATE_DPS * DPH_PER_DPS:.1f} deg/h times the sine of the latitude went into"
        f" {goes_into}; {remedy}",
    )


def azimuth_missing(goes_into: str, level: float) -> Note:
    """The azimuth was not stated, and this gyro is good enough to feel the Earth's level rate."""
    return Note(
        Severity.WARNING,
        "earth_azimuth",
        "this gyro feels the rotation of the Earth, and the azimuth of the head was not stated: up"
        f" to {level * DPH_PER_DPS:.1f} deg/h went into {goes_into}; state the azimuth of the"
        " shaft",
    )
