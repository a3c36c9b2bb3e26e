"""A record of a standing unit -> tables of the right-hand side."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from gui.thermal.texts import degrees, plain_unit, with_half
from gui.thermal.working import RecordOutcome
from gui.widgets.number_text import fixed, grouped, significant, value_and_uncertainty
from gui.widgets.states import FindingsState, TableState

_DASH = "\N{EM DASH}"


def of_record(outcome: RecordOutcome) -> FindingsState:
    """Return what was found."""
    run, found = outcome.run, outcome.found
    first = found.trends[0]
    source = QCoreApplication.translate(
        "Thermal", "{rows} rows, {device}, {low} … {high}; beyond, nothing is compensated"
    ).format(
        rows=grouped(len(run)),
        device=run.device,
        low=degrees(first.low_c, 1),
        high=degrees(first.high_c, 1),
    )
    title = QCoreApplication.translate("Thermal", "A standing unit over temperature")
    tables = (_summary(outcome), _coefficients(outcome), _record_orders(outcome))
    return FindingsState(title, source, tables, found.notes)


def _summary(outcome: RecordOutcome) -> TableState:
    rows = tuple(
        (
            trend.channel,
            str(trend.order),
            fixed(trend.explained, 3),
            significant(trend.rms_before, 3),
            significant(trend.rms_after, 3),
            with_half(trend.hysteresis) if np.isfinite(trend.hysteresis.value) else _DASH,
            degrees(trend.hysteresis_at_c),
        )
        for trend in outcome.found.trends
    )
    unit = plain_unit(outcome.run.unit)
    return TableState(
        QCoreApplication.translate("Thermal", "Before and after, {unit}").format(unit=unit),
        QCoreApplication.translate("Thermal", "Heating less cooling where they differ most, 95 %."),
        (
            QCoreApplication.translate("Thermal", "output"),
            QCoreApplication.translate("Thermal", "order"),
            "R²",
            QCoreApplication.translate("Thermal", "sd before"),
            QCoreApplication.translate("Thermal", "after"),
            QCoreApplication.translate("Thermal", "hysteresis"),
            QCoreApplication.translate("Thermal", "at"),
        ),
        rows,
    )


def _coefficients(outcome: RecordOutcome) -> TableState:
    rows = tuple(
        (
            trend.channel if power == 0 else "",
            f"t{'⁰¹²³⁴⁵'[power]}",
            *value_and_uncertainty(one.value, one.expanded()),
            plain_unit(one.unit),
        )
        for trend in outcome.found.trends
        for power, one in enumerate(trend.coefficients)
    )
    reference = fixed(outcome.found.trends[0].reference_c, 1)
    return TableState(
        QCoreApplication.translate("Thermal", "Polynomials"),
        f"t = T − {reference} °C",
        (
            QCoreApplication.translate("Thermal", "output"),
            "",
            QCoreApplication.translate("Thermal", "coefficient"),
            "± 95 %",
            QCoreApplication.translate("Thermal", "unit"),
        ),
        rows,
        words=2,
    )


def _record_orders(outcome: RecordOutcome) -> TableState:
    trends = outcome.found.trends
    rows = tuple(
        (str(order), *(significant(trend.scores[order].rms, 3) for trend in trends))
        for order in range(len(trends[0].scores))
    )
    return TableState(
        QCoreApplication.translate("Thermal", "Orders, rms at temperatures left out"),
        "",
        (
            QCoreApplication.translate("Thermal", "order"),
            *(trend.channel for trend in trends),
        ),
        rows,
    )
