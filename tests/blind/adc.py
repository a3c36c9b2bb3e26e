"""Electronics: limits, sampling noise and rounding, sample by sample, then the mean."""

import numpy as np

from tests.blind.world import World


def expected(values: np.ndarray, sigma: float, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Mean of clipped normal samples (rounding is dithered away by the noise)."""
    from scipy.special import ndtr

    def above(excess: np.ndarray) -> np.ndarray:
        excess = np.maximum(excess, -40.0)
        density = np.exp(-0.5 * excess**2) / np.sqrt(2.0 * np.pi)
        return sigma * (excess * ndtr(excess) + density)

    if not np.any(np.isfinite([low, high])):
        return values
    return values - above((values - high) / sigma) + above((low - values) / sigma)


def accumulated(
    world: World,
    values: np.ndarray,
    limits: tuple[np.ndarray, np.ndarray],
    samples: np.ndarray,
    rng: np.random.Generator,
) -> tuple[np.ndarray, np.ndarray]:
    """Means and their standard errors (n, c), output units.

    values : (n, c) in g or deg/s; limits : (c,) each; samples : (n,) per accumulation
    """
    sigma = world.levels.white * np.sqrt(samples.max())
    means, errors = np.empty_like(values), np.empty_like(values)
    low, high = limits
    for channel in range(values.shape[1]):
        step = world.lsb / abs(world.scale[channel])
        bounded = np.isfinite(low[channel]) or np.isfinite(high[channel])
        for row in range(len(values)):
            each = values[row, channel] + sigma * rng.standard_normal(samples[row])
            if bounded:
                each = np.clip(each, low[channel], high[channel])
            codes = np.rint(each / step)
            means[row, channel] = codes.mean() * step
            errors[row, channel] = codes.std(ddof=1) * step / np.sqrt(samples[row])
    return means, errors
