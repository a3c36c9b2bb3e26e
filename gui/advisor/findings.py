"""A prediction -> table and doubts of the right-hand side."""

import math

from PySide6.QtCore import QCoreApplication

from core.errors import Note, Severity
from core.procedures.prediction.catalogue import METHODS
from gui.advisor.state import Advised
from gui.advisor.words import limit_words, minutes_words, unit_words
from gui.widgets.number_text import significant
from gui.widgets.states import FindingsState, TableState


def findings_of(advised: Advised) -> FindingsState | None:
    """What the chosen plan would give; None where there is no plan."""
    whole, choices = advised.whole, advised.choices
    if whole is None:
        return None
    method = METHODS[choices.method]
    title = whole.title
    if advised.after is None:
        note = Note(Severity.ERROR, "plan", advised.why)
        return FindingsState(title, method.gives, (), (note,))
    after = advised.after
    template = QCoreApplication.translate(
        "Advisor", "{method}: {rows} accumulations, {time}; {dof} more than unknowns"
    )
    source = template.format(
        method=method.title, rows=after.rows, time=minutes_words(after.minutes), dof=after.dof
    )
    blind = Note(
        Severity.INFO,
        "unseen",
        QCoreApplication.translate("Advisor", "This plan shows all that the method can tell"),
    )
    return FindingsState(title, source, (_table(advised),), advised.unseen or (blind,))


def _table(advised: Advised) -> TableState:
    after, before = advised.after, advised.before
    if after is None or before is None:
        raise ValueError("a plan without a prediction has no table")
    changed = advised.plan is not None and advised.plan != advised.whole
    names = list(dict.fromkeys(one.name for one in (*after.parameters, *before.parameters)))
    now = {one.name: one for one in after.parameters}
    then = {one.name: one for one in before.parameters}
    rows: list[tuple[str, ...]] = []
    for name in names:
        one = now.get(name)
        known = one or then[name]
        row = [
            f"{known.symbol}, {unit_words(known.unit)}",
            _number(math.nan if one is None else one.u),
            "" if one is None else limit_words(one.limited_by),
        ]
        if changed:
            row.insert(2, _number(before.u(name)))
        rows.append(tuple(row))
    header = [
        QCoreApplication.translate("Advisor", "Parameter"),
        QCoreApplication.translate("Advisor", "u (k = 1)"),
        QCoreApplication.translate("Advisor", "limited by"),
    ]
    if changed:
        header.insert(2, QCoreApplication.translate("Advisor", "whole plan"))
    return TableState(
        QCoreApplication.translate("Advisor", "Predicted before measuring"),
        QCoreApplication.translate("Advisor", "From the design matrix, the noise, the settings, g"),
        tuple(header),
        tuple(rows),
    )


def _number(value: float) -> str:
    return significant(value, 2)
