"""Accelerometers on the dividing head: (1.8), (2.4) and any other set of positions.

The practicum's pair formulas are the least squares of their position sets, so one fit serves them
all; what a set of positions cannot determine is left out by name, never guessed.
"""

from dataclasses import dataclass, replace
from datetime import UTC, datetime

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note, RankDeficient, Severity
from core.fit.linear import Rows, fit_sensor
from core.fit.quantiles import student_t
from core.fit.result import FitResult
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Effect, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stimulus_of
from core.plans.orientation import LEVEL, NO_TILT, BaseOrientation
from core.procedures.added import NOTHING, Added, AddedEffect, response_of, with_effects
from core.procedures.calibration import Calibration, Provenance
from core.samples.run import Conditions, Run
from core.version import SOFTWARE

PROCEDURE = "accelerometers on the dividing head, practicum (1.8), (2.4)"
_MG = 1e3
_SURE = 0.999


@dataclass(frozen=True, slots=True)
class _Pair:
    """Bias by opposite positions, its variance in shares of one row's, and the rows."""

    bias: float
    share: float
    rows: str


def calibrate(
    run: Run,
    conditions: Conditions,
    base: BaseOrientation = LEVEL,
    tilter_deg: tuple[float, float, float] = NO_TILT,
    added: Added = NOTHING,
) -> Calibration:
    """Estimate bias, scale factor and cross-axis sensitivity of every sensor of a run.

    Parameters
    ----------
    run : a run on the dividing head; its rows may repeat positions
    conditions : g with its uncertainty, u of a head setting; over what the run itself states
    base : how the head's base plate stands
    tilter_deg : yaw, pitch, roll that a tilter adds between the head's plate and the case
    added : effects beyond bias, scale factor and cross axes

    Raises
    ------
    FitError
        g is missing, a number is not finite, or the positions determine nothing.
    """
    if not len(run):
        raise FitError("the run holds no rows")
    if not conditions.g_mps2 > 0:
        raise FitError("local gravity is missing; state it in m/s^2, e.g. 9.8106 for Kyiv")
    stimulus = stimulus_of(run, conditions.g_mps2, base=base, tilter_deg=tilter_deg)
    axes = tuple(axis or _steepest_axis(stimulus, run.y[:, c]) for c, axis in enumerate(run.axes))
    found = [_fit_channel(run, stimulus, conditions, c, axis, added) for c, axis in enumerate(axes)]
    fits = tuple(fit for fit, _ in found)
    return Calibration(
        sensor=run.sensor,
        unit=run.unit,
        channels=run.channels,
        axes=axes,
        fits=fits,
        conditions=conditions,
        temperature_c=_mean_temperature(run),
        notes=(*run.notes, *_unit_notes(run, axes, fits)),
        provenance=Provenance(
            procedure=PROCEDURE,
            device=run.device,
            profile=str(run.meta.get("profile", "")),
            plan=str(run.meta.get("plan", "")),
            records=_sources(run),
            software=SOFTWARE,
            measured_utc=str(run.meta.get("measured_utc", "")),
            computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
        ),
        effects=tuple(effects for _, effects in found) if added else (),
    )


def _sources(run: Run) -> tuple[tuple[str, str], ...]:
    """Name and hash of the file that the run was read from, if it was read from one."""
    name, sha256 = run.meta.get("source"), run.meta.get("source_sha256")
    return ((str(name), str(sha256)),) if name and sha256 else ()


def _fit_channel(
    run: Run, stimulus: Stimulus, conditions: Conditions, channel: int, axis: str, added: Added
) -> tuple[FitResult, tuple[AddedEffect, ...]]:
    sensor = Sensor(run.sensor, axis, run.unit)
    full = (CATALOGUE["bias"], CATALOGUE["scale_factor"], CATALOGUE["cross_axis"])
    se_dof = run.extra.get("se_dof", np.full(len(run), np.inf))
    name = run.channels[channel]
    y = run.y[:, channel] + added.change(name, slice(None))
    rows = Rows(y, run.y_se[:, channel], se_dof)
    notes: tuple[Note, ...] = ()
    try:
        fit = fit_sensor(SensorModel(sensor, full), stimulus, rows, conditions)
    except RankDeficient as deficient:
        reduced = _determined(sensor, full, stimulus)
        fit = fit_sensor(SensorModel(sensor, reduced), stimulus, rows, conditions)
        notes = (
            Note(
                Severity.INFO,
                "left_out",
                f"{', '.join(deficient.free)} left out: these positions do not determine"
                " them; add a rotation about another axis",
            ),
        )
    effects = added.of(name)
    fit, acting = with_effects(fit, sensor, stimulus, rows, conditions, effects, added.columns)
    if acting:
        linear = fit.value("bias") + stimulus.a @ np.array(response_of(sensor, fit))
        y = y - (fit.fitted - linear)
    pairs = _opposite_pairs(run, stimulus, y, fit, conditions.g_mps2)
    return replace(fit, notes=(*fit.notes, *notes, *pairs)), acting


