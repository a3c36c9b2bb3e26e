"""Results -> what the plot draws."""

from collections.abc import Iterator

import numpy as np

from core.allan.coefficients import NoiseCoefficients
from core.allan.curve import AllanCurve
from core.allan.model import TERMS
from core.records.noise_study import NoiseStudy
from core.records.noise_tables import published_row
from gui.allan.library import Entry
from gui.allan.live import LiveRecord
from gui.allan.state import CurveState, LineState, PictureState
from gui.allan.texts import DEVIATIONS, plain_unit, titled

LIVE_COLOUR = 6
_SLOPES = {-2: "−1", -1: "−½", 0: "0", 1: "+½", 2: "+1"}
_BELOW = 0.02
"""Share of the lowest point of the curve below which a term is not drawn."""


def picture_of(
    entries: tuple[Entry, ...], live: LiveRecord, current: int, live_key: int
) -> PictureState | None:
    """Return the plot of all records that are shown; None where there is nothing to draw.

    Parameters
    ----------
    current : key of the chosen record, whose terms are drawn
    live_key : which key means the live record
    """
    shown = [(e.key, e.study, e.colour) for e in entries if e.shown and e.study is not None]
    drawn: list[tuple[int, str, list[CurveState]]] = [
        (key, study.unit, list(_of_study(study, colour))) for key, study, colour in shown
    ]
    if live.found is not None:
        name = f"{live.device} {live.channel.name}, live"
        drawn.append((live_key, live.unit, [_curve(name, LIVE_COLOUR, live.found.curve)]))
    if not drawn:
        return None
    # The chosen one is drawn last, over the others; the cursor reads it.
    drawn.sort(key=lambda one: one[0] == current)
    curves = [curve for _, _, of_one in drawn for curve in of_one]
    chosen = next((study.published for key, study, _ in shown if key == current), None)
    if current == live_key:
        chosen = live.found
    units = list(dict.fromkeys(plain_unit(unit) for _, unit, _ in reversed(drawn)))
    lines = tuple(_lines(chosen)) if chosen is not None else ()
    return PictureState(units[0], tuple(curves), lines, ", ".join(units[1:]))


def _of_study(study: NoiseStudy, colour: int) -> Iterator[CurveState]:
    name = titled(study)
    if study.beside is not None:
        words = DEVIATIONS[study.beside.mode].removesuffix(" deviation")
        yield _curve(f"{name}, {words}", colour, study.beside, aside=True)
    if study.after is not None and study.regression is not None:
        yield _curve(f"{name}, before regression", colour, study.coefficients.curve, aside=True)
        yield _curve(f"{name}, after", colour, study.after.curve)
    else:
        yield _curve(name, colour, study.coefficients.curve)


def _curve(name: str, colour: int, curve: AllanCurve, *, aside: bool = False) -> CurveState:
    return CurveState(
        name, colour, curve.taus, curve.deviation, curve.lower, curve.upper, curve.edf, aside
    )


def _lines(found: NoiseCoefficients) -> Iterator[LineState]:
    """The detected terms with their slopes, and their sum."""
    low, high = float(found.curve.taus[0]), float(found.curve.taus[-1])
    taus = np.geomspace(low, high, 60)
    if found.model == type(found.model)():
        return
    floor = _BELOW * float(found.curve.deviation.min())
    yield LineState("", taus, np.sqrt(found.model.variance(taus)), whole=True)
    for name, term in TERMS.items():
        row = published_row(found, name)
        if row is not None and row.upper_limit:
            continue
        values = np.sqrt(found.model.part(name, taus))
        inside = values > floor
        if np.count_nonzero(inside) > 1:
            words = f"{term.symbol}  {_SLOPES[term.power]}"
            yield LineState(words, taus[inside], values[inside])
