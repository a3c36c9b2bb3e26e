"""How well one point of an Allan curve is known.

The estimate of a variance with e equivalent degrees of freedom scatters like chi-square/e. e
depends on the kind of noise: it is identified from the slope of the curve, or taken from a fitted
model. The lag-1 autocorrelation that frequency standards use is biased for block-averaged
flicker and random walk of rate, so the slope is used here.
"""

import math
from collections.abc import Sequence

import numpy as np

from core.allan.covariance import degrees_of_freedom
from core.allan.model import TERMS, NoiseModel
from core.arrays import FloatArray, IntArray, frozen

SPAN = 1.5
"""The local slope is taken from tau/1.5 to 1.5 tau."""
SHARES = ("random_walk", "bias_instability", "rate_random_walk", "quantization", "rate_ramp")
CERTAIN = 100.0
"""Averages in the record from which the slope always tells the kind of noise."""
TRUSTED = 20.0
"""Averages in the record below which it does not tell it at all."""
ONE_SIGMA = 0.6826894921370859


def local_slopes(taus: FloatArray, deviation: FloatArray) -> FloatArray:
    """Return d log(deviation) / d log(tau), by least squares over a factor 1.5 to either side.

    Parameters
    ----------
    taus : (t,) s, increasing; t >= 2
    deviation : (t,)

    Returns
    -------
    (t,)
        Where the grid is too coarse for that span the two neighbours are used.
    """
    x, y = np.log(taus), np.log(deviation)
    reach = math.log(SPAN) * (1.0 + 1e-9)
    count = len(x)
    low: list[int] = np.searchsorted(x, x - reach).tolist()
    high: list[int] = np.searchsorted(x, x + reach, side="right").tolist()
    slopes = np.empty_like(x)
    for at in range(count):
        start = min(low[at], max(at - 1, 0))
        stop = max(high[at], min(at + 2, count))
        from_mean = x[start:stop] - x[start:stop].mean()
        slopes[at] = (from_mean @ y[start:stop]) / (from_mean @ from_mean)
    return slopes


def noise_types(taus: FloatArray, deviation: FloatArray, m: IntArray, n: int) -> tuple[str, ...]:
    """Name the term that dominates at each tau, from the local slope of the curve.

    Parameters
    ----------
    taus, deviation, m : (t,) the curve
    n : samples in the record

    Returns
    -------
    (t,) keys of TERMS
        Below 100 averages a type may only give way to one that rises faster with tau, since the
        slope of any sum of the terms grows (a chance dip is not quantisation noise); below 20
        averages the last type is kept.
    """
    by_slope = sorted(TERMS, key=lambda name: TERMS[name].power)
    if len(taus) < 2:
        return ("random_walk",) * len(taus)
    nearest = np.clip(np.rint(2.0 * local_slopes(taus, deviation)) + 2.0, 0.0, 4.0)
    places: list[int] = nearest.astype(np.int64).tolist()
    averages: list[float] = (n / m).tolist()
    for at in range(1, len(places)):
        if averages[at] < TRUSTED:
            places[at] = places[at - 1]
        elif averages[at] < CERTAIN:
            places[at] = max(places[at], places[at - 1])
    return tuple(by_slope[place] for place in places)


def edf_of_types(types: Sequence[str], m: IntArray, pairs: IntArray) -> FloatArray:
    """Return (t,) degrees of freedom where one term dominates at each tau.

    A ramp is treated as the random walk of rate it is taken for.
    """
    edf = np.empty(len(m))
    for at, name in enumerate(types):
        shares = np.zeros(5)
        shares[SHARES.index(name if name != "rate_ramp" else "rate_random_walk")] = 1.0
        edf[at] = degrees_of_freedom(shares, int(m[at]), int(pairs[at]))
    return edf


def edf_of_model(model: NoiseModel, m: IntArray, pairs: IntArray, rate: float) -> FloatArray:
    """Return (t,) composite degrees of freedom under a fitted model."""
    taus = m / rate
    parts = np.stack([model.part(name, taus) for name in SHARES], axis=1)
    parts /= parts.sum(axis=1, keepdims=True)
    return np.array(
        [degrees_of_freedom(parts[at], int(m[at]), int(pairs[at])) for at in range(len(m))]
    )


def interval(
    deviation: FloatArray, edf: FloatArray, level: float = ONE_SIGMA
) -> tuple[FloatArray, FloatArray]:
    """Return the two-sided chi-square confidence limits of Allan deviations.

    Parameters
    ----------
    deviation, edf : (t,)
    level : confidence level; 0.683 as frequency analysts print it unless told otherwise

    Returns
    -------
    lower, upper : (t,)
    """
    from scipy.special import chdtri

    tail = 0.5 * (1.0 - level)
    variance = edf * deviation**2
    lower = np.sqrt(variance / chdtri(edf, tail))
    upper = np.sqrt(variance / chdtri(edf, 1.0 - tail))
    return frozen(lower), frozen(upper)
