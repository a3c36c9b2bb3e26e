"""Numbers and words of the archive; needs no Qt, since ``calrig archive`` prints them too."""

import math
from collections.abc import Iterable, Sequence
from datetime import datetime

from core.archive.compare import Compared, Difference
from core.archive.entry import Entry, Quantity
from core.archive.history import History
from core.archive.limits import Limit
from core.archive.reprocess import Redone
from gui.widgets.number_text import MINUS, decimals_of, fixed, significant, value_and_uncertainty

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
        entry.verdict,
        degrees(entry.temperature_c),
        entry.operator,
        entry.what,
    )


LISTED = ("serial", "kind", "measured", "verdict", "°C", "operator", "what")


def parameter_row(quantity: Quantity, limit: Limit | None) -> tuple[str, ...]:
    """A parameter: channel, name, value, expanded uncertainty, unit, verdict on its limit."""
    value, expanded = value_and_uncertainty(quantity.value, quantity.expanded())
    judged = "" if limit is None else limit.judge(quantity).value
    return (quantity.channel, spoken(quantity.name), value, expanded, quantity.unit, judged)


def spoken(name: str) -> str:
    """``cross_axis_y`` -> ``cross axis y``."""
    return name.replace("_", " ")


def compared_row(row: Difference) -> tuple[str, ...]:
    """A difference as a line, in the columns of `COMPARED`."""
    known = row.u > 0.0 and math.isfinite(row.u)
    decimals = decimals_of(2.0 * row.u) if known else 0
    numbers = (row.first, row.second, row.difference)
    texts = [fixed(x, decimals) if known else significant(x, 7) for x in numbers]
    ratio = fixed(row.ratio, 1) if known else DASH
    expanded = fixed(2.0 * row.u, decimals) if known else DASH
    mark = "differs" if row.marked else ""
    names = (row.channel, spoken(row.name), mark)
    return (*names, ratio, texts[2], expanded, row.unit, texts[0], texts[1])


COMPARED = ("channel", "parameter", "", "d / u", "d", "U (k = 2)", "unit", "first", "second")


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
        rows.append(("repeatability s", value, u, unit))
        excess = fixed(history.excess, decimals_of(history.u_repeatability))
        rows.append(("s beyond the u", excess, "", unit))
    if history.drift is not None:
        value, expanded = value_and_uncertainty(history.drift.value, history.drift.expanded())
        seen = "drift" if history.drift.significant else "drift, not significant"
        rows.append((seen, value, expanded, history.drift.unit))
    if history.limit is not None:
        rows.append(("limits", limits_text(history.limit), "", unit))
    return rows


def limits_text(limit: Limit) -> str:
    """Both limits, or the one there is."""
    low, high = (f"{bound:g}".replace("-", MINUS) for bound in (limit.low, limit.high))
    if math.isinf(limit.low):
        return f"≤ {high}"
    return f"≥ {low}" if math.isinf(limit.high) else f"{low} … {high}"


def redone_row(one: Redone) -> tuple[str, ...]:
    """A position decoded again, in the columns of `REDONE`."""
    step = one.position.step
    where = f"{step.number}  {step.mount} {step.head_deg:g}°".rstrip()
    stored = str(one.position.accumulation.n)
    if one.why_not:
        return (where, "not possible", stored, DASH, DASH)
    largest = DASH if math.isnan(one.largest) else significant(one.largest, 3)
    return (where, "the same" if one.same else "differs", stored, str(one.n), largest)


def reasons(found: Iterable[Redone]) -> tuple[str, ...]:
    """Why positions could not be decoded, each reason once."""
    return tuple(dict.fromkeys(one.why_not for one in found if one.why_not))


REDONE = ("position", "", "samples", "again", "largest d / se")


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Columns under their header, for a console."""
    lines = [tuple(header), *(tuple(row) for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    return "\n".join(
        "  ".join(text.ljust(width) for text, width in zip(line, widths, strict=True)).rstrip()
        for line in lines
    )
