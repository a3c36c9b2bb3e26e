"""A result -> what the plots draw."""

from collections.abc import Iterator

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.procedures.drift.compensate import DriftResult
from gui.analysis.curves import LineState
from gui.drift.knots import Knots
from gui.drift.state import ALL, KnotsState, PictureState
from gui.drift.texts import method_words, shown_unit
from gui.widgets.number_text import fixed, significant

_TURN_ON, _MEAN = 5, 0
_COLOURS = {"none": 4, "cubic": 1, "quartic": 3, "angles": 2, "table": 6, "mean": 5}
_SMOOTHED = ("none", "quartic", "angles", "mean", "table")
_FLOOR = 1e-3


def picture_of(result: DriftResult, shown: int) -> PictureState:
    """Return the curves of one temperature, or the means of all.

    Parameters
    ----------
    shown : place of the temperature, or `ALL`
    """
    unit, _ = shown_unit(result.table.unit)
    return PictureState(
        unit,
        tuple(_turn_ons(result, shown)),
        tuple(_means(result, shown)),
        tuple(_left(result, shown)),
    )


def knots_of(knots: Knots, shown: int) -> KnotsState:
    """Return the table as it is drawn now, with its cost."""
    table = knots.table
    unit, factor = shown_unit(table.unit)
    places = slice(None) if shown == ALL else slice(shown, shown + 1)
    words = QCoreApplication.translate(
        "Drift", "cost {cost} {unit} rms on the means (optimal {best}), {p} knots, {bytes} bytes"
    )
    return KnotsState(
        table.times_s,
        table.values[places] * factor,
        words.format(
            cost=significant(knots.cost * factor, 3),
            unit=unit,
            best=significant(knots.optimal_cost * factor, 3),
            p=len(table.times_s),
            bytes=table.bytes,
        ),
    )


def knot_words(time_s: float) -> str:
    """Where a knot stands."""
    return f"t = {fixed(time_s, 2)} s"


def _turn_ons(result: DriftResult, shown: int) -> Iterator[LineState]:
    if shown == ALL:
        return
    curves, (_, factor) = result.curves, shown_unit(result.table.unit)
    name = QCoreApplication.translate("Drift", "turn-ons")
    for row in np.flatnonzero(curves.place == shown):
        yield LineState(curves.t, curves.y[row] * factor, _TURN_ON, name)
        name = ""


def _means(result: DriftResult, shown: int) -> Iterator[LineState]:
    curves, (_, factor) = result.curves, shown_unit(result.table.unit)
    mean = curves.mean * factor
    name = QCoreApplication.translate("Drift", "mean")
    for at in range(len(mean)) if shown == ALL else (shown,):
        yield LineState(curves.t, mean[at], _MEAN, name)
        name = ""


def _left(result: DriftResult, shown: int) -> Iterator[LineState]:
    """What is left against time, over all held-out turn-ons that are shown."""
    words, (_, factor) = method_words(), shown_unit(result.table.unit)
    by_name = {one.method: one for one in result.methods}
    if not by_name:
        return
    weights = result.curves.counts.astype(np.float64)
    for method in _SMOOTHED:
        squares = by_name[method].left ** 2
        rows = ~np.isnan(squares[:, 0])
        if shown != ALL:
            if not rows[shown]:
                return
            left = by_name[method].left[shown]
        else:
            left = np.sqrt(np.average(squares[rows], axis=0, weights=weights[rows]))
        # A residual of a few turn-ons passes zero now and then, which a logarithm cannot show.
        floor = _FLOOR * float(left.max())
        yield LineState(
            result.curves.t,
            np.maximum(left, floor) * factor,
            _COLOURS[method],
            words[method],
            dashed=method == "mean",
        )
