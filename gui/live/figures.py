"""Statistics between the cursors as a table."""

import math

from PySide6.QtCore import QCoreApplication

from gui.live.trace import Trace
from gui.widgets.number_text import decimals_of, fixed, significant
from gui.widgets.states import TableState

_DIGITS, _FEW = 8, 4


def _say(text: str) -> str:
    return QCoreApplication.translate("LiveFigures", text)


def cursor_table(trace: Trace, shown: list[int], a: float | None, b: float | None) -> TableState:
    """Mean, sigma, extremes and slope of every shown channel between A and B.

    Parameters
    ----------
    trace : the samples
    shown : numbers of the channels
    a, b : times of the cursors, s; None where one is not set
    """
    header = tuple(
        map(_say, ("Channel", "Unit", "n", "Mean", "σ", "Min", "Max", "Max − Min", "Slope, 1/s"))
    )
    if a is None or b is None:
        hint = _say("Click into the charts for cursor A, Shift+click for B.")
        return TableState("", hint, (), ())
    start, stop = sorted((a, b))
    history = trace.history
    first, end = history.number(start), history.number(stop) + 1
    rows: list[tuple[str, ...]] = []
    for channel in shown:
        found = history.statistics(channel, first, end)
        described = history.channels[channel]
        level = (_level(value, found.sigma) for value in (found.mean, found.low, found.high))
        mean, low, high = level
        rows.append(
            (
                described.name,
                described.unit,
                str(found.count),
                mean,
                _number(found.sigma, _FEW),
                low,
                high,
                _number(found.high - found.low, _FEW),
                _number(found.slope, _FEW),
            )
        )
    times = f"A = {fixed(a, 3)} s   B = {fixed(b, 3)} s   B − A = {fixed(b - a, 3)} s"
    # Each row has a unit of its own: there is nothing to align, and room is scarce.
    return TableState(_say("Between the cursors"), times, header, tuple(rows), len(header))


def _level(value: float, sigma: float) -> str:
    """A value with the digits that its scatter leaves meaning in a mean of many."""
    if math.isfinite(sigma) and sigma > 0.0:
        return fixed(value, max(0, decimals_of(sigma, _FEW)))
    return _number(value, _DIGITS)


def _number(value: float, digits: int) -> str:
    return "—" if math.isnan(value) else significant(value, digits)
