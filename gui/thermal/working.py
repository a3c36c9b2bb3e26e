"""What is read and computed of a cycle and of a record; no Qt."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.arrays import BoolArray
from core.errors import FitError, FormatError
from core.plans.plan import load_plans
from core.procedures.dividing_head import calibrate
from core.procedures.thermal.cycle import ThermalCalibration, calibrate_thermal
from core.procedures.thermal.joined import joined
from core.procedures.thermal.plateaus import plateaus_of
from core.procedures.thermal.record import RecordResult, fit_record
from core.procedures.thermal.simulated import simulated_cycle
from core.procedures.thermal.split import SplitPoint, splits_of
from core.procedures.thermal.tilt import TiltErrors, tilt_errors, tilt_left_out
from core.records.open import read_any
from core.records.run_head import is_run_file
from core.records.series_run import record_run
from core.records.session.record import START_NAME, read_session
from core.samples.run import Conditions, Run
from drivers.series import read_series
from gui.thermal.state import FOUND, Settings

RECORD = "record"
SUFFIXES = (".calrec", ".csv", ".txt", ".dat")
_HEAD = 4096
_SEED = 1


@dataclass(frozen=True, slots=True, eq=False)
class TiltTable:
    """Errors of roll and pitch.

    Parameters
    ----------
    before : by the first temperature alone
    after : compensated
    unseen : (n,) rows that the compensation has not seen
    check : whether the rows are those of a check run
    """

    before: TiltErrors
    after: TiltErrors
    unseen: BoolArray
    check: bool


@dataclass(frozen=True, slots=True, eq=False)
class CycleOutcome:
    """What was found of positions.

    Parameters
    ----------
    run : all rows
    conditions : taken; `assumed` tells that nobody stated g
    thermal : None where the rows allow no dependence on temperature, and `why` tells it
    splits : k, T and mounting at each temperature
    tilt : None where the sensors are no triad, or a check leaves the temperatures: `why_no_tilt`
    """

    run: Run
    conditions: Conditions
    assumed: bool
    thermal: ThermalCalibration | None
    why: str
    splits: tuple[SplitPoint, ...]
    tilt: TiltTable | None
    why_no_tilt: str


@dataclass(frozen=True, slots=True, eq=False)
class RecordOutcome:
    """What was found of a standing unit."""

    run: Run
    found: RecordResult


Outcome = CycleOutcome | RecordOutcome


def read_source(path: Path, settings: Settings) -> Run:
    """Read a session's folder, a run file, a legacy file, or a record of a standing unit.

    Raises
    ------
    FormatError, FitError
        It is none of them.
    """
    if path.is_dir() or path.name == START_NAME:
        return read_any(path, sensor="accelerometer")
    try:
        with path.open("rb") as file:
            head = file.read(_HEAD).decode("utf-8-sig", errors="replace")
    except OSError as error:
        raise FormatError(path, f"cannot be read: {error.strerror}") from error
    if is_run_file(head):
        return read_any(path)
    try:
        return read_any(path, sensor="accelerometer")
    except FormatError as no_positions:
        names = [name.strip() for name in settings.outputs.split(",") if name.strip()]
        try:
            return record_run(read_series(path), names)
        except (FormatError, FitError) as no_record:
            raise (no_positions if path.suffix == ".txt" else no_record) from no_record


def simulated() -> Run:
    """The simulated triad through the packaged cycle."""
    return simulated_cycle(load_plans()["thermal_8"], _SEED)


def sources_of(paths: Sequence[Path]) -> list[Path]:
    """What is meant: a session, or all sessions and files of a folder, by name."""
    found: list[Path] = []
    for path in paths:
        if not path.is_dir() or (path / START_NAME).is_file():
            found.append(path)
            continue
        inside = sorted(path.iterdir())
        found += [one for one in inside if (one / START_NAME).is_file()]
        found += [one for one in inside if one.is_file() and one.suffix.lower() in SUFFIXES]
    return found


def newest_cycle(root: Path) -> Path | None:
    """The newest session with temperatures under the folder of all sessions; None without one."""
    for start in sorted(root.glob(f"*/{START_NAME}"), reverse=True):
        try:
            record = read_session(start.parent)
        except FormatError:
            # A damaged session has its own message where it is opened.
            continue
        if record.start.plan.test == "dividing_head" and record.start.plan.temperatures_c:
            return start.parent
    return None


def computed(runs: Sequence[Run], checks: Sequence[Run], settings: Settings) -> Outcome:
    """Fit what the list holds.

    Raises
    ------
    FitError
        The runs do not belong together, or determine nothing.
    """
    records = [run for run in runs if run.test == RECORD]
    if not records:
        return _cycle(joined(runs), checks, settings)
    if len(runs) > 1:
        raise FitError(
            "a record of a standing unit is taken by itself: remove the others from the list"
        )
    order = None if settings.bias_order == FOUND else settings.bias_order
    return RecordOutcome(records[0], fit_record(records[0], order=order))


def _cycle(run: Run, checks: Sequence[Run], settings: Settings) -> CycleOutcome:
    conditions = run.conditions
    assumed = not np.isfinite(conditions.g_mps2)
    if assumed:
        conditions = replace(conditions, g_mps2=settings.g_mps2)
    thermal, why = None, ""
    try:
        thermal = calibrate_thermal(
            run,
            conditions,
            bias_order=None if settings.bias_order == FOUND else settings.bias_order,
            scale_order=None if settings.scale_order == FOUND else settings.scale_order,
            reference_c=settings.reference_c,
        )
    except FitError as error:
        why = str(error)
    splits = splits_of(run, conditions)
    if thermal is None and not splits:
        raise FitError(why)
    tilt, why_no_tilt = None, ""
    if thermal is not None:
        try:
            tilt = _tilt(run, checks, thermal, conditions)
        except FitError as error:
            why_no_tilt = str(error)
    return CycleOutcome(run, conditions, assumed, thermal, why, splits, tilt, why_no_tilt)


def _tilt(
    run: Run, checks: Sequence[Run], thermal: ThermalCalibration, conditions: Conditions
) -> TiltTable:
    first = plateaus_of(run.temperature_c, run.order)[0]
    alone = calibrate(run.rows(first.rows), conditions).triad()
    if checks:
        other = joined(checks)
        every = np.ones(len(other), dtype=np.bool_)
        before = tilt_errors(other, alone, conditions)
        return TiltTable(before, tilt_errors(other, thermal, conditions), every, True)
    after, unseen = tilt_left_out(run, thermal, conditions)
    return TiltTable(tilt_errors(run, alone, conditions), after, unseen, False)
