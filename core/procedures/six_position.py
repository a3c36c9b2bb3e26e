"""Three accelerometers in orthogonal positions, with the parameters of source 002.

The source writes a = k T^-1 g + b (1) with an upper triangular T^-1: nine parameters. That form
has no rotation of the sensor block against the platform, and half a degree of it leaves 8 to 9 mg
in the residuals. So twelve parameters are fitted always, and K is split by RQ afterwards::

    K = diag(k) T^-1 R,   T^-1 = [[1, a_yz, a_yz a_zx - a_zy], [0, 1, a_zx], [0, 0, 1]]

with R the mounting. The source's own form is fitted beside it, its sign slip corrected.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import Note, Severity
from core.fit.estimate import Estimate
from core.fit.linear import Rows, fit_sensor
from core.fit.result import FitResult
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import stimulus_of
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.procedures.propagation import jacobian
from core.procedures.triad import Triad
from core.samples.run import Conditions, Run
from core.units import DEG_PER_RAD

_PER_SENSOR = 4
_MG = 1e3
_UPPER = {"x": "yz", "y": "z", "z": ""}
"""The axes that the source's form lets each sensor feel beside its own."""


@dataclass(frozen=True, slots=True)
class Skew:
    """Small angles of the source's T, deg.

    Parameters
    ----------
    yz, zy, zx : alpha_yz, alpha_zy, alpha_zx
    """

    yz: Estimate
    zy: Estimate
    zx: Estimate


@dataclass(frozen=True, slots=True, eq=False)
class NineParameters:
    """The source's form (1), (2) by least squares (3).

    Parameters
    ----------
    fits : (3,) of x, y, z with 4, 3 and 2 parameters
    skew_deg : (3,) alpha_yz, alpha_zy, alpha_zx
    residual_mg : (3,) root mean square of what it leaves, mg
    """

    fits: tuple[FitResult, ...]
    skew_deg: FloatArray
    residual_mg: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class SixPosition:
    """A triad with the parameters of source 002.

    Parameters
    ----------
    calibration : the fit of twelve parameters
    triad : the same as matrices
    scale : (3,) k of x, y, z: signed change of output per unit of specific force
    skew : the three angles of T
    mounting : (3,) rotation vector of the sensor block in the platform, deg, about x, y, z
    residual_mg : (3,) root mean square of what the twelve parameters leave, mg
    nine : the source's form beside it
    notes : what the comparison says
    """

    calibration: Calibration
    triad: Triad
    scale: tuple[Estimate, Estimate, Estimate]
    skew: Skew
    mounting: tuple[Estimate, Estimate, Estimate]
    residual_mg: FloatArray
    nine: NineParameters
    notes: tuple[Note, ...]


def calibrate_six(run: Run, conditions: Conditions, base: BaseOrientation = LEVEL) -> SixPosition:
    """Calibrate three accelerometers in orthogonal or any other positions.

    Parameters
    ----------
    run : rows of a triad on the dividing head; six orthogonal positions or more
    conditions : g with its uncertainty, u of a head setting
    base : how the head's base plate stands

    Raises
    ------
    FitError
        The run holds no triad, or its positions leave parameters free.
    """
    calibration = calibrate(run, conditions, base)
    triad = calibration.triad()
    scale, skew, mounting = decomposed(triad, f"{run.unit}/(m/s^2)")
    order = [calibration.axes.index(axis) for axis in AXES]
    g = conditions.g_mps2
    rms = np.array([_rms(calibration.fits[channel].residuals) for channel in order])
    left = rms / np.abs([one.value for one in scale])
    nine = _nine(run, conditions, base, order)
    return SixPosition(
        calibration=calibration,
        triad=triad,
        scale=scale,
        skew=skew,
        mounting=mounting,
        residual_mg=left / g * _MG,
        nine=nine,
        notes=_compared(left / g * _MG, nine, mounting),
    )


