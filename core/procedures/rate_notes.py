"""Doubts about a rate-table result, in plain words."""

import math
from collections.abc import Sequence

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import Note, Severity
from core.fit.estimate import Estimate, parameter, ratio
from core.fit.lack import REJECTED
from core.fit.result import FitResult
from core.procedures.characteristic import Points, Term
from core.procedures.earth import feels, latitude_missing
from core.units import DEG_PER_RAD, DPH_PER_DPS, EARTH_RATE_DPS

_UNITS = ((DEG_PER_RAD, "rad/s"), (DPH_PER_DPS, "deg/h"), (6.0, "rpm"))
_NEAR = 0.05
_FAR = 0.1
_COMMON = 0.8
_WARM_C = 5.0


def sensor_notes(
    channel: str,
    fit: FitResult,
    points: Points,
    terms: tuple[Term, ...],
    halves: tuple[Estimate, Estimate, Estimate] | None,
    *,
    earth_known: bool,
    expected: float | None,
) -> tuple[Note, ...]:
    """What is doubtful about one sensor.

    Parameters
    ----------
    channel : its name
    fit, points : its line
    terms, halves : what is bent about it
    earth_known : whether a latitude was stated
    expected : an earlier scale factor, None if there is none
    """
    k, bias = parameter(fit, "scale_factor"), ratio(fit, "bias", "scale_factor", "deg/s")
    notes: list[Note] = []
    if len(np.unique(points.x)) == 2:
        notes.append(_two_rates(channel))
    if k.u > 0 and not k.significant:
        notes.append(_insensitive(channel, k))
        return tuple(notes)
    if k.value < 0:
        notes.append(_negative(channel, k))
    notes.extend(_bent(channel, points, terms, halves))
    if expected is not None:
        notes.extend(_unexpected(channel, k, expected))
    if not earth_known and feels(bias.expanded(), EARTH_RATE_DPS, math.nan):
        note = latitude_missing(f"the zero of {channel}", "state the latitude")
        notes.append(note)
    return tuple(notes)


def table_notes(residuals: Sequence[tuple[FloatArray, IntArray, tuple[Term, ...]]]) -> list[Note]:
    """What several sensors that turned together say about the table.

    Parameters
    ----------
    residuals : of each sensor: errors (m,) of the calibrated rates in deg/s, their rows (m,), and
        the tests of its bend
    """
    straight = [
        (errors, tuple(rows.tolist()))
        for errors, rows, terms in residuals
        if not any(term.p_value < REJECTED for term in terms)
    ]
    alike = [errors for errors, rows in straight if rows == straight[0][1]]
    if len(alike) < 3 or len(alike[0]) < 5:
        return []
    table = np.array(alike)
    common = table.mean(axis=0)
    if len(alike) * float(common @ common) < _COMMON * float(np.sum(table**2)):
        return []
    return [
        Note(
            Severity.INFO,
            "common_error",
            f"the errors of {len(alike)} sensors go together ({common.std(ddof=2):.2g} deg/s): the"
            " table is at fault, not the sensors. State the uncertainty of its rate, so that it"
            " weighs",
        )
    ]


def temperature_notes(known: FloatArray) -> list[Note]:
    """Rows at different temperatures, in degC, that one line was laid through."""
    if not known.size or np.ptp(known) <= _WARM_C:
        return []
    text = (
        f"the rows are from {known.min():.0f} to {known.max():.0f} degC, and one line went through"
        " all of them; fit each temperature on its own"
    )
    return [Note(Severity.WARNING, "temperature_varies", text)]


def _bent(
    channel: str,
    points: Points,
    terms: tuple[Term, ...],
    halves: tuple[Estimate, Estimate, Estimate] | None,
) -> list[Note]:
    worst = min(terms, key=lambda term: term.p_value, default=None)
    if worst is None or worst.p_value >= REJECTED:
        return []
    shape = "parabola" if worst.power == 2 else "cubic"
    also = ""
    if worst.power == 2 and halves is not None and halves[2].significant:
        also = (
            f" Unequal scale factors of the two senses ({halves[2].value:+.0f} ppm) would look much"
            " the same; more rates near zero tell the two apart."
        )
    return [
        Note(
            Severity.WARNING,
            "not_straight",
            f"{channel}: the straight line is rejected (p = {worst.p_value:.2g}); a {shape} of"
            f" {worst.coefficient.value:.3g} {worst.coefficient.unit} fits significantly better. It"
            f" bends the characteristic by {abs(worst.bend_ppm):.0f} ppm of"
            f" {points.full_scale:g} deg/s.{also}",
        )
    ]


def _unexpected(channel: str, k: Estimate, expected: float) -> list[Note]:
    found = k.value / expected
    if found < 0:
        text = (
            f"{channel}: the scale factor {k.value:.6g} {k.unit} has the opposite sign of the"
            f" expected {expected:.6g}: the table was turned the wrong way, or the unit lay upside"
            " down"
        )
        return [Note(Severity.ERROR, "sign_reversed", text)]
    for factor, unit in _UNITS:
        for over in (factor, 1.0 / factor):
            if abs(found / over - 1.0) < _NEAR:
                text = (
                    f"{channel}: the scale factor is {found:.4g} times the expected one, which is"
                    f" the ratio of deg/s and {unit}: the rates or the outputs are in another unit"
                )
                return [Note(Severity.ERROR, "wrong_unit", text)]
    if abs(found - 1.0) > _FAR:
        text = (
            f"{channel}: the scale factor {k.value:.6g} {k.unit} is {100.0 * (found - 1.0):+.0f} %"
            f" from the expected {expected:.6g}: another unit, range or channel?"
        )
        return [Note(Severity.WARNING, "scale_factor_unexpected", text)]
    return []


def _two_rates(channel: str) -> Note:
    return Note(
        Severity.WARNING,
        "two_rates",
        f"{channel}: two rates always lie on a line, so nothing can contradict it; measure three"
        " or more",
    )


def _insensitive(channel: str, k: Estimate) -> Note:
    return Note(
        Severity.ERROR,
        "insensitive",
        f"{channel}: no answer to the rate ({k.value:.3g} +/- {k.expanded():.2g} {k.unit}); another"
        " axis, or the table did not turn",
    )


def _negative(channel: str, k: Estimate) -> Note:
    return Note(
        Severity.INFO,
        "negative_scale_factor",
        f"{channel}: the scale factor is negative ({k.value:.6g} {k.unit}), which is legal; the"
        " output falls when the unit turns counter-clockwise seen from above",
    )
