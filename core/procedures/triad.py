"""Three sensors as one: matrices K and Q, calibrated input, non-orthogonality and mounting."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError
from core.fit.result import FitResult
from core.model.effect import AXES
from core.units import DEG_PER_RAD

_PER_SENSOR = 4


@dataclass(frozen=True, slots=True, eq=False)
class Decomposition:
    """K split into scale factors, non-orthogonality and mounting (source 002, with RQ).

    Parameters
    ----------
    sensitivity : (3,) change of output per unit of input along each sensor's own input axis
    input_axes : (3, 3) rows are the unit vectors in the case along which the outputs rise; a
        sensor of negative polarity points against its nominal axis
    skew_deg : (3,) non-orthogonality of the input axes: xy, xz, yz; positive when the angle
        between them is below 90 degrees
    mounting_deg : (3,) small rotation of the sensor block in the case, about x, y, z, with the
        polarities taken out
    """

    sensitivity: FloatArray
    input_axes: FloatArray
    skew_deg: FloatArray
    mounting_deg: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Triad:
    """U = K a + U0 (2.2) and a = Q (U - U0) (2.5).

    Parameters
    ----------
    k : (3, 3) K[i, j] is the response of sensor i to input along axis j
    bias : (3,) U0, output at zero input
    covariance : (12, 12) of (U0_i, K_i1, K_i2, K_i3) for i = 1..3
    t_dof : (3,) degrees of freedom of the sensors' uncertainties
    """

    k: FloatArray
    bias: FloatArray
    covariance: FloatArray
    t_dof: FloatArray

    @property
    def q(self) -> FloatArray:
        """Q = K^-1 (3, 3), (2.6)."""
        return frozen(np.linalg.inv(self.k))

    @property
    def determinant(self) -> float:
        """Determinant of K."""
        return float(np.linalg.det(self.k))

    @property
    def condition(self) -> float:
        """Condition number of K."""
        return float(np.linalg.cond(self.k))

    def u_k(self) -> FloatArray:
        """Standard uncertainties (3, 3) of K."""
        return np.sqrt(np.diag(self.covariance)).reshape(3, _PER_SENSOR)[:, 1:]

    def u_bias(self) -> FloatArray:
        """Standard uncertainties (3,) of U0."""
        return np.sqrt(np.diag(self.covariance)).reshape(3, _PER_SENSOR)[:, 0]

    def u_q(self) -> FloatArray:
        """Standard uncertainties (3, 3) of Q, by dQ = -Q dK Q."""
        q = self.q
        places = [_PER_SENSOR * i + 1 + j for i in range(3) for j in range(3)]
        jacobian = -np.einsum("ri,jc->rcij", q, q).reshape(9, 9)
        part = self.covariance[np.ix_(places, places)]
        return np.sqrt(np.einsum("ri,ij,rj->r", jacobian, part, jacobian)).reshape(3, 3)

    def calibrated(self, u: FloatArray) -> FloatArray:
        """Input (n, 3) from outputs (n, 3), (2.5)."""
        return (u - self.bias) @ self.q.T

    def calibrated_covariance(self, u: FloatArray, se: FloatArray) -> FloatArray:
        """Covariance (n, 3, 3) of the calibrated input.

        Parameters
        ----------
        u, se : (n, 3) outputs and their standard errors
        """
        q = self.q
        x = np.column_stack([np.ones(len(u)), self.calibrated(u)])
        # d a = Q (dU - dU0 - dK a): each sensor's four parameters act through x = (1, a).
        blocks = self.covariance.reshape(3, _PER_SENSOR, 3, _PER_SENSOR)
        by_parameters = np.einsum("nk,ikjl,nl->nij", x, blocks, x)
        total = by_parameters + np.einsum("ni,ij->nij", se**2, np.eye(3))
        return q @ total @ q.T

    def decompose(self) -> Decomposition:
        """Split K by RQ: K = diag(k) T^-1 R, T^-1 upper triangular with unit rows' diagonal."""
        length = np.linalg.norm(self.k, axis=1)
        axes = self.k / length[:, None]
        cosine = axes @ axes.T
        skew = 90.0 - np.arccos(np.clip(cosine[[0, 0, 1], [1, 2, 2]], -1.0, 1.0)) * DEG_PER_RAD
        rotation = _rotation_of_rq(self.k)
        mounting = (
            np.array(
                [
                    rotation[1, 2] - rotation[2, 1],
                    rotation[2, 0] - rotation[0, 2],
                    rotation[0, 1] - rotation[1, 0],
                ]
            )
            / 2.0
            * DEG_PER_RAD
        )
        return Decomposition(frozen(length), frozen(axes), frozen(skew), frozen(mounting))


def _rotation_of_rq(k: FloatArray) -> FloatArray:
    """The rotation R of K = (upper triangular) R with the signs of K's diagonal taken out."""
    signed = k * np.sign(np.diag(k))[:, None]
    q, r = np.linalg.qr(signed[::-1].T)
    rotation = q.T[::-1]
    triangle = r.T[::-1, ::-1]
    return rotation * np.sign(np.diag(triangle))[:, None]


def triad_of(axes: tuple[str, ...], fits: tuple[FitResult, ...]) -> Triad:
    """Put three single-sensor fits together.

    Parameters
    ----------
    axes : (3,) nominal axis of each sensor, each of x, y, z once
    fits : (3,) their fits with bias, scale factor and both cross-axis terms

    Raises
    ------
    FitError
        The sensors are no triad, or K is singular.
    """
    if sorted(axes) != list(AXES):
        raise FitError(f"axes {', '.join(axes)} are no triad; each of x, y, z is needed once")
    order = [axes.index(axis) for axis in AXES]
    chosen = [fits[i] for i in order]
    places = [_places(axis, fit) for axis, fit in zip(AXES, chosen, strict=True)]
    values = np.array([fit.values[p] for fit, p in zip(chosen, places, strict=True)])
    shared = np.vstack([fit.shared[p] for fit, p in zip(chosen, places, strict=True)])
    covariance = shared @ shared.T
    for i, (fit, p) in enumerate(zip(chosen, places, strict=True)):
        block = slice(_PER_SENSOR * i, _PER_SENSOR * (i + 1))
        covariance[block, block] = fit.covariance[np.ix_(p, p)]
    k = values[:, 1:]
    if abs(np.linalg.det(k / np.linalg.norm(k, axis=1)[:, None])) < 1e-6:
        raise FitError("the matrix K is singular: two sensors feel the same axis")
    return Triad(
        k=frozen(k),
        bias=frozen(values[:, 0]),
        covariance=frozen(covariance),
        t_dof=frozen([float(fit.t_dof.min()) for fit in chosen]),
    )


def _places(axis: str, fit: FitResult) -> list[int]:
    """Places of U0 and of the responses to x, y, z in a fit."""
    names = ["scale_factor" if other == axis else f"cross_axis_{other}" for other in AXES]
    try:
        return [fit.index(name) for name in ("bias", *names)]
    except KeyError as error:
        raise FitError(f"the {axis} sensor has no parameter {error}") from error
