"""Where the angles of an accuracy check come from: raw codes, or the unit itself."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.model.effect import AXES
from core.procedures.angle_errors import PITCH, ROLL, direction
from core.procedures.attitude import attitude
from core.procedures.calibration import Calibration
from core.samples.run import Run

OWN, INTER, MAGS, ALIGNED = "own", "inter", "mags_accels", "aligned"
PLANE = "plane"
_COLUMNS = {INTER: "unit", MAGS: "mag"}
"""Start of the names of a reporting source's columns: ``unit_pitch_deg``, ``mag_roll_deg``."""
_DECIMALS = 4


@dataclass(frozen=True, slots=True, eq=False)
class Source:
    """Angles of one source.

    Parameters
    ----------
    id : `OWN`, `INTER` or `MAGS`
    force : (n, 3) direction of the specific force; m/s^2 for `OWN`
    pitch, roll, heading : (n,) deg; NaN where undefined or not there
    u_mean : (n,) standard uncertainty of pitch, roll and in-plane angle, without that of the
        calibration: noise of the mean, resolution
    noise : (n,) standard deviation of single samples of the same; NaN where it was not kept
    """

    id: str
    force: FloatArray
    pitch: FloatArray
    roll: FloatArray
    heading: FloatArray
    u_mean: Mapping[str, FloatArray]
    noise: Mapping[str, FloatArray]


@dataclass(frozen=True, slots=True, eq=False)
class Codes:
    """Raw codes of the accelerometers, in the order X, Y, Z.

    Parameters
    ----------
    mean, se, std : (n, 3) means, their standard errors, deviation of single samples; NaN if unknown
    """

    mean: FloatArray
    se: FloatArray
    std: FloatArray


def codes_of(run: Run) -> Codes | None:
    """Codes of the accelerometers, as outputs of the run or beside them; None without."""
    unknown = np.full((len(run), 3), np.nan)
    std = np.column_stack([run.extra.get(f"std_acc_{axis}", unknown[:, 0]) for axis in AXES])
    if run.sensor == "accelerometer" and sorted(run.axes) == list(AXES):
        order = [run.axes.index(axis) for axis in AXES]
        return Codes(run.y[:, order], run.y_se[:, order], std)
    columns = [run.extra.get(f"acc_{axis}") for axis in AXES]
    found = [column for column in columns if column is not None]
    if len(found) < len(AXES):
        return None
    return Codes(np.column_stack(found), unknown, std)


def own_source(codes: Codes, calibration: Calibration, unit: str) -> tuple[Source, FloatArray]:
    """Angles by a calibration, and the covariance (n, 3, 3) that it brings itself.

    Raises
    ------
    FitError
        The calibration is for outputs in another unit, or of no triad of accelerometers.
    """
    if calibration.sensor != "accelerometer":
        raise FitError("angles need a calibration of the accelerometers, this one is of gyros")
    if calibration.unit != unit:
        raise FitError(f"the calibration takes {calibration.unit}, the codes are in {unit}")
    triad = calibration.triad()
    force = triad.calibrated(codes.mean)
    of_calibration = triad.calibrated_covariance(codes.mean, np.zeros_like(codes.mean))
    q = triad.q

    def through(deviation: FloatArray) -> dict[str, FloatArray]:
        return angle_uncertainty(force, np.einsum("ij,nj,kj->nik", q, deviation**2, q))

    found = attitude(force, of_calibration)
    source = Source(
        id=OWN,
        force=force,
        pitch=found.pitch,
        roll=found.roll,
        heading=np.full(len(force), np.nan),
        u_mean=through(np.nan_to_num(codes.se)),
        noise=through(codes.std),
    )
    return source, of_calibration


def angle_uncertainty(force: FloatArray, covariance: FloatArray) -> dict[str, FloatArray]:
    """Standard uncertainty (n,) of pitch, roll and in-plane angle, deg."""
    found = attitude(force, covariance)
    return {PITCH: found.u_pitch, ROLL: found.u_roll, PLANE: found.u_plane}


def reported_sources(run: Run) -> list[Source]:
    """Angles that the unit computed itself, as far as the run holds them."""
    sources: list[Source] = []
    for identifier, stem in _COLUMNS.items():
        pitch, roll = run.extra.get(f"{stem}_pitch_deg"), run.extra.get(f"{stem}_roll_deg")
        if pitch is None or roll is None:
            continue
        unknown = np.full(len(run), np.nan)
        names = {PITCH: PITCH, ROLL: ROLL, PLANE: PITCH}
        step = {PITCH: _resolution(pitch), ROLL: _resolution(roll)}
        known = {of: run.extra.get(f"se_{stem}_{of}_deg", unknown) for of in (PITCH, ROLL)}
        u_mean = {
            name: np.hypot(step[of] / np.sqrt(12.0), np.nan_to_num(known[of]))
            for name, of in names.items()
        }
        noise = {name: run.extra.get(f"std_{stem}_{of}_deg", unknown) for name, of in names.items()}
        sources.append(
            Source(
                id=identifier,
                force=direction(pitch, roll),
                pitch=pitch,
                roll=roll,
                heading=run.extra.get(
                    f"{stem}_heading_deg", run.extra.get(f"{stem}_yaw_deg", unknown)
                ),
                u_mean=u_mean,
                noise=noise,
            )
        )
    return sources


def _resolution(angles: FloatArray) -> float:
    """The decimal step that all of these angles are multiples of; 0 where there is none."""
    for decimals in range(_DECIMALS + 1):
        step = 10.0**-decimals
        if np.allclose(angles / step, np.round(angles / step), rtol=0.0, atol=1e-6):
            return step
    return 0.0
