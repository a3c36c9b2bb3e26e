"""Doubts about an accuracy check, in plain words."""

import numpy as np

from core.arrays import FloatArray
from core.errors import Note, Severity
from core.fit.lack import REJECTED
from core.fit.quantiles import chi2_sf, f_sf, student_t
from core.procedures.angle_errors import wrapped
from core.procedures.calibration import Calibration
from core.samples.run import Conditions
from core.units import MILLI

_FAR_DEG = 5.0
_SURE = 0.999


def no_codes(device: str) -> Note:
    """The unit reports angles and nothing else."""
    return Note(
        Severity.INFO,
        "no_raw_codes",
        f"{device} sends angles but no raw codes of its accelerometers: only its own angles are"
        " judged, none by a calibration",
    )


def no_calibration() -> Note:
    """Raw codes without a calibration."""
    return Note(
        Severity.INFO,
        "no_calibration",
        "no calibration was chosen: only the unit's own angles are judged; calibrate it on the head"
        " to judge the raw codes",
    )


def head_note() -> Note:
    """A verdict without the uncertainty of the reference."""
    return Note(
        Severity.WARNING,
        "head_u_missing",
        "the uncertainty of a head setting was not stated: the verdict counts noise and resolution"
        " only",
    )


def mount_notes(set_deg: FloatArray, angle: FloatArray) -> list[Note]:
    """Angles that follow the set ones backwards, or not at all."""
    error, back = _rms(angle - set_deg), _rms(angle + set_deg)
    if error < _FAR_DEG:
        return []
    if back < _FAR_DEG:
        text = (
            f"the angles follow the set ones with the opposite sign ({error:.0f} deg off as they"
            f" are, {back:.2g} deg with the sign turned): the unit is mounted the other way round,"
            " or the head was turned the other way"
        )
        return [Note(Severity.ERROR, "sign_reversed", text)]
    text = (
        f"the angles are {error:.0f} deg off the set ones: another list of angles, pitch taken for"
        " roll, or another mount?"
    )
    return [Note(Severity.ERROR, "wrong_angles", text)]


def calibration_notes(
    device: str,
    calibration: Calibration,
    force: FloatArray,
    covariance: FloatArray,
    conditions: Conditions,
    error: FloatArray,
    u_error: FloatArray,
) -> list[Note]:
    """Whether the calibration still holds for this unit.

    Parameters
    ----------
    device : name of the unit that was checked
    calibration : the calibration
    force, covariance : (n, 3) specific force by it and (n, 3, 3) what it does not know of it
    conditions : g with its uncertainty
    error, u_error : (n,) errors of the angle and all that is known of their uncertainty
    """
    notes: list[Note] = []
    name = calibration.provenance.device
    if name and name.strip() != device.strip():
        text = f"the calibration is of {name!r}, the angles were measured on {device!r}"
        notes.append(Note(Severity.WARNING, "other_unit", text))
    length = np.linalg.norm(force, axis=1)
    along = force / length[:, None]
    u = np.sqrt(np.einsum("ni,nij,nj->n", along, covariance, along))
    u = np.hypot(u, np.nan_to_num(conditions.u_g_mps2))
    off = length - conditions.g_mps2
    place = int(np.argmax(np.abs(off) / u))
    dof = float(calibration.triad().t_dof.min())
    if abs(off[place]) > student_t(_SURE, dof) * u[place]:
        in_mg = off[place] / conditions.g_mps2 / MILLI
        text = (
            f"row {place + 1}: the specific force is {in_mg:+.2f} mg from g"
            f" (u = {u[place] / conditions.g_mps2 / MILLI:.2g} mg): the sensors are no longer what"
            " they were when calibrated; another temperature or another day?"
        )
        notes.append(Note(Severity.WARNING, "force_differs", text))
    known = u_error > 0
    if known.any():
        chi2 = float(np.sum((error[known] / u_error[known]) ** 2))
        mean = chi2 / int(known.sum())
        p_value = chi2_sf(chi2, known.sum()) if np.isinf(dof) else f_sf(mean, known.sum(), dof)
        if p_value < REJECTED:
            times = np.sqrt(mean)
            text = (
                f"the errors by the calibration are {times:.1f} times larger than its uncertainty"
                f" and that of the head allow (p = {p_value:.2g}): the unit has changed, or it sits"
                " askew on the head (see the aligned errors)"
            )
            notes.append(Note(Severity.WARNING, "calibration_exceeded", text))
    return notes


def _rms(difference: FloatArray) -> float:
    return float(np.sqrt(np.mean(wrapped(difference) ** 2)))
