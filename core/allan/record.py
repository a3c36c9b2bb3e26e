"""Survey of a record before it is analysed: what is wrong with it is said, not turned into NaN."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from core.allan.taus import SHORTEST_RECORD
from core.arrays import FloatArray, IntArray, frozen_int
from core.errors import FitError, Note, Severity

Record = NDArray[Any]
"""(n,) real numbers of any type; may be a memory map, it is read in chunks."""

GapPolicy = Literal["refuse", "longest", "stretches"]
"""``"refuse"``: raise; ``"longest"``: analyse the longest gap-free stretch only; ``"stretches"``:
no difference is taken across a gap, those of all stretches are pooled."""

CHUNK = 65536
JITTER = 0.25
"""Largest departure of a time stamp from the uniform grid, in sampling intervals."""
STUCK = 100
"""Shortest run of equal samples that can be called stuck."""
PILE = 5
"""Fewest samples at an extreme value that can be called clipping."""


@dataclass(frozen=True, slots=True, eq=False)
class Survey:
    """What was found in a record.

    Parameters
    ----------
    stretches : (k, 2) int64, start and stop of the gap-free stretches to analyse
    mean : of their finite samples
    lowest, highest : extreme values
    integral : all samples are whole numbers (codes), so sums can be exact
    notes : doubts about the record
    """

    stretches: IntArray
    mean: float
    lowest: float
    highest: float
    integral: bool
    notes: tuple[Note, ...]

    @property
    def n(self) -> int:
        """Samples in the stretches."""
        return int((self.stretches[:, 1] - self.stretches[:, 0]).sum())

    @property
    def longest(self) -> tuple[int, int]:
        """Start and stop of the longest stretch."""
        lengths = self.stretches[:, 1] - self.stretches[:, 0]
        start, stop = self.stretches[int(lengths.argmax())].tolist()
        return start, stop


def chunks(values: Record, start: int, stop: int) -> Iterator[tuple[int, FloatArray]]:
    """Yield (position, float64 chunk) of values[start:stop]."""
    for at in range(start, stop, CHUNK):
        yield at, np.asarray(values[at : min(at + CHUNK, stop)], dtype=np.float64)


def sample_index(time: FloatArray) -> tuple[IntArray, float]:
    """Turn time stamps into sample numbers on a uniform grid.

    Parameters
    ----------
    time : (n,) s

    Returns
    -------
    index : (n,) int64 from 0; steps above 1 are lost samples
    rate : samples per second

    Raises
    ------
    FitError
        Time stamps run backwards, repeat, or leave the grid by more than a quarter of the sampling
        interval (the message names the first such sample).
    """
    steps = np.diff(time)
    if len(steps) < SHORTEST_RECORD - 1:
        raise FitError(f"the record has {len(time)} time stamps; record longer")
    bad = np.flatnonzero(~(steps > 0.0))
    if len(bad):
        at = int(bad[0]) + 1
        raise FitError(
            f"time does not increase at sample {at} ({time[at - 1]:.9g} s, then {time[at]:.9g} s; "
            f"{len(bad)} such places): the file is damaged or two runs were joined"
        )
    middle = float(np.median(steps))
    index = np.concatenate(([0], np.cumsum(np.maximum(np.rint(steps / middle), 1.0))))
    for _ in range(2):
        interval = float((time[-1] - time[0]) / index[-1])
        index = np.rint((time - time[0]) / interval)
    off = np.abs((time - time[0]) / interval - index)
    worst = int(off.argmax())
    if off[worst] > JITTER or np.any(np.diff(index) < 1.0):
        raise FitError(
            f"samples are not uniform in time: sample {worst} at {time[worst]:.9g} s is "
            f"{off[worst]:.2f} of the interval {interval:.6g} s off the grid; use the device's "
            "counter as the time axis, or resample"
        )
    return frozen_int(index.astype(np.int64)), 1.0 / interval


def survey(values: Record, index: IntArray | None = None, gaps: GapPolicy = "refuse") -> Survey:
    """Look a record over in one reading.

    Parameters
    ----------
    values : (n,) samples; a value that is not finite is a lost sample
    index : (n,) sample numbers by the device's counter, if there are any; a step of more than one
        is a gap
    gaps : what to do with gaps

    Raises
    ------
    FitError
        Too short, gaps while `gaps` is ``"refuse"``, or all samples equal.
    """
    if values.ndim != 1:
        raise ValueError(f"a record is one-dimensional, not {values.shape}")
    stretches, lost = _stretches(values, index)
    notes: list[Note] = []
    if len(stretches) > 1 or lost:
        stretches = _apply(gaps, stretches, lost, len(values), notes)
    counted = int((stretches[:, 1] - stretches[:, 0]).sum())
    if counted < SHORTEST_RECORD:
        raise FitError(
            f"the record has {counted} usable samples: an Allan curve needs at least "
            f"{SHORTEST_RECORD}; record longer"
        )
    tally = _Tally()
    for start, stop in stretches.tolist():
        tally.break_run()
        for _, chunk in chunks(values, start, stop):
            tally.add(chunk)
    if tally.highest == tally.lowest:
        raise FitError(
            f"all {tally.count} samples equal {tally.lowest:.9g}: the channel is stuck or not "
            "connected"
        )
    notes.extend(tally.notes(values, stretches))
    return Survey(
        frozen_int(stretches), tally.mean, tally.lowest, tally.highest, tally.integral, tuple(notes)
    )


def _stretches(values: Record, index: IntArray | None) -> tuple[IntArray, int]:
    """Return the gap-free stretches and the number of lost samples."""
    n = len(values)
    cuts = [np.empty(0, dtype=np.int64)]
    lost = 0
    if index is not None:
        if len(index) != n:
            raise ValueError(f"{len(index)} sample numbers for {n} samples")
        steps = np.diff(index)
        if np.any(steps < 1):
            at = int(np.flatnonzero(steps < 1)[0]) + 1
            raise FitError(f"sample numbers do not increase at sample {at}: two runs were joined")
        cuts.append(np.flatnonzero(steps > 1) + 1)
        lost = int(steps.sum()) - len(steps)
    holes = _holes(values)
    lost += len(holes)
    if not len(holes):
        edges = np.concatenate(([0], cuts[-1], [n]))
        return np.stack((edges[:-1], edges[1:]), axis=1), lost
    # A hole is a stretch of its own between two cuts, dropped afterwards.
    edges = np.unique(np.concatenate(([0], cuts[-1], holes, holes + 1, [n])))
    pairs = np.stack((edges[:-1], edges[1:]), axis=1)
    return pairs[~np.isin(pairs[:, 0], holes)], lost


def _holes(values: Record) -> IntArray:
    """Return the positions of samples that are not finite."""
    if values.dtype.kind in "iub":
        return np.empty(0, dtype=np.int64)
    found = [np.empty(0, dtype=np.int64)]
    for at, chunk in chunks(values, 0, len(values)):
        if not math.isfinite(float(chunk.sum())):
            found.append(np.flatnonzero(~np.isfinite(chunk)) + at)
    return np.concatenate(found)


def _apply(gaps: GapPolicy, stretches: IntArray, lost: int, n: int, notes: list[Note]) -> IntArray:
    lengths = stretches[:, 1] - stretches[:, 0]
    first = int(stretches[0, 1]) if len(stretches) else 0
    if gaps == "refuse" or not len(stretches):
        raise FitError(
            f"the record has gaps: {lost} samples lost, the first after sample {first} of {n}; "
            "analyse the longest gap-free stretch, or pool the stretches"
        )
    if gaps == "longest":
        best = int(lengths.argmax())
        stretches = stretches[best : best + 1]
        text = (
            f"{lost} samples were lost; only the longest gap-free stretch is analysed: "
            f"{int(lengths[best])} of {n} samples"
        )
    else:
        text = (
            f"{lost} samples were lost; the differences within {len(stretches)} gap-free stretches "
            f"are pooled, the longest has {int(lengths.max())} samples"
        )
    notes.append(Note(Severity.WARNING, "gaps", text))
    return stretches


class _Tally:
    """Extremes, mean, repetitions and wholeness of samples that come in chunks."""

    __slots__ = (
        "_last", "_longest", "_open", "_repeats", "_total", "count", "highest", "integral", "lowest",
    )  # fmt: skip

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
        return self._total / self.count

    def break_run(self) -> None:
        """Forget the last sample: the next one is not its neighbour."""
        self._open = 1
        self._last = math.nan

    def add(self, chunk: FloatArray) -> None:
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
