"""Heading from the Earth's rotation, by one gyro turned on a level base (source 000, conclusions).

The input axis at azimuth psi + delta and elevation eps feels, in deg/h::

    w = W cos(lat) cos(eps) cos(psi + delta) + W sin(lat) sin(eps) + d

delta is what the base reads, clockwise from above. With A = W cos(lat) cos(psi) and B = W
cos(lat) sin(psi) this is linear in A, B and the drift d, so any three headings or more give all
three: the heading needs neither the scale factor nor, on a level base, the latitude. The length of
(A, B) is then a check of both.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note, RankDeficient, Severity
from core.fit.estimate import Estimate, parameter
from core.fit.linear import Rows, fit_sensor
from core.fit.result import FitResult
from core.model.effect import Effect, Parameter, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.procedures.earth import level_dps, vertical_dps
from core.procedures.propagation import Spread, draws_of
from core.samples.run import Conditions, Run
from core.units import ARCMIN_PER_DEG, DEG_PER_RAD, DPH_PER_DPS, RAD_PER_DEG

UNITS_DPH = {"deg/h": 1.0, "deg/s": DPH_PER_DPS, "rad/s": DEG_PER_RAD * DPH_PER_DPS}
"""deg/h in one unit of the output."""
_POLE_DEG = 89.5
_SEEN = 3.0
_UNLIKE = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class Gyrocompass:
    """Heading and drift.

    Parameters
    ----------
    heading : azimuth of the input axis at reading 0 of the base, deg, 0 ... 360 from true north
        clockwise; its interval may leave this range rather than break
    drift : systematic drift of the gyro, deg/h
    level : level part of the Earth's rate as measured, deg/h
    expected_dph : the same by the latitude; NaN where none was stated
    fit : `north`, `east`, `drift` (`ramp`), deg/h
    notes : every doubt
    """

    heading: Spread
    drift: Estimate
    level: Estimate
    expected_dph: float
    fit: FitResult
    notes: tuple[Note, ...]


class EarthTurn(Effect):
    """Level part of the Earth's rate on a turning input axis, and drift."""

    id = "earth_turn"
    name = "Earth rate on a turning axis, and drift"
    plain = "the axis feels the Earth by its azimuth, and drifts"
    equation = "A cos(delta) - B sin(delta) + d"
    needs = ("head_deg", "tilt_deg")

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Rates of the axis at reading 0 and 90 degrees back, and the drift."""
        return (
            Parameter("north", "A", sensor.unit),
            Parameter("east", "B", sensor.unit),
            Parameter("drift", "d", sensor.unit),
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:  # noqa: ARG002
        """Cosine and sine of the reading, shortened by the tilt, and one."""
        delta = stimulus.column("head_deg") * RAD_PER_DEG
        level = np.cos(stimulus.column("tilt_deg") * RAD_PER_DEG)
        return np.column_stack([level * np.cos(delta), -level * np.sin(delta), np.ones_like(level)])


class Ramp(Effect):
    """A steady change of the drift."""

    id = "drift_ramp"
    name = "Drift ramp"
    plain = "the drift changes steadily, e.g. while the unit warms up"
    equation = "r * (t - middle)"
    needs = ("t_s",)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: change of the drift in an hour."""
        return (Parameter("ramp", "r", f"{sensor.unit}/h"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:  # noqa: ARG002
        """Hours from the middle of the run."""
        t = stimulus.column("t_s")
        return ((t - t.mean()) / 3600.0)[:, None]


def find_north(
    run: Run,
    conditions: Conditions,
    *,
    channel: int = 0,
    scale_factor: float = np.nan,
    u_tilt_arcmin: float = 0.0,
    ramp: bool = False,
) -> Gyrocompass:
    """Find heading and drift from a gyro that stood at several headings.

    Parameters
    ----------
    run : rows of one gyro; `head_deg` is the reading of the base, clockwise from above,
        `extra["tilt_deg"]` the elevation of the input axis by an accelerometer, if it was measured
    conditions : latitude (negative in the south); repeatability of the gyro, deg/s
    channel : which output
    scale_factor : output per deg/s, where the output is no rate
    u_tilt_arcmin : standard uncertainty of one reading of the tilt
    ramp : estimate a steady change of the drift along; needs times and five rows

    Raises
    ------
    RankDeficient
        The headings do not tell north from drift, e.g. two opposite ones.
    FitError
        At a pole; tilt without latitude; an output in no known unit; the level part of the Earth's
        rate is not above the noise.
    """
    latitude = conditions.latitude_deg
    _check_latitude(latitude)
    factor = _deg_per_hour(run.unit, scale_factor)
    tilt = run.extra.get("tilt_deg", np.zeros(len(run)))
    levelled = "tilt_deg" not in run.extra
    if not levelled and np.isnan(latitude):
        raise FitError(
            "the tilt brings in the vertical part of the Earth's rate: state the latitude"
        )
    vertical = np.nan_to_num(vertical_dps(latitude)) * DPH_PER_DPS
    y = run.y[:, channel] * factor - vertical * np.sin(tilt * RAD_PER_DEG)
    by_tilt = vertical * u_tilt_arcmin / ARCMIN_PER_DEG * RAD_PER_DEG
    nothing = np.zeros((len(run), 3))
    columns = {"head_deg": run.head_deg, "tilt_deg": tilt, "t_s": run.t_s}
    stimulus = Stimulus(nothing, nothing, nothing, nothing, columns)
    sensor = Sensor("gyro", run.axes[channel] or "x", "deg/h")
    model = SensorModel(sensor, (EarthTurn(), Ramp()) if ramp else (EarthTurn(),))
    rows = Rows(
        y,
        np.hypot(run.y_se[:, channel] * abs(factor), by_tilt),
        run.extra.get("se_dof", np.full(len(run), np.inf)),
    )
    stated = Conditions(repeatability=conditions.repeatability * DPH_PER_DPS)
    try:
        fit = fit_sensor(model, stimulus, rows, stated)
    except RankDeficient as deficient:
        raise RankDeficient(
            deficient.free,
            "these headings do not tell the Earth's rate from drift; turn the base in steps of 90"
            " degrees (at least three different headings, not all on one line)",
        ) from deficient
    level = _level(fit, latitude)
    expected = level_dps(latitude) * DPH_PER_DPS
    return Gyrocompass(
        heading=_heading(fit),
        drift=parameter(fit, "drift"),
        level=level,
        expected_dph=expected,
        fit=fit,
        notes=(*run.notes, *fit.notes, *_doubts(level, expected, latitude, levelled)),
    )


def run_of_headings(
    headings_deg: FloatArray,
    rates: FloatArray,
    unit: str,
    *,
    se: FloatArray | None = None,
    tilt_deg: FloatArray | None = None,
    t_s: FloatArray | None = None,
    device: str = "",
) -> Run:
    """Rates of one gyro at several headings as a run.

    Parameters
    ----------
    headings_deg, rates : (n,) readings of the base, mean outputs
    unit : of the outputs
    se, tilt_deg, t_s : (n,) standard errors, elevations of the input axis, times
    """
    n = len(rates)
    unknown = np.full(n, np.nan)
    return Run(
        test="headings",
        sensor="gyro",
        device=device,
        channels=("w",),
        axes=("x",),
        unit=unit,
        y=frozen(np.reshape(rates, (n, 1))),
        y_se=frozen(np.reshape(unknown if se is None else se, (n, 1))),
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n, dtype=np.int64),
        mount=("",) * n,
        head_deg=frozen(headings_deg),
        set_rate_dps=unknown,
        temperature_c=unknown,
        t_s=unknown if t_s is None else frozen(t_s),
        extra={} if tilt_deg is None else {"tilt_deg": frozen(tilt_deg)},
    )


def _check_latitude(latitude_deg: float) -> None:
    if abs(latitude_deg) > 90.0:
        raise FitError(
            f"a latitude of {latitude_deg:g} deg does not exist; -90 to 90, south negative"
        )
    if abs(latitude_deg) > _POLE_DEG:
        raise FitError(
            f"at {latitude_deg:g} deg of latitude the Earth's rate has no level part to speak of"
            f" ({level_dps(latitude_deg) * DPH_PER_DPS:.2g} deg/h): at a pole a gyro finds no"
            " heading"
        )


def _deg_per_hour(unit: str, scale_factor: float) -> float:
    if unit in UNITS_DPH:
        return UNITS_DPH[unit]
    if not np.isfinite(scale_factor) or scale_factor == 0.0:
        raise FitError(
            f"the output is in {unit}, which is no rate; state the scale factor in {unit}/(deg/s)"
        )
    return DPH_PER_DPS / scale_factor


def _level(fit: FitResult, latitude_deg: float) -> Estimate:
    values, covariance = fit.values[:2], fit.covariance[:2, :2]
    length = float(np.hypot(*values))
    direction = values / max(length, np.finfo(float).tiny)
    u = float(np.sqrt(direction @ covariance @ direction))
    dof = float(fit.t_dof[0])
    level = Estimate(length, u, dof, "deg/h")
    if np.isnan(u):
        raise FitError(
            "as many headings as unknowns leave no uncertainty; add a heading, or standard errors"
        )
    if length < _SEEN * u:
        earth = level_dps(latitude_deg) * DPH_PER_DPS
        there = "" if np.isnan(earth) else f"; the Earth's is {earth:.3g} there"
        raise FitError(
            f"the rate changes by {length:.3g} deg/h with the heading, u = {u:.2g} deg/h{there}:"
            " north cannot be told from noise; average longer, or use a quieter gyro"
        )
    return level


def _heading(fit: FitResult) -> Spread:
    values = fit.values[:2]
    heading = float(np.arctan2(values[1], values[0])) * DEG_PER_RAD % 360.0
    draws = draws_of(values, fit.covariance[:2, :2], float(fit.t_dof[0]))
    along, across = draws @ values, draws[:, 1] * values[0] - draws[:, 0] * values[1]
    away = np.arctan2(across, along) * DEG_PER_RAD
    low, high = np.percentile(away, [2.5, 97.5])
    return Spread(heading, float(away.std()), heading + float(low), heading + float(high), "deg")


def _doubts(
    level: Estimate, expected_dph: float, latitude_deg: float, levelled: bool
) -> tuple[Note, ...]:
    notes: list[Note] = []
    if np.isnan(latitude_deg):
        notes.append(
            Note(
                Severity.INFO,
                "latitude_missing",
                f"no latitude was stated: the {level.value:.3g} deg/h that were found could not be"
                " compared with the Earth's rate",
            )
        )
    elif abs(level.value - expected_dph) > _UNLIKE * level.u + 0.02 * expected_dph:
        notes.append(
            Note(
                Severity.WARNING,
                "level_rate",
                f"the level part of the Earth's rate came out as {level.value:.4g} +-"
                f" {level.expanded():.2g} deg/h, at {latitude_deg:g} deg it is {expected_dph:.4g}:"
                " check scale factor and latitude; the heading does not depend on them",
            )
        )
    if levelled:
        leak = abs(np.tan(latitude_deg * RAD_PER_DEG))
        much = f"{leak:.2g} arcmin" if np.isfinite(leak) else "tan(latitude) arcmin"
        notes.append(
            Note(
                Severity.INFO,
                "tilt_unknown",
                "the tilt was not measured: each arcmin by which the base leans east or west moves"
                f" the heading by {much}",
            )
        )
    return tuple(notes)
