"""Noise coefficients as people quote and compare them: one number a line, with its interval."""

from collections.abc import Sequence
from dataclasses import dataclass

from core.allan.coefficients import NoiseCoefficients, NoiseRow
from core.allan.conventions import Convention, conventions
from core.allan.model import TERMS
from core.records.noise_study import NoiseStudy

METHODS = ("likelihood", "least_squares", "graphical")
"""In the order in which they are to be believed."""
NAMES = {
    "quantization": "quantisation",
    "random_walk": "random walk",
    "bias_instability": "bias instability",
    "rate_random_walk": "rate random walk",
    "rate_ramp": "rate ramp",
}
ORDER = ("random_walk", "bias_instability", "rate_random_walk", "rate_ramp", "quantization")
COMPARED = (
    ("random_walk", "si"),
    ("random_walk", "per_root_hour"),
    ("random_walk", "one_sided"),
    ("bias_instability", "si"),
    ("bias_instability", "per_hour"),
    ("bias_instability", "floor"),
    ("bias_instability", "micro_g"),
    ("rate_random_walk", "si"),
    ("rate_random_walk", "per_root_hour"),
)
"""Rows of the comparison: term and convention."""


@dataclass(frozen=True, slots=True)
class Quote:
    """One coefficient in one convention.

    Parameters
    ----------
    term, symbol : which
    method : by which it was found
    text : what is quoted, in words
    unit : of the numbers
    value, u, lower, upper : estimate, standard uncertainty and 95 % interval
    upper_limit : the term was not detected: only ``< upper`` may be quoted
    """

    term: str
    symbol: str
    method: str
    text: str
    unit: str
    value: float
    u: float
    lower: float
    upper: float
    upper_limit: bool


@dataclass(frozen=True, slots=True)
class Compared:
    """One row of the comparison of devices.

    Parameters
    ----------
    label, unit : of the row
    quotes : one a device; None where its record is in another unit or was not fitted
    """

    label: str
    unit: str
    quotes: tuple[Quote | None, ...]


def quote(row: NoiseRow, convention: Convention) -> Quote:
    """Return a coefficient in a convention."""
    factor = convention.factor
    return Quote(
        term=row.term,
        symbol=row.symbol,
        method=row.method,
        text=convention.text,
        unit=convention.unit,
        value=row.value * factor,
        u=row.u * factor,
        lower=row.lower * factor,
        upper=row.upper * factor,
        upper_limit=row.upper_limit,
    )


def terms_of(found: NoiseCoefficients) -> tuple[str, ...]:
    """Return the terms that were fitted, in the order of reading."""
    fitted = {row.term for row in found.rows}
    return tuple(term for term in ORDER if term in fitted)


def by_method(found: NoiseCoefficients, term: str) -> tuple[Quote | None, ...]:
    """Return a coefficient by each of METHODS in its own unit; None where one gives none."""
    own = conventions(term, found.unit)[0]
    rows = {row.method: row for row in found.rows if row.term == term}
    return tuple(quote(rows[name], own) if name in rows else None for name in METHODS)


def in_conventions(found: NoiseCoefficients, term: str) -> tuple[Quote, ...]:
    """Return the published value of a coefficient in every convention; nothing without a fit."""
    row = published_row(found, term)
    if row is None:
        return ()
    return tuple(quote(row, convention) for convention in conventions(term, found.unit))


def published_row(found: NoiseCoefficients, term: str) -> NoiseRow | None:
    """Return the row to publish; None where no noise model could be fitted."""
    rows = (row for row in found.rows if row.term == term and row.method == METHODS[0])
    return next(rows, None)


def comparison(studies: Sequence[NoiseStudy]) -> tuple[Compared, ...]:
    """Return the comparison of devices of lab 6, with every convention in which B and N are quoted.

    A row whose convention belongs to no record's unit is left out.
    """
    rows: list[Compared] = []
    units = dict.fromkeys(one.unit for one in studies)
    for unit in units:
        for term, name in COMPARED:
            matching = [one for one in conventions(term, unit) if one.name == name]
            if not matching:
                continue
            found = [
                published_row(one.published, term) if one.unit == unit else None for one in studies
            ]
            quotes = tuple(None if row is None else quote(row, matching[0]) for row in found)
            label = f"{TERMS[term].symbol}: {matching[0].text}"
            rows.append(Compared(label, matching[0].unit, quotes))
    return tuple(rows)