def _determined(
    sensor: Sensor, effects: tuple[Effect, ...], stimulus: Stimulus
) -> tuple[Effect, ...]:
    """The effects, with the cross axes cut down to those that the positions excite."""
    excited = [axis for axis in sensor.cross_axes if np.ptp(stimulus.a[:, AXES.index(axis)]) > 1e-9]
    kept = tuple(effect for effect in effects if effect.id != "cross_axis")
    return (*kept, CrossAxis("".join(excited)))


def _steepest_axis(stimulus: Stimulus, y: FloatArray) -> str:
    """The case axis that an output follows most: where a sensor looks, if nothing says it."""
    design = np.column_stack([np.ones(len(y)), stimulus.a])
    slopes = np.linalg.lstsq(design, y, rcond=1e-9)[0][1:]
    return AXES[int(np.argmax(np.abs(slopes)))]


def _mean_temperature(run: Run) -> float:
    known = run.temperature_c[np.isfinite(run.temperature_c)]
    return float(known.mean()) if known.size else float("nan")


def _opposite_pairs(
    run: Run, stimulus: Stimulus, y: FloatArray, fit: FitResult, g: float
) -> tuple[Note, ...]:
    """Compare the bias that each pair of opposite positions gives on its own.

    A model with one bias must find the same in every pair. With four positions this is the one
    degree of freedom that there is, and the pair formulas of (1.8) average over it in silence.
    """
    pairs: list[_Pair] = []
    for axis in range(3):
        along = np.abs(stimulus.a[:, axis]) > g * (1.0 - 1e-6)
        up = np.flatnonzero(along & (stimulus.a[:, axis] > 0))
        down = np.flatnonzero(along & (stimulus.a[:, axis] < 0))
        if up.size and down.size:
            rows = "/".join(str(i + 1) for i in sorted((*up, *down)))
            bias = float(y[up].mean() + y[down].mean()) / 2.0
            pairs.append(_Pair(bias, (1.0 / up.size + 1.0 / down.size) / 4.0, rows))
    if len(pairs) < 2:
        return ()
    low, high = min(pairs, key=lambda pair: pair.bias), max(pairs, key=lambda pair: pair.bias)
    difference = high.bias - low.bias
    spread = float(np.sqrt(low.share + high.share))
    per_mg = abs(fit.value("scale_factor")) * g / _MG
    if fit.sigma_source in ("known", "partly"):
        limit = student_t(_SURE, np.inf) * spread * float(np.sqrt(np.mean(fit.sigma**2)))
    elif fit.lack_of_fit is not None:
        limit = student_t(_SURE, fit.lack_of_fit.pure_dof) * spread * fit.lack_of_fit.pure_sd
    else:
        limit = per_mg
    if difference <= limit:
        return ()
    return (
        Note(
            Severity.WARNING,
            "bias_pairs_differ",
            f"rows {high.rows} give a bias of {high.bias:.2f} {run.unit}, rows {low.rows} one of"
            f" {low.bias:.2f}: {difference:.2f} {run.unit} = {difference / per_mg:.3g} mg"
            " apart. A second-order nonlinearity, a drift or a wrong position would do this;"
            " measure more positions to tell which",
        ),
    )


def _unit_notes(run: Run, axes: tuple[str, ...], fits: tuple[FitResult, ...]) -> list[Note]:
    notes: list[Note] = []
    negative = [
        name for name, fit in zip(run.channels, fits, strict=True) if fit.value("scale_factor") < 0
    ]
    if negative:
        notes.append(
            Note(
                Severity.INFO,
                "negative_scale_factor",
                f"{', '.join(negative)}: the scale factor is negative, which is legal; the output"
                " falls when its axis points up. If every earlier calibration had it positive, the"
                " unit was mounted upside down",
            )
        )
    for name, axis, fit in zip(run.channels, axes, fits, strict=True):
        cross = [
            abs(v) for n, v in zip(fit.names, fit.values, strict=True) if n.startswith("cross_axis")
        ]
        if cross and max(cross) > abs(fit.value("scale_factor")):
            notes.append(
                Note(
                    Severity.WARNING,
                    "wrong_axis",
                    f"{name} follows another axis more than its own ({axis}): are the channels"
                    " permuted, or is the unit mounted about another axis than the plan says?",
                )
            )
    return notes
