"""A bias that goes to and fro between two levels, beside the drift that it looks like.

Restricted likelihood swallows such a bias as a larger drift. Here every size of the drift is
weighed twice, with the likeliest path between two levels and without; each path pays for where it
changes.
"""

from dataclasses import dataclass
from math import lgamma

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.engine import Engine
from core.discrepancy.slots import Slot, State

SURE = 4.0
"""Nats beyond which a path is no drift: more than any of 140 clean runs gave."""

_DRIFTS = (0.5, 1.0, 1.8, 3.2)
_SPREAD, _G = 0.5, 64.0
_FEWEST_ROWS, _MOST_MOVES = 8, 60


@dataclass(frozen=True, slots=True, eq=False)
class Levels:
    """Two levels, or names, under all sizes of the drift.

    Parameters
    ----------
    evidence : of the best path, nats over nothing but drift
    path : (n,) plus or minus one in the rows of one channel, zero in others
    named : evidence of the names that were added, under the same sizes of the drift
    """

    evidence: float
    path: FloatArray
    named: float


def two_levels(engine: Engine, state: State, named: tuple[Slot, ...] = ()) -> Levels | None:
    """Return the best path beside the slots of a state; None where there are too few rows.

    Parameters
    ----------
    state : what the plain model has been given already
    named : slots that are weighed against the path
    """
    problem, parts = engine.problem, engine.floor.parts
    n = problem.rows
    if n < _FEWEST_ROWS or engine.search.bank.space.dof < _FEWEST_ROWS:
        return None
    sized = [p.matrix * r**2 for p, r in zip(parts, engine.floor.sizes.ratio, strict=True)]
    drifts = np.array(["drift" in part.name for part in parts])
    other = np.sum([m for m, d in zip(sized, drifts, strict=True) if not d], axis=0)
    drift = np.sum([p.matrix for p, d in zip(parts, drifts, strict=True) if d], axis=0)
    design = np.hstack([problem.design(), *(slot.raw for slot in state.slots)])
    y = problem.y + np.sum([slot.change for slot in state.slots], axis=0)
    space = engine.search.bank.space
    level, dof = space.prior, space.dof - state.added.shape[1]

    def fit(left: float) -> float:
        """Log-likelihood of a sum of squares; Student's, for the level of the noise is a guess."""
        return -0.5 * (level + dof) * float(np.log1p(max(left, 0.0) / level))

    alone: list[float] = []
    with_names: list[float] = []
    with_path: list[float] = []
    best, path = -np.inf, np.zeros(len(y))
    for size in _DRIFTS:
        precision, likelihood = _precision(other + size**2 * drift, design)
        pull = precision @ y
        likelihood -= 0.5 * (np.log(size) / _SPREAD) ** 2
        squares = float(y @ pull)
        alone.append(likelihood + fit(squares))
        after, price = _explained(engine, precision, y, named)
        with_names.append(likelihood + fit(after) - price)
        wandered = drift @ pull
        for channel in range(problem.channels):
            own = slice(channel * n, (channel + 1) * n)
            start = wandered[own] > 0.5 * np.sum(np.quantile(wandered[own], [0.1, 0.9]))
            inner = precision[own, own]
            levels, gain, price = _climbed(inner, pull[own], np.where(start, 1.0, -1.0))
            price += 0.5 * float(np.log1p(_G)) + float(np.log(problem.channels))
            with_path.append(likelihood + fit(squares - 2.0 * gain) - price)
            if with_path[-1] > best:
                best, path = with_path[-1], np.zeros(len(y))
                path[own] = levels
    nothing = _log_sum(alone)
    return Levels(_log_sum(with_path) - nothing, path, _log_sum(with_names) - nothing)


