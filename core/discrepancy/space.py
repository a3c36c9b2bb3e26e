"""Whitened residual space of a run: noise is unit and white, the plain model is projected out."""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray

_DUST = 1e-7


@dataclass(frozen=True, slots=True, eq=False)
class Space:
    """Where hypotheses are compared.

    Parameters
    ----------
    chol : (n, n) lower triangular root of the covariance of the noise
    basis : (n, k) orthonormal, of the whitened plain model
    dof : rows minus parameters
    prior : degrees of freedom behind the level of the noise
    """

    chol: FloatArray
    basis: FloatArray
    dof: int
    prior: float

    @classmethod
    def of(cls, covariance: FloatArray, design: FloatArray, prior: float) -> "Space":
        """The space of a covariance and a design of full rank."""
        jitter = 1e-12 * float(np.mean(np.diag(covariance)))
        regular = covariance + jitter * np.eye(len(covariance))
        chol = np.asarray(np.linalg.cholesky(regular), dtype=np.float64)
        basis = np.linalg.qr(_solve(chol, design / np.linalg.norm(design, axis=0)))[0]
        return cls(chol, basis, design.shape[0] - design.shape[1], prior)

    def white(self, columns: FloatArray) -> FloatArray:
        """Whiten."""
        return _solve(self.chol, columns)

    def rest(self, columns: FloatArray) -> FloatArray:
        """Whiten and project the plain model out; what is only rounding becomes zero."""
        return self.project(self.white(columns))

    def project(self, white: FloatArray) -> FloatArray:
        """Project the plain model out of whitened columns; rounding becomes zero."""
        rest = white - self.basis @ (self.basis.T @ white)
        rest = rest - self.basis @ (self.basis.T @ rest)
        before = np.sqrt(np.sum(white**2, axis=0))
        after = np.sqrt(np.sum(rest**2, axis=0))
        return rest * (after > _DUST * before)

    def with_columns(self, columns: FloatArray) -> "Space":
        """The space with further columns in the plain model."""
        if not columns.shape[1]:
            return self
        more = orthonormal(self.rest(columns))
        return replace(self, basis=np.hstack([self.basis, more]), dof=self.dof - more.shape[1])


def orthonormal(columns: FloatArray) -> FloatArray:
    """Orthonormal basis (n, rank) of the span of columns."""
    size = np.linalg.norm(columns, axis=0)
    if not np.any(size > 0.0):
        return np.zeros((len(columns), 0))
    columns = columns[:, size > 0.0] / size[size > 0.0]
    left, singular, _ = np.linalg.svd(columns, full_matrices=False)
    return left[:, singular > 1e-6 * singular[0]]


def solved(design: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Least-squares values (p,) of whitened columns, and their covariance (p, p)."""
    size = np.linalg.norm(design, axis=0)
    size = np.where(size > 0.0, size, 1.0)
    inverse = np.linalg.pinv(design / size, rcond=1e-10)
    inner = inverse @ inverse.T
    return inverse @ y / size, inner / np.outer(size, size)


def _solve(chol: FloatArray, columns: FloatArray) -> FloatArray:
    from scipy.linalg import solve_triangular

    return solve_triangular(chol, columns, lower=True, check_finite=False)
