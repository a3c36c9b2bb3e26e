"""Signs of a sick channel in a record: samples that repeat, samples piled up at an extreme."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray
from core.errors import Note, Severity

Record = NDArray[Any]
"""(n,) real numbers of any type; may be a memory map, it is read in chunks."""

CHUNK = 65536
STUCK = 100
"""Shortest run of equal samples that can be called stuck."""
PILE = 5
"""Fewest samples at an extreme value that can be called clipping."""


def chunks(values: Record, start: int, stop: int) -> Iterator[tuple[int, FloatArray]]:
    """Yield (position, float64 chunk) of values[start:stop]."""
    for at in range(start, stop, CHUNK):
        yield at, np.asarray(values[at : min(at + CHUNK, stop)], dtype=np.float64)


class Tally:
    """Extremes, mean, repetitions and wholeness of samples that come in chunks."""

    __slots__ = (
        "_last",
        "_longest",
        "_open",
        "_repeats",
        "_total",
        "count",
        "highest",
        "integral",
        "lowest",
    )

    def __init__(self) -> None:
        self.count = 0
        self._total = 0.0
        self.lowest = math.inf
        self.highest = -math.inf
        self.integral = True
        self._repeats = 0
        self._longest = 1
        self._open = 1
        self._last = math.nan

    @property
    def mean(self) -> float:
        """Mean of all samples."""
        return self._total / self.count

    def break_run(self) -> None:
        """Forget the last sample: the next one is not its neighbour."""
        self._open = 1
        self._last = math.nan

    def add(self, chunk: FloatArray) -> None:
        """Take in the next samples."""
        self.count += len(chunk)
        self._total += float(chunk.sum())
        self.lowest = min(self.lowest, float(chunk.min()))
        self.highest = max(self.highest, float(chunk.max()))
        if self.integral:
            self.integral = bool(np.array_equal(chunk, np.rint(chunk)))
        self._run(chunk)

    def _run(self, chunk: FloatArray) -> None:
        changed = chunk[1:] != chunk[:-1]
        repeats = len(changed) - int(np.count_nonzero(changed))
        joins = bool(chunk[0] == self._last)
        self._repeats += repeats + joins
        before = self._open if joins else 0
        self._last = float(chunk[-1])
        if repeats + before < STUCK // 2:
            # No run here can matter; one that goes on is counted from here, too short by half of
            # STUCK at most.
            self._open = 1
            return
        ends = np.concatenate(([-1], np.flatnonzero(changed), [len(chunk) - 1]))
        runs = np.diff(ends)
        runs[0] += before
        self._longest = max(self._longest, int(runs.max()))
        self._open = int(runs[-1])

    def notes(self, values: Record, stretches: IntArray) -> Iterator[Note]:
        """Yield what looks wrong."""
        share = self._repeats / self.count
        # The longest of n geometric runs; slow drift over a coarse code lengthens it somewhat.
        expected = 1.0
        if 0.0 < share < 1.0:
            expected += math.log(max(self.count * (1.0 - share), 2.0)) / -math.log(share)
        if self._longest >= max(STUCK, 10.0 * expected):
            yield Note(
                Severity.WARNING,
                "stuck",
                f"{self._longest} samples in succession are equal, where at most "
                f"{10.0 * expected:.0f} could be expected: the channel was stuck for a time",
            )
        for extreme, sign in ((self.lowest, -1.0), (self.highest, 1.0)):
            piled, beside = _pile(values, stretches, extreme, sign)
            if piled >= PILE and piled > 2 * beside:
                yield Note(
                    Severity.WARNING,
                    "clipped",
                    f"{piled} samples lie exactly at the extreme value {extreme:.9g}, but only "
                    f"{beside} at the value beside it: the signal is clipped, noise is understated",
                )


def _pile(values: Record, stretches: IntArray, extreme: float, sign: float) -> tuple[int, int]:
    """Count the samples at an extreme and at the distinct value next to it.

    Nothing piles up in a code of two values, whatever their counts: (0, 0).
    """
    spans = [(start, stop) for start, stop in stretches.tolist()]
    piled = 0
    for span in spans:
        for _, chunk in chunks(values, *span):
            piled += int(np.count_nonzero(chunk == extreme))
    if piled < PILE:
        return piled, 0
    following, beside, deeper = -math.inf, 0, 0
    for span in spans:
        for _, chunk in chunks(values, *span):
            inner = chunk[chunk != extreme] * sign
            best = float(inner.max(initial=-math.inf))
            if best > following:
                deeper += beside
                following, beside = best, 0
            here = int(np.count_nonzero(inner == following))
            beside += here
            deeper += len(inner) - here
    return (piled, beside) if deeper else (0, 0)
