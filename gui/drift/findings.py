"""A result -> tables of the right-hand side."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.errors import Note, Severity
from core.procedures.drift.compensate import DriftResult
from core.procedures.drift.held_out import node_scores
from core.procedures.drift.table import DriftTable
from gui.drift.state import ALL
from gui.drift.texts import degrees, method_words, shown_unit
from gui.widgets.number_text import fixed, grouped, significant, value_and_uncertainty
from gui.widgets.states import FindingsState, TableState


def of_result(result: DriftResult, shown: int, memory: int) -> FindingsState:
    """Return what was found.

    Parameters
    ----------
    result : with the table on the screen
    shown : place of the temperature whose ordinates are listed, or `ALL`
    memory : limit in bytes; 0 for none
    """
    table, curves = result.table, result.curves
    unit, factor = shown_unit(table.unit)
    title = QCoreApplication.translate("Drift", "{p} knots × {m} temperatures, {bytes} bytes")
    if memory:
        title += QCoreApplication.translate("Drift", " of {memory}")
    source = QCoreApplication.translate(
        "Drift",
        "{n} turn-ons, {low} … {high}; from {start} to {stop} s. The start is brought to zero over"
        " {begin} … {end} s, whose noise u = {noise} {unit} every correction carries.",
    ).format(
        n=len(curves.labels),
        low=degrees(float(table.temperatures_c[0])),
        high=degrees(float(table.temperatures_c[-1])),
        start=f"{table.times_s[0]:g}",
        stop=f"{table.times_s[-1]:g}",
        begin=f"{table.alignment.start_s:g}",
        end=f"{table.alignment.stop_s:g}",
        noise=significant(table.alignment.u * factor, 2),
        unit=unit,
    )
    tables = [_knots(table, shown, unit, factor)]
    if result.methods:
        tables = [_methods(result, unit, factor), *tables, _temperatures(result, unit, factor)]
    if result.knot_scores:
        tables.append(_numbers(result, unit, factor))
    return FindingsState(
        title.format(
            p=len(table.times_s),
            m=len(table.temperatures_c),
            bytes=grouped(table.bytes),
            memory=grouped(memory),
        ),
        source,
        tuple(tables),
        result.notes,
    )


def of_error(error: str) -> FindingsState:
    """Return why there is no table."""
    title = QCoreApplication.translate("Drift", "No table")
    return FindingsState(title, "", (), (Note(Severity.ERROR, "drift", error),))


def _methods(result: DriftResult, unit: str, factor: float) -> TableState:
    words, best = method_words(), result.score("table").rms
    rows = tuple(
        (
            words[one.method],
            significant(one.rms * factor, 3),
            fixed(one.rms / best, 2),
            grouped(one.bytes),
        )
        for one in result.methods
    )
    return TableState(
        QCoreApplication.translate("Drift", "Left on turn-ons that were not seen"),
        QCoreApplication.translate(
            "Drift",
            "Each turn-on is left out in turn and corrected by what the others gave; rms of block"
            " means.",
        ),
        (
            "",
            QCoreApplication.translate("Drift", "rms, {unit}").format(unit=unit),
            QCoreApplication.translate("Drift", "× table"),
            QCoreApplication.translate("Drift", "bytes"),
        ),
        rows,
    )


def _knots(table: DriftTable, shown: int, unit: str, factor: float) -> TableState:
    places = range(len(table.temperatures_c)) if shown == ALL else (shown,)
    header = [
        QCoreApplication.translate("Drift", "knot"),
        QCoreApplication.translate("Drift", "t, s"),
    ]
    for at in places:
        header.append(f"{degrees(float(table.temperatures_c[at]), 0)}, {unit}")
        if shown != ALL:
            header.append("u (k = 1)")
    rows: list[tuple[str, ...]] = []
    for knot, time in enumerate(table.times_s.tolist()):
        cells = [str(knot + 1), fixed(time, 2)]
        for at in places:
            value, u = float(table.values[at, knot]), float(table.u[at, knot])
            texts = value_and_uncertainty(value * factor, u * factor)
            if np.isnan(u):
                texts = (significant(value * factor, 4), texts[1])
            cells += texts if shown != ALL else texts[:1]
        rows.append(tuple(cells))
    return TableState(
        QCoreApplication.translate("Drift", "The table"),
        QCoreApplication.translate(
            "Drift", "Linear between knots and, by values, between temperatures of the chip."
        ),
        tuple(header),
        tuple(rows),
    )


def _temperatures(result: DriftResult, unit: str, factor: float) -> TableState:
    curves = result.curves
    without = node_scores(curves, result.table.times_s)
    by_name = {one.method: one.by_temperature for one in result.methods}
    rows = tuple(
        (
            degrees(float(temperature)),
            str(int(curves.counts[at])),
            *(
                significant(float(values[at]) * factor, 3)
                for values in (by_name["none"], by_name["quartic"], by_name["table"], without)
            ),
        )
        for at, temperature in enumerate(curves.temperatures_c)
    )
    return TableState(
        QCoreApplication.translate("Drift", "Temperature nodes, rms in {unit}").format(unit=unit),
        QCoreApplication.translate(
            "Drift",
            "Without the node: its turn-ons corrected by values interpolated between its"
            " neighbours. Much more than with it means that the nodes are too far apart.",
        ),
        (
            QCoreApplication.translate("Drift", "chip"),
            QCoreApplication.translate("Drift", "turn-ons"),
            QCoreApplication.translate("Drift", "none"),
            QCoreApplication.translate("Drift", "quartic"),
            QCoreApplication.translate("Drift", "table"),
            QCoreApplication.translate("Drift", "without node"),
        ),
        rows,
    )


def _numbers(result: DriftResult, unit: str, factor: float) -> TableState:
    m = len(result.table.temperatures_c)
    rows = tuple(
        (
            str(one.knots),
            significant(one.rms * factor, 3),
            grouped(2 * (one.knots + m + one.knots * m)),
        )
        for one in result.knot_scores
    )
    return TableState(
        QCoreApplication.translate("Drift", "By number of knots"),
        QCoreApplication.translate(
            "Drift", "The fewest that leave at most 2 % more than the best are taken."
        ),
        (
            QCoreApplication.translate("Drift", "tp"),
            QCoreApplication.translate("Drift", "rms, {unit}").format(unit=unit),
            QCoreApplication.translate("Drift", "bytes"),
        ),
        rows,
    )
