"""Survey of a record before it is analysed: what is wrong with it is said, not turned into NaN."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from core.allan.faults import Record, Tally, chunks
from core.allan.taus import SHORTEST_RECORD
from core.arrays import FloatArray, IntArray, frozen_int
from core.errors import FitError, Note, Severity

GapPolicy = Literal["refuse", "longest", "stretches"]
"""``"refuse"``: raise; ``"longest"``: analyse the longest gap-free stretch only; ``"stretches"``:
no difference is taken across a gap, those of all stretches are pooled."""

JITTER = 0.25
"""Largest departure of a time stamp from the uniform grid, in sampling intervals."""

MOST_GAPS = 0.1
"""Share of long steps above which time stamps are no grid with samples missing."""


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
    jumps = float(np.mean(steps > 1.5 * middle))
    if jumps > MOST_GAPS:
        raise FitError(
            f"samples are not uniform in time: {100.0 * jumps:.0f} % of the steps are longer than "
            f"the usual {middle:.3g} s. Are these arrival times of bursts? Use the device's counter"
        )
    index = np.concatenate(([0], np.cumsum(np.maximum(np.rint(steps / middle), 1.0))))
    interval = float(time[-1] - time[0]) / float(index[-1])
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
    tally = Tally()
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
