"""The source's own parameters (18), where the data can separate them.

The second harmonic is small, and its phase is all that tells the mounting angle alpha0 from the
cross-axis sensitivity k_y: with 80 angles, 5 realisations and 1 mV of noise u(alpha0) is 4
degrees. A quadratic term K2 enters the same harmonic, so K2 = 0 is an assumption of (18), and one
that half a milligram breaks.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note, Severity
from core.procedures.fourier.tumble import TumbleResult
from core.procedures.propagation import TRIALS, Spread, draws_of, spread_of
from core.units import DEG_PER_RAD

_SEPARABLE = 5.0


@dataclass(frozen=True, slots=True)
class Split:
    """Parameters of (1) with the mounting angle of fig. 5, if K2 = 0.

    Parameters
    ----------
    alpha0 : mounting angle, deg, between -45 and 45
    k_x, k_y : response along the input axis and across it, in the plane of rotation
    k_xy : product term
    ratio : second harmonic over its standard uncertainty
    separable : whether `ratio` allows the split; else the numbers are noise and their intervals
        say so
    notes : the assumption, and what follows from the ratio
    """

    alpha0: Spread
    k_x: Spread
    k_y: Spread
    k_xy: Spread
    ratio: float
    separable: bool
    notes: tuple[Note, ...]


def split(result: TumbleResult, *, gravity_projection: bool = False) -> Split:
    """Split the coefficients by (18), with the sign and the branch that (18) lost.

    Parameters
    ----------
    result : a tumble with its uncertainties
    gravity_projection : give k_x and k_y the signs of the source, whose `a` is the projection of
        gravity, rather than those of specific force

    Raises
    ------
    FitError
        The fit has no uncertainty, so nothing tells whether the split is possible.

    Notes
    -----
    alpha0 = atan(C4/C3)/2 and k_xy = sign(C3) 2/g^2 hypot(C3, C4). As printed k_xy is never
    negative, and its sign reappears as axes that are swapped.
    """
    fit, g = result.fit, result.g_mps2
    places = [fit.index(f"c{i}") for i in range(5)]
    covariance = fit.covariance[np.ix_(places, places)]
    if not np.all(np.isfinite(covariance)):
        raise FitError("the fit has no uncertainty: repeat angles before splitting (18)")
    values = fit.values[places]
    length = float(np.hypot(values[3], values[4]))
    direction = values[3:] / length if length > 0 else np.sqrt([0.5, 0.5])
    ratio = length / float(np.sqrt(direction @ covariance[3:, 3:] @ direction))
    sign = -1.0 if values[3] < 0 else 1.0
    alpha0 = float(np.arctan2(sign * values[4], sign * values[3])) / 2.0
    draws = draws_of(values, covariance, float(fit.t_dof[places[3]]))
    # The angle of each draw from the estimate, so that no draw jumps to another branch.
    along = draws[:, 3:] @ direction
    across = draws[:, 4] * direction[0] - draws[:, 3] * direction[1]
    angles = alpha0 + np.arctan2(across, along) / 2.0
    g_draws = _gravity(result)
    toward = -1.0 if gravity_projection else 1.0
    k_x, k_y = _responses(values[None, :], np.array([alpha0]))
    k_x_draws, k_y_draws = _responses(draws, angles)
    per = f"{fit.parameters[0].unit}/(m/s^2)"
    k_xy = sign * 2.0 * length / g**2
    k_xy_draws = sign * 2.0 * np.hypot(draws[:, 3], draws[:, 4]) / g_draws**2
    return Split(
        alpha0=spread_of(alpha0 * DEG_PER_RAD, angles * DEG_PER_RAD, "deg"),
        k_x=spread_of(toward * float(k_x[0]) / g, toward * k_x_draws / g_draws, per),
        k_y=spread_of(toward * float(k_y[0]) / g, toward * k_y_draws / g_draws, per),
        k_xy=spread_of(k_xy, k_xy_draws, f"{per}^2"),
        ratio=ratio,
        separable=ratio > _SEPARABLE,
        notes=_notes(result, ratio),
    )


def _responses(c: FloatArray, alpha0: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Products g k_x and g k_y for coefficients (n, 5) and mounting angles (n,), specific force."""
    cosine, sine = np.cos(alpha0), np.sin(alpha0)
    return c[:, 1] * cosine + c[:, 2] * sine, c[:, 2] * cosine - c[:, 1] * sine


def _gravity(result: TumbleResult) -> FloatArray:
    rng = np.random.default_rng(TRIALS)
    return result.g_mps2 + result.u_g_mps2 * rng.standard_normal(TRIALS)


def _notes(result: TumbleResult, ratio: float) -> tuple[Note, ...]:
    assumed = Note(
        Severity.INFO,
        "k2_assumed_zero",
        "the split (18) assumes that the sensor has no quadratic term K2: one of half the size of"
        " k_xy would move alpha0 by 13 degrees; turn the sensor over in its fixture and tumble it"
        " again to do without the assumption",
    )
    if ratio > _SEPARABLE:
        return (assumed,)
    return (
        assumed,
        Note(
            Severity.WARNING,
            "not_separable",
            f"the second harmonic is {ratio:.1f} times its uncertainty, {_SEPARABLE:g} are needed:"
            " mounting angle and cross-axis sensitivity cannot be told apart; their sum is"
            f" {result.misalignment.value:.4g} +- {result.misalignment.expanded():.2g} deg",
        ),
    )
