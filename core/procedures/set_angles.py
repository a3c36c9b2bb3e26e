"""Which angles were set: from mount and head angle, from the operator, or from the practicum."""

from collections.abc import Sequence

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note, Severity
from core.plans.orientation import Mount, specific_force
from core.plans.plan import load_plans
from core.procedures.angle_errors import PITCH, ROLL, main_angle, wrapped
from core.samples.run import Run

_KINDS = {"X": PITCH, "Y": ROLL}
_PLAN = "pitch_accuracy"
_DECIMALS = 9


def set_angles(
    run: Run, kind: str | None, angles_deg: Sequence[float] | None, force: FloatArray
) -> tuple[str, FloatArray, tuple[Note, ...]]:
    """Return what was set: `PITCH` or `ROLL`, the angles (n,), and what had to be inferred.

    Parameters
    ----------
    run : rows with mount and head angle, or legacy rows with a number in their list of angles
    kind : `PITCH` or `ROLL`, None where the run must tell
    angles_deg : (n,) set angles, None where the run must tell
    force : (n, 3) measured specific force, which tells pitch from roll if nothing else does

    Raises
    ------
    FitError
        The angles or their kind are unknown, or there are more or fewer than rows.
    """
    if angles_deg is not None:
        if len(angles_deg) != len(run):
            raise FitError(f"{len(angles_deg)} set angles were given for {len(run)} rows")
        angles = np.array(angles_deg, dtype=np.float64)
        return _kind_of(run, kind) or _follows(angles, force), wrapped(angles), ()
    if np.all(np.isfinite(run.head_deg)) and all(run.mount):
        kind = _kind_of(run, kind)
        if kind is None:
            raise FitError("pitch is set with X along the shaft, roll with Y; this run has neither")
        return kind, _by_head(run, kind), ()
    angles = _by_number(run)
    kind = kind or _follows(angles, force)
    first = ", ".join(f"{angle % 360.0:g}" for angle in angles[:4])
    text = (
        f"the file does not hold the set angles; its rows were taken as {kind} {first}, ... of the"
        " practicum's list Angles"
    )
    return kind, angles, (Note(Severity.INFO, "angles_inferred", text),)


def _kind_of(run: Run, kind: str | None) -> str | None:
    if kind is not None:
        return kind
    axes = {Mount.parse(mount).axis for mount in run.mount if mount}
    return _KINDS.get(axes.pop()) if len(axes) == 1 else None


def _by_head(run: Run, kind: str) -> FloatArray:
    force = np.array(
        [
            specific_force(mount, float(angle), 1.0)
            for mount, angle in zip(run.mount, run.head_deg, strict=True)
        ]
    )
    return _angles(kind, force)


def _by_number(run: Run) -> FloatArray:
    numbers = run.extra.get("step")
    steps = {step.number: step for step in load_plans()[_PLAN].steps}
    if numbers is None or not all(int(number) in steps for number in numbers):
        raise FitError("the run does not hold the set angles; give them, e.g. 0,30,60")
    force = np.array([steps[int(number)].specific_force(1.0) for number in numbers])
    return _angles(PITCH, force)


def _angles(kind: str, force: FloatArray) -> FloatArray:
    """Set angles (n,) without the rounding of their sines."""
    return wrapped(np.round(main_angle(kind, force, full_turn=True), _DECIMALS))


def _follows(angles: FloatArray, force: FloatArray) -> str:
    """Whether pitch or roll follows the set angles more closely."""

    def rms(kind: str) -> float:
        error = wrapped(main_angle(kind, force, full_turn=True) - angles)
        return float(np.sqrt(np.mean(error**2)))

    return min((PITCH, ROLL), key=rms)