def split_k(k: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Split K (3, 3) into k (3,), the angles of T and the mounting R (3, 3).

    Returns
    -------
    scale : (3,) signed; the sign is that of the diagonal of K
    skew : (3,) alpha_yz, alpha_zy, alpha_zx, rad
    rotation : (3, 3)
    """
    polarity = np.sign(np.diag(k))
    q, r = np.linalg.qr((k * polarity[:, None])[::-1].T)
    rotation, upper = q.T[::-1], r.T[::-1, ::-1]
    sense = np.sign(np.diag(upper))
    rotation, upper = rotation * sense[:, None], upper * sense
    length = np.diag(upper)
    unit = upper / length[:, None]
    skew = np.array([unit[0, 1], unit[0, 1] * unit[1, 2] - unit[0, 2], unit[1, 2]])
    return polarity * length, skew, rotation


def joined_k(scale: FloatArray, skew: FloatArray, rotation: FloatArray) -> FloatArray:
    """K (3, 3) of its parts; the inverse of `split_k`."""
    yz, zy, zx = skew
    inverse_t = np.array([[1.0, yz, yz * zx - zy], [0.0, 1.0, zx], [0.0, 0.0, 1.0]])
    return scale[:, None] * inverse_t @ rotation


def rotation_vector(rotation: FloatArray) -> FloatArray:
    """Axis times angle (3,), rad, of a rotation matrix; below half a turn."""
    axial = np.array(
        [
            rotation[1, 2] - rotation[2, 1],
            rotation[2, 0] - rotation[0, 2],
            rotation[0, 1] - rotation[1, 0],
        ]
    )
    sine, cosine = float(np.linalg.norm(axial)) / 2.0, (float(np.trace(rotation)) - 1.0) / 2.0
    angle = float(np.arctan2(sine, cosine))
    return axial / 2.0 * (angle / sine if sine > 0 else 1.0)


def decomposed(
    triad: Triad, unit: str
) -> tuple[tuple[Estimate, Estimate, Estimate], Skew, tuple[Estimate, Estimate, Estimate]]:
    """Scale factors, angles of T and mounting of a triad, with uncertainties."""
    places = [_PER_SENSOR * i + 1 + j for i in range(3) for j in range(3)]
    covariance = triad.covariance[np.ix_(places, places)]

    def parts(flat: FloatArray) -> FloatArray:
        scale, skew, rotation = split_k(flat.reshape(3, 3))
        return np.concatenate([scale, skew * DEG_PER_RAD, rotation_vector(rotation) * DEG_PER_RAD])

    flat = triad.k.ravel()
    values = parts(flat)
    slopes = jacobian(parts, flat, np.repeat(np.abs(values[:3]), 3))
    u = np.sqrt(np.einsum("qi,ij,qj->q", slopes, covariance, slopes))
    dof = float(triad.t_dof.min())
    units = (unit,) * 3 + ("deg",) * 6
    k_x, k_y, k_z, yz, zy, zx, about_x, about_y, about_z = (
        Estimate(float(value), float(doubt), dof, name)
        for value, doubt, name in zip(values, u, units, strict=True)
    )
    return (k_x, k_y, k_z), Skew(yz, zy, zx), (about_x, about_y, about_z)


def _nine(
    run: Run, conditions: Conditions, base: BaseOrientation, order: list[int]
) -> NineParameters:
    stimulus = stimulus_of(run, conditions.g_mps2, base=base)
    fits: list[FitResult] = []
    for axis, channel in zip(AXES, order, strict=True):
        effects = (CATALOGUE["bias"], CATALOGUE["scale_factor"], CrossAxis(_UPPER[axis]))
        model = SensorModel(Sensor(run.sensor, axis, run.unit), effects)
        rows = Rows.of(run.y[:, channel])
        fits.append(fit_sensor(model, stimulus, rows, Conditions(g_mps2=conditions.g_mps2)))
    x, y, _ = fits
    yz = x.value("cross_axis_y") / x.value("scale_factor")
    zx = y.value("cross_axis_z") / y.value("scale_factor")
    # Printed with a plus before p_x4: the fourth element of p_x is -k_x (a_zy - a_yz a_zx).
    zy = -x.value("cross_axis_z") / x.value("scale_factor") + yz * zx
    left = [_rms(fit.residuals) / abs(fit.value("scale_factor")) for fit in fits]
    return NineParameters(
        tuple(fits),
        np.array([yz, zy, zx]) * DEG_PER_RAD,
        np.array(left) / conditions.g_mps2 * _MG,
    )


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _compared(
    left_mg: FloatArray, nine: NineParameters, mounting: tuple[Estimate, Estimate, Estimate]
) -> tuple[Note, ...]:
    worst = int(np.argmax(nine.residual_mg - left_mg))
    if nine.residual_mg[worst] < 2.0 * left_mg[worst] or nine.residual_mg[worst] < 0.1:
        return ()
    angle = float(np.linalg.norm([one.value for one in mounting]))
    return (
        Note(
            Severity.INFO,
            "nine_parameters",
            f"the nine-parameter form of source 002 leaves {nine.residual_mg[worst]:.3g} mg on"
            f" {AXES[worst]}, the twelve parameters {left_mg[worst]:.2g} mg: the sensor block is"
            f" turned by {angle:.3g} deg in the platform, for which that form has no parameter",
        ),
    )
