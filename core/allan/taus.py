"""Averaging factors m: the taus of a curve are m / rate."""

import math
from collections.abc import Callable

import numpy as np

from core.arrays import FloatArray, IntArray, frozen_int
from core.errors import FitError

SHORTEST_RECORD = 9
"""Samples below which there is nothing to average three times."""
FINEST = 16
"""Partial overlap steps by m/16 to m/32: 0.8 % of the degrees of freedom are given up at most."""


def _octave(limit: int, count: int) -> FloatArray:
    del count
    return np.array([float(1 << power) for power in range(limit.bit_length())])


def _log(limit: int, count: int) -> FloatArray:
    return np.exp(np.linspace(0.0, math.log(limit), count))


def _all(limit: int, count: int) -> FloatArray:
    del count
    return np.arange(1.0, limit + 1.0)


GRIDS: dict[str, Callable[[int, int], FloatArray]] = {"octave": _octave, "log": _log, "all": _all}


def averaging_factors(n: int, grid: str = "log", count: int = 100) -> IntArray:
    """Return distinct averaging factors from 1 to n/3.

    Parameters
    ----------
    n : samples in the record
    grid : ``"octave"`` (1, 2, 4, ...), ``"log"`` (`count` spaced evenly in log tau, the rounded
        duplicates dropped) or ``"all"`` (every integer)
    count : points of the ``"log"`` grid before duplicates are dropped

    Returns
    -------
    (t,) int64, increasing

    Raises
    ------
    FitError
        The record is shorter than 9 samples.
    """
    if n < SHORTEST_RECORD:
        raise FitError(
            f"the record has {n} samples: an Allan curve needs at least {SHORTEST_RECORD}; "
            "record longer"
        )
    limit = n // 3
    m = np.unique(np.rint(GRIDS[grid](limit, count)).astype(np.int64))
    return frozen_int(m[m <= limit])


def stride_of(m: int) -> int:
    """Return the power of two between m/32 and m/16 by which partial overlap steps, at least 1."""
    return 1 << max((m // FINEST).bit_length() - 1, 0)


def quantised(m: IntArray) -> IntArray:
    """Round averaging factors to multiples of their stride (a change of 1/32 at most)."""
    steps = np.array([stride_of(int(one)) for one in m], dtype=np.int64)
    return np.unique(np.rint(m / steps).astype(np.int64) * steps)


def multitau_factors(limit: int, per_octave: int = 4) -> IntArray:
    """Return 1 to 16, then `per_octave` factors an octave, each a multiple of its stride.

    Parameters
    ----------
    limit : the largest factor wanted
    per_octave : 1 to 16 factors between one power of two and the next

    Returns
    -------
    (t,) int64, increasing
    """
    low = np.arange(1, FINEST + 1, dtype=np.int64)
    pattern = np.rint(FINEST * 2.0 ** (np.arange(per_octave) / per_octave)).astype(np.int64)
    octaves = max(limit // FINEST, 1).bit_length()
    high = (pattern[np.newaxis, :] << np.arange(octaves)[:, np.newaxis]).ravel()
    m = np.unique(np.concatenate((low, high)))
    return m[m <= limit]
