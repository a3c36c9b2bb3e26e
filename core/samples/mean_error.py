"""The standard error of a mean of correlated samples.

Sensor noise is correlated by filters and by slow drift, so s / sqrt(n) is too small. The samples
are whitened by an autoregression whose order grows with the evidence; the long-run variance is
that of the whitened samples over the squared gain of the filter (Parzen 1974; Berk 1974). A weak
slow component hides from that under white noise, so the same is done with means of 4, 16, ...
samples, and the coarser answer is taken where it is significantly larger.
"""

from collections.abc import Sequence

import numpy as np

from core.arrays import FloatArray

_MAX_ORDER = 12
_COARSER = 4
_FEWEST = 24
_SIGNIFICANT = 1.645
"""One-sided 5 %: missing a slow component costs more than a wider interval."""
_ROUNDING_SD = 1.0 / np.sqrt(12.0)


def standard_error(
    data: FloatArray, integer_codes: Sequence[bool]
) -> tuple[FloatArray, FloatArray]:
    """Standard error of the mean of each column and its effective degrees of freedom.

    Parameters
    ----------
    data : (n, c) equally spaced samples, n >= 16; single gaps matter little
    integer_codes : (c,) whether a column is in ADC codes: rounding to one code is then a floor
        of the error where the noise is too small to dither it

    Returns
    -------
    se, dof : (c,) each
    """
    c = data.shape[1]
    se, dof = np.empty(c), np.empty(c)
    for column in range(c):
        x = data[:, column] - data[:, column].mean()
        # The mean of equal numbers need not be that number, to the last bit.
        x = x if np.ptp(data[:, column]) > 0.0 else np.zeros_like(x)
        variance, dof[column] = _over_scales(x)
        error = np.sqrt(variance)
        if integer_codes[column] and x.std() < 0.5 and np.all(data[:, column] % 1.0 == 0.0):
            error = np.hypot(error, _ROUNDING_SD)
        se[column] = error
    return se, dof


def _over_scales(x: FloatArray) -> tuple[float, float]:
    """Variance of the mean and its degrees of freedom, from the finest scale that suffices."""
    variance, dof = _of_scale(x)
    while len(x) // _COARSER >= _FEWEST:
        kept = len(x) // _COARSER * _COARSER
        x = x[:kept].reshape(-1, _COARSER).mean(axis=1)
        coarse, coarse_dof = _of_scale(x - x.mean())
        if coarse > variance * np.exp(_SIGNIFICANT * np.sqrt(2.0 / dof + 2.0 / coarse_dof)):
            variance, dof = coarse, coarse_dof
    return variance, dof


def _of_scale(x: FloatArray) -> tuple[float, float]:
    """Variance of the mean of a zero-mean series and its degrees of freedom."""
    n = len(x)
    orders = min(_MAX_ORDER, n // 8)
    covariance = np.array([x[: n - lag] @ x[lag:] for lag in range(orders + 1)]) / (n - 1)
    if covariance[0] <= 0.0:
        return 0.0, float(n - 1)
    # Levinson-Durbin: all orders in one pass; the order is chosen by the Bayes criterion.
    phi = np.zeros(0)
    error = float(covariance[0])
    best = (np.log(error), error, 0)
    for order in range(1, orders + 1):
        reflection = (covariance[order] - phi @ covariance[order - 1 : 0 : -1]) / error
        phi = np.append(phi - reflection * phi[::-1], reflection)
        error *= 1.0 - float(reflection) ** 2
        if error <= 0.0:
            break
        score = np.log(error) + order * np.log(n) / n
        if score < best[0]:
            best = (score, error / (1.0 - float(phi.sum())) ** 2, order)
    _, variance, order = best
    return variance / n, max((n - order - 1) / (2.0 * order + 1.0), 1.0)
