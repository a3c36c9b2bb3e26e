"""Limits as they are typed -> limits that parameters are judged by."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from core.certificates.limits import ParameterLimit, Stated
from gui.certificate.state import LimitRow
from gui.certificate.texts import say
from gui.settings import Section
from gui.widgets.number_text import MINUS, significant


@dataclass(frozen=True, slots=True)
class Limits:
    """The table of limits.

    Parameters
    ----------
    rows : parameters of the calibration
    """

    rows: tuple[LimitRow, ...] = ()

    @property
    def usable(self) -> tuple[ParameterLimit, ...]:
        """Those that something can be judged by."""
        return tuple(
            ParameterLimit(row.parameter, "", number_of(row.nominal or "0"), number_of(row.limit))
            for row in self.rows
            if row.limit.strip() and not row.problem
        )

    @property
    def problem(self) -> str:
        """Why a row cannot be used; empty if all can."""
        return next((f"{row.symbol}: {row.problem}" for row in self.rows if row.problem), "")

    def with_typed(self, parameter: str, nominal: str, limit: str) -> "Limits":
        """The table with what was typed into a row."""
        return Limits(
            tuple(
                _checked(replace(row, nominal=nominal, limit=limit))
                if row.parameter == parameter
                else row
                for row in self.rows
            )
        )

    def typed(self) -> dict[str, list[str]]:
        """What was typed, to be remembered."""
        return {row.parameter: [row.nominal, row.limit] for row in self.rows if row.limit.strip()}


def limits_of(stated: Sequence[Stated], typed: Section) -> Limits:
    """The table for some results, filled with what was typed before.

    Parameters
    ----------
    stated : the numbers; none of a check, which is not judged here
    typed : of `Limits.typed`
    """
    found: dict[str, list[tuple[float, str, str]]] = {}
    for one in stated:
        place = found.setdefault(one.parameter, [])
        place.append((one.value, one.symbol, one.unit.replace("^2", "²")))
    rows: list[LimitRow] = []
    for name, values in found.items():
        low, high = min(values)[0], max(values)[0]
        span = significant(low, 6)
        if high != low:
            span = f"{span} … {significant(high, 6)}"
        symbols = ", ".join(dict.fromkeys(symbol for _, symbol, _ in values))
        nominal, limit = _pair(typed.get(name))
        rows.append(_checked(LimitRow(name, symbols, values[0][2], span, nominal, limit)))
    return Limits(tuple(rows))


def number_of(text: str) -> float:
    """A number with point or comma, minus or hyphen; NaN where it is none."""
    plain = text.strip().replace(MINUS, "-").replace(",", ".").replace(" ", "")
    try:
        value = float(plain)
    except ValueError:
        return math.nan
    return value if math.isfinite(value) else math.nan


def _pair(value: object) -> tuple[str, str]:
    """Nominal value and limit as remembered; empty where they are not."""
    if not isinstance(value, list | tuple) or len(value) != 2:
        return "", ""
    return str(value[0]), str(value[1])


def _checked(row: LimitRow) -> LimitRow:
    problem = ""
    if row.nominal.strip() and math.isnan(number_of(row.nominal)):
        problem = say("{text} is no number").format(text=row.nominal.strip())
    elif row.limit.strip():
        value = number_of(row.limit)
        if math.isnan(value):
            problem = say("{text} is no number").format(text=row.limit.strip())
        elif value <= 0:
            problem = say("a limit must be above zero")
    return replace(row, problem=problem)
