"""What the tab asks the archive; all of it runs in a worker."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from core.archive.compare import Compared, compare
from core.archive.entry import DAMAGED, Entry, Quantity
from core.archive.history import History, history_of
from core.archive.limits import Limit, limit_of, read_limits
from core.archive.nearest import Proposal, nearest
from core.archive.reprocess import Redone, reprocess
from core.errors import FormatError, Note, StorageError
from core.fit.quantiles import student_t
from core.records.session.record import read_session
from gui.archive.opening import opening_of

if TYPE_CHECKING:
    from core.archive.search import Hits
    from core.archive.store import Archive

_WITH_QUANTITIES = ("calibration", "noise")
_SHOWN = 500


@dataclass(frozen=True, slots=True)
class Listed:
    """What was found, and whether there is anything at all."""

    hits: "Hits"
    anything: bool
    name: str
    notes: tuple[Note, ...]


@dataclass(frozen=True, slots=True)
class Parameter:
    """One that can be followed."""

    serial: str
    sensor: str
    channel: str
    name: str


@dataclass(frozen=True, slots=True)
class Details:
    """What is known of the chosen entries.

    Parameters
    ----------
    entries : one or two
    quantities, limits : of the first, a limit each; None where there is none
    compared : of two
    proposals : calibrations nearest to a measurement
    parameters : what can be followed
    path : file of the first; None if it stands elsewhere, and `why_not` tells
    opening : title of the tab that can work with it, and what that tab is to load
    """

    entries: tuple[Entry, ...]
    quantities: tuple[Quantity, ...]
    limits: tuple[Limit | None, ...]
    compared: Compared | None
    proposals: tuple[Proposal, ...]
    parameters: tuple[Parameter, ...]
    path: Path | None
    opening: tuple[str, Path] | None
    why_not: str = ""


def can_be_certified(found: Details) -> bool:
    """Whether a certificate can be made of the chosen entry."""
    entry = found.entries[0]
    kinds = ("session", "calibration", "run", "legacy", "record")
    return found.path is not None and entry.kind in kinds and entry.verdict != DAMAGED


@dataclass(frozen=True, slots=True)
class Redecoded:
    """A session decoded again."""

    entry: Entry
    found: tuple[Redone, ...]


def listed(archive: "Archive", text: str, kind: str) -> Listed:
    """Search."""
    # scipy is imported by the first quantile: here, and not in the window's thread.
    student_t(0.95, 3.0)
    hits = archive.search(text, (kind,) if kind else (), limit=_SHOWN)
    anything = bool(hits.total) or bool(archive.search(limit=1).total)
    return Listed(hits, anything, archive.name, archive.notes)


def details(archive: "Archive", numbers: Sequence[int]) -> Details:
    """Return what is known of one entry, or of two that are compared."""
    entries = tuple(archive.entry(number) for number in numbers[:2])
    each = [archive.quantities(entry) for entry in entries]
    limits = read_limits(archive.place.root)
    first = entries[0]
    path, why_not = None, ""
    try:
        path = archive.path_of(first)
    except StorageError as error:
        why_not = str(error)
    return Details(
        entries=entries,
        quantities=each[0],
        limits=tuple(limit_of(limits, first, quantity) for quantity in each[0]),
        compared=compare((first, each[0]), (entries[1], each[1])) if len(entries) > 1 else None,
        proposals=_proposals(archive, first),
        parameters=_parameters(archive, first, each[0]),
        path=path,
        opening=None if path is None else opening_of(first, path),
        why_not=why_not,
    )


def _proposals(archive: "Archive", entry: Entry) -> tuple[Proposal, ...]:
    """For what was measured, the calibrations that it could be used with."""
    if entry.kind in _WITH_QUANTITIES or entry.when is None:
        return ()
    return nearest(archive, entry.serial, entry.when, entry.temperature_c)[:3]


def _parameters(
    archive: "Archive", entry: Entry, own: tuple[Quantity, ...]
) -> tuple[Parameter, ...]:
    """Parameters of the entry; where it has none, of the latest calibration of its device."""
    if not own:
        latest = archive.search(kinds=_WITH_QUANTITIES, serial=entry.serial, limit=1).entries
        if not latest:
            return ()
        entry, own = latest[0], archive.quantities(latest[0])
    return tuple(Parameter(entry.serial, entry.sensor, q.channel, q.name) for q in own)


def followed(
    archive: "Archive", parameter: Parameter, temperature_c: float = math.nan
) -> History | None:
    """Return the history of a parameter, at about a temperature, or at all where it is NaN."""
    readings = archive.readings(
        parameter.serial, parameter.name, parameter.channel, parameter.sensor
    )
    if not readings:
        return None
    return history_of(readings, read_limits(archive.place.root), temperature_c=temperature_c)


def redecoded(archive: "Archive", number: int) -> Redecoded:
    """Decode a session again.

    Raises
    ------
    FormatError
        It is no session.
    """
    from gui.archive.raw import TodaysDecoder

    entry = archive.entry(number)
    if entry.kind != "session":
        raise FormatError(entry.path, "is no session: it has no raw bytes")
    record = read_session(archive.path_of(entry))
    found = reprocess(record, archive.place.root / "raw", TodaysDecoder())
    return Redecoded(entry, found)
