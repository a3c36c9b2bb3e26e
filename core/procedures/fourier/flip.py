"""Two tumbles, the second with the sensor turned by 180 degrees about its input axis.

The fixture's angle keeps its sense in the room, the sensor's own misalignment keeps its sense in
the case: half the sum and half the difference tell them apart, from the first harmonic alone. With
the fixture's angle known, the second harmonic gives k_xy and K2 as well, so nothing has to be
assumed as in (18).
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.fit.estimate import Estimate, freedom
from core.procedures.fourier.tumble import TumbleResult
from core.procedures.propagation import jacobian
from core.units import DEG_PER_RAD

_COEFFICIENTS = 5


@dataclass(frozen=True, slots=True)
class Flip:
    """Fixture and sensor apart.

    Parameters
    ----------
    fixture : angle of the fixture from the head's zero, deg, in the sense of the head angle
    misalignment : angle of the input axis from the nominal axis of the case, deg, towards the
        other axis of the plane
    bias : output at zero input, without K2
    k, k_cross : responses along the nominal axis and along the other one
    product : k_xy of (1)
    quadratic : response to the square of the input along the axis, less that across it (K2)
    """

    fixture: Estimate
    misalignment: Estimate
    bias: Estimate
    k: Estimate
    k_cross: Estimate
    product: Estimate
    quadratic: Estimate


def separate(upright: TumbleResult, flipped: TumbleResult) -> Flip:
    """Separate the fixture from the sensor.

    Parameters
    ----------
    upright, flipped : tumbles of one sensor, in either order

    Raises
    ------
    FitError
        The two are not of the same axis and plane, the sensor was not turned over between them, or
        a fit has no uncertainty.
    """
    both = (upright, flipped)
    if upright.axis != flipped.axis or upright.cross != flipped.cross:
        raise FitError(
            f"the tumbles are of {upright.axis} in the {upright.axis}-{upright.cross} plane and of"
            f" {flipped.axis} in the {flipped.axis}-{flipped.cross} plane; one sensor is needed"
        )
    if upright.sense == flipped.sense:
        raise FitError(
            "the sensor was not turned over between the tumbles: in both the input axis moves in"
            " the same sense with the head; turn it by 180 degrees about its input axis"
        )
    values = np.concatenate([_values(one) for one in both])
    covariance = np.zeros((2 * _COEFFICIENTS, 2 * _COEFFICIENTS))
    for place, one in enumerate(both):
        block = slice(_COEFFICIENTS * place, _COEFFICIENTS * (place + 1))
        covariance[block, block] = one.fit.covariance[:_COEFFICIENTS, :_COEFFICIENTS]
    if not np.all(np.isfinite(covariance)):
        raise FitError("a tumble has no uncertainty; repeat angles")
    senses, g = np.array([one.sense for one in both]), upright.g_mps2

    def quantities(c: FloatArray) -> FloatArray:
        return _quantities(c.reshape(2, _COEFFICIENTS), senses, g)

    found = quantities(values)
    slopes = jacobian(quantities, values, np.full(len(values), np.abs(values).max()))
    u = np.sqrt(np.einsum("qi,ij,qj->q", slopes, covariance, slopes))
    # Responses go with 1/g, product and quadratic term with 1/g^2.
    relative_g = upright.u_g_mps2 / g
    u = np.hypot(u, relative_g * np.array([0, 0, 0, 1, 1, 2, 2]) * found)
    dof = freedom((1.0, 1.0), (float(upright.fit.t_dof[1]), float(flipped.fit.t_dof[1])))
    unit = upright.bias.unit
    per = f"{unit}/(m/s^2)"
    units = ("deg", "deg", unit, per, per, f"{per}^2", f"{per}^2")
    return Flip(
        *(
            Estimate(float(value), float(doubt), dof, name)
            for value, doubt, name in zip(found, u, units, strict=True)
        )
    )


def _values(one: TumbleResult) -> FloatArray:
    return one.fit.values[:_COEFFICIENTS]


def _quantities(c: FloatArray, senses: FloatArray, g: float) -> FloatArray:
    """Fixture, misalignment, bias, k, k_cross, product, quadratic from (2, 5) coefficients."""
    polarity = np.copysign(1.0, c[:, 1])
    lean = np.arctan2(polarity * c[:, 2], polarity * c[:, 1])
    misalignment = lean.mean()
    fixture = (lean * senses).mean()
    twice = 2.0 * senses * fixture
    product = (c[:, 3] * np.cos(twice) + c[:, 4] * np.sin(twice)).mean() * 2.0 / g**2
    quadratic = (c[:, 3] * np.sin(twice) - c[:, 4] * np.cos(twice)).mean() * 2.0 / g**2
    bias = c[:, 0].mean() - quadratic * g**2 / 2.0
    length = (polarity * np.hypot(c[:, 1], c[:, 2])).mean() / g
    return np.array(
        [
            fixture * DEG_PER_RAD,
            misalignment * DEG_PER_RAD,
            bias,
            length * np.cos(misalignment),
            length * np.sin(misalignment),
            product,
            quadratic,
        ]
    )
