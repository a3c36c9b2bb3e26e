"""The common scatter of rows that brought no standard error of their own.

The rows share one unknown variance s^2 beside their stated setting variances v. The residuals say
something about s^2, but little when degrees of freedom are few, and a point estimate of it gives
intervals that miss (measured: 80 % where 95 % is meant, for a table whose error grows with the
rate). So s^2 is integrated out: its restricted likelihood times the density tr(P), P the
precision left after the fit, which is the scale-invariant 1/s^2 wherever v vanishes and gives
Student t exactly there.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.fit.quantiles import normal_cdf

_LEVEL = 0.95
_POINTS = 33
_DECADES = (-8.0, 6.0)
_COUNTS = 1e-7
"""Share of the largest posterior weight below which a value of s^2 no longer counts."""


@dataclass(frozen=True, slots=True, eq=False)
class Scatter:
    """What the rows say about their common variance.

    Parameters
    ----------
    variance : (n,) variance of each row, the inverse of its mean precision
    weights : (g,) posterior probabilities of the grid of values of s^2
    centres : (g, p) parameters at each of them, less those of equal weights
    spread : (g, p) their standard uncertainties at each of them
    offset : (p,) parameters at `variance`, less those of equal weights
    """

    variance: FloatArray
    weights: FloatArray
    centres: FloatArray
    spread: FloatArray
    offset: FloatArray

    def half_widths(self) -> FloatArray:
        """Half widths (p,) of the 95 % intervals around the parameters at `variance`."""
        away = self.centres - self.offset
        weights = self.weights[:, None]
        width = self.spread.min(axis=0)
        # The covered probability is concave in the width, so Newton's steps come from below.
        for _ in range(60):
            above, below = (width - away) / self.spread, (-width - away) / self.spread
            inside = normal_cdf(above) - normal_cdf(below)
            density = np.exp(-(above**2) / 2.0) + np.exp(-(below**2) / 2.0)
            slope = np.sum(weights * density / self.spread, axis=0) / np.sqrt(2.0 * np.pi)
            step = (_LEVEL - np.sum(weights * inside, axis=0)) / slope
            width = width + step
            if np.all(np.abs(step) < 1e-9 * width):
                break
        return width


def common_scatter(design: FloatArray, y: FloatArray, setting: FloatArray) -> Scatter:
    """Estimate the common variance beside the setting variances.

    Parameters
    ----------
    design : (n, p) of full rank, n > p
    y : (n,) measured
    setting : (n,) stated variance of the settings, not all zero
    """
    n, p = design.shape
    q, r = np.linalg.qr(design)
    residual = y - q @ (q.T @ y)
    residual = residual - q @ (q.T @ residual)
    scale = max(float(residual @ residual) / (n - p), rounding_variance(y))
    low, high = (math.log(scale) + math.log(10.0) * decades for decades in _DECADES)
    while True:
        grid = np.linspace(low, high, _POINTS)
        precision, centres, covariance, score = _at(np.exp(grid), q, residual, setting)
        score = score + grid  # the grid is even in log s^2
        score = score - score.max()
        live = np.flatnonzero(score > np.log(_COUNTS))
        if live.size >= _POINTS // 2:
            break
        low = float(grid[max(int(live[0]) - 1, 0)])
        high = float(grid[min(int(live[-1]) + 1, _POINTS - 1)])
    weights = np.exp(score)
    weights /= weights.sum()
    variance = 1.0 / (weights @ precision)
    to_parameters = np.linalg.inv(r)
    _, offset, _, _ = _at(np.zeros(1), q, residual, variance)
    spread = np.sqrt(np.einsum("ja,gab,jb->gj", to_parameters, covariance, to_parameters))
    return Scatter(
        variance, weights, centres @ to_parameters.T, spread, offset[0] @ to_parameters.T
    )


def rounding_variance(y: FloatArray) -> float:
    """Variance below which residuals are the rounding of the arithmetic."""
    return float(np.spacing(np.abs(y).max())) ** 2


def _at(
    common: FloatArray, q: FloatArray, residual: FloatArray, setting: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Precisions (g, n), solution (g, p), its covariance (g, p, p) and log posterior (g,)."""
    precision = 1.0 / (setting + common[:, None])
    weighted = precision[:, :, None] * q
    covariance = np.asarray(np.linalg.inv(np.swapaxes(weighted, 1, 2) @ q), dtype=np.float64)
    moment = np.swapaxes(weighted, 1, 2) @ residual
    centres: FloatArray = (covariance @ moment[:, :, None])[:, :, 0]
    left = residual - centres @ q.T
    chi2 = np.sum(precision * left**2, axis=1)
    log_det = np.log(precision).sum(axis=1) + np.linalg.slogdet(covariance)[1]
    squares = np.swapaxes(weighted, 1, 2) @ weighted
    trace = precision.sum(axis=1) - np.sum(covariance * squares, axis=(1, 2))
    return precision, centres, covariance, (log_det - chi2) / 2.0 + np.log(trace)
