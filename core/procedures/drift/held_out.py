"""Every method judged on turn-ons that it has not seen.

Residuals on the turn-ons that made a table always fall with more knots; those on others stop
falling where the knots begin to follow the noise.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray
from core.procedures.drift.angles import sharpest_knots
from core.procedures.drift.curves import Curves
from core.procedures.drift.hats import hat_basis, projector
from core.procedures.drift.knots import optimal_knots
from core.procedures.drift.table import BYTES_PER_NUMBER, DriftTable

_AS_GOOD = 1.02
"""Residuals within 2 % of the least are as good: the smaller table is taken."""
_FLOAT_BYTES = 4


@dataclass(frozen=True, slots=True, eq=False)
class MethodScore:
    """How one method does on turn-ons that it has not seen.

    Parameters
    ----------
    method : key of `METHODS`
    rms : root mean square of the block means that it leaves, over all turn-ons
    by_temperature : (m,) the same at each temperature
    left : (m, k) the same at each temperature and time
    bytes : memory that it takes
    """

    method: str
    rms: float
    by_temperature: FloatArray
    left: FloatArray
    bytes: int


@dataclass(frozen=True, slots=True)
class KnotScore:
    """What is left on held-out turn-ons with a table of so many knots."""

    knots: int
    rms: float


Fit = Callable[[FloatArray, FloatArray, int], FloatArray]
"""Smooth curves (m, k) at times (k,) with so many knots."""


def knot_times(curves: Curves, places: IntArray) -> FloatArray:
    """Times of knots; the outermost at the edges of the blocks, where the table begins and ends."""
    times = curves.t[places].copy()
    times[0], times[-1] = curves.alignment.stop_s, curves.horizon_s
    return times


def broken_line(t: FloatArray, curves: FloatArray, knots: FloatArray) -> FloatArray:
    """The least-squares broken lines (m, k) of curves (m, k)."""
    return curves @ projector(t, knots).T @ hat_basis(t, knots).T


def _nothing(_t: FloatArray, curves: FloatArray, _knots: int) -> FloatArray:
    return np.zeros_like(curves)


def _itself(_t: FloatArray, curves: FloatArray, _knots: int) -> FloatArray:
    return curves


def _polynomial(order: int) -> Fit:
    def smooth(t: FloatArray, curves: FloatArray, _knots: int) -> FloatArray:
        x = (t - t[0]) / (t[-1] - t[0]) * 2.0 - 1.0
        q = np.linalg.qr(x[:, None] ** np.arange(order + 1))[0]
        return curves @ q @ q.T

    return smooth


def _angles(t: FloatArray, curves: FloatArray, knots: int) -> FloatArray:
    smooth = np.empty_like(curves)
    for row, curve in zip(smooth, curves, strict=True):
        places = sharpest_knots(curve, knots)
        row[:] = np.interp(t, t[places], curve[places])
    return smooth


def _optimal(t: FloatArray, curves: FloatArray, knots: int) -> FloatArray:
    return broken_line(t, curves, t[optimal_knots(t, curves, knots)[-1]])


METHODS: dict[str, Fit] = {
    "none": _nothing,
    "cubic": _polynomial(3),
    "quartic": _polynomial(4),
    "angles": _angles,
    "table": _optimal,
    "mean": _itself,
}
"""No correction; polynomials in time; the source's angles; CalRig's table, its knots left on the
blocks; the mean curve itself, the floor that no smoothing of it can beat by much."""


def method_bytes(method: str, temperatures: int, knots: int, blocks: int) -> int:
    """Memory that a method takes for all temperatures, without the temperatures themselves."""
    return {
        "none": 0,
        "cubic": 4 * _FLOAT_BYTES * temperatures,
        "quartic": 5 * _FLOAT_BYTES * temperatures,
        "angles": 2 * knots * BYTES_PER_NUMBER * temperatures,
        "table": (temperatures + 1) * knots * BYTES_PER_NUMBER,
        "mean": blocks * BYTES_PER_NUMBER * temperatures,
    }[method]


def folds_of(curves: Curves) -> tuple[int, ...]:
    """Ranks that can be left out: those with another turn-on of their temperature beside them."""
    return tuple(range(int(curves.counts.max()))) if curves.counts.max() > 1 else ()


def knot_scores(curves: Curves, limit: int) -> tuple[KnotScore, ...]:
    """What 2 ... `limit` knots leave on the turn-ons left out; empty without repetitions."""
    squares, count = np.zeros(limit - 1), 0
    for rank in folds_of(curves):
        held = _held(curves, rank)
        mean = curves.mean_without(rank)
        count += held.sum() * len(curves.t)
        for at, places in enumerate(optimal_knots(curves.t, mean, limit)):
            smooth = broken_line(curves.t, mean, knot_times(curves, places))
            squares[at] += float(np.sum((curves.y[held] - smooth[curves.place[held]]) ** 2))
    if not count:
        return ()
    return tuple(
        KnotScore(at + 2, float(np.sqrt(total / count))) for at, total in enumerate(squares)
    )


def fewest_knots(scores: tuple[KnotScore, ...]) -> int:
    """The fewest knots that leave hardly more than the least."""
    least = min(score.rms for score in scores)
    return next(score.knots for score in scores if score.rms <= _AS_GOOD * least)


def method_scores(curves: Curves, knots: int) -> tuple[MethodScore, ...]:
    """Every method on the turn-ons left out; empty without repetitions."""
    if not folds_of(curves):
        return ()
    return tuple(_score(curves, method, fit, knots) for method, fit in METHODS.items())


def score_of_knots(curves: Curves, times_s: FloatArray) -> MethodScore:
    """The table on given knots (p,), on the turn-ons left out.

    Notes
    -----
    The ordinates come from the other turn-ons, the knots from whoever saw them all.

    Raises
    ------
    ValueError
        There are no repeated turn-ons.
    """
    if not folds_of(curves):
        raise ValueError("without repeated turn-ons none can be left out")

    def on_them(t: FloatArray, mean: FloatArray, _knots: int) -> FloatArray:
        return broken_line(t, mean, times_s)

    return _score(curves, "table", on_them, len(times_s))


def _score(curves: Curves, method: str, fit: Fit, knots: int) -> MethodScore:
    m, blocks = len(curves.temperatures_c), len(curves.t)
    squares, counts = np.zeros((m, blocks)), np.zeros(m)
    for rank in folds_of(curves):
        held = _held(curves, rank)
        place = curves.place[held]
        counts += np.bincount(place, minlength=m)
        left = curves.y[held] - fit(curves.t, curves.mean_without(rank), knots)[place]
        np.add.at(squares, place, left**2)
    with np.errstate(invalid="ignore"):
        return MethodScore(
            method,
            float(np.sqrt(squares.sum() / counts.sum() / blocks)),
            np.sqrt(squares.sum(axis=1) / counts / blocks),
            np.sqrt(squares / counts[:, None]),
            method_bytes(method, m, knots, blocks),
        )


def node_scores(curves: Curves, times_s: FloatArray) -> FloatArray:
    """What is left (m,) at each temperature if its own node were missing, rms.

    Parameters
    ----------
    times_s : (p,) knots

    Returns
    -------
    NaN at the outermost temperatures, which nothing can replace
        The values are interpolated between the neighbours; the measure of whether the
        temperatures are near enough to each other.
    """
    values = curves.mean @ projector(curves.t, times_s).T
    basis, nodes = hat_basis(curves.t, times_s), curves.temperatures_c
    left = np.full(len(nodes), np.nan)
    for at in range(1, len(nodes) - 1):
        share = (nodes[at] - nodes[at - 1]) / (nodes[at + 1] - nodes[at - 1])
        between = (1.0 - share) * values[at - 1] + share * values[at + 1]
        away: FloatArray = curves.y[curves.place == at] - basis @ between
        left[at] = float(np.sqrt(np.mean(away**2)))
    return left


def residuals_of(table: DriftTable, curves: Curves) -> FloatArray:
    """What a table leaves (r, k) of other turn-ons.

    Raises
    ------
    FitError
        A turn-on began outside the temperatures of the table.
    """
    rows: list[FloatArray] = []
    for y, start_c, place in zip(curves.y, curves.start_c, curves.place, strict=True):
        known = start_c if np.isfinite(start_c) else curves.temperatures_c[place]
        rows.append(y - table.correction(curves.t, float(known)))
    return np.array(rows)


def _held(curves: Curves, rank: int) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    return (curves.ranks == rank) & (curves.counts[curves.place] > 1)
