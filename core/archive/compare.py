"""Two calibrations side by side: difference over combined uncertainty."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from core.archive.entry import Entry, Quantity
from core.errors import Note, Severity

MARK = 2.0
"""A ratio beyond this is marked: 5 % of the pairs of a unit that has not changed."""
_FAR_K = 2.0


@dataclass(frozen=True, slots=True)
class Difference:
    """One parameter of both.

    Parameters
    ----------
    channel, name, symbol, unit : of the parameter
    first, second : its values
    difference : second minus first
    u : of the difference, k = 1, of independent calibrations; NaN where one has none
    """

    channel: str
    name: str
    symbol: str
    unit: str
    first: float
    second: float
    difference: float
    u: float

    @property
    def ratio(self) -> float:
        """Difference over its uncertainty; NaN without one."""
        return self.difference / self.u if self.u > 0.0 else math.nan

    @property
    def marked(self) -> bool:
        """Whether the difference is more than its uncertainty explains."""
        return abs(self.ratio) > MARK


@dataclass(frozen=True, slots=True)
class Compared:
    """Two calibrations.

    Parameters
    ----------
    first, second : the earlier and the later one
    rows : parameters that both have, in one unit
    notes : what stands in the way of comparing
    """

    first: Entry
    second: Entry
    rows: tuple[Difference, ...]
    notes: tuple[Note, ...]

    @property
    def marked(self) -> int:
        """How many differences are more than their uncertainties explain."""
        return sum(row.marked for row in self.rows)


def compare(
    one: tuple[Entry, Sequence[Quantity]], other: tuple[Entry, Sequence[Quantity]]
) -> Compared:
    """Compare two calibrations, the earlier first.

    Their uncertainties are taken as independent; what both share (local g, the same head) makes the
    true uncertainty of the difference smaller, never larger.
    """
    (first, of_first), (second, of_second) = sorted((one, other), key=lambda pair: pair[0].measured)
    there = {(quantity.channel, quantity.name): quantity for quantity in of_second}
    rows: list[Difference] = []
    units: list[str] = []
    alone = 0
    for quantity in of_first:
        match = there.pop((quantity.channel, quantity.name), None)
        if match is None:
            alone += 1
        elif match.unit != quantity.unit:
            units.append(f"{quantity.channel} {quantity.name}")
        else:
            rows.append(_difference(quantity, match))
    notes = _notes(first, second, units, alone + len(there), not rows)
    return Compared(first, second, tuple(rows), notes)


def _difference(first: Quantity, second: Quantity) -> Difference:
    return Difference(
        channel=first.channel,
        name=first.name,
        symbol=first.symbol,
        unit=first.unit,
        first=first.value,
        second=second.value,
        difference=second.value - first.value,
        u=math.hypot(first.u, second.u),
    )


def _notes(
    first: Entry, second: Entry, units: list[str], alone: int, nothing: bool
) -> tuple[Note, ...]:
    notes: list[Note] = []
    if nothing:
        notes.append(Note(Severity.WARNING, "nothing_common", "they have no parameter in common"))
    if first.serial != second.serial:
        text = f"they are of different devices, {first.serial} and {second.serial}"
        notes.append(Note(Severity.INFO, "other_device", text))
    if units:
        text = f"in different units, not compared: {', '.join(units)}"
        notes.append(Note(Severity.WARNING, "other_units", text))
    if alone and not nothing:
        text = f"{alone} parameters stand in one of them only"
        notes.append(Note(Severity.INFO, "only_in_one", text))
    apart = abs(second.temperature_c - first.temperature_c)
    if apart > _FAR_K:
        text = (
            f"they were measured {apart:.2g} K apart ({first.temperature_c:.3g} and"
            f" {second.temperature_c:.3g} °C): a part of the differences is temperature"
        )
        notes.append(Note(Severity.WARNING, "other_temperature", text))
    return tuple(notes)
