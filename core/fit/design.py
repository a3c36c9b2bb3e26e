"""A model over its stimulus: what the fits of all sensors measured together have in common."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import FitError, RankDeficient
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus

_FREE = 1e-11
"""Singular values below this share of the largest, columns at unit length, see nothing."""
_MOVES = 1e-6
_ALIKE_DECIMALS = 9


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """Least squares with given weights.

    Parameters
    ----------
    values : (p,) parameters
    inverse : (p, n) with values = inverse @ y
    condition : of the weighted design with columns of unit length
    """

    values: FloatArray
    inverse: FloatArray
    condition: float


@dataclass(frozen=True, slots=True, eq=False)
class Design:
    """Rows and columns of a fit, before any output is known.

    Parameters
    ----------
    model, stimulus : what acts, and what acted
    matrix : (n, p) the output that one unit of each parameter adds in each row
    inverse : (p, n) of equal weights
    condition : of the matrix with columns of unit length
    replicate : (n,) number of the group of rows whose inputs are the same to rounding
    """

    model: SensorModel
    stimulus: Stimulus
    matrix: FloatArray
    inverse: FloatArray
    condition: float
    replicate: IntArray

    @classmethod
    def of(cls, model: SensorModel, stimulus: Stimulus) -> "Design":
        """Prepare the fits of a model over a stimulus.

        Raises
        ------
        RankDeficient
            The rows leave parameters free; they are named.
        FitError
            An input that the model needs is not known in every row.
        """
        matrix = model.design(stimulus)
        names = tuple(parameter.symbol for parameter in model.parameters)
        unknown = np.flatnonzero(~np.isfinite(matrix).all(axis=0))
        if unknown.size:
            which = ", ".join(names[i] for i in unknown)
            raise FitError(f"the input that {which} respond to is not known in every row")
        n, p = matrix.shape
        length = np.linalg.norm(matrix, axis=0)
        length = np.where(length > 0, length, 1.0)
        u, s, vt = np.linalg.svd(matrix / length, full_matrices=n < p)
        rank = int(np.sum(s > _FREE * s[0])) if s.size else 0
        if rank < p:
            # A parameter is free if a direction that the rows do not see moves it.
            free = np.abs(vt[rank:]).max(axis=0) > _MOVES
            raise RankDeficient(
                tuple(name for name, is_free in zip(names, free, strict=True) if is_free),
                f"{n} rows of these positions determine {rank} of {p} parameters; measure"
                " positions in which the missing axes change, or fit fewer parameters",
            )
        inverse = ((vt.T / s) @ u.T) / length[:, None]
        return cls(model, stimulus, matrix, inverse, float(s[0] / s[-1]), replicate_groups(matrix))

    def solve(self, y: FloatArray, variance: FloatArray) -> Solution:
        """Solve for outputs (n,) of these variances (n,)."""
        inverse, condition = self.inverse, self.condition
        if variance.min() != variance.max():
            weight = 1.0 / np.sqrt(variance)
            length = np.linalg.norm(self.matrix, axis=0)
            scaled = (self.matrix / length) * weight[:, None]
            u, s, vt = np.linalg.svd(scaled, full_matrices=False)
            inverse = ((vt.T / s) @ u.T) * weight / length[:, None]
            condition = float(s[0] / s[-1])
        values = inverse @ y
        # One step of refinement returns the digits that a large offset took.
        values = values + inverse @ (y - self.matrix @ values)
        return Solution(values, inverse, condition)


def replicate_groups(matrix: FloatArray) -> IntArray:
    """Number (n,) of the group of each row of a matrix (n, p), the same for equal rows."""
    scale = np.abs(matrix).max(axis=0)
    keys = np.round(matrix / np.where(scale > 0, scale, 1.0), _ALIKE_DECIMALS) + 0.0
    known: dict[bytes, int] = {}
    return np.array([known.setdefault(key.tobytes(), len(known)) for key in keys], dtype=np.int64)
