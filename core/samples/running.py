"""Mean and standard deviation of every channel while samples come: of all, and of the last second.

Blocks are merged about their means (Chan, Golub, LeVeque 1979): a plain sum of squares would lose
the scatter of one code on an output of millions.
"""

from collections import deque
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen


@dataclass(frozen=True, slots=True, eq=False)
class Moments:
    """What is known of the channels.

    Parameters
    ----------
    n : number of samples
    last : (c,) the newest sample; NaN before the first
    mean, std : (c,) mean, and standard deviation with n - 1; NaN where n does not allow them
    low, high : (c,) extremes
    """

    n: int
    last: FloatArray
    mean: FloatArray
    std: FloatArray
    low: FloatArray
    high: FloatArray


class RunningMoments:
    """Moments of all samples since the start, in constant memory.

    Parameters
    ----------
    channels : number of them
    """

    def __init__(self, channels: int) -> None:
        self._n = 0
        self._last = np.full(channels, np.nan)
        self._mean = np.zeros(channels)
        self._squares = np.zeros(channels)
        self._low = np.full(channels, np.inf)
        self._high = np.full(channels, -np.inf)

    def feed(self, data: FloatArray) -> None:
        """Take samples (n, c)."""
        n = len(data)
        if not n:
            return
        mean = data.mean(axis=0)
        squares = ((data - mean) ** 2).sum(axis=0)
        together = self._n + n
        step = mean - self._mean
        self._squares += squares + step**2 * (self._n * n / together)
        self._mean += step * (n / together)
        self._n = together
        self._last = data[-1].copy()
        self._low = np.minimum(self._low, data.min(axis=0))
        self._high = np.maximum(self._high, data.max(axis=0))

    @property
    def moments(self) -> Moments:
        """Moments so far."""
        unknown = np.full_like(self._mean, np.nan)
        some = self._n > 0
        return Moments(
            self._n,
            frozen(self._last),
            frozen(self._mean if some else unknown),
            frozen(np.sqrt(self._squares / (self._n - 1)) if self._n > 1 else unknown),
            frozen(self._low if some else unknown),
            frozen(self._high if some else unknown),
        )


class LatestMoments:
    """Moments of the newest samples.

    Parameters
    ----------
    wanted : how many of them
    channels : number of channels
    """

    def __init__(self, wanted: int, channels: int) -> None:
        self._wanted = max(2, wanted)
        self._channels = channels
        self._blocks: deque[FloatArray] = deque()
        self._count = 0

    def feed(self, data: FloatArray) -> None:
        """Take samples (n, c)."""
        self._blocks.append(data)
        self._count += len(data)
        while self._count - len(self._blocks[0]) >= self._wanted:
            self._count -= len(self._blocks.popleft())

    @property
    def moments(self) -> Moments:
        """Moments of the newest `wanted` samples, or of what has come."""
        found = RunningMoments(self._channels)
        if self._count:
            found.feed(np.concatenate(list(self._blocks))[-self._wanted :])
        return found.moments
