"""From measurements to a judged accuracy check; runs in a worker thread."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from core.archive.nearest import Usable
from core.errors import FitError, FormatError, LabError, Note, Severity
from core.procedures.accuracy import Accuracy, Limit, check_accuracy
from core.procedures.calibration import Calibration
from core.records.calibration_json import read_calibration
from core.records.open import read_any
from core.records.open_calibration import nearest_calibration, open_calibration
from core.samples.run import Conditions, Run
from gui.services import Nearest

NEAREST, NONE = "nearest", "none"
"""Choices of a calibration that are no file."""
_STATED = ("g_mps2", "u_g_mps2", "head_u_arcsec")


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """What the operator decided.

    Parameters
    ----------
    conditions : g, uncertainty of the head
    calibration : `NEAREST`, `NONE`, or a file
    root : folder of all sessions
    limit : None for no verdict
    near : returns the calibrations of the archive nearest to a moment and a temperature; None to
        look into the folders of `root` alone
    angles_deg : set angles of the rows; None where the data tell them
    kind : pitch or roll; None where the data tell it
    """

    conditions: Conditions
    calibration: str
    root: Path
    limit: Limit | None = None
    angles_deg: tuple[float, ...] | None = None
    kind: str | None = None
    near: Nearest | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Checked:
    """A judged check.

    Parameters
    ----------
    found, run : the check and what was measured
    source : session or file
    calibration : where the calibration comes from; empty for none
    request : what it was made by
    """

    found: Accuracy
    run: Run
    source: str
    calibration: str
    request: CheckRequest

    @property
    def wants_calibration(self) -> bool:
        """Whether there are raw codes that only lack a calibration to be judged too."""
        return not self.calibration and self.found.codes.shape[1] > 0


def check_file(path: Path, device: str | None, request: CheckRequest) -> Checked:
    """Read a session, a run file or a legacy file and judge it.

    What the file states of its conditions counts before what is on the screen.

    Raises
    ------
    FormatError, FitError
        The file is refused, or holds another test.
    """
    run = read_any(path, device=device)
    if run.test != "accuracy":
        raise FitError(f"{path.name} holds the test {run.test!r}, no accuracy check")
    told = {name: getattr(run.conditions, name) for name in _STATED}
    stated = {name: value for name, value in told.items() if np.isfinite(value)}
    conditions = replace(request.conditions, **stated)
    return check_run(run, path.name, replace(request, conditions=conditions))


def check_run(run: Run, source: str, request: CheckRequest) -> Checked:
    """Judge a run.

    Raises
    ------
    FitError
        There is nothing to judge, or the set angles are unknown.
    """
    calibration, name, notes = _calibration(run, request)
    found = check_accuracy(
        run,
        request.conditions,
        calibration=calibration,
        kind=request.kind,
        angles_deg=request.angles_deg,
        limit=request.limit,
    )
    found = replace(found, notes=(*notes, *found.notes))
    return Checked(found, run, source, name, request)


def _calibration(
    run: Run, request: CheckRequest
) -> tuple[Calibration | None, str, tuple[Note, ...]]:
    """The calibration, where it comes from, and why there is none."""
    if request.calibration == NONE:
        return None, "", ()
    path: Path | None = Path(request.calibration)
    name, doubts = Path(request.calibration).name, tuple[Note, ...]()
    if request.calibration == NEAREST:
        path, name, doubts = _nearest(run, request)
    if path is None:
        return None, "", doubts
    conditions: Callable[[Conditions], Conditions] = lambda _: request.conditions  # noqa: E731
    try:
        found = open_calibration(path, conditions)
        found.triad()
    except LabError as error:
        note = Note(Severity.WARNING, "calibration_refused", f"{path.name} is not used: {error}")
        return None, "", (note,)
    return found, name, doubts


def _nearest(run: Run, request: CheckRequest) -> tuple[Path | None, str, tuple[Note, ...]]:
    """The triad's calibration nearest by date and temperature, its name, and doubts."""
    doubts: tuple[Note, ...] = ()
    if request.near is not None:
        try:
            for one in near_of(run, request.near):
                if is_triad(one.path):
                    return one.path, f"{one.path.parent.name} ({one.words})", ()
        except LabError as error:
            words = f"the archive was not asked for the nearest calibration: {error}"
            doubts = (Note(Severity.WARNING, "archive_not_asked", words),)
    path = nearest_calibration(request.root, run.device, _measured(run))
    return path, "" if path is None else path.parent.name, doubts


def near_of(run: Run, near: Nearest) -> tuple[Usable, ...]:
    """Calibrations of a run's unit, the nearest first; raises `LabError`."""
    known = run.temperature_c[np.isfinite(run.temperature_c)]
    warmth = float(known.mean()) if known.size else float("nan")
    when = _measured(run) or datetime.now(UTC)
    return near(run.device, when.astimezone(), warmth, "accelerometer")


def is_triad(path: Path) -> bool:
    """Whether a calibration's file can be read and holds three sensors with all cross axes."""
    try:
        return read_calibration(path).is_triad
    except FormatError:
        return False


def _measured(run: Run) -> datetime | None:
    told = run.meta.get("measured_utc") or run.meta.get("start_local")
    try:
        return datetime.fromisoformat(str(told)) if told else None
    except ValueError:
        return None
