"""What the index holds of a file."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime

import numpy as np

from core.errors import Note, Severity
from core.fit.estimate import Estimate

KINDS = ("session", "calibration", "run", "legacy", "record", "means", "noise")
"""What can stand in an archive, in the order in which it is listed."""

FINISHED, OPEN, GOOD, DOUBT, BAD, DAMAGED = "finished", "open", "good", "doubt", "bad", "damaged"


@dataclass(frozen=True, slots=True)
class Quantity:
    """One parameter of a calibration, or one coefficient of a noise analysis.

    Parameters
    ----------
    channel : output that it belongs to
    name, symbol, unit : of the parameter
    value : estimate
    u : standard uncertainty; NaN where none is known
    dof : degrees of freedom of `u`; inf where it is as good as known
    """

    channel: str
    name: str
    symbol: str
    unit: str
    value: float
    u: float
    dof: float = math.inf

    def expanded(self, level: float = 0.95) -> float:
        """Half width of the two-sided coverage interval; NaN without an uncertainty."""
        return Estimate(self.value, self.u, self.dof, self.unit).expanded(level)


@dataclass(frozen=True, slots=True)
class Entry:
    """One thing in the archive: a session, a calibration, a device's rows of an old file.

    Parameters
    ----------
    kind : one of `KINDS`
    path : below the archive's folder, with ``/``; of a session its folder
    part : device, where a file holds several; else empty
    serial : name or serial number of the device
    sensor : ``"accelerometer"``, ``"gyro"``, or empty
    what : plan, procedure or layout
    operator, profile : empty where unknown
    measured : UTC, ISO 8601 to the second; empty where unknown
    temperature_c : mean; NaN where it was not measured
    verdict : ``"finished"``, ``"open"``, ``"good"``, ``"doubt"``, ``"bad"`` or ``"damaged"``;
        empty where there is nothing to judge
    count : positions, rows or sensors
    remark : the worst doubt, or why it cannot be read
    sha256 : of the content; empty where it is too large to be hashed
    id : in the index; 0 before it is there
    place : identity of the archive's folder that holds it
    """

    kind: str
    path: str
    serial: str
    part: str = ""
    sensor: str = ""
    what: str = ""
    operator: str = ""
    profile: str = ""
    measured: str = ""
    temperature_c: float = float("nan")
    verdict: str = ""
    count: int = 0
    remark: str = ""
    sha256: str = ""
    id: int = 0
    place: str = ""

    @property
    def when(self) -> datetime | None:
        """The moment of measuring."""
        return datetime.fromisoformat(self.measured) if self.measured else None


@dataclass(frozen=True, slots=True)
class Found:
    """An entry with its quantities, as a reader gives it."""

    entry: Entry
    quantities: tuple[Quantity, ...] = ()


def judged(notes: Iterable[Note], good: str = GOOD) -> tuple[str, str]:
    """Return the verdict that notes give, and the words of the worst."""
    ranked = {Severity.ERROR: BAD, Severity.WARNING: DOUBT}
    worst = ("", "")
    for note in notes:
        verdict = ranked.get(note.severity, "")
        if verdict and (not worst[0] or (verdict == BAD and worst[0] == DOUBT)):
            worst = (verdict, note.text)
    return worst if worst[0] else (good, "")


def mean_of(values: Iterable[float]) -> float:
    """Return the mean of the finite numbers, NaN without any."""
    array = np.array([value for value in values if np.isfinite(value)])
    return float(array.mean()) if array.size else float("nan")
