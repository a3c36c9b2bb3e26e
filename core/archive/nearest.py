"""The calibration nearest by date and temperature."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from core.archive.entry import BAD, DAMAGED, Entry
from core.errors import StorageError

if TYPE_CHECKING:
    from core.archive.store import Archive

DAYS_PER_KELVIN = 10.0
"""How many days weigh as much as one kelvin."""
_UNKNOWN_K = 10.0
"""How far off a calibration of unknown temperature is taken to be."""
_ALL = 100_000


@dataclass(frozen=True, slots=True)
class Proposal:
    """A calibration that can be used.

    Parameters
    ----------
    entry : the calibration
    days : later than asked for; negative for earlier
    kelvin : warmer than asked for; NaN where either temperature is unknown
    """

    entry: Entry
    days: float
    kelvin: float

    @property
    def distance(self) -> float:
        """Days, with kelvins counted as days."""
        apart = _UNKNOWN_K if math.isnan(self.kelvin) else abs(self.kelvin)
        return math.hypot(self.days, DAYS_PER_KELVIN * apart)


@dataclass(frozen=True, slots=True)
class Usable:
    """A calibration whose file stands here.

    Parameters
    ----------
    proposal : which, and how far off
    path : its file
    """

    proposal: Proposal
    path: Path

    @property
    def words(self) -> str:
        """Number, how long before or after, and temperature, for a line of text."""
        entry, days = self.proposal.entry, self.proposal.days
        count = round(abs(days))
        when = "the same day"
        if count == 1:
            when = "one day earlier" if days < 0 else "one day later"
        elif count:
            when = f"{count} days earlier" if days < 0 else f"{count} days later"
        warmth = entry.temperature_c
        if math.isnan(warmth):
            return f"No. {entry.id}, {when}"
        return f"No. {entry.id}, {when}, {warmth:.1f} °C"


def usable(
    archive: "Archive",
    serial: str,
    when: datetime,
    temperature_c: float = math.nan,
    *,
    sensor: str = "",
    limit: int = 5,
) -> tuple[Usable, ...]:
    """Return the nearest calibrations whose files stand at this rig; parameters as of `nearest`.

    Raises
    ------
    StorageError
        The index cannot be read.
    """
    found: list[Usable] = []
    for proposal in nearest(archive, serial, when, temperature_c, sensor=sensor):
        if len(found) == limit:
            break
        try:
            found.append(Usable(proposal, archive.path_of(proposal.entry)))
        except StorageError:  # at another rig, or gone since the last look
            continue
    return tuple(found)


def nearest(
    archive: "Archive",
    serial: str,
    when: datetime,
    temperature_c: float = math.nan,
    *,
    sensor: str = "",
) -> tuple[Proposal, ...]:
    """Return the calibrations of a device, the nearest first; bad and damaged ones never.

    Parameters
    ----------
    archive : where to look
    serial : of the device
    when : moment of the measurement that wants one, with its offset from UTC
    temperature_c : of that measurement; NaN where it does not matter or is unknown
    sensor : ``"accelerometer"`` or ``"gyro"``; empty for either

    Raises
    ------
    StorageError
        The index cannot be read.
    """
    found = archive.search(kinds=("calibration",), serial=serial, limit=_ALL).entries
    return ranked([one for one in found if sensor in ("", one.sensor)], when, temperature_c)


def ranked(
    entries: Sequence[Entry], when: datetime, temperature_c: float = math.nan
) -> tuple[Proposal, ...]:
    """Return calibrations by their distance, without bad and damaged ones."""
    proposals: list[Proposal] = [
        Proposal(
            entry,
            (entry.when - when).total_seconds() / 86400.0,
            entry.temperature_c - temperature_c,
        )
        for entry in entries
        if entry.when is not None and entry.verdict not in (BAD, DAMAGED)
    ]
    return tuple(sorted(proposals, key=lambda proposal: proposal.distance))
