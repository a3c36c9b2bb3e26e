"""All channels of a device over time, ready to be drawn: pyramids, and the gaps between samples."""

import bisect
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray
from core.samples.block import Channel
from gui.widgets.moments import Moments
from gui.widgets.pyramid import Columns, Pyramid

FILL = 4096
"""A gap up to this many samples is filled with NaN; a longer one costs no memory."""


@dataclass(frozen=True, slots=True)
class Statistics:
    """One channel between two moments.

    Parameters
    ----------
    count : samples that came
    mean, sigma, low, high : in the channel's unit; NaN where too few samples came
    slope : per second
    """

    count: int
    mean: float
    sigma: float
    low: float
    high: float
    slope: float


class History:
    """Samples by the device's counter.

    Time zero is the first sample; seconds are counter steps over the rate.

    Parameters
    ----------
    channels : (c,) what the columns are
    rate : samples per second, positive
    """

    def __init__(self, channels: tuple[Channel, ...], rate: float) -> None:
        if not rate > 0.0:
            raise ValueError(f"a history needs a positive rate, not {rate}")
        self.channels = channels
        self.rate = rate
        # Segment s holds the samples numbered from _starts[s] on, one pyramid a channel.
        self._starts: list[int] = []
        self._segments: list[list[Pyramid]] = []
        self._next = 0

    @property
    def first(self) -> int:
        """Number of the first sample."""
        return self._starts[0] if self._starts else 0

    @property
    def end(self) -> int:
        """Number after the last sample."""
        return self._next

    def seconds(self, number: float) -> float:
        """Return the time of a sample number."""
        return (number - self.first) / self.rate

    def number(self, seconds: float) -> int:
        """Return the sample number nearest to a time."""
        return self.first + round(seconds * self.rate)

    def append(self, index: IntArray, data: FloatArray) -> None:
        """Add samples.

        Parameters
        ----------
        index : (n,) strictly increasing sample numbers, beyond all earlier ones
        data : (n, c)

        Raises
        ------
        ValueError
            The numbers do not increase.
        """
        if not index.size:
            return
        if (self._starts and index[0] < self._next) or np.any(np.diff(index) < 1):
            raise ValueError(f"sample numbers from {index[0]} do not follow {self._next - 1}")
        breaks = np.flatnonzero(np.diff(index) > 1) + 1
        for start, stop in zip([0, *breaks], [*breaks, index.size], strict=True):
            self._append_run(int(index[start]), data[start:stop])

    def _append_run(self, first: int, data: FloatArray) -> None:
        missing = first - self._next
        if not self._starts or missing > FILL:
            self._starts.append(first)
            self._segments.append([Pyramid() for _ in self.channels])
        elif missing:
            hole = np.full(missing, np.nan)
            for pyramid in self._segments[-1]:
                pyramid.append(hole)
        for pyramid, column in zip(self._segments[-1], data.T, strict=True):
            pyramid.append(column)
        self._next = first + len(data)

    def _pieces(self, channel: int, start: int, stop: int) -> Iterator[tuple[int, Pyramid]]:
        """The pyramids that hold samples start to stop, each with the number of its first."""
        number = max(0, bisect.bisect_right(self._starts, start) - 1)
        while number < len(self._starts) and self._starts[number] < stop:
            pyramid = self._segments[number][channel]
            if start < self._starts[number] + len(pyramid):
                yield self._starts[number], pyramid
            number += 1

    def columns(self, channel: int, start: int, stop: int, pixels: int) -> list[Columns]:
        """Return what to draw of a channel, one entry for each stretch without a long gap."""
        drawn: list[Columns] = []
        for first, pyramid in self._pieces(channel, start, stop):
            begin, finish = max(start, first), min(stop, first + len(pyramid))
            share = max(2, -(-pixels * (finish - begin) // (stop - start)))
            part = pyramid.query(begin - first, finish - first, share)
            drawn.append(Columns(part.first + first, part.step, part.low, part.high))
        return drawn

    def value(self, channel: int, number: int) -> float:
        """Return one sample; NaN where it never came."""
        for first, pyramid in self._pieces(channel, number, number + 1):
            return float(pyramid.raw(number - first, number - first + 1)[0])
        return np.nan

    def samples(self, start: int, stop: int) -> tuple[IntArray, FloatArray]:
        """Return the samples numbered start to stop, without stop: numbers (n,), data (n, c)."""
        numbers: list[IntArray] = [np.empty(0, dtype=np.int64)]
        rows: list[FloatArray] = [np.empty((0, len(self.channels)))]
        columns = [
            list(self._pieces(channel, start, stop)) for channel in range(len(self.channels))
        ]
        for piece in zip(*columns, strict=True):
            first, pyramid = piece[0]
            begin, finish = max(start, first), min(stop, first + len(pyramid))
            data = np.stack([one.raw(begin - first, finish - first) for _, one in piece], axis=1)
            came = ~np.isnan(data).all(axis=1)
            numbers.append(np.arange(begin, finish)[came])
            rows.append(data[came])
        return np.concatenate(numbers), np.concatenate(rows)

    def extremes(self, channel: int, start: int, stop: int) -> tuple[float, float]:
        """Return least and greatest of samples start to stop; NaN where there is none."""
        found = [
            pyramid.extremes(start - first, stop - first)
            for first, pyramid in self._pieces(channel, start, stop)
        ]
        if not found:
            return np.nan, np.nan
        low, high = np.array(found).T
        return float(np.fmin.reduce(low)), float(np.fmax.reduce(high))

    def statistics(self, channel: int, start: int, stop: int) -> Statistics:
        """Return the statistics of samples start to stop, without stop."""
        total = Moments.merge(
            pyramid.moments(start - first, stop - first).shifted(first)
            for first, pyramid in self._pieces(channel, start, stop)
        )
        low, high = self.extremes(channel, start, stop)
        return Statistics(
            int(total.count), total.mean, total.sigma, low, high, total.slope * self.rate
        )
