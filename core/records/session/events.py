"""What happens in a session, as events that are never taken back.

A position that was measured is an event; that it is repeated, discarded or taken back in is
another one. Which positions count follows from all of them (`counting`).
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from core.errors import FormatError
from core.plans.plan import Step
from core.records.json_fields import (
    Fields,
    Json,
    notes_to_json,
    number_to_json,
    numbers_to_json,
)
from core.samples.accumulate import Accumulation
from core.samples.block import Channel


@dataclass(frozen=True, slots=True)
class RawRange:
    """Where the bytes of an accumulation stand.

    Parameters
    ----------
    name : raw log file in the session's folder
    first, last : its bytes from `first` up to `last`
    """

    name: str
    first: int
    last: int


@dataclass(frozen=True, slots=True, eq=False)
class Position:
    """One accumulation of a session.

    Parameters
    ----------
    id : number of its event
    attempt : how many accumulations of this step at this temperature there were, with this one
    step : the step of the plan, with the angle or rate that was really set
    measured_utc : end of the accumulation, ISO 8601
    accumulation : the means
    temperature_c : measured case temperature; NaN if the device tells none in degrees
    set_temperature_c : temperature set on the chamber; NaN without one
    raw : where its bytes stand, None without a raw log
    """

    id: int
    attempt: int
    step: Step
    measured_utc: str
    accumulation: Accumulation
    temperature_c: float
    set_temperature_c: float
    raw: RawRange | None


@dataclass(frozen=True, slots=True, eq=False)
class Event:
    """One line of the journal.

    Parameters
    ----------
    id : its number, from 1
    utc : when, ISO 8601
    kind : ``"accepted"`` or ``"rejected"`` (both with a position), ``"discarded"``,
        ``"restored"``, ``"recovered"``, ``"finished"``, ``"reopened"``
    position : what was measured; None for the other kinds
    targets : accepted: positions that it supersedes; discarded, restored: the positions meant
    instead_of : restored: positions that no longer count
    reason : in the operator's words, or the program's
    """

    id: int
    utc: str
    kind: str
    position: Position | None = None
    targets: tuple[int, ...] = ()
    instead_of: tuple[int, ...] = ()
    reason: str = ""


def counting(events: Iterable[Event]) -> tuple[Position, ...]:
    """The positions that count, in the order of measuring."""
    positions: dict[int, Position] = {}
    counts: dict[int, bool] = {}
    for event in events:
        if event.position is not None:
            positions[event.id] = event.position
            counts[event.id] = event.kind == "accepted"
        counts.update(dict.fromkeys((*event.targets, *event.instead_of), False))
        if event.kind == "restored":
            counts.update(dict.fromkeys(event.targets, True))
    return tuple(position for number, position in positions.items() if counts[number])


def event_to_json(event: Event) -> Json:
    """The event as one JSON object; what is empty is left out."""
    document: dict[str, Json] = {"id": event.id, "utc": event.utc, "kind": event.kind}
    if event.position is not None:
        document["position"] = _position_to_json(event.position)
    if event.targets:
        document["targets"] = list(event.targets)
    if event.instead_of:
        document["instead_of"] = list(event.instead_of)
    if event.reason:
        document["reason"] = event.reason
    return document


def event_from_json(fields: Fields, channels: tuple[Channel, ...]) -> Event:
    """Read an event.

    Raises
    ------
    FormatError
        It does not hold what it should.
    """
    number = fields.integer("id")
    position = None
    if "position" in fields.data:
        position = _position_from_json(fields.object("position"), number, channels)
    return Event(
        id=number,
        utc=fields.text("utc"),
        kind=fields.text("kind"),
        position=position,
        targets=_ids(fields, "targets"),
        instead_of=_ids(fields, "instead_of"),
        reason=fields.text("reason") if "reason" in fields.data else "",
    )


def _ids(fields: Fields, key: str) -> tuple[int, ...]:
    if key not in fields.data:
        return ()
    found: list[int] = []
    for item in fields.items(key):
        if isinstance(item, bool) or not isinstance(item, int):
            raise fields.wrong(key, "event numbers", item)
        found.append(item)
    return tuple(found)


def step_to_json(step: Step) -> dict[str, Json]:
    """A step of a plan as data."""
    return {
        "number": step.number,
        "group": step.group,
        "mount": step.mount,
        "head_deg": number_to_json(step.head_deg),
        "rate_dps": number_to_json(step.rate_dps),
        "axis": step.axis,
    }


def step_from_json(fields: Fields) -> Step:
    """Read a step of a plan."""
    return Step(
        number=fields.integer("number"),
        group=fields.text("group"),
        mount=fields.text("mount"),
        head_deg=fields.number("head_deg"),
        rate_dps=fields.number("rate_dps"),
        axis=fields.text("axis"),
    )


def _position_to_json(position: Position) -> Json:
    mean = position.accumulation
    document: dict[str, Json] = {
        "attempt": position.attempt,
        "step": step_to_json(position.step),
        "measured_utc": position.measured_utc,
        "temperature_c": number_to_json(position.temperature_c),
        "set_temperature_c": number_to_json(position.set_temperature_c),
        "n": mean.n,
        "seconds": number_to_json(mean.seconds),
        "lost": mean.lost,
        "first": mean.first,
        "mean": numbers_to_json(mean.mean),
        "std": numbers_to_json(mean.std),
        "se": numbers_to_json(mean.se),
        "se_dof": numbers_to_json(mean.se_dof),
        "slope": numbers_to_json(mean.slope),
        "slope_se": numbers_to_json(mean.slope_se),
        "notes": notes_to_json(mean.notes),
    }
    if position.raw is not None:
        document["raw"] = {
            "name": position.raw.name,
            "first": position.raw.first,
            "last": position.raw.last,
        }
    return document


def _position_from_json(fields: Fields, number: int, channels: tuple[Channel, ...]) -> Position:
    c = len(channels)
    raw = None
    if "raw" in fields.data:
        place = fields.object("raw")
        raw = RawRange(place.text("name"), place.integer("first"), place.integer("last"))
    if math.isnan(fields.number("seconds")):
        raise FormatError(fields.path, f"{fields.where}.seconds is no number")
    return Position(
        id=number,
        attempt=fields.integer("attempt"),
        step=step_from_json(fields.object("step")),
        measured_utc=fields.moment("measured_utc"),
        temperature_c=fields.number("temperature_c"),
        set_temperature_c=fields.number("set_temperature_c"),
        raw=raw,
        accumulation=Accumulation(
            channels=channels,
            n=fields.integer("n"),
            seconds=fields.number("seconds"),
            lost=fields.integer("lost"),
            first=fields.integer("first"),
            mean=fields.numbers("mean", c),
            std=fields.numbers("std", c),
            se=fields.numbers("se", c),
            se_dof=fields.numbers("se_dof", c),
            slope=fields.numbers("slope", c),
            slope_se=fields.numbers("slope_se", c),
            notes=fields.notes("notes"),
        ),
    )
