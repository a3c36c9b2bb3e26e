"""The reading of an Allan curve with a ruler, as lab 6 teaches it.

A straight line of the slope of each term is laid on the part of the curve that has this slope and
is read at the tau where the term equals its coefficient: Q at sqrt(3) s, N at 1 s, K at 3 s, R at
sqrt(2) s; B is the lowest point over 0.664. Points beyond a tenth of the record are not used. The
reading ignores that the terms overlap: N comes out several per cent high, and a B is always found,
even where there is none. It is kept for comparison, not as a result.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from core.allan.confidence import local_slopes
from core.allan.curve import AllanCurve
from core.allan.model import FLOOR, TERMS

SHARE = 0.1
"""Longest tau read, as a share of the record."""
NEAR = 0.1
"""Departure of the local slope within which a part of the curve counts as straight."""
FEWEST = 2


@dataclass(frozen=True, slots=True)
class Reading:
    """One coefficient read off.

    Parameters
    ----------
    term : key of TERMS
    value : coefficient
    edf : degrees of freedom of the best of the points used
    tau : where the line touches the curve, s
    bound : the curve still falls at its end: B is at most this
    """

    term: str
    value: float
    edf: float
    tau: float
    bound: bool


def read_curve(curve: AllanCurve, terms: Iterable[str] = TERMS) -> tuple[Reading, ...]:
    """Read the coefficients whose slope the curve shows.

    Parameters
    ----------
    curve : the curve
    terms : keys of TERMS to look for

    Returns
    -------
    tuple of Reading
        Empty for a curve of fewer than three points up to a tenth of the record.
    """
    used = curve.taus <= SHARE * curve.duration
    taus, deviation, edf = curve.taus[used], curve.deviation[used], curve.edf[used]
    if len(taus) < 3:
        return ()
    slopes = local_slopes(taus, deviation)
    readings: list[Reading] = []
    for name in terms:
        term = TERMS[name]
        if term.power == 0:
            lowest = int(deviation.argmin())
            readings.append(
                Reading(
                    name,
                    float(deviation[lowest]) / FLOOR,
                    float(edf[lowest]),
                    float(taus[lowest]),
                    lowest == len(taus) - 1,
                )
            )
            continue
        slope = 0.5 * term.power
        start, stop = _longest_run(np.abs(slopes - slope) < NEAR)
        if stop - start < FEWEST:
            continue
        line = np.log(deviation[start:stop]) - slope * np.log(taus[start:stop])
        value = float(np.exp(line.mean() + slope * np.log(term.reading)))
        middle = float(np.sqrt(taus[start] * taus[stop - 1]))
        readings.append(Reading(name, value, float(edf[start:stop].max()), middle, False))
    return tuple(readings)


def _longest_run(flags: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> tuple[int, int]:
    """Return start and stop of the longest run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], flags, [False])).astype(np.int8)))
    if not len(edges):
        return 0, 0
    starts, stops = edges[::2], edges[1::2]
    best = int((stops - starts).argmax())
    return int(starts[best]), int(stops[best])
