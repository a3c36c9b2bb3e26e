"""Minimum and maximum of any stretch of a long record, at the cost of the pixels it is drawn on.

Over the raw samples stand levels that hold the extremes of 64, 512, 4096 ... samples. Bins are
aligned to sample numbers, not to the view, so a curve does not tremble while it scrolls. NaN stands
for a sample that never came; extremes ignore it.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from core.arrays import FloatArray
from gui.widgets.moments import BIN as MOMENT_BIN
from gui.widgets.moments import Moments, MomentTable

BASE = 64
FACTOR = 8
CHUNK = 1 << 16
"""Raw samples are kept in pieces: one array that grows would stop the screen while it is copied."""


@dataclass(frozen=True, slots=True, eq=False)
class Columns:
    """What to draw of a stretch.

    Parameters
    ----------
    first, step : bin k holds samples ``first + k step`` up to the next bin
    low, high : (m,) extremes of the bins; the same array, the samples themselves, where step is 1
    """

    first: int
    step: int
    low: FloatArray
    high: FloatArray


class Pyramid:
    """Samples of one channel that only grow."""

    def __init__(self) -> None:
        self._chunks: list[FloatArray] = []
        self._count = 0
        self._levels: list[_Level] = [_Level(BASE)]
        self._moments = MomentTable()

    def __len__(self) -> int:
        return self._count

    def append(self, values: ArrayLike) -> None:
        """Add samples, (n,)."""
        rest = np.asarray(values, dtype=np.float64)
        while rest.size:
            place = self._count % CHUNK
            if place == 0:
                self._chunks.append(np.empty(CHUNK))
            taken = min(rest.size, CHUNK - place)
            self._chunks[-1][place : place + taken] = rest[:taken]
            self._count += taken
            rest = rest[taken:]
            self._grow()

    def _grow(self) -> None:
        """Fill the bins that have become whole."""
        bottom = self._levels[0]
        whole = self._count // BASE
        if whole == bottom.count:
            return
        raw = self.raw(bottom.count * BASE, whole * BASE)
        bottom.extend(*_reduce(raw, raw, BASE))
        lower = bottom
        for number in range(1, 64):
            if lower.count < FACTOR:
                return
            if number == len(self._levels):
                self._levels.append(_Level(lower.width * FACTOR))
            level = self._levels[number]
            start, stop = level.count * FACTOR, lower.count // FACTOR * FACTOR
            if start < stop:
                level.extend(*_reduce(lower.low[start:stop], lower.high[start:stop], FACTOR))
            lower = level

    def raw(self, start: int, stop: int) -> FloatArray:
        """Return samples start to stop, without stop; a view where they lie in one piece."""
        start, stop = max(0, start), min(self._count, stop)
        if stop <= start:
            return np.empty(0)
        first, last = start // CHUNK, (stop - 1) // CHUNK
        if first == last:
            return self._chunks[first][start - first * CHUNK : stop - first * CHUNK]
        pieces = [self._chunks[first][start - first * CHUNK :], *self._chunks[first + 1 : last]]
        return np.concatenate([*pieces, self._chunks[last][: stop - last * CHUNK]])

    def query(self, start: int, stop: int, pixels: int) -> Columns:
        """Return what to draw of samples start to stop on so many pixels.

        At most two points a pixel: the samples themselves while there are at most two of them a
        pixel, otherwise bins of a power of two of samples, at most one bin a pixel and one more.
        The first and the last bin are whole ones that may reach beyond the stretch.
        """
        start, stop = max(0, start), min(self._count, stop)
        if stop <= start:
            return Columns(start, 1, np.empty(0), np.empty(0))
        span = stop - start
        if span <= 2 * pixels:
            samples = self.raw(start, stop)
            return Columns(start, 1, samples, samples)
        step = 1 << (-(-span // max(1, pixels)) - 1).bit_length()
        first = start // step * step
        end = min(self._count, -(-stop // step) * step)
        if step < BASE:
            low = high = self.raw(first, end)
            width = 1
        else:
            number = 0
            while number + 1 < len(self._levels) and self._levels[number + 1].width <= step:
                number += 1
            width = self._levels[number].width
            low, high = self._entries(number, first // width, -(-end // width))
        while width < step:
            low, high = _halve(low, np.fmin), _halve(high, np.fmax)
            width *= 2
        return Columns(first, step, low, high)

    def _entries(self, number: int, start: int, stop: int) -> tuple[FloatArray, FloatArray]:
        """Bins of a level; the last one may be one that is not whole yet."""
        level = self._levels[number]
        whole = min(stop, level.count)
        low, high = level.low[start:whole], level.high[start:whole]
        if stop <= level.count:
            return low, high
        last = self.extremes(level.count * level.width, self._count)
        return np.append(low, last[0]), np.append(high, last[1])

    def extremes(self, start: int, stop: int) -> tuple[float, float]:
        """Return the exact least and greatest of samples start to stop; NaN where there is none."""
        start, stop = max(0, start), min(self._count, stop)
        if stop <= start:
            return np.nan, np.nan
        lows: list[FloatArray] = []
        highs: list[FloatArray] = []
        todo = [(start, stop, len(self._levels) - 1)]
        while todo:
            start, stop, number = todo.pop()
            if start >= stop:
                continue
            if number < 0:
                raw = self.raw(start, stop)
                lows.append(raw)
                highs.append(raw)
                continue
            level = self._levels[number]
            one = -(-start // level.width)
            other = min(stop // level.width, level.count)
            if one >= other:
                todo.append((start, stop, number - 1))
                continue
            lows.append(level.low[one:other])
            highs.append(level.high[one:other])
            todo.append((start, one * level.width, number - 1))
            todo.append((other * level.width, stop, number - 1))
        return (
            float(np.fmin.reduce(np.concatenate(lows))),
            float(np.fmax.reduce(np.concatenate(highs))),
        )

    def moments(self, start: int, stop: int) -> Moments:
        """Return count, mean, scatter and trend of samples start to stop."""
        start, stop = max(0, start), min(self._count, stop)
        one, other = -(-start // MOMENT_BIN), stop // MOMENT_BIN
        if one >= other:
            return Moments.of(self.raw(start, stop), start)
        while self._moments.count < other:
            # The table is filled when it is first asked for: most records never are.
            begin = self._moments.count * MOMENT_BIN
            self._moments.extend(self.raw(begin, min(begin + CHUNK, other * MOMENT_BIN)))
        parts = (
            Moments.of(self.raw(start, one * MOMENT_BIN), start),
            self._moments.merged(one, other),
            Moments.of(self.raw(other * MOMENT_BIN, stop), other * MOMENT_BIN),
        )
        return Moments.merge(parts)


class _Level:
    """Extremes of whole bins of `width` samples."""

    def __init__(self, width: int) -> None:
        self.width = width
        self.count = 0
        self._low = np.empty(64)
        self._high = np.empty(64)

    @property
    def low(self) -> FloatArray:
        return self._low[: self.count]

    @property
    def high(self) -> FloatArray:
        return self._high[: self.count]

    def extend(self, low: FloatArray, high: FloatArray) -> None:
        end = self.count + low.size
        if end > self._low.size:
            size = max(end, 2 * self._low.size)
            self._low = np.concatenate([self._low, np.empty(size - self._low.size)])
            self._high = np.concatenate([self._high, np.empty(size - self._high.size)])
        self._low[self.count : end] = low
        self._high[self.count : end] = high
        self.count = end


def _reduce(low: FloatArray, high: FloatArray, width: int) -> tuple[FloatArray, FloatArray]:
    """Extremes of whole bins of `width` entries each."""
    return (
        np.fmin.reduce(low.reshape(-1, width), axis=1),
        np.fmax.reduce(high.reshape(-1, width), axis=1),
    )


def _halve(
    entries: FloatArray, choose: Callable[[FloatArray, FloatArray], FloatArray]
) -> FloatArray:
    """Join entries two by two; an odd last one stays."""
    paired = entries.size // 2 * 2
    joined = choose(entries[0:paired:2], entries[1:paired:2])
    return np.append(joined, entries[-1]) if paired < entries.size else joined
