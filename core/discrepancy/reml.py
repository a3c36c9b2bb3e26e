"""Sizes of the parts of the noise from what replicates show.

Maximum a posteriori with a log-normal prior of each size, on contrasts that hold neither what
repeats at a position nor what goes with time (restricted likelihood: Patterson and Thompson 1971).
"""

from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.components import Component

_ROUNDS = 8
_CLIP = 3.0
_FEWEST = 4
_TOGETHER = 0.7
_FREE = 0.2
"""Part of a row's residual that its replicates must leave free for it to be looked at."""


@dataclass(frozen=True, slots=True, eq=False)
class Sizes:
    """What was found.

    Parameters
    ----------
    ratio : (k,) size of each part over its stated size
    spread : (k, k) covariance of the logarithms of the variances, prior and data
    dof : number of contrasts
    """

    ratio: FloatArray
    spread: FloatArray
    dof: int

    def total(self, parts: tuple[Component, ...]) -> FloatArray:
        """Covariance (n, n) of the noise."""
        matrices = zip(parts, self.ratio, strict=True)
        return np.sum([part.matrix * ratio**2 for part, ratio in matrices], axis=0)

    def drawn(
        self, count: int, rng: np.random.Generator, wider: float = 1.0
    ) -> tuple["Sizes", ...]:
        """So many choices of the sizes as they could be as well, spread evenly.

        Parameters
        ----------
        wider : how much further they go than is likely
        """
        root = np.linalg.cholesky(self.spread)
        steps = wider * even_normal(count, len(self.ratio), rng) @ root.T
        return tuple(
            Sizes(self.ratio * np.exp(0.5 * step), self.spread, self.dof) for step in steps
        )


def even_normal(count: int, dimensions: int, rng: np.random.Generator) -> FloatArray:
    """Normal numbers (count, dimensions), in each dimension one from each equal part.

    A dozen free draws hold freaks, and what is judged by them is (McKay, Beckman, Conover 1979).
    """
    quantile = NormalDist().inv_cdf
    middles = np.array([quantile((i + 0.5) / count) for i in range(count)])
    return np.column_stack([rng.permutation(middles) for _ in range(dimensions)])


def prior_of(parts: tuple[Component, ...]) -> FloatArray:
    """Covariance (k, k) of the logarithms of the variances before anything is measured.

    Parts of one family (``drift``, ``slow_drift``) are large or small together, and so are those
    that are guessed from the same scatter.
    """
    spread = np.array([2.0 * part.spread for part in parts])
    family = [part.name.removeprefix("slow_") for part in parts]
    together = np.array([[_TOGETHER if a == b else 0.0 for a in family] for b in family])
    np.fill_diagonal(together, 1.0)
    common = np.array([2.0 * part.common for part in parts])
    return together * np.outer(spread, spread) + np.outer(common, common)


def stated_sizes(parts: tuple[Component, ...]) -> Sizes:
    """The sizes before anything is measured."""
    return Sizes(np.ones(len(parts)), prior_of(parts), 0)


def find_sizes(parts: tuple[Component, ...], y: FloatArray, nuisance: FloatArray) -> Sizes:
    """Find the sizes.

    Parameters
    ----------
    parts : of the noise
    y : (n,) outputs
    nuisance : (n, q) columns whose span is left out
    """
    contrasts = _complement(nuisance)
    if contrasts.shape[1] < _FEWEST:
        return stated_sizes(parts)
    precision = np.linalg.inv(prior_of(parts))
    u = contrasts.T @ _winsorised(contrasts @ (contrasts.T @ y), contrasts)
    matrices = [contrasts.T @ part.matrix @ contrasts for part in parts]
    log = np.zeros(len(parts))
    curvature = precision
    for _ in range(_ROUNDS):
        weights = np.exp(log)
        total: FloatArray = np.sum([w * m for w, m in zip(weights, matrices, strict=True)], axis=0)
        inverse: FloatArray = np.asarray(np.linalg.inv(total), dtype=np.float64)
        products: list[FloatArray] = [
            np.asarray(w * inverse @ m, dtype=np.float64)
            for w, m in zip(weights, matrices, strict=True)
        ]
        white = inverse @ u
        fit = np.array([w * white @ m @ white for w, m in zip(weights, matrices, strict=True)])
        slope = 0.5 * (fit - [np.trace(p) for p in products]) - precision @ log
        information = np.array([[0.5 * np.sum(p * q.T) for q in products] for p in products])
        curvature = information + precision
        step = np.clip(np.linalg.solve(curvature, slope), -1.5, 1.5)
        log = log + step
        if np.max(np.abs(step)) < 0.02:
            break
    spread = np.asarray(np.linalg.inv(curvature), dtype=np.float64)
    return Sizes(np.exp(0.5 * log), spread, contrasts.shape[1])


def _complement(columns: FloatArray) -> FloatArray:
    """Orthonormal basis (n, n - rank) of what is orthogonal to the columns."""
    size = np.linalg.norm(columns, axis=0)
    columns = columns[:, size > 1e-12 * max(float(size.max(initial=0.0)), 1e-300)]
    columns = columns / np.linalg.norm(columns, axis=0)
    left, singular, _ = np.linalg.svd(columns, full_matrices=True)
    rank = int(np.sum(singular > 1e-8 * singular[0]))
    return left[:, rank:]


def _winsorised(residual: FloatArray, contrasts: FloatArray) -> FloatArray:
    """Residuals (n,) without what stands out; rows that no replicate contradicts say nothing."""
    free = np.sqrt(np.sum(contrasts**2, axis=1))
    told = free > _FREE
    limit = _CLIP * 1.4826 * float(np.median(np.abs(residual[told] / free[told])))
    return np.clip(residual, -limit * free, limit * free) if limit > 0.0 else residual
