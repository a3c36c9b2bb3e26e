"""The questions to the index as SQL."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import Connection, Select, and_, exists, func, insert, not_, select

from core.archive.entry import Entry, Found, Quantity
from core.archive.tables import ENTRIES, QUANTITIES

_E, _Q = ENTRIES.c, QUANTITIES.c
_TEXTS = (
    *("kind", "path", "serial", "part", "sensor", "what", "operator", "profile"),
    *("measured", "verdict", "remark", "sha256"),
)
_ENTRY = (*(_E[name] for name in _TEXTS), _E.temperature_c, _E["count"], _E.id, _E.place)
_OTHER = ENTRIES.alias("other").c
_NO_COPY = not_(
    exists(select(_OTHER.id)).where(
        _E.kind == "calibration",
        _E.sha256 != "",
        _OTHER.place == _E.place,
        _OTHER.folder == _E.folder,
        _OTHER.kind == _E.kind,
        _OTHER.sha256 == _E.sha256,
        _OTHER.id < _E.id,
    )
)
"""A calibration that was exported stands twice in its folder, to the byte, and counts once."""
_QUANTITY = (_Q.channel, _Q.name, _Q.symbol, _Q.unit, _Q.value, _Q.u, _Q.dof)


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is looked for.

    Parameters
    ----------
    text : words that must all stand in serial number, kind, date, plan, operator, path, ...
    kinds : of these kinds; empty for all
    serial : of this device exactly; empty for all
    """

    text: str = ""
    kinds: tuple[str, ...] = ()
    serial: str = ""


@dataclass(frozen=True, slots=True)
class Hits:
    """What was found.

    Parameters
    ----------
    entries : the latest first; no more than were asked for
    total : how many there are
    """

    entries: tuple[Entry, ...]
    total: int


@dataclass(frozen=True, slots=True)
class Reading:
    """One value of a quantity in time."""

    entry: Entry
    quantity: Quantity


def search(connection: Connection, wanted: Wanted, limit: int) -> Hits:
    """Find entries."""
    # LIKE: SQLite's instr walks every character and takes four times as long.
    conditions = [_E.words.contains(word, autoescape=True) for word in folded(wanted.text).split()]
    if wanted.kinds:
        conditions.append(_E.kind.in_(wanted.kinds))
    if wanted.serial:
        conditions.append(_E.serial == wanted.serial)
    found = and_(_NO_COPY, *conditions)
    rows = connection.execute(
        select(*_ENTRY).where(found).order_by(_E.measured.desc(), _E.id.desc()).limit(limit)
    ).all()
    total = len(rows)
    if total == limit:
        total = connection.execute(
            select(func.count()).select_from(ENTRIES).where(found)
        ).scalar_one()
    return Hits(tuple(map(entry_of, rows)), total)


def entry_by_id(connection: Connection, number: int) -> Entry | None:
    """Return an entry; None if there is none of this number."""
    row = connection.execute(select(*_ENTRY).where(_E.id == number)).one_or_none()
    return None if row is None else entry_of(row)


def quantities_of(connection: Connection, number: int) -> tuple[Quantity, ...]:
    """Return the quantities of an entry in their order."""
    query = select(*_QUANTITY).where(_Q.entry == number).order_by(_Q.rank)
    return tuple(map(quantity_of, connection.execute(query)))


def readings(
    connection: Connection, serial: str, name: str, channel: str, sensor: str
) -> tuple[Reading, ...]:
    """Return every value of a quantity of a device, the earliest first."""
    query: Select[Any] = (
        select(*_ENTRY, *_QUANTITY)
        .join(QUANTITIES, _Q.entry == _E.id)
        .where(_E.serial == serial, _Q.name == name, _Q.channel == channel, _NO_COPY)
        .order_by(_E.measured, _E.id)
    )
    if sensor:
        query = query.where(_E.sensor == sensor)
    width = len(_ENTRY)
    rows = connection.execute(query)
    return tuple(Reading(entry_of(row[:width]), quantity_of(row[width:])) for row in rows)


def entry_of(row: Sequence[Any]) -> Entry:
    """An entry from the columns `_ENTRY`."""
    *texts, temperature, count, number, place = row
    return Entry(
        **dict(zip(_TEXTS, texts, strict=True)),
        temperature_c=math.nan if temperature is None else temperature,
        count=count,
        id=number,
        place=place,
    )


def quantity_of(row: Sequence[Any]) -> Quantity:
    """A quantity from the columns `_QUANTITY`."""
    channel, name, symbol, unit, value, u, dof = row
    return Quantity(
        channel,
        name,
        symbol,
        unit,
        value,
        math.nan if u is None else u,
        math.inf if dof is None else dof,
    )


def store(connection: Connection, place: str, found: list[tuple[str, str, Found]]) -> None:
    """Put entries in: folder, signature, what was found."""
    if not found:
        return
    rows = [_row(place, folder, signature, one.entry) for folder, signature, one in found]
    statement = insert(ENTRIES).returning(_E.id, sort_by_parameter_order=True)
    numbers = connection.execute(statement, rows).scalars().all()
    quantities = [
        _quantity_row(number, rank, quantity)
        for number, (_, _, one) in zip(numbers, found, strict=True)
        for rank, quantity in enumerate(_once(one.quantities))
    ]
    if quantities:
        connection.execute(insert(QUANTITIES), quantities)


def _once(quantities: tuple[Quantity, ...]) -> list[Quantity]:
    unique = {(quantity.channel, quantity.name): quantity for quantity in quantities}
    return [quantity for quantity in unique.values() if math.isfinite(quantity.value)]


def _row(place: str, folder: str, signature: str, entry: Entry) -> dict[str, Any]:
    row: dict[str, Any] = {name: _clean(getattr(entry, name)) for name in _TEXTS}
    words = [row[name] for name in _TEXTS if name != "sha256"]
    return {
        **row,
        "place": place,
        "folder": folder,
        "signature": signature,
        "temperature_c": _finite(entry.temperature_c),
        "count": entry.count,
        "words": folded(" ".join(words)),
    }


def _quantity_row(number: int, rank: int, quantity: Quantity) -> dict[str, Any]:
    texts = {name: _clean(getattr(quantity, name)) for name in ("channel", "name", "symbol")}
    return {
        **texts,
        "unit": _clean(quantity.unit),
        "entry": number,
        "rank": rank,
        "value": quantity.value,
        "u": _finite(quantity.u),
        "dof": _finite(quantity.dof),
    }


def folded(text: str) -> str:
    """Text in which case makes no difference, also of Cyrillic letters."""
    return text.casefold()


def _clean(text: str) -> str:
    """PostgreSQL's texts hold no zero characters."""
    return text.replace("\0", "")


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
