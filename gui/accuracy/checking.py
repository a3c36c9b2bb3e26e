"""From measurements to a judged accuracy check; runs in a worker thread."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

import numpy as np

from core.errors import FitError, LabError, Note, Severity
from core.procedures.accuracy import Accuracy, Limit, check_accuracy
from core.procedures.calibration import Calibration
from core.records.open import read_any
from core.records.open_calibration import nearest_calibration, open_calibration
from core.samples.run import Conditions, Run

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
    angles_deg : set angles of the rows; None where the data tell them
    kind : pitch or roll; None where the data tell it
    """

    conditions: Conditions
    calibration: str
    root: Path
    limit: Limit | None = None
    angles_deg: tuple[float, ...] | None = None
    kind: str | None = None


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
    path = (
        nearest_calibration(request.root, run.device, _measured(run))
        if request.calibration == NEAREST
        else Path(request.calibration)
    )
    if path is None:
        return None, "", ()
    conditions: Callable[[Conditions], Conditions] = lambda _: request.conditions  # noqa: E731
    try:
        found = open_calibration(path, conditions)
        found.triad()
    except LabError as error:
        note = Note(Severity.WARNING, "calibration_refused", f"{path.name} is not used: {error}")
        return None, "", (note,)
    name = path.parent.name if request.calibration == NEAREST else path.name
    return found, name, ()


def _measured(run: Run) -> datetime | None:
    told = run.meta.get("measured_utc") or run.meta.get("start_local")
    try:
        return datetime.fromisoformat(str(told)) if told else None
    except ValueError:
        return None
