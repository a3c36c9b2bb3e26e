"""What goes wrong at a rate table, found before the fit and said by row.

A robust line (the median of the slopes through all pairs of points, Theil and Sen) tells which
rate each output stands for; a row that stands for another one than was set has a story, and the
usual stories are known: the table stood, stopped, turned the wrong way, or the rate was written in
another unit. Outputs that stop growing at an end of the range are clipped.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.errors import Note, Severity
from core.units import DEG_PER_RAD

_SHARE_OF_RANGE = 0.02
_ROBUST_SIGMAS = 10.0
_TO_SIGMA = 1.4826
_FLATTER = 0.9
_UNSTEADY = 8.0
_ALIKE = 0.05
_FEWEST = 4


@dataclass(frozen=True, slots=True, eq=False)
class Examined:
    """Rows as they were found.

    Parameters
    ----------
    clipped : (n, c) outputs at the limit of the sensor or of its converter
    notes : what is wrong, one note a cause and row
    """

    clipped: NDArray[np.bool_]
    notes: tuple[Note, ...]


def examine(
    x: FloatArray, y: FloatArray, se: FloatArray, channels: Sequence[str], rows: Sequence[int]
) -> Examined:
    """Look for faults in outputs of sensors that all turn about their input axis.

    Parameters
    ----------
    x : (n,) set rate about the input axis, deg/s
    y, se : (n, c) outputs and their standard errors, NaN where unknown
    channels : (c,) names of the outputs
    rows : (n,) numbers of the rows, as operators count them
    """
    if len(np.unique(x)) < _FEWEST:
        return Examined(np.zeros(y.shape, dtype=np.bool_), ())
    notes = list(_unsteady(x, se, rows))
    clipped = _clipped(x, y, se)
    k = _median_slopes(x, y)
    turning = np.flatnonzero(k != 0)
    notes.extend(_clipped_notes(x, y, clipped, channels))
    stands_for = _stands_for(x, y[:, turning], k[turning], clipped[:, turning])
    notes.extend(_row_notes(x, stands_for, [channels[i] for i in turning.tolist()], rows))
    return Examined(clipped, tuple(notes))


def _median_slopes(x: FloatArray, y: FloatArray) -> FloatArray:
    """Median (c,) of the slopes through all pairs of rows with different rates."""
    first, second = np.triu_indices(len(x), 1)
    run = x[second] - x[first]
    apart = run != 0
    return np.median((y[second[apart]] - y[first[apart]]) / run[apart, None], axis=0)


def _clipped(x: FloatArray, y: FloatArray, se: FloatArray) -> NDArray[np.bool_]:
    """Rows (n, c) at the ends whose output grows less than in the middle, or no more."""
    rates, group = np.unique(x, return_inverse=True)
    alike = (group == np.arange(len(rates))[:, None]).astype(np.float64)
    means = alike @ y / alike.sum(axis=1, keepdims=True)
    trim = len(rates) // 3
    middle = slice(trim, len(rates) - trim)
    k = _median_slopes(rates[middle], means[middle])
    k = np.where(k == 0, np.inf, k)  # a dead sensor cannot be clipped
    grown = np.diff(means, axis=0) / np.diff(rates)[:, None] / k
    ends = (grown[[0, -1]] < _FLATTER) & (grown[[0, -1]] > -_ALIKE)
    clipped = np.zeros(y.shape, dtype=np.bool_)
    for channel in np.flatnonzero(ends.any(axis=0) & np.isfinite(k)):
        deviation = means[:, channel] / k[channel] - rates
        deviation = np.abs(deviation - np.median(deviation[middle]))
        noise = _TO_SIGMA * float(np.median(deviation[middle]))
        limit = max(_ROBUST_SIGMAS * noise, _SHARE_OF_RANGE * float(np.abs(rates).max()))
        missing = deviation > limit
        own = se[:, channel]
        if np.all(np.isfinite(own)):
            missing[group[own > _UNSTEADY * np.median(own)]] = False
        flat = (grown[:, channel] > -_ALIKE) & (grown[:, channel] < _FLATTER)
        clipped[:, channel] = _from_the_ends(flat, missing)[group]
    return clipped


def _from_the_ends(flat: NDArray[np.bool_], missing: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Rates (m,) that fall short, in one stretch from either end, by the steps (m - 1,) to them."""
    out = np.zeros(len(missing), dtype=np.bool_)
    for place in range(len(missing) - 1, _FEWEST - 2, -1):
        if not (flat[place - 1] and missing[place]):
            break
        out[place] = True
    for place in range(len(missing) - _FEWEST + 1):
        if not (flat[place] and missing[place]):
            break
        out[place] = True
    return out


