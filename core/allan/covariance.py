"""Exact covariances of the overlapping Allan variance, by Isserlis' theorem.

The second difference of phase s_k = x[k+2m] - 2 x[k+m] + x[k] is stationary for all five terms;
with its autocovariance R the mean of s^2 over M overlapping places has variance
2/M^2 sum (M-|j|) R(j)^2 (Greenhall and Riley 2003, eq. 7 with d = 2). Everything here is that sum,
so there is no small-m or large-m formula to choose between.

R follows from the generalised autocovariance of phase s(t) (t in samples of dt): white rate noise
-N^2 dt |t|/2, flicker B^2 dt^2 t^2 ln|t| / (2 pi), random walk K^2 dt^3 |t|^3 / 12, quantisation
Q^2 at t = 0.
"""

import math
from functools import lru_cache

import numpy as np

from core.allan.model import NoiseModel
from core.arrays import FloatArray, IntArray, frozen

NODES = 32
"""Lags per averaging time in the sum, where the averaging time has more samples than that."""
REACH = 50.0
"""Averaging times after which the correlation is dropped: flicker's tail is below 1e-6 there."""
SECOND = (1.0, -2.0, 1.0)
FOURTH = (1.0, -4.0, 6.0, -4.0, 1.0)
BY_TERM = ("random_walk", "bias_instability", "rate_random_walk")
QUANTIZATION_LAGS = ((0, 1.0), (1, -2.0 / 3.0), (2, 1.0 / 6.0))
"""(lag / m, correlation) of the second differences of white phase noise, one side."""


def _square_log(t: FloatArray) -> FloatArray:
    square = t * t
    return square * np.log(np.where(square > 0.0, square, 1.0)) * 0.5


@lru_cache(maxsize=2 * NODES)
def _correlations(nodes: int) -> tuple[FloatArray, FloatArray]:
    """Return lags u (in averaging times) and the (3, len(u)) correlations of BY_TERM at them."""
    u = np.arange(0.0, REACH, 1.0 / nodes)
    rows = np.zeros((3, len(u)))
    for weight, shift in zip(FOURTH, (-2.0, -1.0, 0.0, 1.0, 2.0), strict=True):
        t = np.abs(u + shift)
        rows[0] -= weight * t / 4.0
        rows[1] += weight * _square_log(t) / (8.0 * np.log(2.0))
        rows[2] += weight * t**3 / 8.0
    rows[0, u >= 2.0] = 0.0
    rows[2, u >= 2.0] = 0.0
    return frozen(u), frozen(rows)


def degrees_of_freedom(shares: FloatArray, m: int, pairs: int) -> float:
    """Return the equivalent degrees of freedom of one overlapping Allan variance.

    Parameters
    ----------
    shares : (5,) of the variance: random_walk, bias_instability, rate_random_walk, quantization,
        rate_ramp; their sum is 1
    m : averaging factor
    pairs : number of overlapping second differences M; where these come from several stretches
        their sum gives a lower bound of the degrees of freedom

    Returns
    -------
    float
        2 E^2 / Var of the estimate. A ramp adds the cross term of a mean; it is no noise.
    """
    nodes = min(m, NODES)
    u, rows = _correlations(nodes)
    left = pairs - u * m
    last = int(np.searchsorted(-left, 0.0))
    left = left[:last]
    rho = shares[:3] @ rows[:, :last]
    ramp = float(shares[4])
    terms = left * rho * (rho + 2.0 * ramp)
    total = (2.0 * float(terms.sum()) - float(terms[0])) * (m / nodes)
    quantization = float(shares[3])
    if quantization > 0.0:
        for lag, correlation in QUANTIZATION_LAGS:
            if pairs > lag * m:
                spike = quantization * correlation
                smooth = float(rho[lag * nodes])
                sides = 2.0 if lag else 1.0
                total += sides * (pairs - lag * m) * spike * (spike + 2.0 * smooth + 2.0 * ramp)
    return pairs * pairs / total


def _smooth_autocovariance(model: NoiseModel, t: FloatArray, dt: float) -> FloatArray:
    """Return s(t) of phase without white and walk, which need their own cut-off."""
    return (model.bias_instability * dt) ** 2 / (2.0 * np.pi) * _square_log(t)


