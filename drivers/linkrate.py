"""The rate of samples by the clock of the computer.

USB adapters deliver in bursts, so single arrival times scatter by milliseconds; a line through
many of them does not.
"""

import math
from collections import deque

import numpy as np

_POINTS = 1200
_SPAN_S = 1.0
_EVERY_S = 0.5


class LinkRate:
    """Line fit of sample number against arrival time over the latest 1200 reads."""

    def __init__(self) -> None:
        self._points: deque[tuple[float, int]] = deque(maxlen=_POINTS)
        self._told = -math.inf

    def add(self, arrival: float, index: int) -> None:
        """Note that the sample before `index` had come by the time `arrival`, in s."""
        self._points.append((arrival, index))

    def due(self, now: float) -> bool:
        """Whether the last answer of `hz` is half a second old."""
        return now - self._told >= _EVERY_S

    def hz(self) -> float:
        """Samples per second; NaN while the points span less than a second."""
        if not self._points or self._points[-1][0] - self._points[0][0] < _SPAN_S:
            return math.nan
        self._told = self._points[-1][0]
        points = np.array(self._points)
        t, index = (points - points.mean(axis=0)).T
        return float(t @ index / (t @ t))