def _precision(covariance: FloatArray, design: FloatArray) -> tuple[FloatArray, float]:
    """What is left of the inverse of a covariance beside a design, and its log-likelihood."""
    jitter = 1e-12 * float(np.mean(np.diag(covariance)))
    root = np.linalg.cholesky(covariance + jitter * np.eye(len(covariance)))
    white = _inverse(np.asarray(root, dtype=np.float64))
    size = np.linalg.norm(design, axis=0)
    shown = white @ (design / np.where(size > 0.0, size, 1.0))
    left, singular, _ = np.linalg.svd(shown, full_matrices=False)
    free = singular > 1e-10 * singular[0]
    left = left[:, free]
    rest = white - left @ (left.T @ white)
    likelihood = -float(np.sum(np.log(np.diag(root)))) - float(np.sum(np.log(singular[free])))
    return rest.T @ rest, likelihood


def _inverse(root: FloatArray) -> FloatArray:
    from scipy.linalg import solve_triangular

    return solve_triangular(root, np.eye(len(root)), lower=True, check_finite=False)


def _explained(
    engine: Engine, precision: FloatArray, y: FloatArray, named: tuple[Slot, ...]
) -> tuple[float, float]:
    """Sum of squares that names leave, and what their places and shapes cost."""
    if not named:
        return float(y @ precision @ y), 0.0
    moved = y + np.sum([slot.change for slot in named], axis=0)
    raw = np.hstack([slot.raw for slot in named])
    inner, along = raw.T @ precision @ raw, raw.T @ (precision @ moved)
    taken = float(along @ np.linalg.pinv(inner, rcond=1e-10) @ along) if raw.shape[1] else 0.0
    bank = engine.bank
    places = sum(
        float(np.log(max(int(np.sum(bank.name == bank.names.index(slot.name))), 1)))
        for slot in named
        if slot.name in bank.names
    )
    price = 0.5 * raw.shape[1] * float(np.log1p(_G)) + places
    return float(moved @ precision @ moved) - taken, price


def _climbed(
    inner: FloatArray, pull: FloatArray, path: FloatArray
) -> tuple[FloatArray, float, float]:
    """The best path (n,) that turning one stretch after another leads to, its gain and its price.

    Of all stretches [i, j) the best is turned; sums over them are differences of running sums.
    """
    n = len(pull)
    price = np.array([_choices(n - 1, count) + np.log(n) for count in range(n)])
    price = np.concatenate([[np.inf, np.inf], price[2:], [np.inf, np.inf]])
    empty = np.tril(np.full((n, n), np.inf), -1)  # stretches that end before they begin
    both = np.zeros((n + 1, n + 1))
    one = np.zeros(n + 1)
    worth, found = -np.inf, 0.0
    for _ in range(_MOST_MOVES):
        both[1:, 1:] = np.cumsum(np.cumsum(np.outer(path, path) * inner, axis=0), axis=1)
        one[1:] = np.cumsum(path * pull)
        ends, rows = np.diag(both), both[:, n]
        # A stretch loses four times what it has with all rows, and gains that with itself back.
        across = 4.0 * ((ends + rows)[:n, None] + (ends - rows)[None, 1:] - 2.0 * both[:n, 1:])
        along = 2.0 * (one[:n, None] - one[None, 1:]) + one[n]
        turns = 1 - 2 * (path[1:] != path[:-1]).astype(np.int64)
        edges = np.concatenate([[0], turns])[:, None] + np.concatenate([turns, [0]])[None, :]
        count = int(np.sum(turns < 0)) + edges
        gain = 0.5 * along**2 / np.maximum(across + both[n, n], 1e-9)
        value = gain - price[count] - empty
        best = int(np.argmax(value))
        if value.flat[best] <= worth + 1e-9:
            break
        worth, found = float(value.flat[best]), float(gain.flat[best])
        path = path.copy()
        path[best // n : best % n + 1] *= -1.0
    return path, found, found - worth


def _choices(n: int, k: int) -> float:
    """Logarithm of the number of ways to choose k of n."""
    return lgamma(n + 1) - lgamma(k + 1) - lgamma(n - k + 1)


def _log_sum(values: list[float]) -> float:
    return float(np.logaddexp.reduce(np.array(values)))
