"""One record from switching on, and what a set of them must have in common."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.errors import FitError
from core.samples.run import Run

_APART_C = 1.0
"""Ambient temperatures nearer than this, but not equal, are taken for a slip."""
_ONE_SET_C = 3.0
"""Starts nearer than this belong to one set, where the chamber's temperature is not known."""
_UNEVEN = 0.01


@dataclass(frozen=True, slots=True, eq=False)
class TurnOn:
    """The output of a standing sensor from the moment it is switched on.

    Parameters
    ----------
    label : how the operator calls it
    ambient_c : temperature of the chamber, degC; the same number in every turn-on of one set
    y : (n,) output, equally spaced in time
    rate : samples per second
    temperature_c : (n,) temperature of the chip, degC; NaN throughout if it is not measured
    start_s : time of the first sample after switching on, s
    """

    label: str
    ambient_c: float
    y: FloatArray
    rate: float
    temperature_c: FloatArray
    start_s: float = 0.0

    @property
    def end_s(self) -> float:
        """Time of the end of the last sample, s."""
        return self.start_s + len(self.y) / self.rate

    def within(self, start_s: float, stop_s: float) -> slice:
        """The samples between two times."""
        first = round((start_s - self.start_s) * self.rate)
        return slice(first, round((stop_s - self.start_s) * self.rate))


def check_turn_ons(turn_ons: Sequence[TurnOn], horizon_s: float) -> float:
    """Refuse what cannot be averaged and return the common horizon, s.

    Parameters
    ----------
    turn_ons : one or more
    horizon_s : how long the compensation shall work; NaN takes the common length

    Raises
    ------
    FitError
        Lengths or sampling rates differ, a number is not finite, temperatures nearly coincide, or
        the records end before the horizon.
    """
    if not turn_ons:
        raise FitError("there is no turn-on")
    first = turn_ons[0]
    for one in turn_ons:
        bad = np.flatnonzero(~np.isfinite(one.y))
        if bad.size:
            raise FitError(f"{one.label}: sample {bad[0] + 1} is not a number")
        if not np.isfinite(one.ambient_c):
            raise FitError(f"{one.label}: the temperature of the chamber is missing")
        if not one.rate > 0 or one.rate != first.rate:
            raise FitError(
                f"{one.label} has {one.rate:g} samples per second, {first.label} {first.rate:g};"
                " turn-ons of one table need the same"
            )
        if one.temperature_c.shape != one.y.shape:
            raise FitError(f"{one.label}: {len(one.temperature_c)} temperatures, {len(one.y)} rows")
    ends = [one.end_s for one in turn_ons]
    shortest = turn_ons[int(np.argmin(ends))]
    if np.isnan(horizon_s):
        if max(ends) - min(ends) > 1.5 / first.rate:
            longest = turn_ons[int(np.argmax(ends))]
            raise FitError(
                f"the turn-ons differ in length: {shortest.label} ends at {min(ends):g} s,"
                f" {longest.label} at {max(ends):g} s; state a horizon of at most {min(ends):g} s"
                " to use the common part"
            )
        horizon_s = min(ends)
    elif horizon_s > min(ends) + 0.5 / first.rate:
        raise FitError(
            f"{shortest.label} ends at {min(ends):g} s, before the horizon of {horizon_s:g} s"
        )
    _check_ambients(turn_ons)
    return horizon_s


def _check_ambients(turn_ons: Sequence[TurnOn]) -> None:
    ambients = np.unique([one.ambient_c for one in turn_ons])
    near = np.flatnonzero(np.diff(ambients) < _APART_C)
    if near.size:
        low, high = ambients[near[0]], ambients[near[0] + 1]
        raise FitError(
            f"there are sets at {low:g} and at {high:g} degC; give turn-ons of one set the same"
            " temperature"
        )


def turn_ons_of(run: Run, channel: int) -> tuple[TurnOn, ...]:
    """The turn-ons of a run of test ``"record"``: one for each number in its column `run`.

    Parameters
    ----------
    run : `t_s` is the time since switching on; `extra["ambient_c"]`, where there is such a column,
        the temperature of the chamber
    channel : which output

    Raises
    ------
    FitError
        Times are missing or uneven.
    """
    ambient = run.extra.get("ambient_c", np.full(len(run), np.nan))
    found: list[TurnOn] = []
    for number in np.unique(run.run):
        chosen: BoolArray = np.equal(run.run, number)
        label = f"{run.device or 'record'}, turn-on {number}"
        t = run.t_s[chosen]
        found.append(
            TurnOn(
                label=label,
                ambient_c=float(ambient[chosen][0]),
                y=run.y[chosen, channel],
                rate=_rate(t, label),
                temperature_c=run.temperature_c[chosen],
                start_s=float(t[0]),
            )
        )
    return tuple(found)


def with_ambients(turn_ons: Sequence[TurnOn]) -> tuple[TurnOn, ...]:
    """Put turn-ons into sets by their first chip temperature where the chamber's is not known.

    Raises
    ------
    FitError
        Neither is known.
    """
    unknown = [one for one in turn_ons if np.isnan(one.ambient_c)]
    for one in unknown:
        if not np.isfinite(one.temperature_c[0]):
            raise FitError(f"{one.label}: the temperatures of chamber and chip are both unknown")
    unknown.sort(key=lambda one: float(one.temperature_c[0]))
    sets: dict[int, float] = {}
    members: list[TurnOn] = []
    for place, one in enumerate(unknown):
        members.append(one)
        following = unknown[place + 1 : place + 2]
        if not following or following[0].temperature_c[0] - one.temperature_c[0] > _ONE_SET_C:
            mean = float(np.mean([member.temperature_c[0] for member in members]))
            sets |= dict.fromkeys(map(id, members), mean)
            members = []
    return tuple(replace(one, ambient_c=sets.get(id(one), one.ambient_c)) for one in turn_ons)


def _rate(t: FloatArray, label: str) -> float:
    """Samples per second of equally spaced times."""
    if len(t) < 2 or not np.all(np.isfinite(t)):
        raise FitError(f"{label}: the time since switching on is missing")
    steps = np.diff(t)
    step = float(np.median(steps))
    off = np.abs(steps - step)
    if not step > 0 or np.any(off > _UNEVEN * step):
        place = int(np.argmax(off))
        raise FitError(
            f"{label}: rows {place + 1} and {place + 2} are {steps[place]:.6g} s apart, the others"
            f" {step:.6g} s; gaps cannot be averaged over"
        )
    rate = (len(t) - 1) / float(t[-1] - t[0])
    # Written times are rounded; a sampling rate hardly ever is no whole number.
    return float(round(rate)) if abs(rate - round(rate)) < 1e-4 * rate else rate
