"""Has the head come to rest; did it move meanwhile.

Both questions are asked without knowing the sensor's scale: the spread between the means of
quarters of a window is compared with the noise inside the quarters.
"""

from collections import deque

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.samples.block import SampleBlock, chosen_columns
from core.samples.mean_error import standard_error
from core.samples.turning import turning_columns, unwrapped

_QUARTERS = 4
_REST_LIMIT = 8.0
"""Range of the quarter means over the error of one: chance alone gives 8 about once in 1e7."""
_LONGEST_MEMORY = 0.97
"""Correlation of neighbouring samples that is still taken for noise."""
_MOVED_LIMIT = 10.0


class StillnessDetector:
    """Tells from the stream whether the unit is at rest.

    Parameters
    ----------
    rate : samples per second
    watched : start of the role of the channels that show motion, e.g. ``"acc."``
    window_s : how much of the past is judged
    """

    def __init__(self, rate: float, watched: str, window_s: float = 1.0) -> None:
        self._watched = watched
        self._wanted = max(round(rate * window_s), 2 * _QUARTERS)
        self._blocks: deque[FloatArray] = deque()
        self._turning: list[int] = []
        self._count = 0

    def feed(self, block: SampleBlock) -> None:
        """Take a block; a gap inside it starts the window anew."""
        columns = chosen_columns(block.channels, self._watched)
        if len(block.index) > 1 and np.any(np.diff(block.index) > 1):
            self.reset()
        self._turning = turning_columns([block.channels[place] for place in columns])
        self._blocks.append(block.data[:, columns])
        self._count += len(block.index)
        while self._count - len(self._blocks[0]) >= self._wanted:
            self._count -= len(self._blocks.popleft())

    def reset(self) -> None:
        """Forget the past."""
        self._blocks.clear()
        self._count = 0

    @property
    def full(self) -> bool:
        """Whether enough has come to judge."""
        return self._count >= self._wanted

    @property
    def at_rest(self) -> bool:
        """Whether the whole window shows no motion; False until the window is full."""
        if not self.full:
            return False
        return bool(np.all(_spread(self._window()) < _REST_LIMIT))

    def mean(self) -> FloatArray:
        """Mean (m,) of the watched channels over the window."""
        return self._window().mean(axis=0)

    def _window(self) -> FloatArray:
        return unwrapped(np.concatenate(self._blocks)[-self._wanted :], self._turning)


def _quarters(window: FloatArray) -> FloatArray:
    n = len(window) // _QUARTERS
    return window[: n * _QUARTERS].reshape(_QUARTERS, n, -1)


def _spread(window: FloatArray) -> FloatArray:
    """Range of the quarter means over the error of one quarter's mean, (m,).

    The noise inside a quarter is what a straight line leaves, so motion does not hide itself, and
    its error is that of a first-order autoregression, since sensors filter their output.
    """
    quarters = _quarters(window)
    n = quarters.shape[1]
    span: FloatArray = np.ptp(quarters.mean(axis=1), axis=0)
    ramp = np.linspace(-1.0, 1.0, n)
    centred = quarters - quarters.mean(axis=1, keepdims=True)
    slopes = np.einsum("t,qtm->qm", ramp, centred) / (ramp @ ramp)
    rest = centred - ramp[None, :, None] * slopes[:, None, :]
    power = np.maximum((rest**2).mean(axis=(0, 1)), np.finfo(float).tiny)
    lagged = (rest[:, 1:] * rest[:, :-1]).mean(axis=(0, 1))
    memory = np.clip(lagged / power, 0.0, _LONGEST_MEMORY)
    return span / np.sqrt(power * (1.0 + memory) / (1.0 - memory) / n)


def moved(data: FloatArray) -> BoolArray:
    """Which of the channels (m,) changed during an accumulation by more than their noise.

    Parameters
    ----------
    data : (n, m) samples of the watched channels, n >= 64 for an answer other than no
    """
    quarters = _quarters(data)
    if quarters.shape[1] < 16:
        return np.zeros_like(data[0], dtype=np.bool_)
    errors = np.array([standard_error(q, [False] * q.shape[1])[0] for q in quarters])
    span: FloatArray = np.ptp(quarters.mean(axis=1), axis=0)
    noise = np.maximum(np.median(errors, axis=0), np.finfo(float).tiny)
    changed: BoolArray = np.array(span / noise > _MOVED_LIMIT, dtype=np.bool_)
    return changed
