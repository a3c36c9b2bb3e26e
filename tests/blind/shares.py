"""Shares with their Wilson intervals, and how likely a true share fails a limit by chance."""

import math

from tests.blind.scoring import Z95


def wilson(hits: int, trials: int, z: float = Z95) -> tuple[float, float]:
    """Interval of a share (Wilson 1927)."""
    if trials == 0:
        return 0.0, 1.0
    p, n = hits / trials, float(trials)
    centre = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z / (1 + z * z / n) * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return max(centre - half, 0.0), min(centre + half, 1.0)


def at_most(hits: int, trials: int, p: float) -> float:
    """Probability of `hits` or fewer."""
    return sum(math.comb(trials, k) * p**k * (1 - p) ** (trials - k) for k in range(hits + 1))


def most_allowed(trials: int, p: float, risk: float) -> int:
    """Smallest number of failures that a share `p` exceeds with no more than `risk`."""
    return next(k for k in range(trials + 1) if 1.0 - at_most(k, trials, p) <= risk)
