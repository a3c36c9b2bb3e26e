"""One accelerometer through a full turn of the dividing head (source 000, multipoint tumble).

The output is a Fourier series of the elevation alpha of the input axis, (14)::

    u = C0 + C1 sin a + C2 cos a + C3 sin 2a + C4 cos 2a [+ C5 sin 3a + C6 cos 3a]

by least squares over all angles and realisations; (17) is meant so, its matrix is not square.
What the coefficients determine well comes first: C0, the sensitivity hypot(C1, C2)/g, and the
angle of the input axis in the plane of rotation. What they mean beyond that is another question,
see `split` and `flip`.

Signs: specific force a = -g (2.3), so the axis feels +g when it points up. The source projects
gravity instead; this turns the signs of k_x and k_y over and leaves C0 ... C6 as they are.
"""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note, Severity
from core.fit.estimate import Estimate, parameter
from core.fit.linear import Rows, fit_sensor
from core.fit.quantiles import student_t
from core.fit.result import FitResult
from core.model.effect import AXES, Effect, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stimulus_of
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.fourier.faults import check_angles, check_saturation
from core.procedures.fourier.overlap import Overlap, overlap_of
from core.procedures.fourier.series import Harmonics, LinearDrift
from core.samples.run import Conditions, Run
from core.units import DEG_PER_RAD

_WIDE_GAP_DEG = 90.0
_WORST_CONDITION = 1e3
_SEEN = 3.0


@dataclass(frozen=True, slots=True)
class Harmonic:
    """One harmonic of the output.

    Parameters
    ----------
    order : 1, 2 or 3
    sine, cosine : amplitudes of sin(order * alpha) and cos(order * alpha), output unit
    """

    order: int
    sine: Estimate
    cosine: Estimate

    @property
    def amplitude(self) -> float:
        """Length of the two, output unit; noise alone makes it positive."""
        return float(np.hypot(self.sine.value, self.cosine.value))


@dataclass(frozen=True, slots=True, eq=False)
class TumbleResult:
    """What a tumble determines well.

    Parameters
    ----------
    channel, axis, cross : output, its nominal case axis, the other case axis in the plane
    g_mps2, u_g_mps2 : local gravity and its standard uncertainty
    sense : +1 where the input axis rises with the head angle at alpha = 0, else -1
    alpha_deg : (n,) elevation of the nominal axis, 0 ... 360
    fit : `c0` ... `c4` (`c6`), `drift` if it was asked for
    bias : C0; it holds K2 g^2/2 as well
    sensitivity : hypot(C1, C2)/g with the sign of the polarity: change of output per unit of
        specific force along the sensor's own input axis
    misalignment : angle of the input axis from the nominal one in the plane of rotation, deg,
        towards `cross`; fixture and sensor together
    harmonics : of order 1, 2 (3)
    overlap : the drift check of a run of more than a turn; None where no angle came again
    notes : every doubt
    """

    channel: str
    axis: str
    cross: str
    g_mps2: float
    u_g_mps2: float
    sense: int
    alpha_deg: FloatArray
    fit: FitResult
    bias: Estimate
    sensitivity: Estimate
    misalignment: Estimate
    harmonics: tuple[Harmonic, ...]
    overlap: Overlap | None
    notes: tuple[Note, ...]


def calibrate_tumble(
    run: Run,
    conditions: Conditions,
    *,
    channel: int = 0,
    harmonics: int = 2,
    remove_drift: bool = False,
    base: BaseOrientation = LEVEL,
) -> TumbleResult:
    """Fit the Fourier series to one output of a run on the dividing head.

    Parameters
    ----------
    run : rows of one mount; realisations differ in the column `run`
    conditions : g with its uncertainty, u of a head setting
    channel : which output
    harmonics : 2, or 3 to see a third-order nonlinearity
    remove_drift : estimate a steady drift along with the series
    base : how the head's base plate stands

    Raises
    ------
    RankDeficient
        The angles do not determine the series, e.g. multiples of 90 degrees.
    FitError
        g is missing, angles are too few, the output is saturated or does not follow the head.
    """
    if harmonics not in (2, 3):
        raise FitError(f"{harmonics} harmonics; the series has 2 or 3")
    if not conditions.g_mps2 > 0:
        raise FitError("local gravity is missing; state it in m/s^2, e.g. 9.8106 for Kyiv")
    if len(set(run.mount)) > 1:
        raise FitError(
            f"the run holds the mounts {', '.join(sorted(set(run.mount)))}; a tumble is the turn of"
            " one mount, choose its rows"
        )
    stimulus = _stimulus(run, conditions.g_mps2, base)
    axis, cross = _plane(run, stimulus, channel)
    place, other = AXES.index(axis), AXES.index(cross)
    alpha = np.arctan2(stimulus.a[:, place], stimulus.a[:, other]) * DEG_PER_RAD % 360.0
    y = run.y[:, channel]
    check_angles(alpha, harmonics)
    check_saturation(alpha, y)
    effects: tuple[Effect, ...] = (Harmonics(harmonics, cross),)
    model = SensorModel(
        Sensor(run.sensor, axis, run.unit), (*effects, LinearDrift()) if remove_drift else effects
    )
    se_dof = run.extra.get("se_dof", np.full(len(run), np.inf))
    if conditions.repeatability > 0:
        # Stated in input units; half the swing of the output over g is the scale factor.
        swing = float(np.ptp(y)) / 2.0 / conditions.g_mps2
        conditions = replace(conditions, repeatability=conditions.repeatability * swing)
    fit = fit_sensor(model, stimulus, Rows(y, run.y_se[:, channel], se_dof), conditions)
    if fit.condition > _WORST_CONDITION:
        raise FitError(
            f"the angles determine the series badly (condition {fit.condition:.3g}); spread them"
            " over the whole turn"
        )
    turning = (
        stimulus.a[:, other] * stimulus.da_dhead[:, place]
        - stimulus.a[:, place] * stimulus.da_dhead[:, other]
    )
    overlap = overlap_of(run, fit, y)
    return TumbleResult(
        channel=run.channels[channel],
        axis=axis,
        cross=cross,
        g_mps2=conditions.g_mps2,
        u_g_mps2=float(np.nan_to_num(conditions.u_g_mps2)),
        sense=1 if float(turning.sum()) > 0 else -1,
        alpha_deg=frozen(alpha),
        fit=fit,
        bias=parameter(fit, "c0"),
        sensitivity=_sensitivity(fit, conditions, run.unit),
        misalignment=_misalignment(fit),
        harmonics=tuple(
            Harmonic(n, parameter(fit, f"c{2 * n - 1}"), parameter(fit, f"c{2 * n}"))
            for n in range(1, harmonics + 1)
        ),
        overlap=overlap,
        notes=(*run.notes, *fit.notes, *_doubts(alpha, overlap, remove_drift)),
    )


