"""Non-negative least squares of (6.4) on the Allan variance.

The weights edf / (2 sigma^4) come from the fitted model, not from the data (a point that is low by
chance would weigh too much), so the fit is iterated. The points of an overlapping curve are
strongly correlated: intervals from the fit's own covariance cover 70 % where 95 % is meant. They
are taken from the full covariance of the points instead ("sandwich").
"""

from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from core.allan.confidence import edf_of_model
from core.allan.covariance import variance_covariance
from core.allan.curve import AllanCurve
from core.allan.model import NoiseModel, from_squares, variance_columns
from core.arrays import FloatArray, IntArray
from core.errors import FitError

POINTS = 24
ITERATIONS = 8


@dataclass(frozen=True, slots=True, eq=False)
class VarianceFit:
    """Terms fitted to an Allan curve.

    Parameters
    ----------
    terms : (p,) keys of TERMS
    squares : (p,) squared coefficients, none negative
    covariance : (p, p) of the squares, as if they were free to be negative
    taus : (t,) the points used, s
    """

    terms: tuple[str, ...]
    squares: FloatArray
    covariance: FloatArray
    taus: FloatArray

    @property
    def model(self) -> NoiseModel:
        """The fitted model."""
        return from_squares(self.terms, self.squares)


def fit_variance(curve: AllanCurve, terms: tuple[str, ...], shortest: float = 0.0) -> VarianceFit:
    """Fit terms to the Allan variance.

    Parameters
    ----------
    curve : the curve
    terms : keys of TERMS
    shortest : s; points below it are left out (5 / bandwidth of the sensor)

    Raises
    ------
    FitError
        Fewer points than terms in the range.
    """
    chosen = _thinned(curve, shortest)
    if len(chosen) <= len(terms):
        raise FitError(
            f"{len(chosen)} points of the Allan curve lie between {shortest:.4g} s and a third of "
            f"the record; {len(terms)} terms need more: record longer"
        )
    m, pairs = curve.m[chosen], curve.pairs[chosen]
    taus, variance = curve.taus[chosen], curve.variance[chosen]
    columns = variance_columns(terms, taus)
    weights = curve.edf[chosen] / (2.0 * variance**2)
    squares = np.zeros(len(terms))
    for _ in range(ITERATIONS):
        squares = _solve(columns, variance, weights)
        model = from_squares(terms, squares)
        edf = edf_of_model(model, m, pairs, curve.rate)
        weights = edf / (2.0 * model.variance(taus) ** 2)
    covariance = _sandwich(columns, weights, from_squares(terms, squares), m, pairs, curve.rate)
    return VarianceFit(terms, squares, covariance, taus)


def _thinned(curve: AllanCurve, shortest: float) -> IntArray:
    """Return at most POINTS indices of the curve, evenly in log tau."""
    inside = np.flatnonzero(curve.taus >= shortest * (1.0 - 1e-9))
    if len(inside) <= POINTS:
        return inside
    x = np.log(curve.taus[inside])
    wanted = np.linspace(float(x[0]), float(x[-1]), POINTS)
    nearest = np.abs(x[:, np.newaxis] - wanted[np.newaxis, :]).argmin(axis=0)
    return inside[np.unique(nearest)]


def _solve(columns: FloatArray, variance: FloatArray, weights: FloatArray) -> FloatArray:
    from scipy.optimize import nnls

    root = np.sqrt(weights)
    design = columns * root[:, np.newaxis]
    scale = np.sqrt((design * design).sum(axis=0))
    solved = cast(tuple[Any, float], nnls(design / scale, variance * root))
    return np.asarray(solved[0], dtype=np.float64) / scale


def _sandwich(
    columns: FloatArray,
    weights: FloatArray,
    model: NoiseModel,
    m: IntArray,
    pairs: IntArray,
    rate: float,
) -> FloatArray:
    scale = np.sqrt((columns**2 * weights[:, np.newaxis]).sum(axis=0))
    design = columns / scale
    weighted = design * weights[:, np.newaxis]
    gain: FloatArray = np.asarray(np.linalg.inv(design.T @ weighted), dtype=np.float64)
    gain = gain @ weighted.T / scale[:, np.newaxis]
    return gain @ variance_covariance(model, m, pairs, 1.0 / rate) @ gain.T
