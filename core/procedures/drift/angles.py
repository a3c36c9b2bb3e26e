"""The source's own way (003): knots by the sharpest angles, slopes against temperature.

Kept for comparison. The angle at a point depends on an arbitrary horizontal spacing; where that
is large, 180 degrees less the angle is the second difference over the spacing, a local curvature
without any bound on the error of the whole, and where it is small only reversals of the sign are
seen. In the simulated comparison it does no better than a quartic.
"""

import numpy as np

from core.arrays import FloatArray, IntArray, frozen_int
from core.errors import Note, Severity
from core.units import DEG_PER_RAD

_TELLING = 5.0


def corner_angles(y: FloatArray, spacing: float) -> FloatArray:
    """Angles (k-2,) at the middle of each three neighbouring points, degrees; (5) to (8).

    Parameters
    ----------
    y : (k,) block means
    spacing : horizontal distance of neighbours, sh * l in the source, in the unit of `y`

    Notes
    -----
    In (5) the printed "2ac" is right; the left side of (8), printed v, is c.
    """
    a2 = (y[1:-1] - y[2:]) ** 2 + spacing**2
    b2 = (y[:-2] - y[2:]) ** 2 + (2.0 * spacing) ** 2
    c2 = (y[:-2] - y[1:-1]) ** 2 + spacing**2
    cosine = (a2 + c2 - b2) / (2.0 * np.sqrt(a2 * c2))
    return np.arccos(np.clip(cosine, -1.0, 1.0)) * DEG_PER_RAD


def sharpest_knots(y: FloatArray, knots: int) -> IntArray:
    """Places of the first, the last and the sharpest inner points of one curve.

    Parameters
    ----------
    y : (k,) block means
    knots : how many in all, at least 2

    Notes
    -----
    The spacing, which the source adjusts to the ordinates without saying how, is their median
    step.
    """
    spacing = max(float(np.median(np.abs(np.diff(y)))), np.finfo(float).tiny)
    angles = corner_angles(y, spacing)
    inner = np.sort(np.argsort(angles, kind="stable")[: knots - 2] + 1)
    return frozen_int([0, *inner.tolist(), len(y) - 1])


def temperature_slopes(
    values: FloatArray, temperature: FloatArray, u_temperature: float
) -> tuple[FloatArray, tuple[Note, ...]]:
    """The source's coefficients d_i (1): change of the output over change of the temperature.

    Parameters
    ----------
    values : (p,) ordinates at the knots
    temperature : (p,) chip temperature at the knots
    u_temperature : standard uncertainty of one of them

    Returns
    -------
    slopes : (p-1,); NaN where the temperature changes by less than 5 uncertainties
    notes : which segments have none

    Notes
    -----
    The sum (2) of the differences (3) must start one step later than printed; it is then
    T(t_{i+1}) - T(t_i). On the plateau that ends every warm-up it vanishes, and (1) divides by
    it: there time must be the abscissa, as it is everywhere in `DriftTable`.
    """
    steps = np.diff(temperature)
    told = np.abs(steps) >= _TELLING * u_temperature
    told &= steps != 0
    slopes = np.full(len(steps), np.nan)
    slopes[told] = np.diff(values)[told] / steps[told]
    if told.all():
        return slopes, ()
    which = ", ".join(str(place + 1) for place in np.flatnonzero(~told))
    note = Note(
        Severity.WARNING,
        "temperature_plateau",
        f"segments {which}: the temperature changes by less than {_TELLING:g} times its"
        " uncertainty; the coefficient against temperature (1) is not defined there",
    )
    return slopes, (note,)
