"""A parameter over time: scatter from turn-on to turn-on, drift over the years.

The statistics are those of the calibrations as they are: each is a turn-on of its own, under what
conditions it was made. Their scatter is compared with their own uncertainties; parts that all
calibrations of a bench share (local g, the head's constant errors) stand in the uncertainties and
not in the scatter, so that the excess is a lower limit.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from core.archive.entry import BAD
from core.archive.limits import Limit, limit_of
from core.errors import Note, Severity
from core.fit.estimate import Estimate

if TYPE_CHECKING:
    from core.archive.search import Reading

YEAR_S = 365.25 * 86400.0
TOLERANCE_K = 5.0
"""How near to a temperature a calibration is "at" it."""


@dataclass(frozen=True, slots=True)
class History:
    """A parameter of a device over time.

    Parameters
    ----------
    readings : the earliest first; all of one unit
    counted : (n,) whether each is in the statistics
    unit : of the numbers
    mean : of those that count; NaN without any
    repeatability : standard deviation from calibration to calibration, k = 1, (n - 1 degrees of
        freedom); NaN for fewer than two
    excess : the part of it that the uncertainties of the calibrations do not explain
    drift : per year, of a straight line; None for fewer than three or all of one moment
    limit : what the laboratory demands; None if it states nothing
    notes : what was left out, and why
    """

    readings: "tuple[Reading, ...]"
    counted: tuple[bool, ...]
    unit: str
    mean: float
    repeatability: float
    excess: float
    drift: Estimate | None
    limit: Limit | None
    notes: tuple[Note, ...]

    @property
    def n(self) -> int:
        """How many are in the statistics."""
        return sum(self.counted)

    @property
    def u_repeatability(self) -> float:
        """Standard uncertainty of the repeatability, of a normal scatter."""
        return self.repeatability / math.sqrt(2.0 * (self.n - 1)) if self.n > 1 else math.nan


def history_of(
    readings: "Sequence[Reading]",
    limits: Sequence[Limit] = (),
    *,
    temperature_c: float = math.nan,
    tolerance_k: float = TOLERANCE_K,
) -> History:
    """Return the history of a parameter.

    Parameters
    ----------
    readings : of one parameter of one device, the earliest first
    limits : of the laboratory
    temperature_c, tolerance_k : only calibrations at about this temperature count; NaN for all

    Raises
    ------
    ValueError
        There are no readings.
    """
    if not readings:
        raise ValueError("a history of nothing")
    latest = readings[-1]
    unit = latest.quantity.unit
    kept = tuple(reading for reading in readings if reading.quantity.unit == unit)
    bad = [reading.entry.verdict == BAD for reading in kept]
    near = [
        math.isnan(temperature_c) or abs(reading.entry.temperature_c - temperature_c) <= tolerance_k
        for reading in kept
    ]
    counted = tuple(not b and n for b, n in zip(bad, near, strict=True))
    notes = _notes(len(readings) - len(kept), unit, sum(bad), near.count(False), temperature_c)
    used = [reading for reading, count in zip(kept, counted, strict=True) if count]
    values = np.array([reading.quantity.value for reading in used])
    spread = float(values.std(ddof=1)) if len(used) > 1 else math.nan
    own = np.array([reading.quantity.u for reading in used])
    known = own[np.isfinite(own)]
    explained = float(np.mean(known**2)) if known.size else 0.0
    return History(
        readings=kept,
        counted=counted,
        unit=unit,
        mean=float(values.mean()) if len(used) else math.nan,
        repeatability=spread,
        excess=math.sqrt(max(0.0, spread**2 - explained)) if len(used) > 1 else math.nan,
        drift=_drift(used, unit),
        limit=limit_of(limits, latest.entry, latest.quantity),
        notes=notes,
    )


def temperatures_of(readings: "Sequence[Reading]") -> tuple[float, ...]:
    """Return the temperatures at which there are readings, rising: means of those close together.

    Parameters
    ----------
    readings : of one parameter; those of unknown temperature are passed over
    """
    known = sorted(
        reading.entry.temperature_c
        for reading in readings
        if not math.isnan(reading.entry.temperature_c)
    )
    groups: list[list[float]] = []
    for temperature in known:
        if groups and temperature - groups[-1][0] <= TOLERANCE_K:
            groups[-1].append(temperature)
        else:
            groups.append([temperature])
    return tuple(sum(group) / len(group) for group in groups)


def _drift(used: "Sequence[Reading]", unit: str) -> Estimate | None:
    """Slope of the least-squares line; its uncertainty is from the scatter about it."""
    moments = [reading.entry.when for reading in used]
    t = np.array([moment.timestamp() for moment in moments if moment is not None]) / YEAR_S
    if len(t) < 3 or len(t) != len(used) or not np.ptp(t) > 0.0:
        return None
    y = np.array([reading.quantity.value for reading in used])
    t = t - t.mean()
    square = float(t @ t)
    slope = float(t @ y) / square
    rest = y - y.mean() - slope * t
    dof = len(t) - 2
    u = math.sqrt(float(rest @ rest) / dof / square)
    return Estimate(slope, u, float(dof), f"{unit}/year")


def _notes(
    other_units: int, unit: str, bad: int, far: int, temperature_c: float
) -> tuple[Note, ...]:
    notes: list[Note] = []
    if other_units:
        text = f"{other_units} earlier values are in another unit than {unit} and are left out"
        notes.append(Note(Severity.WARNING, "other_units", text))
    if bad:
        text = f"{bad} calibrations with errors are shown and do not count"
        notes.append(Note(Severity.INFO, "bad_left_out", text))
    if far:
        text = f"{far} calibrations not at about {temperature_c:.3g} °C are shown and do not count"
        notes.append(Note(Severity.INFO, "far_left_out", text))
    return tuple(notes)
