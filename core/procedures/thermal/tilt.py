"""Errors of roll and pitch, before and after compensation: the table of source 002."""

from collections.abc import Callable
from dataclasses import dataclass, fields

import numpy as np

from core.arrays import BoolArray, FloatArray, frozen
from core.model.effect import AXES
from core.model.stimulus import stimulus_of
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.attitude import attitude
from core.procedures.thermal.cycle import ThermalCalibration, calibrate_thermal
from core.procedures.thermal.plateaus import plateaus_of
from core.procedures.triad import Triad
from core.samples.run import Conditions, Run


@dataclass(frozen=True, slots=True, eq=False)
class TiltErrors:
    """Roll and pitch by the calibrated sensors less those that were set.

    Parameters
    ----------
    roll_deg, pitch_deg : (n,) set; roll is NaN where the Y axis is vertical
    roll_error_deg, pitch_error_deg : (n,) found less set
    u_roll_deg, u_pitch_deg : (n,) standard uncertainties of what was found
    temperature_c : (n,)
    """

    roll_deg: FloatArray
    pitch_deg: FloatArray
    roll_error_deg: FloatArray
    pitch_error_deg: FloatArray
    u_roll_deg: FloatArray
    u_pitch_deg: FloatArray
    temperature_c: FloatArray

    @property
    def worst_deg(self) -> float:
        """Largest error of either angle."""
        return float(np.nanmax(np.abs([self.roll_error_deg, self.pitch_error_deg])))


def tilt_errors(
    run: Run,
    calibration: Triad | ThermalCalibration,
    conditions: Conditions,
    base: BaseOrientation = LEVEL,
) -> TiltErrors:
    """Compare the attitude that three accelerometers find with the one that was set.

    Parameters
    ----------
    run : rows of a triad on the dividing head
    calibration : a `Triad` of one temperature for all rows (before compensation), or over
        temperature (after)
    conditions : g
    base : how the head's base plate stands

    Raises
    ------
    FitError
        A row's temperature was not measured in the calibration, or the sensors are no triad.
    """
    order = [run.axes.index(axis) for axis in AXES]
    y, se = run.y[:, order], np.nan_to_num(run.y_se[:, order])
    triad_of_row = _triads(run, calibration)
    found: list[FloatArray] = []
    for row in range(len(run)):
        triad = triad_of_row(row)
        a = triad.calibrated(y[[row]])
        angles = attitude(a, triad.calibrated_covariance(y[[row]], se[[row]]))
        found.append(np.concatenate([angles.roll, angles.pitch, angles.u_roll, angles.u_pitch]))
    roll, pitch, u_roll, u_pitch = np.array(found).T
    true = stimulus_of(run, conditions.g_mps2, base=base).a
    was_set = attitude(true, np.broadcast_to(1e-12 * np.eye(3), (len(run), 3, 3)))
    return TiltErrors(
        roll_deg=frozen(was_set.roll),
        pitch_deg=frozen(was_set.pitch),
        roll_error_deg=frozen((roll - was_set.roll + 180.0) % 360.0 - 180.0),
        pitch_error_deg=frozen(pitch - was_set.pitch),
        u_roll_deg=frozen(u_roll),
        u_pitch_deg=frozen(u_pitch),
        temperature_c=frozen(run.temperature_c),
    )


def tilt_left_out(
    run: Run,
    calibration: ThermalCalibration,
    conditions: Conditions,
    base: BaseOrientation = LEVEL,
) -> tuple[TiltErrors, BoolArray]:
    """Errors of roll and pitch where each inner temperature is corrected by the others.

    Parameters
    ----------
    run : that `calibration` was made from

    Returns
    -------
    errors : (n,) of all rows
    unseen : (n,) rows whose temperature was left out of what corrects them; the outermost
        temperatures are not, since nothing may be extrapolated

    Raises
    ------
    FitError
        The sensors are no triad.
    """
    plateaus = plateaus_of(run.temperature_c, run.order)
    level = np.zeros(len(run), dtype=np.int64)
    for plateau in plateaus:
        level[plateau.rows] = plateau.level
    parts = [np.isin(level, [0, level.max()])]
    found = [tilt_errors(run.rows(np.flatnonzero(parts[0])), calibration, conditions, base)]
    for at in range(1, int(level.max())):
        held = level == at
        others = run.rows(np.flatnonzero(~held))
        by_them = calibrate_thermal(
            others, conditions, base=base, reference_c=calibration.reference_c
        )
        parts.append(held)
        found.append(tilt_errors(run.rows(np.flatnonzero(held)), by_them, conditions, base))
    rows = np.concatenate([np.flatnonzero(part) for part in parts])
    back = np.argsort(rows)
    columns = {
        item.name: frozen(np.concatenate([getattr(one, item.name) for one in found])[back])
        for item in fields(TiltErrors)
    }
    return TiltErrors(**columns), ~parts[0]


def _triads(run: Run, calibration: Triad | ThermalCalibration) -> Callable[[int], Triad]:
    if isinstance(calibration, Triad):
        return lambda _row: calibration
    return lambda row: calibration.triad_at(float(run.temperature_c[row]))