def _stimulus(run: Run, g: float, base: BaseOrientation) -> Stimulus:
    """What acted, each head angle computed once however many realisations there are."""
    missing = np.flatnonzero(~np.isfinite(run.head_deg))
    if missing.size:
        raise FitError(f"row {missing[0] + 1}: the head angle is missing")
    _, first, again = np.unique(run.head_deg, return_index=True, return_inverse=True)
    once = stimulus_of(run.rows(first.astype(np.int64)), g, base=base)
    return Stimulus(
        a=once.a[again],
        w=once.w[again],
        da_dhead=once.da_dhead[again],
        dw_drate=once.dw_drate[again],
        columns={"order": run.order.astype(np.float64)},
    )


def _plane(run: Run, stimulus: Stimulus, channel: int) -> tuple[str, str]:
    """Nominal axis of the sensor and the other case axis in the plane of rotation."""
    along_shaft = int(np.argmin(np.abs(stimulus.da_dhead).max(axis=0)))
    axis = run.axes[channel]
    if not axis:
        raise FitError(f"{run.channels[channel]}: state the case axis along which it looks")
    if AXES.index(axis) == along_shaft:
        raise FitError(
            f"the {axis} axis lies along the shaft of the head ({run.mount[0]}): turning it changes"
            " nothing; mount the unit with another axis along the shaft"
        )
    (cross,) = set(AXES) - {axis, AXES[along_shaft]}
    return axis, cross


def _sensitivity(fit: FitResult, conditions: Conditions, unit: str) -> Estimate:
    c1, c2 = fit.value("c1"), fit.value("c2")
    length = float(np.hypot(c1, c2))
    places = [fit.index("c1"), fit.index("c2")]
    slope = np.array([c1, c2]) / max(length, np.finfo(float).tiny)
    u = float(np.sqrt(slope @ fit.covariance[np.ix_(places, places)] @ slope))
    if not length > _SEEN * (u if np.isfinite(u) else 0.0):
        raise FitError(
            f"the output changes by {length:.3g} {unit} over a turn, which is not more than noise"
            f" ({u:.3g}): it does not follow the head; is the sensor alive, is this its channel?"
        )
    g = conditions.g_mps2
    by_g = float(np.nan_to_num(conditions.u_g_mps2)) * length / g
    value = float(np.copysign(length, c1)) / g
    dof = float(fit.t_dof[places[0]])
    return Estimate(value, float(np.hypot(u, by_g)) / g, dof, f"{unit}/(m/s^2)")


def _misalignment(fit: FitResult) -> Estimate:
    c1, c2 = fit.value("c1"), fit.value("c2")
    places = [fit.index("c1"), fit.index("c2")]
    slope = np.array([-c2, c1]) / (c1**2 + c2**2)
    u = float(np.sqrt(slope @ fit.covariance[np.ix_(places, places)] @ slope))
    # A negative polarity is no misalignment by 180 degrees.
    angle = float(np.arctan2(np.copysign(1.0, c1) * c2, abs(c1)))
    return Estimate(angle * DEG_PER_RAD, u * DEG_PER_RAD, float(fit.t_dof[places[0]]), "deg")


def _doubts(alpha: FloatArray, overlap: Overlap | None, removed: bool) -> list[Note]:
    notes: list[Note] = []
    sorted_alpha = np.sort(alpha)
    gap = float(np.max(np.diff(sorted_alpha, append=sorted_alpha[0] + 360.0)))
    if gap > _WIDE_GAP_DEG + 1e-6:
        notes.append(
            Note(
                Severity.WARNING,
                "partial_turn",
                f"the angles leave {gap:.0f} degrees of the turn out; an error of the model shows"
                " in all coefficients then",
            )
        )
    if overlap is not None and overlap.significant and not removed:
        drift = overlap.drift
        notes.append(
            Note(
                Severity.WARNING,
                "drift",
                f"after a full turn the output came back changed by {drift.value:.3g} +-"
                f" {student_t(0.95, drift.dof) * drift.u:.2g} {drift.unit}: it drifts, with"
                " temperature or since switching on; fit the drift along, or wait and repeat",
            )
        )
    return notes
