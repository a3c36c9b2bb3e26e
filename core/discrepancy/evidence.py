"""How much better a hypothesis explains whitened residuals than nothing does.

All evidence is the natural logarithm of a Bayes factor, free of units: the size of an effect has
a mixture of g-priors (Zellner 1986; Liang et al. 2008), the level of the noise a Student form, so
that a misjudged level does no great harm.
"""

import numpy as np
from numpy.typing import ArrayLike

from core.arrays import FloatArray

_G = np.array([16.0, 64.0, 256.0, 1024.0, 4096.0, 65536.0])
_SHARES = 1.0 - np.exp(-np.linspace(0.0, 9.0, 1500))
_AMPLITUDES = np.geomspace(0.5, 64.0, 8)


def block_evidence(
    explained: ArrayLike, parameters: ArrayLike, rss: ArrayLike, prior: float, dof: float
) -> FloatArray:
    """Evidence of columns.

    Parameters
    ----------
    explained : sum of squares that they take away
    parameters : how many they are
    rss : sum of squares without them
    prior : degrees of freedom behind the level of the noise
    dof : of `rss`
    """
    share = np.asarray(explained) / (prior + np.asarray(rss))
    p = np.asarray(parameters)[..., None]
    left = np.maximum(1.0 - _G / (1.0 + _G) * share[..., None], 1e-12)
    each = -0.5 * p * np.log1p(_G) - 0.5 * (prior + dof) * np.log(left)
    return log_mean(each, axis=-1)


def many_block_evidence(
    explained: FloatArray, parameters: FloatArray, rss: FloatArray, prior: float, dof: float
) -> FloatArray:
    """The same for many residuals (m, k) at once, by a table of the explained share.

    Parameters
    ----------
    explained : (m, k)
    parameters : (m,)
    rss : (k,)
    """
    share = np.minimum(explained / (prior + rss), _SHARES[-1])
    found = np.empty_like(share)
    for count in np.unique(parameters):
        own = parameters == count
        table = block_evidence(_SHARES, np.full(len(_SHARES), count), 1.0, 0.0, prior + dof)
        found[own] = np.interp(share[own], _SHARES, table)
    return found


def relabel_evidence(rss_after: ArrayLike, rss: float, prior: float, dof: float) -> FloatArray:
    """Evidence of a hypothesis without parameters that leaves another sum of squares."""
    ratio = (prior + np.asarray(rss_after)) / (prior + rss)
    return -0.5 * (prior + dof) * np.log(np.maximum(ratio, 1e-12))


def curve_evidence(
    coefficients: FloatArray, sizes: FloatArray, rss: ArrayLike, prior: float, dof: float
) -> FloatArray:
    """Evidence of an unknown smooth curve.

    Parameters
    ----------
    coefficients : (q,) or (q, m) residual along the principal directions of its basis
    sizes : (q,) how strongly a curve of unit amplitude excites each
    """
    squared = np.atleast_2d(coefficients.T).T ** 2
    e = (_AMPLITUDES[:, None] * sizes[None, :]) ** 2
    penalty = -0.5 * np.log1p(e).sum(axis=1)
    explained = (e / (1.0 + e)) @ squared
    share = explained / (prior + np.asarray(rss))
    each = penalty[:, None] - 0.5 * (prior + dof) * np.log(np.maximum(1.0 - share, 1e-12))
    found = log_mean(each, axis=0)
    return found if coefficients.ndim > 1 else found[0]


def log_mean(values: FloatArray, axis: int) -> FloatArray:
    """Logarithm of the mean of the exponentials."""
    top = np.max(values, axis=axis, keepdims=True)
    mean = np.mean(np.exp(values - top), axis=axis)
    return np.log(mean) + np.squeeze(top, axis=axis)