def _stands_for(
    x: FloatArray, y: FloatArray, k: FloatArray, clipped: NDArray[np.bool_]
) -> FloatArray:
    """Rate (n, t) that each output stands for, where it is far from the set one; else NaN."""
    implied = y / k
    middle = np.median(implied - x[:, None], axis=0)
    for place in np.flatnonzero(clipped.any(axis=0)):
        good = ~clipped[:, place]
        implied[:, place] = y[:, place] / _median_slopes(x[good], y[good][:, [place]])[0]
        middle[place] = np.median(implied[good, place] - x[good])
    implied = implied - middle
    deviation = np.abs(implied - x[:, None])
    # Clipped rows are few, and the median bears them.
    noise = _TO_SIGMA * np.median(deviation, axis=0)
    limit = np.maximum(_ROBUST_SIGMAS * noise, _SHARE_OF_RANGE * np.abs(x).max())
    return np.where((deviation > limit) & ~clipped, implied, np.nan)


def _row_notes(
    x: FloatArray, stands_for: FloatArray, channels: Sequence[str], rows: Sequence[int]
) -> list[Note]:
    notes: list[Note] = []
    smallest = _SHARE_OF_RANGE * float(np.abs(x).max())
    for place in np.flatnonzero(np.isfinite(stands_for).any(axis=1)).tolist():
        hit = np.isfinite(stands_for[place])
        implied = float(np.median(stands_for[place][hit]))
        who = "" if hit.all() else f" in {', '.join(np.array(channels)[hit])}"
        notes.append(
            Note(
                Severity.ERROR,
                "wrong_rate",
                f"row {rows[place]}, {x[place]:g} deg/s: the output{who} stands for"
                f" {implied:.3g} deg/s; {story(float(x[place]), implied, smallest)}."
                " Repeat this rate, or leave the row out",
            )
        )
    return notes


def story(set_rate: float, implied: float, smallest: float) -> str:
    """Why an output may stand for another rate than was set."""
    ratio = implied / set_rate if set_rate else float("inf")
    if abs(set_rate) > 2 * smallest and abs(implied) < smallest:
        return "the table stood still"
    if abs(ratio + 1.0) < _ALIKE:
        return "the table was turned the wrong way, or the sign of the rate is wrong"
    for factor, unit in ((DEG_PER_RAD, "rad/s"), (6.0, "rpm"), (360.0, "turns/s")):
        if abs(ratio / factor - 1.0) < _ALIKE:
            return f"the set rate seems to be in {unit}"
    if 0.0 < ratio < 1.0:
        return (
            f"as if the table had turned for {100.0 * ratio:.0f} % of the accumulation: it stopped"
            " or slowed down"
        )
    return "the set rate is wrong, or something disturbed the accumulation"


def _unsteady(x: FloatArray, se: FloatArray, rows: Sequence[int]) -> list[Note]:
    """Rows in which the outputs scattered far more than in the others."""
    with np.errstate(invalid="ignore"):
        known = np.isfinite(se).all(axis=0) & (np.median(se, axis=0) > 0)
        if not known.any():
            return []
        times = np.median(se[:, known] / np.median(se[:, known], axis=0), axis=1)
    return [
        Note(
            Severity.WARNING,
            "unsteady",
            f"row {rows[place]}, {x[place]:g} deg/s: the mean is {times[place]:.0f} times less"
            " certain than in the other rows; the table changed its rate during the accumulation",
        )
        for place in np.flatnonzero(times > _UNSTEADY).tolist()
    ]


def _clipped_notes(
    x: FloatArray, y: FloatArray, clipped: NDArray[np.bool_], channels: Sequence[str]
) -> list[Note]:
    notes: list[Note] = []
    for channel in np.flatnonzero(clipped.any(axis=0)).tolist():
        at = clipped[:, channel]
        rates = ", ".join(f"{rate:g}" for rate in np.unique(x[at]))
        outputs = ", ".join(f"{output:.6g}" for output in np.unique(y[at, channel]))
        notes.append(
            Note(
                Severity.WARNING,
                "clipped",
                f"{channels[channel]}: at {rates} deg/s the output ({outputs}) no longer follows"
                " the rate; the sensor or its converter is at its limit. These rows are left out of"
                " the line",
            )
        )
    return notes
