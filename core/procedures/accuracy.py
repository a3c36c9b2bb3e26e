"""Accuracy of pitch and roll against set angles: the unit's own answers and the calibration's.

Tables 2.5 and 2.6 of the practicum: the same rows give the angles that the unit computed itself
(Inter), those it computed from accelerometers and magnetometers (Mags/Accels), and those that a
chosen calibration makes of the raw codes. A unit that sends no raw codes is judged by its own
angles alone, and the result says so.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note
from core.fit.quantiles import student_t
from core.procedures.accuracy_notes import (
    calibration_notes,
    head_note,
    mount_notes,
    no_calibration,
    no_codes,
)
from core.procedures.accuracy_sources import (
    ALIGNED,
    INTER,
    MAGS,
    OWN,
    PLANE,
    Source,
    angle_uncertainty,
    codes_of,
    own_source,
    reported_sources,
)
from core.procedures.angle_errors import (
    ROLL,
    Statistics,
    aligned,
    cross_error,
    heading_error,
    is_full_turn,
    main_angle,
    wrapped,
)
from core.procedures.calibration import Calibration
from core.procedures.conformity import RULES, Rule, Verdict, judge, worst
from core.procedures.set_angles import set_angles
from core.samples.run import Conditions, Run
from core.units import ARCSEC_PER_DEG

TITLES = {
    OWN: "Calibration",
    INTER: "Inter",
    MAGS: "Mags/Accels",
    ALIGNED: "Tilter axes aligned",
}
"""Sources by the names that operators know."""


@dataclass(frozen=True, slots=True)
class Limit:
    """What the angle must keep.

    Parameters
    ----------
    error_deg : largest allowed error
    rule : how the measurement uncertainty counts
    """

    error_deg: float
    rule: Rule = RULES["guarded"]


@dataclass(frozen=True, slots=True, eq=False)
class Trace:
    """Errors of one source.

    Parameters
    ----------
    source : key of `TITLES`
    pitch, roll, heading : (n,) as the source gives them, deg; NaN where undefined or not there
    angle : (n,) what is compared: pitch, in-plane angle of a full turn, or roll
    error : (n,) angle less set angle
    cross_error, heading_error : (n,) of the other angle, and of the heading against the first row
    u_error : (n,) standard uncertainty of the error: head, resolution, noise of the mean
    statistics : of `error`
    verdicts : (n,) by row; empty without a limit
    """

    source: str
    pitch: FloatArray
    roll: FloatArray
    heading: FloatArray
    angle: FloatArray
    error: FloatArray
    cross_error: FloatArray
    heading_error: FloatArray
    u_error: FloatArray
    statistics: Statistics
    verdicts: tuple[Verdict, ...]

    @property
    def verdict(self) -> Verdict | None:
        """The verdict on the source; None without a limit."""
        return worst(self.verdicts) if self.verdicts else None


@dataclass(frozen=True, slots=True, eq=False)
class Accuracy:
    """An accuracy check of one unit.

    Parameters
    ----------
    device : its name
    kind : `PITCH` or `ROLL`
    full_turn : whether pitch is compared by the in-plane angle
    set_deg : (n,) set angles
    codes, force : (n, 3) raw codes and calibrated specific force, m/s^2; (n, 0) without
    force_error : (n,) length of the specific force less g, m/s^2; NaN without
    u_calibration : (n,) what the calibration's own uncertainty does to the angle, deg; NaN without
    traces : in the order of `TITLES`
    temperature_c : (n,)
    limit : None where none was stated
    notes : doubts
    """

    device: str
    kind: str
    full_turn: bool
    set_deg: FloatArray
    codes: FloatArray
    force: FloatArray
    force_error: FloatArray
    u_calibration: FloatArray
    traces: tuple[Trace, ...]
    temperature_c: FloatArray
    limit: Limit | None
    notes: tuple[Note, ...]

    def trace(self, source: str) -> Trace:
        """Return the trace of a source.

        Raises
        ------
        KeyError
            The data have none.
        """
        for trace in self.traces:
            if trace.source == source:
                return trace
        raise KeyError(source)


def check_accuracy(
    run: Run,
    conditions: Conditions,
    *,
    calibration: Calibration | None = None,
    kind: str | None = None,
    angles_deg: Sequence[float] | None = None,
    limit: Limit | None = None,
) -> Accuracy:
    """Compare the angles of a run with the set ones.

    Parameters
    ----------
    run : a run of the test ``"accuracy"``
    conditions : g, u of a head setting
    calibration : makes angles of the raw codes; None for the unit's own angles alone
    kind : `PITCH` or `ROLL`; None to take it from the mount, or from what follows the set angles
    angles_deg : (n,) set angles where the run does not hold them; None for the practicum's list
    limit : the largest allowed error, None for no verdict

    Raises
    ------
    FitError
        There are neither raw codes with a calibration nor angles, or the set angles are unknown.
    """
    if not len(run):
        raise FitError("the run holds no rows")
    codes = codes_of(run)
    notes = [*run.notes]
    own: Source | None = None
    of_calibration: FloatArray | None = None
    if codes is None:
        notes.append(no_codes(run.device))
    elif calibration is None:
        notes.append(no_calibration())
    else:
        own, of_calibration = own_source(codes, calibration, run.unit)
    sources = [*([own] if own else []), *reported_sources(run)]
    if not sources:
        raise FitError(
            f"{run.device}: there are neither angles of the unit nor raw codes with a calibration"
        )
    kind, set_deg, told = set_angles(run, kind, angles_deg, sources[0].force)
    notes.extend(told)
    full_turn = is_full_turn(kind, set_deg)
    rig = _Rig(kind, set_deg, full_turn, conditions.head_u_arcsec / ARCSEC_PER_DEG, limit)
    traces = [rig.trace(source) for source in sources]
    notes.extend(mount_notes(set_deg, traces[0].angle))
    if np.linalg.matrix_rank(sources[0].force, tol=1e-3 * np.linalg.norm(sources[0].force)) > 1:
        traces.append(rig.trace(_aligned(rig, sources[0])))
    if limit is not None and not conditions.head_u_arcsec > 0:
        notes.append(head_note())
    unknown = np.full(len(run), np.nan)
    force_error, u_calibration = unknown, unknown
    if own is not None and of_calibration is not None and calibration is not None:
        force_error = np.linalg.norm(own.force, axis=1) - conditions.g_mps2
        u_calibration = angle_uncertainty(own.force, of_calibration)[rig.compared]
        u_total = np.hypot(u_calibration, traces[0].u_error)
        notes.extend(
            calibration_notes(
                run.device,
                calibration,
                own.force,
                of_calibration,
                conditions,
                traces[0].error,
                u_total,
            )
        )
    return Accuracy(
        device=run.device,
        kind=kind,
        full_turn=full_turn,
        set_deg=frozen(set_deg),
        codes=frozen(np.empty((len(run), 0)) if codes is None else codes.mean),
        force=frozen(np.empty((len(run), 0)) if own is None else own.force),
        force_error=frozen(force_error),
        u_calibration=frozen(u_calibration),
        traces=tuple(traces),
        temperature_c=run.temperature_c,
        limit=limit,
        notes=tuple(notes),
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Rig:
    """What the sources are compared with."""

    kind: str
    set_deg: FloatArray
    full_turn: bool
    u_head_deg: float
    limit: Limit | None

    @property
    def compared(self) -> str:
        """Which angle is compared: `PITCH`, `PLANE` or `ROLL`."""
        return PLANE if self.full_turn else self.kind

    def trace(self, source: Source) -> Trace:
        """The errors of one source."""
        angle = main_angle(self.kind, source.force, full_turn=self.full_turn)
        error = wrapped(angle - self.set_deg)
        u = np.hypot(np.nan_to_num(source.u_mean[self.compared]), np.nan_to_num(self.u_head_deg))
        verdicts: tuple[Verdict, ...] = ()
        if self.limit is not None:
            factor = student_t(0.95, float("inf"))
            verdicts = tuple(
                judge(float(e), factor * float(one), self.limit.error_deg, self.limit.rule)
                for e, one in zip(error, u, strict=True)
            )
        return Trace(
            source=source.id,
            pitch=frozen(source.pitch),
            roll=frozen(source.roll),
            heading=frozen(source.heading),
            angle=frozen(angle),
            error=frozen(error),
            cross_error=frozen(cross_error(self.kind, self.set_deg, source.force)),
            heading_error=frozen(heading_error(self.kind, self.set_deg, source.heading)),
            u_error=frozen(u),
            statistics=Statistics.of(error, source.noise[self.compared]),
            verdicts=verdicts,
        )


def _aligned(rig: _Rig, source: Source) -> Source:
    """The same source with the mounting of the unit on the head taken out."""
    force = aligned(rig.kind, rig.set_deg, source.force)
    return Source(
        id=ALIGNED,
        force=force,
        pitch=main_angle("pitch", force, full_turn=False),
        roll=main_angle(ROLL, force, full_turn=False),
        heading=source.heading,
        u_mean=source.u_mean,
        noise=source.noise,
    )
