"""Results -> tables of the right-hand side."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.arrays import BoolArray
from core.errors import Note, Severity
from core.fit.estimate import Estimate, parameter
from core.model.effect import AXES
from core.procedures.thermal.cycle import ThermalCalibration
from core.procedures.thermal.split import SplitPoint
from core.procedures.thermal.tilt import TiltErrors
from gui.thermal.record_findings import of_record
from gui.thermal.texts import WAYS, degrees, plain_unit, with_half
from gui.thermal.working import CycleOutcome, Outcome, RecordOutcome, TiltTable
from gui.widgets.number_text import fixed, grouped, significant, value_and_uncertainty
from gui.widgets.states import FindingsState, TableState

_LAW = "U = K(t) a + U0(t),   t = T − {reference} °C"
_SPLIT_LAW = "K = diag(k) T⁻¹ R"
_DASH = "\N{EM DASH}"
_ROWS = 24
"""Rows of positions that a table still shows one by one."""


def of_outcome(outcome: Outcome) -> FindingsState:
    """Return what was found."""
    if isinstance(outcome, RecordOutcome):
        return of_record(outcome)
    return _of_cycle(outcome)


def of_error(error: str) -> FindingsState:
    """Return why nothing was found."""
    title = QCoreApplication.translate("Thermal", "Nothing found")
    return FindingsState(title, "", (), (Note(Severity.ERROR, "thermal", error),))


# --- positions ------------------------------------------------------------------------------------


def _of_cycle(outcome: CycleOutcome) -> FindingsState:
    thermal, run = outcome.thermal, outcome.run
    notes: list[Note] = []
    tables: list[TableState] = []
    source = QCoreApplication.translate("Thermal", "{rows} positions, {device}").format(
        rows=grouped(len(run)), device=run.device
    )
    if thermal is None:
        notes.append(Note(Severity.WARNING, "no_temperature", outcome.why))
        notes += run.notes
    else:
        notes += thermal.notes
        notes += [
            replace(note, text=f"{one.channel}: {note.text}")
            for one in thermal.channels
            for note in one.fit.notes
        ]
        source += QCoreApplication.translate(
            "Thermal", ", {low} … {high}; beyond, nothing is compensated"
        ).format(low=degrees(thermal.low_c, 1), high=degrees(thermal.high_c, 1))
        tables.append(_parameters(thermal))
        if any(one.hysteresis for one in thermal.channels):
            tables.append(_hysteresis(thermal))
    if outcome.tilt is not None:
        tables.append(_tilt_by_temperature(outcome.tilt))
        if len(outcome.tilt.after.temperature_c) <= _ROWS:
            tables.append(_tilt_rows(outcome.tilt))
    elif outcome.why_no_tilt:
        notes.append(Note(Severity.WARNING, "no_tilt", outcome.why_no_tilt))
    if outcome.splits:
        tables += [_twelve_and_nine(outcome.splits[0]), _splits(outcome.splits)]
        notes += outcome.splits[0].six.notes
    if thermal is not None and any(one.scores for one in thermal.channels):
        tables.append(_orders(thermal))
    if outcome.assumed:
        words = f"g = {outcome.conditions.g_mps2} m/s^2 was assumed; no file states it"
        notes.append(Note(Severity.WARNING, "assumed_g", words))
    title = QCoreApplication.translate("Thermal", "Six positions and temperature")
    return FindingsState(title, source, tuple(tables), tuple(dict.fromkeys(notes)))


def _parameters(thermal: ThermalCalibration) -> TableState:
    symbols: dict[str, tuple[str, str]] = {}
    for channel in thermal.channels:
        for name, p in zip(channel.fit.names, channel.fit.parameters, strict=True):
            symbols.setdefault(name, (_row_symbol(name), plain_unit(p.unit)))
    rows: list[tuple[str, ...]] = []
    for name in sorted(symbols, key=_row_place):
        cells: list[str] = []
        for channel in thermal.channels:
            if name not in channel.fit.names:
                cells += [_DASH, ""]
                continue
            one = parameter(channel.fit, name)
            cells += value_and_uncertainty(one.value, one.expanded())
        rows.append((symbols[name][0], *cells, symbols[name][1]))
    header = [""]
    for channel in thermal.channels:
        header += [channel.channel, "± 95 %"]
    return TableState(
        QCoreApplication.translate("Thermal", "Parameters over temperature"),
        _LAW.format(reference=fixed(thermal.reference_c, 1)),
        (*header, QCoreApplication.translate("Thermal", "unit")),
        tuple(rows),
    )


def _row_symbol(name: str) -> str:
    base, _, power = name.partition("_t")
    kind = {"bias": "U0", "scale_factor": "k"}.get(base, f"k {base[-1].upper()}")
    suffix = "" if not power else (" · t" if power == "1" else f" · t{'⁰¹²³⁴⁵'[int(power)]}")
    return f"{kind}{suffix}"


def _row_place(name: str) -> tuple[int, int, str]:
    base, _, power = name.partition("_t")
    return ({"bias": 0, "scale_factor": 1}.get(base, 2), int(power or 0), base)


def _hysteresis(thermal: ThermalCalibration) -> TableState:
    temperatures = sorted({one.temperature_c for c in thermal.channels for one in c.hysteresis})
    rows: list[tuple[str, ...]] = []
    for at in temperatures:
        cells = [degrees(at)]
        for channel in thermal.channels:
            found = next((one for one in channel.hysteresis if one.temperature_c == at), None)
            for one in (None, None) if found is None else (found.bias, found.scale_factor):
                known = one is not None and np.isfinite(one.value)
                cells.append(with_half(one) if one is not None and known else _DASH)
        rows.append(tuple(cells))
    bias = QCoreApplication.translate("Thermal", "{channel}: U0, {unit}")
    header = [QCoreApplication.translate("Thermal", "at")]
    for channel in thermal.channels:
        header.append(bias.format(channel=channel.channel, unit=plain_unit(thermal.unit)))
        header.append("k")
    return TableState(
        QCoreApplication.translate("Thermal", "Hysteresis: heating less cooling, 95 %"),
        QCoreApplication.translate(
            "Thermal", "What no function of the temperature can compensate."
        ),
        tuple(header),
        tuple(rows),
        words=len(header),
    )


def _orders(thermal: ThermalCalibration) -> TableState:
    pairs = list(dict.fromkeys((s.bias, s.scale) for c in thermal.channels for s in c.scores))
    rows: list[tuple[str, ...]] = []
    for bias, scale in pairs:
        cells = [f"{bias} / {scale}"]
        for channel in thermal.channels:
            rms = next((s.rms for s in channel.scores if (s.bias, s.scale) == (bias, scale)), None)
            taken = (bias, scale) == (channel.bias_order, channel.scale_order)
            cells += [_DASH if rms is None else significant(rms, 3), "✓" if taken else ""]
        rows.append(tuple(cells))
    header = [QCoreApplication.translate("Thermal", "U0 / k")]
    for channel in thermal.channels:
        header += [channel.channel, ""]
    return TableState(
        QCoreApplication.translate("Thermal", "Orders, rms at temperatures left out"),
        QCoreApplication.translate(
            "Thermal", "The lowest that leave at most 10 % more than the best are taken."
        ),
        tuple(header),
        tuple(rows),
    )


# --- roll and pitch -------------------------------------------------------------------------------


def _tilt_by_temperature(tilt: TiltTable) -> TableState:
    temperature = tilt.after.temperature_c
    groups = np.round(temperature / 5.0)
    rows: list[tuple[str, ...]] = []
    for group in np.unique(groups):
        at: BoolArray = groups == group
        rows.append(
            (
                degrees(float(temperature[at].mean())),
                *(_largest(one, at) for one in (tilt.before, tilt.after)),
                ""
                if bool(tilt.unseen[at].all())
                else QCoreApplication.translate("Thermal", "took part"),
            )
        )
    every = np.ones(len(temperature), dtype=np.bool_)
    whole = QCoreApplication.translate("Thermal", "all")
    rows.append((whole, *(_largest(one, every) for one in (tilt.before, tilt.after)), ""))
    law = (
        QCoreApplication.translate("Thermal", "Rows of the check run, which took no part.")
        if tilt.check
        else QCoreApplication.translate(
            "Thermal",
            "Each temperature but the outermost is left out in turn and compensated by the others.",
        )
    )
    return TableState(
        QCoreApplication.translate("Thermal", "Largest error of roll or pitch, °"),
        law,
        (
            QCoreApplication.translate("Thermal", "at"),
            QCoreApplication.translate("Thermal", "before"),
            QCoreApplication.translate("Thermal", "compensated"),
            "",
        ),
        tuple(rows),
    )


def _largest(errors: TiltErrors, at: BoolArray) -> str:
    values = np.abs([errors.roll_error_deg[at], errors.pitch_error_deg[at]])
    return fixed(float(np.nanmax(values)), 4)


def _tilt_rows(tilt: TiltTable) -> TableState:
    before, after = tilt.before, tilt.after
    rows = tuple(
        (
            degrees(float(after.temperature_c[row])),
            fixed(float(after.roll_deg[row]), 1),
            fixed(float(after.pitch_deg[row]), 1),
            fixed(float(before.roll_error_deg[row]), 4),
            fixed(float(before.pitch_error_deg[row]), 4),
            fixed(float(after.roll_error_deg[row]), 4),
            fixed(float(after.pitch_error_deg[row]), 4),
        )
        for row in range(len(after.roll_deg))
    )
    return TableState(
        QCoreApplication.translate("Thermal", "Errors of roll and pitch, °"),
        QCoreApplication.translate("Thermal", "Roll is not defined where the Y axis is vertical."),
        (
            QCoreApplication.translate("Thermal", "at"),
            QCoreApplication.translate("Thermal", "roll"),
            QCoreApplication.translate("Thermal", "pitch"),
            QCoreApplication.translate("Thermal", "roll before"),
            QCoreApplication.translate("Thermal", "pitch before"),
            QCoreApplication.translate("Thermal", "roll after"),
            QCoreApplication.translate("Thermal", "pitch after"),
        ),
        rows,
    )


# --- the split of source 002 ----------------------------------------------------------------------


def _quantities(point: SplitPoint) -> Iterator[tuple[str, Estimate, float]]:
    """Symbol, value by twelve parameters, value by nine (NaN where that form has none)."""
    six = point.six
    scales = (float(fit.value("scale_factor")) for fit in six.nine.fits)
    for axis, one, other in zip(AXES, six.scale, scales, strict=True):
        yield f"k {axis.upper()}", one, other
    skew = (six.skew.yz, six.skew.zy, six.skew.zx)
    for name, one, other in zip(("yz", "zy", "zx"), skew, six.nine.skew_deg, strict=True):
        yield f"α {name}", one, float(other)
    for axis, one in zip(AXES, six.mounting, strict=True):
        yield f"R {axis.upper()}", one, float("nan")


def _twelve_and_nine(point: SplitPoint) -> TableState:
    rows = [
        (
            symbol,
            *value_and_uncertainty(one.value, one.expanded()),
            _DASH if np.isnan(other) else significant(other, 5),
            plain_unit(one.unit),
        )
        for symbol, one, other in _quantities(point)
    ]
    six = point.six
    for axis, left, other in zip(AXES, six.residual_mg, six.nine.residual_mg, strict=True):
        left_words = QCoreApplication.translate("Thermal", "left, {axis}").format(axis=axis.upper())
        rows.append((left_words, significant(left, 2), "", significant(other, 2), "mg"))
    title = QCoreApplication.translate("Thermal", "Six positions")
    if np.isfinite(point.temperature_c):
        title = QCoreApplication.translate("Thermal", "Six positions at {t}").format(
            t=degrees(point.temperature_c)
        )
    return TableState(
        title,
        QCoreApplication.translate(
            "Thermal", "{law}: scale factors, angles of T, mounting. Nine: source 002 has no R."
        ).format(law=_SPLIT_LAW),
        (
            "",
            QCoreApplication.translate("Thermal", "twelve"),
            "± 95 %",
            QCoreApplication.translate("Thermal", "nine"),
            QCoreApplication.translate("Thermal", "unit"),
        ),
        tuple(rows),
    )


def _splits(points: tuple[SplitPoint, ...]) -> TableState:
    named = [list(_quantities(point)) for point in points]
    rows: list[tuple[str, ...]] = []
    for place, (symbol, one, _) in enumerate(named[0]):
        cells = [value_and_uncertainty(each[place][1].value, each[place][1].u)[0] for each in named]
        rows.append((symbol, plain_unit(one.unit), *cells))
    worst: tuple[tuple[str, Callable[[SplitPoint], float]], ...] = (
        (
            QCoreApplication.translate("Thermal", "left, twelve"),
            lambda point: float(point.six.residual_mg.max()),
        ),
        (
            QCoreApplication.translate("Thermal", "left, nine"),
            lambda point: float(point.six.nine.residual_mg.max()),
        ),
    )
    for words, left in worst:
        rows.append((words, "mg", *(significant(left(point), 2) for point in points)))
    header = (f"{degrees(one.temperature_c)} {WAYS[one.came]}".rstrip() for one in points)
    return TableState(
        QCoreApplication.translate("Thermal", "The same at each temperature"),
        QCoreApplication.translate("Thermal", "↑ reached by heating, ↓ by cooling."),
        ("", QCoreApplication.translate("Thermal", "unit"), *header),
        tuple(rows),
        words=2,
    )
