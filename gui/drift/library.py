"""The turn-ons of the list, and the table that is made of them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from PySide6.QtCore import QObject

from core.errors import FitError, FormatError
from core.procedures.drift.compensate import DriftResult, compensate
from core.procedures.drift.curves import curves_of
from core.procedures.drift.simulated import UNIT, simulated_turn_ons
from core.procedures.drift.table import knots_within
from core.procedures.drift.turn_on import TurnOn
from gui.analysis import library
from gui.drift.reading import How, files_of, read_turn_ons
from gui.drift.state import Settings
from gui.jobs import Jobs

SIMULATED_RATE = 200.0


@dataclass(frozen=True, slots=True, eq=False)
class Entry(library.Entry):
    """One row of the list, a file or the simulated gyro.

    Parameters
    ----------
    ambient_c : temperature of the chamber as stated; NaN where nothing is
    turn_ons : what it holds; empty until it was read
    unit : of the outputs
    """

    ambient_c: float = float("nan")
    turn_ons: tuple[TurnOn, ...] = ()
    unit: str = ""


class Library(library.Library[Entry, Settings, DriftResult]):
    """Keeps turn-ons and has the table made.

    Parameters
    ----------
    jobs : where the work is done
    """

    def __init__(self, jobs: Jobs, parent: QObject | None = None) -> None:
        method = library.Method("drift", Entry, files_of, _how, _read, _unread, _table)
        super().__init__(jobs, method, Settings(), parent)

    def state_ambient(self, key: int, ambient_c: float) -> None:
        """Say how warm the chamber was; NaN takes what the file or the chip tells."""
        entry = self.get(key)
        if entry is None or entry.path is None or _same(entry.ambient_c, ambient_c):
            return
        self.exchange(replace(_unread(entry), ambient_c=ambient_c))


def _unread(entry: Entry) -> Entry:
    return replace(entry, turn_ons=(), unit="", error="")


def _read(entry: Entry, settings: Settings) -> Entry:
    if entry.turn_ons:
        return entry
    if entry.path is None:
        return replace(entry, turn_ons=simulated_turn_ons(1, rate=SIMULATED_RATE), unit=UNIT)
    try:
        found, unit = read_turn_ons(entry.path, _how(settings), entry.ambient_c)
    except OSError as error:
        raise FormatError(entry.path, f"cannot be read: {error}") from error
    return replace(entry, turn_ons=found, unit=unit)


def _table(entries: Sequence[Entry], settings: Settings) -> DriftResult | None:
    turn_ons = [one for entry in entries for one in entry.turn_ons]
    if not turn_ons:
        return None
    units = sorted({entry.unit for entry in entries if entry.turn_ons})
    if len(units) > 1:
        raise FitError(f"turn-ons in {', '.join(units)}; one unit is needed")
    curves = curves_of(
        turn_ons,
        window_s=(settings.start_s, settings.stop_s),
        block_s=settings.block_s,
        horizon_s=settings.horizon_s or np.nan,
    )
    limit = min(settings.limit, len(curves.t) // 2)
    temperatures = len(curves.temperatures_c)
    if settings.memory:
        within = knots_within(settings.memory, temperatures)
        if within < 2:
            raise FitError(
                f"{settings.memory} bytes hold no table of {temperatures} temperatures; two knots"
                f" need {2 * (2 + 3 * temperatures)}"
            )
        limit = min(limit, within)
    knots = min(settings.knots, limit) if settings.knots else None
    return compensate(curves, units[0], limit=limit, knots=knots)


def _how(settings: Settings) -> How:
    return How(settings.channel, "", settings.rate, settings.scale_factor)


def _same(one: float, other: float) -> bool:
    return one == other or (np.isnan(one) and np.isnan(other))
