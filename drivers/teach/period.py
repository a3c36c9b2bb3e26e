"""Lengths at which a stream repeats itself, and what stays the same at each of them.

Frames of one length bring their constant bytes back after that length, so the share of bytes equal
to the byte one length later stands out; bytes between frames only lower it. A pair of bytes (or one
byte) that comes once a length is the anchor by which frames are lined up.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray
from drivers.shape import ByteArray

LONGEST = 512
"""Longest frame that is looked for."""
_SHORTEST = 4
_LAGS = 5
_FEWEST = 8
_CONSTANT = 0.97
_WINDOW = 1 << 15


@dataclass(frozen=True, slots=True, eq=False)
class Alignment:
    """A stream lined up at one length.

    Parameters
    ----------
    length : of the frames
    places : (n,) where frames begin if they began with the anchor
    constant : (length,) value of each byte of the cycle that stays the same, else -1
    before : (length,) share of frames where the constant byte holds, one length before the anchor
    after : (length,) the same behind the anchor
    score : 0 to 1, how well the anchor comes once a length
    """

    length: int
    places: IntArray
    constant: IntArray
    before: FloatArray
    after: FloatArray
    score: float


def recurrence(data: ByteArray) -> FloatArray:
    """Return the share of bytes that come again after each lag; (LONGEST + 1,), 0 where unknown."""
    view = data[-_WINDOW:]
    shares = np.zeros(LONGEST + 1)
    for lag in range(_SHORTEST, min(LONGEST, len(view) // 4) + 1):
        shares[lag] = np.count_nonzero(view[lag:] == view[:-lag]) / (len(view) - lag)
    return shares


def likely_lengths(data: ByteArray) -> list[int]:
    """Return the likeliest lengths, the likeliest first; without the multiples of likelier ones."""
    shares = recurrence(data)
    known = shares[_SHORTEST:]
    if not known.any():
        return []
    level = float(np.median(known[known > 0.0]))
    order = np.argsort(shares)[::-1][: 12 * _LAGS].tolist()
    top = float(shares[order[0]]) - level
    chosen: list[int] = []
    for lag in sorted(order):
        excess = float(shares[lag]) - level
        if excess < 0.15 * top:
            continue
        if any(lag % one == 0 and shares[one] - level > 0.75 * excess for one in chosen):
            continue
        chosen.append(lag)
    return sorted(chosen, key=lambda lag: -shares[lag])[:_LAGS]


def alignments(data: ByteArray) -> Iterator[Alignment]:
    """Yield the ways to line a stream up, by likely lengths and the best anchors of each."""
    for rank, length in enumerate(likely_lengths(data)):
        for places, score in _anchors(data, length)[: 1 if rank else 2]:
            found = _aligned(data, length, places, score)
            if found is not None:
                yield found


def _anchors(data: ByteArray, length: int) -> list[tuple[IntArray, float]]:
    """Return where the best anchors of a length stand, and how good each is."""
    equal = data[length:] == data[:-length]
    pairs = (data[:-1].astype(np.int64) << 8) | data[1:]
    found: list[tuple[IntArray, float]] = []
    singles = data.astype(np.int64)
    for grams, both in ((pairs, equal[:-1] & equal[1:]), (singles, equal)):
        support = np.bincount(grams[: len(both)][both], minlength=1)
        total = np.bincount(grams)
        turns = len(data) / length
        grade = np.zeros(len(total))
        grade[: len(support)] = support / np.maximum(total[: len(support)], 1)
        share = total / turns
        grade *= np.where(share > 1.0, 1.0 / np.maximum(share, 1.0), share)
        for gram in np.argsort(grade)[::-1][:2].tolist():
            places = np.flatnonzero(grams == gram)
            if len(places) >= _FEWEST and grade[gram] > 0.0:
                found.append((places, float(grade[gram])))
    found.sort(key=lambda pair: -pair[1])
    return found


def _aligned(data: ByteArray, length: int, places: IntArray, score: float) -> Alignment | None:
    """Line up the places whose neighbour is one length away; None if too few are."""
    inside = places[(places >= length) & (places + 2 * length <= len(data))]
    near = np.isin(inside + length, places) | np.isin(inside - length, places)
    kept = inside[near]
    if len(kept) < _FEWEST:
        return None
    columns = np.arange(-length, length)
    table = data[kept[:, None] + columns]
    modes = np.array([np.bincount(column).argmax() for column in table.T])
    holds = np.mean(table == modes, axis=0)
    before, after = holds[:length], holds[length:]
    best = np.maximum(before, after)
    values = np.where(after >= before, modes[length:], modes[:length])
    constant = np.where(best >= _CONSTANT, values, -1).astype(np.int64)
    return Alignment(length, kept, constant, before, after, score)


def constant_runs(constant: IntArray) -> list[tuple[int, int]]:
    """Return the runs of constant bytes around a cycle as first place and count, longest first.

    A cycle that is constant all over has no run.
    """
    length = len(constant)
    still = constant >= 0
    if still.all():
        return []
    runs: list[tuple[int, int]] = []
    for first in np.flatnonzero(still & ~np.roll(still, 1)).tolist():
        count = 1
        while still[(first + count) % length]:
            count += 1
        runs.append((first, count))
    return sorted(runs, key=lambda run: -run[1])


def boundary_evidence(found: Alignment, start: int) -> float:
    """Return how well the constant bytes hold if frames begin at `start` of the cycle.

    What stands between frames disturbs what is taken across a boundary; so where there is garbage,
    the right beginning gives the largest value, the mean share of constant bytes that hold.
    """
    places = np.flatnonzero(found.constant >= 0)
    if not len(places):
        return 0.0
    # From `start` to the end of the cycle stands before the next anchor, the rest behind it.
    return float(
        np.mean(np.where(places >= start, found.before[places], found.after[places]))
        if start
        else np.mean(found.after[places])
    )
