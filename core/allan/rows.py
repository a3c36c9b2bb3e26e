"""Rows of the coefficient table, one function a method."""

import math

import numpy as np

from core.allan.coefficients import NoiseRow
from core.allan.confidence import interval
from core.allan.conventions import unit_of
from core.allan.graphical import Reading
from core.allan.leastsquares import VarianceFit
from core.allan.model import TERMS
from core.allan.ramp import Ramp
from core.allan.whittle import ONE_SIDED, Bins, Likelihood, covariance_of, maximise, profile_limit

LEVEL = 0.95
TWO_SIDED_DROP = 3.841458820694124
"""Fall of 2 log L for a two-sided interval at 95 %."""
TWO_SIDED = 1.959963984540054
ONE_SIDED_NORMAL = 1.6448536269514722


def likelihood_rows(
    bins: Bins, best: Likelihood, terms: tuple[str, ...], unit: str
) -> list[NoiseRow]:
    """Return the rows of the maximum likelihood with profile intervals.

    A term is detected when leaving it out lowers 2 log L by more than 2.71 (5 %, one-sided).
    """
    covariance = covariance_of(bins, best.squares)
    rows: list[NoiseRow] = []
    for place, term in enumerate(terms):
        square = float(best.squares[place])
        value = math.sqrt(square)
        absent = maximise(bins, place, 0.0).deviance - best.deviance <= ONE_SIDED
        drop = ONE_SIDED if absent else TWO_SIDED_DROP
        upper = math.sqrt(profile_limit(bins, best, place, drop, upward=True))
        if absent:
            rows.append(_limit_row(term, value, upper, unit, "likelihood"))
            continue
        lower = math.sqrt(profile_limit(bins, best, place, drop, upward=False))
        u = math.sqrt(float(covariance[place, place])) / (2.0 * value)
        rows.append(_row(term, (value, u, lower, upper), unit, "likelihood"))
    return rows


def ramp_row(ramp: Ramp, unit: str) -> NoiseRow:
    """Return the signed ramp; its interval holds zero where it is not significant."""
    spread = TWO_SIDED * ramp.u
    numbers = (ramp.value, ramp.u, ramp.value - spread, ramp.value + spread)
    return _row("rate_ramp", numbers, unit, "likelihood")


def variance_rows(fit: VarianceFit, unit: str) -> list[NoiseRow]:
    """Return the rows of the least squares fit of the Allan variance."""
    rows: list[NoiseRow] = []
    for place, term in enumerate(fit.terms):
        square = float(fit.squares[place])
        spread = math.sqrt(float(fit.covariance[place, place]))
        value = math.sqrt(square)
        if square <= ONE_SIDED_NORMAL * spread:
            upper = math.sqrt(square + ONE_SIDED_NORMAL * spread)
            rows.append(_limit_row(term, value, upper, unit, "least_squares"))
            continue
        lower = math.sqrt(max(square - TWO_SIDED * spread, 0.0))
        upper = math.sqrt(square + TWO_SIDED * spread)
        rows.append(
            _row(term, (value, spread / (2.0 * value), lower, upper), unit, "least_squares")
        )
    return rows


def graphical_rows(readings: tuple[Reading, ...], unit: str) -> list[NoiseRow]:
    """Return the rows of the reading; their interval is that of one point, not of the method."""
    rows: list[NoiseRow] = []
    for reading in readings:
        lower, upper = interval(np.array([reading.value]), np.array([reading.edf]), LEVEL)
        if reading.bound:
            rows.append(_limit_row(reading.term, reading.value, float(upper[0]), unit, "graphical"))
            continue
        u = reading.value / math.sqrt(2.0 * reading.edf)
        numbers = (reading.value, u, float(lower[0]), float(upper[0]))
        rows.append(_row(reading.term, numbers, unit, "graphical"))
    return rows


def _row(term: str, numbers: tuple[float, float, float, float], unit: str, method: str) -> NoiseRow:
    value, u, lower, upper = numbers
    return NoiseRow(
        term=term,
        symbol=TERMS[term].symbol,
        value=value,
        u=u,
        lower=lower,
        upper=upper,
        unit=unit_of(term, unit),
        method=method,
        upper_limit=False,
    )


def _limit_row(term: str, value: float, upper: float, unit: str, method: str) -> NoiseRow:
    return NoiseRow(
        term=term,
        symbol=TERMS[term].symbol,
        value=value,
        u=(upper - value) / ONE_SIDED_NORMAL,
        lower=0.0,
        upper=upper,
        unit=unit_of(term, unit),
        method=method,
        upper_limit=True,
    )
