"""Ways in which a bias may have gone to and fro between two levels.

A hidden Markov chain of two levels in white noise (Rabiner 1989): the most likely path, and what
all paths together are worth beside it, so that the choice of the path is paid for.
"""

from collections.abc import Iterable

import numpy as np

from core.arrays import FloatArray, IntArray
from core.discrepancy.problem import Problem
from core.model.catalogue.record import Telegraph

_CHANGES = (4.0, 12.0, 36.0)
"""Changes of level in a record that are tried."""
_ROUNDS = 8
_FEWEST, _MOST = 2, 80


def telegraph_of(problem: Problem, residuals: Iterable[FloatArray]) -> Telegraph | None:
    """Return the paths that residuals (n,) of a record suggest; None where there are none."""
    sigma = float(np.median(problem.se))
    found: dict[tuple[int, ...], float] = {}
    for residual in residuals:
        for changes in _CHANGES:
            path, odds = _path(residual / sigma, changes / len(residual))
            rows = tuple((np.flatnonzero(np.diff(path)) + 1).tolist())
            if _FEWEST <= len(rows) <= _MOST:
                found[rows] = max(found.get(rows, -np.inf), odds)
    return Telegraph(tuple(found), tuple(found.values())) if found else None


def _path(z: FloatArray, rate: float) -> tuple[IntArray, float]:
    """The most likely path (n,) of levels 0 and 1, and the odds that pay for its choice."""
    low, high = np.quantile(z, [0.2, 0.8]).tolist()
    path = np.zeros(len(z), dtype=np.int64)
    for _ in range(_ROUNDS):
        fit = -0.5 * np.column_stack([(z - low) ** 2, (z - high) ** 2])
        new = _viterbi(fit, rate)
        if np.array_equal(new, path) or new.min() == new.max():
            path = new
            break
        path = new
        low, high = float(z[path == 0].mean()), float(z[path == 1].mean())
    fit = -0.5 * np.column_stack([(z - low) ** 2, (z - high) ** 2])
    best = float(fit[np.arange(len(z)), path].sum())
    return path, _forward(fit, rate) - best


def _viterbi(fit: FloatArray, rate: float) -> IntArray:
    stay, change = float(np.log1p(-rate)), float(np.log(rate))
    rows = fit.tolist()
    came: list[tuple[bool, bool]] = []
    a, b = rows[0]
    for one, other in rows[1:]:
        first, second = b + change > a + stay, b + stay >= a + change
        came.append((first, second))
        a, b = (
            (b + change if first else a + stay) + one,
            (b + stay if second else a + change) + other,
        )
    at = bool(b > a)
    path = [int(at)]
    for before in reversed(came):
        at = before[at]
        path.append(int(at))
    return np.array(path[::-1], dtype=np.int64)


def _forward(fit: FloatArray, rate: float) -> float:
    """Logarithm of the likelihood summed over all paths."""
    total = 0.0
    a = b = 0.5
    for one, other in np.exp(fit - fit.max(axis=1, keepdims=True)).tolist():
        a, b = (
            (a * (1.0 - rate) + b * rate) * one,
            (b * (1.0 - rate) + a * rate) * other,
        )
        scale = a + b
        total += float(np.log(scale))
        a, b = a / scale, b / scale
    return total + float(fit.max(axis=1).sum())
