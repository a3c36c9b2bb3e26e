"""Numbers and words of the archive; needs no Qt, since ``calrig archive`` prints them too."""

import math
from collections.abc import Iterable, Sequence
from datetime import datetime

from core.archive.compare import Compared, Difference
from core.archive.entry import Entry, Quantity
from core.archive.history import History
from core.archive.limits import Limit
from core.archive.reprocess import Redone
from gui.widgets.number_text import decimals_of, fixed, significant, value_and_uncertainty

DASH = "\N{EM DASH}"


def local(measured: str) -> str:
    """A stored moment as the wall clock of this computer shows it, to the minute."""
    if not measured:
        return ""
    return datetime.fromisoformat(measured).astimezone().strftime("%Y-%m-%d %H:%M")


def degrees(temperature_c: float) -> str:
    """A temperature for a list."""
    return "" if math.isnan(temperature_c) else fixed(temperature_c, 1)


def listed(entry: Entry) -> tuple[str, ...]:
    """An entry as the line of a list, in the columns of `LISTED`."""
    return (
        entry.serial,
        entry.kind,
        local(entry.measured),
        degrees(entry.temperature_c),
        entry.verdict,
        entry.operator,
        entry.what,
    )


LISTED = ("serial", "kind", "measured", "°C", "verdict", "operator", "what")


def parameter_row(quantity: Quantity, limit: Limit | None) -> tuple[str, ...]:
    """A parameter: channel, name, value, expanded uncertainty, unit, verdict on its limit."""
    value, expanded = value_and_uncertainty(quantity.value, quantity.expanded())
    judged = "" if limit is None else limit.judge(quantity).value
    return (quantity.channel, spoken(quantity.name), value, expanded, quantity.unit, judged)


def spoken(name: str) -> str:
    """``cross_axis_y`` -> ``cross axis y``."""
    return name.replace("_", " ")


def compared_row(row: Difference) -> tuple[str, ...]:
    """Channel, parameter, both values, difference, its expanded uncertainty, ratio, unit."""
    known = row.u > 0.0 and math.isfinite(row.u)
    decimals = decimals_of(2.0 * row.u) if known else 0
    numbers = (row.first, row.second, row.difference)
    texts = [fixed(x, decimals) if known else significant(x, 7) for x in numbers]
    ratio = fixed(row.ratio, 1) if known else DASH
    expanded = fixed(2.0 * row.u, decimals) if known else DASH
    mark = "  !" if row.marked else ""
    return (row.channel, spoken(row.name), *texts, expanded, ratio + mark, row.unit)


COMPARED = ("channel", "parameter", "first", "second", "difference", "U (k = 2)", "d / u", "unit")


def compared_summary(compared: Compared) -> str:
    """How many differences are marked."""
    return f"{compared.marked} of {len(compared.rows)} differ by more than 2 u"


def history_rows(history: History) -> list[tuple[str, ...]]:
    """Every value: moment, temperature, value, expanded uncertainty, verdict; earliest first."""
    rows: list[tuple[str, ...]] = []
    for reading, counted in zip(history.readings, history.counted, strict=True):
        entry, quantity = reading.entry, reading.quantity
        value, expanded = value_and_uncertainty(quantity.value, quantity.expanded())
        judged = "" if history.limit is None else history.limit.judge(quantity).value
        doubt = "" if counted else "not counted"
        words = ", ".join(word for word in (judged, doubt) if word)
        rows.append((local(entry.measured), degrees(entry.temperature_c), value, expanded, words))
    return rows


HISTORY = ("measured", "°C", "value", "U", "")


def statistics_rows(history: History) -> list[tuple[str, ...]]:
    """Mean, repeatability, excess, drift, limits: name, value, uncertainty, unit."""
    unit, spread = history.unit, history.repeatability
    known = math.isfinite(spread) and spread > 0.0
    mean = fixed(history.mean, decimals_of(spread)) if known else significant(history.mean, 7)
    rows = [("mean", mean, "", unit)]
    if known:
        value, u = value_and_uncertainty(spread, history.u_repeatability)
        rows.append(("repeatability, turn-on to turn-on, 1 s", value, u, unit))
        excess = fixed(history.excess, decimals_of(history.u_repeatability))
        rows.append(("  of it beyond the uncertainties", excess, "", unit))
    if history.drift is not None:
        value, expanded = value_and_uncertainty(history.drift.value, history.drift.expanded())
        seen = "drift" if history.drift.significant else "drift, not significant"
        rows.append((seen, value, expanded, history.drift.unit))
    if history.limit is not None:
        rows.append(("limits", limits_text(history.limit), "", unit))
    return rows


def limits_text(limit: Limit) -> str:
    """Both limits, or the one there is."""
    low, high = limit.low, limit.high
    if math.isinf(low):
        return f"≤ {significant(high, 6)}"
    if math.isinf(high):
        return f"≥ {significant(low, 6)}"
    return f"{significant(low, 6)} … {significant(high, 6)}"


def redone_row(one: Redone) -> tuple[str, ...]:
    """A position decoded again: step, samples stored and found, largest difference, words."""
    step = one.position.step
    where = f"{step.number}  {step.mount} {step.head_deg:g}°".rstrip()
    if one.why_not:
        return (where, str(one.position.accumulation.n), DASH, DASH, one.why_not)
    largest = DASH if math.isnan(one.largest) else significant(one.largest, 3)
    words = "the same" if one.same else "differs"
    return (where, str(one.position.accumulation.n), str(one.n), largest, words)


REDONE = ("position", "samples", "again", "largest d / se", "")


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Columns under their header, for a console."""
    lines = [tuple(header), *(tuple(row) for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    return "\n".join(
        "  ".join(text.ljust(width) for text, width in zip(line, widths, strict=True)).rstrip()
        for line in lines
    )
