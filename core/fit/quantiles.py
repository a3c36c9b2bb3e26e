"""Student t, chi-square and F.

scipy.special costs a fifth of a second to import and is wanted only when data are processed, so
it is imported at the first call.
"""

import math
from functools import lru_cache

from core.arrays import FloatArray


@lru_cache(maxsize=256)
def student_t(level: float, dof: float) -> float:
    """Two-sided coverage factor at `level` for `dof` degrees of freedom (inf: normal).

    No degrees of freedom give an infinite factor: such an estimate has no interval.
    """
    from scipy import special

    if dof <= 0:
        return math.inf
    upper = 0.5 + level / 2.0
    return float(special.ndtri(upper) if math.isinf(dof) else special.stdtrit(dof, upper))


def normal_cdf(values: FloatArray) -> FloatArray:
    """Probability of a standard normal below each of `values`."""
    from scipy import special

    return special.ndtr(values)


def student_t_dof(factor: float) -> float:
    """Degrees of freedom whose two-sided 95 % coverage factor is `factor`; inf below 1.96."""
    from scipy import special

    if factor <= special.ndtri(0.975):
        return math.inf
    return float(special.stdtridf(0.975, factor))


def chi2_sf(value: float, dof: float) -> float:
    """Probability of a chi-square above `value`."""
    from scipy import special

    return float(special.chdtrc(dof, value))


def f_sf(value: float, dof_numerator: float, dof_denominator: float) -> float:
    """Probability of an F above `value`."""
    from scipy import special

    return float(special.fdtrc(dof_numerator, dof_denominator, value))
