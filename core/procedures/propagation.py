"""Uncertainty of what is computed from fitted parameters.

The linear rule (GUM, 5.1.2) with numerical slopes, and propagation of distributions (GUM,
Supplement 1) where it fails: an angle from two small amplitudes, a ratio over a small number.
Below five standard uncertainties the linear rule gives intervals of the wrong size and place.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray

TRIALS = 20_000
_SEED = 20_080_923
_STEP = 1e-6


@dataclass(frozen=True, slots=True)
class Spread:
    """A quantity with an interval that need not be symmetric.

    Parameters
    ----------
    value : at the estimates
    u : standard uncertainty, k = 1
    low, high : limits of the 95 % coverage interval, by equal tails
    unit : of all four
    """

    value: float
    u: float
    low: float
    high: float
    unit: str


def jacobian(
    function: Callable[[FloatArray], FloatArray], values: FloatArray, scale: FloatArray
) -> FloatArray:
    """Slopes (q, p) of q results against p parameters, by central differences.

    Parameters
    ----------
    function : (p,) -> (q,), smooth
    values : (p,) where
    scale : (p,) size over which the function changes noticeably; a millionth of it is the step
    """
    steps = _STEP * scale
    columns = [
        (function(values + step) - function(values - step)) / (2.0 * size)
        for step, size in zip(np.diag(steps), steps, strict=True)
    ]
    return np.column_stack(columns)


def draws_of(values: FloatArray, covariance: FloatArray, dof: float) -> FloatArray:
    """Random parameters (TRIALS, p), the same ones each time.

    Parameters
    ----------
    values : (p,) estimates
    covariance : (p, p) their covariance, k = 1
    dof : degrees of freedom of the covariance; inf draws from the normal distribution, else from
        the multivariate t (GUM-S1, 6.4.9)
    """
    rng = np.random.default_rng(_SEED)
    eigenvalues, vectors = np.linalg.eigh(covariance)
    root = vectors * np.sqrt(np.maximum(eigenvalues, 0.0))
    away = rng.standard_normal((TRIALS, len(values))) @ root.T
    if np.isfinite(dof):
        away *= np.sqrt(dof / rng.chisquare(dof, TRIALS))[:, None]
    return values + away


def spread_of(value: float, draws: FloatArray, unit: str) -> Spread:
    """The spread of one quantity from its draws (n,)."""
    low, high = np.percentile(draws, [2.5, 97.5])
    return Spread(value, float(draws.std()), float(low), float(high), unit)
