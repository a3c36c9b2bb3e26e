"""Numbers of a noise study as texts; needs no Qt, since ``calrig allan`` prints them too."""

import math
from collections.abc import Sequence

from core.allan.curve import AllanCurve
from core.records.noise_study import NoiseStudy
from core.records.noise_tables import Compared, Quote
from gui.widgets.number_text import decimals_of, fixed, significant

DEVIATIONS = {
    "hadamard": "Hadamard deviation",
    "modified": "Modified Allan deviation",
    "total": "Total deviation",
}
"""Names of the deviations that can stand beside Allan's."""

_MOST_DECIMALS = 6
_SHORT = {
    "random walk, two-sided S = N^2": "random walk, two-sided",
    "noise density, one-sided": "noise density, one-sided",
    "flicker coefficient B": "flicker coefficient",
    "floor of the Allan curve, 0.664 B": "floor of the curve, 0.664 B",
}
_BRIEF = {
    "random walk, two-sided S = N^2": "N  two-sided",
    "noise density, one-sided": "√2 N  one-sided",
    "flicker coefficient B": "B  flicker",
    "floor of the Allan curve, 0.664 B": "0.664 B  floor",
}


def number(value: float, resolution: float) -> str:
    """Return `value` with two digits of `resolution`; with an exponent where it is very small."""
    if not (math.isfinite(resolution) and resolution > 0.0 and math.isfinite(value)):
        return significant(value, 3)
    decimals = decimals_of(resolution)
    if decimals <= _MOST_DECIMALS or max(abs(value), resolution) >= 1e-3:
        return fixed(value, decimals)
    power = math.floor(math.log10(max(abs(value), resolution)))
    return f"{fixed(value * 10.0**-power, decimals + power)}e{power}".replace(
        "e-", "e\N{MINUS SIGN}"
    )


def short(value: float, digits: int = 2) -> str:
    """Return a number with few digits."""
    if value == 0.0 or not math.isfinite(value):
        return significant(value, digits)
    return number(value, 10.0 ** (math.floor(math.log10(abs(value))) - digits + 2))


def quoted(quote: Quote | None) -> str:
    """Return the value, or ``< limit``; a dash for what a method does not give."""
    if quote is None:
        return "\N{EM DASH}"
    if quote.upper_limit:
        return f"< {short(quote.upper)}"
    return number(quote.value, 0.5 * (quote.upper - quote.lower))


def interval(quote: Quote | None) -> str:
    """Return the 95 % interval; empty for a limit, which is one already."""
    if quote is None or quote.upper_limit:
        return ""
    half = 0.5 * (quote.upper - quote.lower)
    low, mark, power = number(quote.lower, half).partition("e")
    high, _, other = number(quote.upper, half).partition("e")
    if mark and power == other:
        return f"({low} \N{HORIZONTAL ELLIPSIS} {high})e{power}"
    return f"{number(quote.lower, half)} \N{HORIZONTAL ELLIPSIS} {number(quote.upper, half)}"


def words_of(quote: Quote) -> str:
    """Return what is quoted."""
    return _SHORT.get(quote.text, quote.text)


def brief_of(quote: Quote) -> str:
    """Return symbol and convention in as few words as tell it from the others."""
    return _BRIEF.get(quote.text, quote.symbol)


def duration(seconds: float) -> str:
    """Return a length of time: ``45 s``, ``12.5 min``, ``3 h``, ``2.1 d``."""
    for unit, size in (("d", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2.0 * size or (unit == "h" and seconds >= size):
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.3g} s"


def curve_rows(curve: AllanCurve, wanted: int = 12) -> list[tuple[str, ...]]:
    """Return some points of a curve as texts: tau, deviation, lower, upper, degrees of freedom."""
    step = max(1, len(curve.taus) // wanted)
    return [
        tuple(
            short(float(array[place]), digits)
            for array, digits in (
                (curve.taus, 4),
                (curve.deviation, 4),
                (curve.lower, 4),
                (curve.upper, 4),
                (curve.edf, 3),
            )
        )
        for place in range(0, len(curve.taus), step)
    ]


def titled(study: NoiseStudy) -> str:
    """Return the name of a study for lists and legends."""
    return f"{study.device} {study.channel}".strip()


def compared_rows(
    studies: Sequence[NoiseStudy], compared: Sequence[Compared]
) -> list[tuple[str, ...]]:
    """Return the comparison of lab 6 as rows of text: label, unit, one cell a device."""
    factors = tuple(
        "\N{EM DASH}" if one.scale_factor == 1.0 else significant(one.scale_factor, 6)
        for one in studies
    )
    rows = [("scale factor", "output/(unit)", *factors)]
    for row in compared:
        label = row.label.partition(": ")
        text = f"{label[0]}: {_SHORT.get(label[2], label[2])}"
        rows.append((text, row.unit, *(quoted(one) for one in row.quotes)))
    rows.append(("record", "", *(duration(s.coefficients.curve.duration) for s in studies)))
    rows.append(("rate", "Hz", *(f"{one.rate:.6g}" for one in studies)))
    return rows


def plain_unit(unit: str) -> str:
    """Return a unit as it is printed: ``°/s/√Hz`` for ``deg/s/sqrt(Hz)``."""
    text = unit.replace("deg/", "°/").replace("degC", "°C").replace("arcsec", "″")
    text = text.replace("sqrt(s)", "√s").replace("sqrt(h)", "√h").replace("sqrt(Hz)", "√Hz")
    return text.replace("s^2", "s²").replace("s^3", "s³").replace("ug", "µg")
