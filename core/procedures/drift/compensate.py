"""From turn-ons to a table: the procedure of source 003 with the best knots."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note, Severity
from core.procedures.drift.angles import temperature_slopes
from core.procedures.drift.curves import Curves
from core.procedures.drift.hats import hat_basis, projector, refine
from core.procedures.drift.held_out import (
    KnotScore,
    MethodScore,
    fewest_knots,
    knot_scores,
    knot_times,
    method_scores,
    score_of_knots,
)
from core.procedures.drift.knots import optimal_knots
from core.procedures.drift.table import DriftTable

DEFAULT_KNOTS = 10
_DOMINATES = 0.5
_LEAST_U_C = 1e-3
"""Uncertainty of a mean chip temperature that a sensor without noise would pretend to, degC."""


@dataclass(frozen=True, slots=True, eq=False)
class DriftResult:
    """A table with what speaks for it.

    Parameters
    ----------
    curves : what it was made from
    table : the correction
    limit : largest number of knots that the memory allows
    knot_scores : residual on held-out turn-ons against the number of knots; empty without
        repeated turn-ons
    methods : all methods on held-out turn-ons; empty without repeated turn-ons
    notes : every doubt
    """

    curves: Curves
    table: DriftTable
    limit: int
    knot_scores: tuple[KnotScore, ...]
    methods: tuple[MethodScore, ...]
    notes: tuple[Note, ...]

    @property
    def residuals(self) -> FloatArray:
        """What the table leaves (m, k) of the mean curves that it was made from."""
        smooth = self.table.values @ hat_basis(self.curves.t, self.table.times_s).T
        return self.curves.mean - smooth

    def score(self, method: str) -> MethodScore:
        """The score of one method; KeyError without repeated turn-ons."""
        for one in self.methods:
            if one.method == method:
                return one
        raise KeyError(method)


def compensate(
    curves: Curves, unit: str, *, limit: int = 16, knots: int | None = None
) -> DriftResult:
    """Make the table.

    Parameters
    ----------
    curves : see `curves_of`
    unit : of the output
    limit : memory limit tp of the microcontroller: at most so many knots
    knots : how many to use; by default as many as held-out turn-ons ask for

    Raises
    ------
    FitError
        The limit or the number of knots does not fit the blocks.
    """
    blocks = len(curves.t)
    if not 2 <= limit <= blocks // 2:
        raise FitError(f"{limit} knots for {blocks} blocks; state between 2 and {blocks // 2}")
    if knots is not None and not 2 <= knots <= limit:
        raise FitError(f"{knots} knots; the memory limit allows 2 to {limit}")
    scores = knot_scores(curves, limit)
    notes = [*curves.notes]
    if not scores:
        notes.append(
            Note(
                Severity.WARNING,
                "no_repetition",
                "each temperature has one turn-on: nothing tells drift from what differs between"
                " turn-ons, and the number of knots is not tested; make about five",
            )
        )
    chosen = knots or (fewest_knots(scores) if scores else min(DEFAULT_KNOTS, limit))
    mean = curves.mean
    places = optimal_knots(curves.t, mean, chosen)[-1]
    table = with_knots(curves, unit, refine(curves.t, mean, knot_times(curves, places)))
    methods = method_scores(curves, chosen)
    notes += _doubts(curves, methods, unit)
    notes += _plateaus(curves, table)
    return DriftResult(curves, table, limit, scores, methods, tuple(notes))


def with_knots(curves: Curves, unit: str, times_s: FloatArray | Sequence[float]) -> DriftTable:
    """The best table on given knots, e.g. dragged by the operator.

    Parameters
    ----------
    curves : see `curves_of`
    unit : of the output
    times_s : (p,) knots, ascending

    Raises
    ------
    FitError
        Knots coincide, are out of order, or have no block between them.
    """
    times = np.asarray(times_s, dtype=np.float64)
    block = float(curves.t[1] - curves.t[0])
    if len(times) < 2 or np.any(np.diff(times) <= 0):
        raise FitError("knots must be two or more times in ascending order")
    if np.diff(times).min() < block * (1.0 - 1e-9):
        raise FitError(f"knots nearer to each other than a block of {block:g} s mean nothing")
    project = projector(curves.t, times)
    each = curves.y @ project.T
    m, p = len(curves.temperatures_c), len(times)
    values, u = np.empty((m, p)), np.full((m, p), np.nan)
    for at in range(m):
        rows = each[curves.place == at]
        values[at] = rows.mean(axis=0)
        if len(rows) > 1:
            u[at] = rows.std(axis=0, ddof=1) / np.sqrt(len(rows))
    return DriftTable(
        unit=unit,
        times_s=frozen(times),
        temperatures_c=curves.temperatures_c,
        values=frozen(values),
        u=frozen(u),
        dof=frozen(curves.counts - 1.0),
        alignment=curves.alignment,
    )


def moved(result: DriftResult, times_s: FloatArray | Sequence[float]) -> DriftResult:
    """The result on other knots, e.g. after the operator has dragged one.

    Raises
    ------
    FitError
        As `with_knots`.
    """
    table = with_knots(result.curves, result.table.unit, times_s)
    methods = tuple(
        score_of_knots(result.curves, table.times_s) if one.method == "table" else one
        for one in result.methods
    )
    by_hand = Note(
        Severity.INFO,
        "moved_knots",
        "the knots were moved by hand: the score of this table takes them as given, that of the"
        " optimal table also holds what searching them without the held-out turn-on costs",
    )
    return replace(result, table=table, methods=methods, notes=(*result.notes, by_hand))


def cost_of(curves: Curves, table: DriftTable) -> float:
    """Root mean square of what a table leaves of the mean curves, output unit."""
    left = curves.mean - table.values @ hat_basis(curves.t, table.times_s).T
    return float(np.sqrt(np.mean(left**2)))


def _doubts(curves: Curves, methods: tuple[MethodScore, ...], unit: str) -> list[Note]:
    notes: list[Note] = []
    by_name = {score.method: score.rms for score in methods}
    if not by_name:
        return notes
    u = curves.alignment.u
    if u > _DOMINATES * by_name["table"]:
        window = curves.alignment.stop_s - curves.alignment.start_s
        notes.append(
            Note(
                Severity.INFO,
                "alignment_noise",
                f"the start is aligned by a mean over {window:g} s, whose noise of {u:.3g} {unit}"
                f" is a large part of the {by_name['table']:.3g} {unit} that the table leaves; a"
                " longer window would help more than more knots",
            )
        )
    if by_name["table"] > by_name["none"]:
        notes.append(
            Note(
                Severity.WARNING,
                "no_gain",
                f"on turn-ons that it has not seen the table leaves {by_name['table']:.3g} {unit},"
                f" no correction {by_name['none']:.3g}: the drift does not repeat, do not use it",
            )
        )
    return notes


def _plateaus(curves: Curves, table: DriftTable) -> list[Note]:
    """Where the source's coefficients against temperature would divide by nothing."""
    if not np.all(np.isfinite(curves.chip_c)):
        return []
    lost: list[str] = []
    for place, start in enumerate(curves.temperatures_c.tolist()):
        warm, values = curves.chip_c[place], table.values[place]
        at_knots = np.asarray(np.interp(table.times_s, curves.t, warm), dtype=np.float64)
        # Third differences are blind to the warming up and show the noise of the block means.
        jerks: FloatArray = np.diff(warm, 3)
        u = max(float(np.sqrt(np.mean(jerks**2) / 20.0)), _LEAST_U_C)
        slopes, _ = temperature_slopes(values, at_knots, u)
        if np.isnan(slopes).any():
            lost.append(f"{start:.0f}")
    if not lost:
        return []
    return [
        Note(
            Severity.INFO,
            "temperature_plateau",
            f"in the sets at {', '.join(lost)} degC there are segments in which the chip's"
            " temperature stands still: the source's coefficients against temperature (1) divide"
            " by zero there; this table runs over time and needs none",
        )
    ]