def _cross(model: NoiseModel, j: FloatArray, m1: int, m2: int, dt: float) -> FloatArray:
    """Return the covariance of a second difference over m1 with one over m2 that starts j later."""
    near = np.zeros_like(j)
    far = np.zeros_like(j)
    for a, first in enumerate(SECOND):
        for b, second in enumerate(SECOND):
            t = np.abs(j + (b * m2 - a * m1))
            weight = first * second
            near += weight * (
                -0.5 * model.random_walk**2 * dt * t
                + model.rate_random_walk**2 * dt**3 / 12.0 * t**3
            )
            far += weight * _smooth_autocovariance(model, t, dt)
    # Polynomials cancel exactly where the two windows do not touch; in floating point they leave
    # rounding noise there.
    near[(j <= -2.0 * m2) | (j >= 2.0 * m1)] = 0.0
    return near + far


def _nodes(m1: int, m2: int) -> FloatArray:
    """Return integer lags for the sum: dense about the nine kinks, then in geometric steps."""
    steps = np.concatenate(
        (
            np.arange(0.0, 2.0, 0.0625),
            2.0 * 1.25 ** np.arange(math.ceil(math.log(15.0 * m2 / m1) / math.log(1.25))),
        )
    )
    steps = m1 * np.concatenate((-steps, steps))
    kinks = np.array([a * m1 - b * m2 for a in range(3) for b in range(3)], dtype=np.float64)
    return np.unique(np.rint(kinks[:, np.newaxis] + steps[np.newaxis, :]))


def variance_covariance(model: NoiseModel, m: IntArray, pairs: IntArray, dt: float) -> FloatArray:
    """Return the covariance matrix of overlapping Allan variances at several taus.

    Parameters
    ----------
    model : the noise; a ramp in it does not contribute
    m : (t,) averaging factors, increasing
    pairs : (t,) overlapping second differences at each
    dt : sampling interval, s

    Returns
    -------
    (t, t)
        Symmetric; the sums over lags are taken by the trapezoidal rule on graded nodes, within
        0.5 % of the full sums.
    """
    count = len(m)
    result = np.empty((count, count))
    for first in range(count):
        for second in range(first, count):
            result[first, second] = result[second, first] = _pair(
                model, (int(m[first]), int(m[second])), (int(pairs[first]), int(pairs[second])), dt
            )
    tau = m * dt
    return result / (2.0 * np.outer(tau, tau) ** 2)


def _pair(model: NoiseModel, m: tuple[int, int], pairs: tuple[int, int], dt: float) -> float:
    """Return sum over lags of (places with this lag) C(lag)^2, over the product of places."""
    m1, m2 = m
    places1, places2 = pairs
    j = _nodes(m1, m2)
    j = j[(j > -places1) & (j < places2)]
    count = np.minimum(places1, places2 - j) - np.maximum(0.0, -j)
    c = _cross(model, j, m1, m2, dt)
    spacing = np.gradient(j) if len(j) > 1 else np.ones(1)
    spacing[0] = 0.5 * (spacing[0] + 1.0)
    spacing[-1] = 0.5 * (spacing[-1] + 1.0)
    total = float((count * c * c * spacing).sum())
    if model.quantization > 0.0:
        total += _spikes(model, j, c, count, m)
    return total / (places1 * places2)


def _spikes(
    model: NoiseModel, j: FloatArray, c: FloatArray, count: FloatArray, m: tuple[int, int]
) -> float:
    """Return what quantisation noise adds to the sum of _pair: it lives at nine lags only."""
    spikes: dict[int, float] = {}
    for a, first in enumerate(SECOND):
        for b, second in enumerate(SECOND):
            lag = a * m[0] - b * m[1]
            spikes[lag] = spikes.get(lag, 0.0) + first * second * model.quantization**2
    total = 0.0
    for lag, spike in spikes.items():
        at = int(np.searchsorted(j, lag))
        if at < len(j) and int(j[at]) == lag:
            total += float(count[at]) * spike * (spike + 2.0 * float(c[at]))
    return total
