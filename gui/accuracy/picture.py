"""The graph of an accuracy check: errors, other angles and temperatures against the set angle."""

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from core.arrays import FloatArray
from core.fit.quantiles import student_t
from core.procedures.accuracy import TITLES, Accuracy, Trace
from core.samples.run import Run
from gui.accuracy.state import GraphState, Series, TraceToggle
from gui.accuracy.texts import kind_word, other_word, say, trace_word

_QUARTER = 90.0
_MOST_TEMPERATURES = 9


def traces_of(found: Accuracy, hidden: Collection[str]) -> tuple[TraceToggle, ...]:
    """The traces that there are, each with the colour that its source always has."""
    colours = list(TITLES)
    return tuple(
        TraceToggle(
            trace.source,
            trace_word(trace.source),
            colours.index(trace.source),
            trace.source not in hidden,
        )
        for trace in found.traces
    )


def graph_of(
    found: Accuracy, run: Run, page: str, hidden: Collection[str], level: float
) -> GraphState:
    """One page of the graph.

    Parameters
    ----------
    found, run : the check and what was measured
    page : one of `PAGES`
    hidden : traces that are not shown
    level : the angle now, deg; NaN where none is known
    """
    x, low, high = places(found.set_deg)
    return replace(_page(found, run, page, hidden, level, x), low=low, high=high)


def _page(
    found: Accuracy,
    run: Run,
    page: str,
    hidden: Collection[str],
    level: float,
    x: FloatArray,
) -> GraphState:
    shown = [trace for trace in found.traces if trace.source not in hidden]
    match page:
        case "error":
            series = _series(shown, x, [t.error for t in shown], bars=True)
            limit = 0.0 if found.limit is None else found.limit.error_deg
            title = say("{angle} error, deg").format(angle=kind_word(found.kind))
            return GraphState(title, say("deg"), series, limit=limit)
        case "cross":
            series = _series(shown, x, [t.cross_error for t in shown])
            title = say("{angle} while {other} is set, deg").format(
                angle=other_word(found.kind), other=kind_word(found.kind)
            )
            return GraphState(title, say("deg"), series)
        case "heading":
            known = [t for t in shown if np.isfinite(t.heading).any()]
            series = _series(known, x, [t.heading_error for t in known])
            hint = say("The unit tells no heading.")
            title = say("Heading, change against the first row, deg")
            return GraphState(title, say("deg"), series, hint=hint)
        case "current":
            turned = [_near(t.angle, x) for t in shown]
            series = _series(shown, x, turned)
            title = say("{angle}, deg").format(angle=kind_word(found.kind))
            return GraphState(title, say("deg"), series, level=level)
        case _:
            return _temperatures(run, x)


def _temperatures(run: Run, x: FloatArray) -> GraphState:
    """Change of every temperature against the first row, which drift would follow."""
    codes = {name: column for name, column in run.extra.items() if name.startswith("temp_")}
    unit = say("code")
    if not codes and np.isfinite(run.temperature_c).any():
        codes, unit = {"temperature": run.temperature_c}, "°C"
    series = tuple(
        Series(
            name.removeprefix("temp_").replace("_", " "),
            number,
            tuple(x.tolist()),
            tuple((column - column[0]).tolist()),
        )
        for number, (name, column) in enumerate(list(codes.items())[:_MOST_TEMPERATURES])
    )
    title = say("Temperatures, change against the first row, {unit}").format(unit=unit)
    return GraphState(title, unit, series, hint=say("The unit tells no temperature."))


def places(set_deg: FloatArray) -> tuple[FloatArray, float, float]:
    """Set angles (n,) as the operator calls them, and their range.

    A full turn counts from 0 to 360, back at the beginning; less than that from -90 to 90.
    """
    if np.all(np.abs(set_deg) <= _QUARTER):
        return set_deg, -_QUARTER if (set_deg < 0).any() else 0.0, _QUARTER
    x = set_deg % 360.0
    back = (x == 0.0) & (np.arange(len(x)) > 0)
    return np.where(back, 360.0, x), 0.0, 360.0


def _near(angle: FloatArray, x: FloatArray) -> FloatArray:
    """Measured angles in the turn of the set ones."""
    return x + (angle - x + 180.0) % 360.0 - 180.0


def _series(
    traces: list[Trace],
    x: FloatArray,
    values: list[FloatArray],
    *,
    bars: bool = False,
) -> tuple[Series, ...]:
    colours = list(TITLES)
    return tuple(
        Series(
            trace_word(trace.source),
            colours.index(trace.source),
            tuple(x.tolist()),
            tuple(y.tolist()),
            tuple(expanded(trace).tolist()) if bars else (),
        )
        for trace, y in zip(traces, values, strict=True)
    )


def expanded(trace: Trace) -> FloatArray:
    """Expanded uncertainty (n,) of the error of a trace, 95 %, as the verdict counts it."""
    return student_t(0.95, float("inf")) * trace.u_error
