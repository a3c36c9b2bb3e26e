"""The turn-ons of the list, and the work on them: in a worker thread, the newest wish last."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal

from core.errors import FitError, FormatError, LabError
from core.procedures.drift.compensate import DriftResult, compensate
from core.procedures.drift.curves import curves_of
from core.procedures.drift.simulated import UNIT, simulated_turn_ons
from core.procedures.drift.table import knots_within
from core.procedures.drift.turn_on import TurnOn
from gui.drift.reading import How, files_of, read_turn_ons
from gui.drift.state import Settings
from gui.jobs import Jobs

SIMULATED_RATE = 200.0


@dataclass(frozen=True, slots=True, eq=False)
class Entry:
    """One row of the list.

    Parameters
    ----------
    key : by which it is meant
    path : its file; None for the simulated gyro
    ambient_c : temperature of the chamber as stated; NaN where nothing is
    turn_ons : what it holds; empty until it was read
    unit : of the outputs
    error : why it cannot be used
    """

    key: int
    path: Path | None
    ambient_c: float = float("nan")
    turn_ons: tuple[TurnOn, ...] = ()
    unit: str = ""
    error: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class _Wish:
    entries: tuple[Entry, ...]
    settings: Settings


@dataclass(frozen=True, slots=True, eq=False)
class _Done:
    wish: _Wish
    entries: tuple[Entry, ...]
    result: DriftResult | None
    error: str


@dataclass(slots=True)
class _Kept:
    entries: dict[int, Entry] = field(default_factory=dict[int, Entry])
    next: int = 1


class Library(QObject):
    """Keeps turn-ons and has the table made.

    Parameters
    ----------
    jobs : where the work is done
    """

    changed = Signal()
    """Entries, result or work have changed."""

    def __init__(self, jobs: Jobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._kept = _Kept()
        self._running: _Wish | None = None
        self._again = False
        self.settings = Settings()
        self.result: DriftResult | None = None
        self.error = ""

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All rows, in the order in which they came."""
        return tuple(self._kept.entries.values())

    @property
    def busy(self) -> bool:
        """Whether work runs."""
        return self._running is not None

    def get(self, key: int) -> Entry | None:
        """Return a row; None if it was removed."""
        return self._kept.entries.get(key)

    def add(self, paths: Sequence[Path]) -> int:
        """Read files, or all of a folder; return the key of the last one, 0 for none."""
        return self._put([Entry(0, path) for path in files_of(paths)])

    def simulate(self) -> int:
        """Put the simulated gyro into the list; return its key."""
        return self._put([Entry(0, None)])

    def _put(self, fresh: Sequence[Entry]) -> int:
        kept = self._kept
        key = 0
        for entry in fresh:
            key = kept.next
            kept.entries[key] = replace(entry, key=key)
            kept.next += 1
        if key:
            self._go_on()
        return key

    def remove(self, key: int) -> None:
        """Take a row out of the list; its file stays."""
        if self._kept.entries.pop(key, None) is not None:
            self._go_on()

    def state_ambient(self, key: int, ambient_c: float) -> None:
        """Say how warm the chamber was; NaN takes what the file or the chip tells."""
        entry = self.get(key)
        if entry is None or entry.path is None or _same(entry.ambient_c, ambient_c):
            return
        self._kept.entries[key] = Entry(key, entry.path, ambient_c)
        self._go_on()

    def decide(self, settings: Settings) -> None:
        """Make the table with other settings."""
        if settings == self.settings:
            return
        how = _how(settings)
        if how != _how(self.settings):
            for key, entry in self._kept.entries.items():
                if entry.path is not None:
                    self._kept.entries[key] = Entry(key, entry.path, entry.ambient_c)
        self.settings = settings
        self._go_on()

    def _go_on(self) -> None:
        if self._running is not None:
            self._again = True
        else:
            wish = _Wish(self.entries, self.settings)
            self._running, self._again = wish, False
            self._jobs.start("drift table", lambda: _work(wish), self._on_done, self._on_failed)
        self.changed.emit()

    def _on_done(self, done: object) -> None:
        if not isinstance(done, _Done):
            raise TypeError(f"the work brought {type(done).__name__}")
        self._running = None
        for before, after in zip(done.wish.entries, done.entries, strict=True):
            if self._kept.entries.get(after.key) is before:
                self._kept.entries[after.key] = after
        if self._again:
            self._go_on()
            return
        self.result, self.error = done.result, done.error
        self.changed.emit()

    def _on_failed(self, error: LabError) -> None:
        self._running = None
        self.result, self.error = None, str(error)
        self.changed.emit()


def _work(wish: _Wish) -> _Done:
    entries = tuple(_read(entry, wish.settings) for entry in wish.entries)
    turn_ons = [one for entry in entries for one in entry.turn_ons]
    if not turn_ons:
        return _Done(wish, entries, None, "")
    try:
        return _Done(wish, entries, _table(turn_ons, entries, wish.settings), "")
    except LabError as error:
        return _Done(wish, entries, None, str(error))


def _read(entry: Entry, settings: Settings) -> Entry:
    if entry.turn_ons or entry.error:
        return entry
    if entry.path is None:
        return replace(entry, turn_ons=simulated_turn_ons(1, rate=SIMULATED_RATE), unit=UNIT)
    try:
        found, unit = read_turn_ons(entry.path, _how(settings), entry.ambient_c)
    except LabError as error:
        return replace(entry, error=str(error))
    except OSError as error:
        return replace(entry, error=str(FormatError(entry.path, f"cannot be read: {error}")))
    return replace(entry, turn_ons=found, unit=unit)


def _table(turn_ons: list[TurnOn], entries: tuple[Entry, ...], settings: Settings) -> DriftResult:
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
