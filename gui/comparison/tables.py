"""The comparison of lab 6 as a table, the best of each row marked."""

from collections.abc import Sequence

from PySide6.QtCore import QCoreApplication

from core.errors import Note, Severity
from core.fit.estimate import Estimate
from core.procedures.comparison import Column, Comparison, Row, compare_columns
from core.records.gyro_facts import Facts, column_of
from gui.widgets.number_text import value_and_uncertainty
from gui.widgets.states import FindingsState, TableState

BEST = "★"


def say(text: str) -> str:
    """The words in the language of the window."""
    return QCoreApplication.translate("Comparison", text)


def findings_of(named: Sequence[tuple[str, Facts]]) -> FindingsState:
    """The table of all named facts; those of one name stand in one column.

    Raises
    ------
    FitError
        There are none.
    """
    names = list(dict.fromkeys(name for name, _ in named))
    columns: list[Column] = []
    notes: list[Note] = []
    for name in names:
        column, told = column_of(name, [facts for other, facts in named if other == name])
        columns.append(column)
        notes.extend(told)
    found = compare_columns(columns)
    return FindingsState(
        say("Gyros side by side (lab 6)"),
        say("Value ± U (95 %). {star} the smallest of its row, where they can be compared.").format(
            star=BEST
        ),
        (_table(found),),
        (*notes, *_missing(found)),
    )


def _table(found: Comparison) -> TableState:
    rows = tuple(
        (
            _name(row),
            _unit(row),
            *(_cell(cell, place == row.best) for place, cell in enumerate(row.cells)),
        )
        for row in found.rows
    )
    return TableState("", "", (say("Quantity"), say("Unit"), *found.columns), rows, 2)


def _cell(cell: Estimate | None, best: bool) -> str:
    if cell is None:
        return say("not measured")
    value, half = value_and_uncertainty(cell.value, cell.expanded())
    return f"{f'{BEST} ' if best else ''}{value} ± {half}"


def _name(row: Row) -> str:
    return QCoreApplication.translate("Comparison", row.name)


def _unit(row: Row) -> str:
    """The unit of the cells; several where they differ, and then none is the best."""
    units = sorted({cell.unit for cell in row.cells if cell is not None}) or [row.unit]
    return say(" or ").join(unit.replace("^2", "²") for unit in units)


def _missing(found: Comparison) -> list[Note]:
    """What to measure so that every cell is filled."""
    wanted = {
        "scale_factor": say("a run on the rate table"),
        "g_sensitivity": say("positions on the dividing head"),
        "random_walk": say("an Allan analysis (Export, Coefficients CSV)"),
    }
    notes: list[Note] = []
    for row in found.rows:
        empty = [n for n, cell in zip(found.columns, row.cells, strict=True) if cell is None]
        if empty and row.id in wanted:
            text = say("{names}: no {quantity}; add {file}").format(
                names=", ".join(empty), quantity=_name(row).lower(), file=wanted[row.id]
            )
            notes.append(Note(Severity.INFO, "missing", text))
    return notes
