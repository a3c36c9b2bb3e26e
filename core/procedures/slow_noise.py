"""What noise with memory does to a combination of accumulations made one after another.

White noise averages out; flicker and random walk do not, and neighbouring accumulations share
them. A combination whose weights sum to zero (a difference of headings, a scale factor) is blind
to what all share, so its variance is finite and follows from the noise coefficients exactly, by
the generalised covariance of the integrated output (two-sided densities of (6.3))::

    white N: -N^2 |t| / 2      flicker B: B^2 t^2 ln|t| / (2 pi)      walk K: K^2 |t|^3 / 12

A combination whose weights sum to one (a bias) is taken against the mean of the session, which is
all that "the" bias can mean for noise without a mean.
"""

from typing import Protocol

import numpy as np

from core.arrays import FloatArray


class RateNoise(Protocol):
    """Noise coefficients, e.g. a `core.allan.model.NoiseModel`; u is the unit of the output."""

    @property
    def random_walk(self) -> float:
        """N, u sqrt(s)."""
        ...

    @property
    def bias_instability(self) -> float:
        """B, u."""
        ...

    @property
    def rate_random_walk(self) -> float:
        """K, u / sqrt(s)."""
        ...


def combined_covariance(
    noise: RateNoise, weights: FloatArray, starts_s: FloatArray, lengths_s: FloatArray
) -> FloatArray:
    """Covariance (q, q) of combinations of accumulations.

    Parameters
    ----------
    noise : coefficients of the sensor
    weights : (q, n) weight of each accumulation in each combination
    starts_s, lengths_s : (n,) when the accumulations begin and how long they last; they do not
        overlap
    """
    covariance = (weights / lengths_s) @ weights.T * noise.random_walk**2
    if not (noise.bias_instability or noise.rate_random_walk):
        return covariance
    first, last = starts_s.min(), (starts_s + lengths_s).max()
    starts, ends = np.append(starts_s, first), np.append(starts_s + lengths_s, last)
    all_weights = np.hstack([weights, -weights.sum(axis=1, keepdims=True)])
    # The mean over a window is the increment of the integral over its length.
    by_length = all_weights / (ends - starts)
    at = np.concatenate([ends, starts])
    on_integral = np.hstack([by_length, -by_length])
    t = np.abs(at[:, None] - at[None, :])
    logarithm = np.log(np.where(t > 0, t, 1.0))
    kernel = noise.bias_instability**2 * t**2 * logarithm / (2.0 * np.pi)
    kernel += noise.rate_random_walk**2 * t**3 / 12.0
    return covariance + on_integral @ kernel @ on_integral.T


def in_turn(count: int, length_s: float, pause_s: float) -> tuple[FloatArray, FloatArray]:
    """Starts and lengths (n,) of equal accumulations with a pause before each."""
    starts: FloatArray = np.arange(count, dtype=np.float64) * (length_s + pause_s) + pause_s
    return starts, np.full(count, length_s, dtype=np.float64)
