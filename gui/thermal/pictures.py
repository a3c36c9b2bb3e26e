"""Results -> curves of the plots."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.arrays import FloatArray
from core.fit.estimate import Estimate
from core.model.effect import AXES
from core.procedures.thermal.cycle import ThermalCalibration, ThermalChannel
from core.procedures.thermal.export import polynomials
from core.procedures.thermal.record import Trend
from gui.analysis.curves import LineState
from gui.thermal.state import PlotState, PointState
from gui.thermal.texts import degrees, plain_unit, with_half
from gui.thermal.working import Outcome, RecordOutcome, TiltTable

_HEATED, _COOLED, _FIRST, _MODEL, _WAY = 6, 0, 4, 2, 5
BIAS, SCALE, TILT = range(3)
_FINE = 101
_MEANS = 240
"""Points that a record is drawn with: means of neighbouring rows."""
_NONE: FloatArray = np.empty(0)


def plots_of(outcome: Outcome, quantity: int) -> tuple[PlotState, ...]:
    """Return the plots, one above the other; empty where there is nothing to draw."""
    if isinstance(outcome, RecordOutcome):
        return tuple(_trend(outcome, c, trend) for c, trend in enumerate(outcome.found.trends))
    if outcome.thermal is None:
        return ()
    if quantity == TILT:
        return () if outcome.tilt is None else _tilt(outcome.tilt)
    thermal = outcome.thermal
    return tuple(_channel(thermal, c, quantity) for c in range(len(thermal.channels)))


def _channel(thermal: ThermalCalibration, place: int, quantity: int) -> PlotState:
    channel = thermal.channels[place]
    bias, k = polynomials(thermal)
    terms = bias[place] if quantity == BIAS else k[place, AXES.index(channel.axis)]
    x = np.linspace(thermal.low_c, thermal.high_c, _FINE)
    model = LineState(
        x,
        np.polynomial.polynomial.polyval(x - thermal.reference_c, terms),
        _MODEL,
        QCoreApplication.translate("Thermal", "polynomial"),
    )
    points = [
        (point.temperature_c, point.came, point.bias if quantity == BIAS else point.scale_factor)
        for point in channel.points
    ]
    way = LineState(
        np.array([at for at, _, _ in points]),
        np.array([one.value for _, _, one in points]),
        _WAY,
        QCoreApplication.translate("Thermal", "cycle"),
        dashed=True,
    )
    unit = points[0][2].unit
    name = (
        QCoreApplication.translate("Thermal", "U0, {unit}")
        if quantity == BIAS
        else QCoreApplication.translate("Thermal", "k, {unit}")
    )
    return PlotState(
        _channel_title(channel, quantity),
        name.format(unit=plain_unit(unit)),
        (way, model),
        tuple(_by_way(points)),
    )


def _channel_title(channel: ThermalChannel, quantity: int) -> str:
    order = channel.bias_order if quantity == BIAS else channel.scale_order
    title = QCoreApplication.translate("Thermal", "{channel}, order {order}").format(
        channel=channel.channel, order=order
    )
    found = [
        (abs(one.value), one, each.temperature_c)
        for each in channel.hysteresis
        for one in (each.bias if quantity == BIAS else each.scale_factor,)
        if np.isfinite(one.value)
    ]
    if not found:
        return title
    _, worst, at = max(found, key=lambda one: one[0])
    words = QCoreApplication.translate("Thermal", "{title};  hysteresis {value} {unit} at {at}")
    return words.format(
        title=title, value=with_half(worst), unit=plain_unit(worst.unit), at=degrees(at)
    )


def _by_way(points: list[tuple[float, int, Estimate]]) -> list[PointState]:
    """Points with bars of 95 %, heated and cooled apart."""
    names = {
        0: (_FIRST, QCoreApplication.translate("Thermal", "first")),
        1: (_HEATED, QCoreApplication.translate("Thermal", "heated")),
        -1: (_COOLED, QCoreApplication.translate("Thermal", "cooled")),
    }
    made: list[PointState] = []
    for came, (colour, name) in names.items():
        chosen = [(at, one) for at, way, one in points if way == came and np.isfinite(one.value)]
        if not chosen:
            continue
        x = np.array([at for at, _ in chosen])
        y = np.array([one.value for _, one in chosen])
        half = np.array([one.expanded() for _, one in chosen])
        bars = bool(np.all(np.isfinite(half)))
        low, high = (y - half, y + half) if bars else (_NONE, _NONE)
        made.append(PointState(x, y, low, high, colour, name))
    return made


def _tilt(tilt: TiltTable) -> tuple[PlotState, ...]:
    angles = (
        (QCoreApplication.translate("Thermal", "Roll"), "roll_error_deg"),
        (QCoreApplication.translate("Thermal", "Pitch"), "pitch_error_deg"),
    )
    names = (
        (tilt.before, _COOLED, QCoreApplication.translate("Thermal", "by the first temperature")),
        (tilt.after, _HEATED, QCoreApplication.translate("Thermal", "compensated")),
    )
    made: list[PlotState] = []
    for title, column in angles:
        points: list[PointState] = []
        for errors, colour, name in names:
            y: FloatArray = getattr(errors, column)
            known = np.isfinite(y)
            points.append(
                PointState(errors.temperature_c[known], y[known], _NONE, _NONE, colour, name)
            )
        label = QCoreApplication.translate("Thermal", "error, °")
        made.append(PlotState(title, label, (), tuple(points)))
    return tuple(made)


def _trend(outcome: RecordOutcome, place: int, trend: Trend) -> PlotState:
    run = outcome.run
    per = max(1, len(run) // _MEANS)
    whole = len(run) // per * per
    warm = run.temperature_c[:whole].reshape(-1, per).mean(axis=1)
    y = run.y[:whole, place].reshape(-1, per).mean(axis=1)
    heating = np.gradient(warm) > 0.0
    x = np.linspace(trend.low_c, trend.high_c, _FINE)
    sides = (
        (heating, _HEATED, QCoreApplication.translate("Thermal", "heating")),
        (~heating, _COOLED, QCoreApplication.translate("Thermal", "cooling")),
    )
    words = QCoreApplication.translate("Thermal", "{channel}, order {order}")
    title = words.format(channel=trend.channel, order=trend.order)
    if np.isfinite(trend.hysteresis.value):
        words = QCoreApplication.translate("Thermal", "{title};  hysteresis {value} {unit} at {at}")
        title = words.format(
            title=title,
            value=with_half(trend.hysteresis),
            unit=plain_unit(trend.unit),
            at=degrees(trend.hysteresis_at_c),
        )
    polynomial = QCoreApplication.translate("Thermal", "polynomial")
    return PlotState(
        title,
        plain_unit(trend.unit),
        (LineState(x, trend.at(x), _MODEL, polynomial),),
        tuple(
            PointState(warm[side], y[side], _NONE, _NONE, colour, name)
            for side, colour, name in sides
        ),
    )
