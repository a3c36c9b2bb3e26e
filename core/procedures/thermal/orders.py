"""The order of the polynomials, by cross-validation over temperatures.

A whole temperature is left out at a time, both visits of it, since rows of one temperature share
what a polynomial of too high an order would follow.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray

_AS_GOOD = 1.1
"""Residuals within 10 % of the least are as good: the lower orders are taken."""
_FEWEST_INSIDE = 3


@dataclass(frozen=True, slots=True)
class OrderScore:
    """What is left at temperatures left out.

    Parameters
    ----------
    bias, scale : orders of the polynomials
    rms : root mean square, output unit
    """

    bias: int
    scale: int
    rms: float


def highest_order(levels: int, limit: int) -> int:
    """Highest order that so many temperatures can test: S + 2 temperatures for order S."""
    return max(min(limit, levels - 2), 1 if levels > 1 else 0)


def order_scores(
    candidates: Sequence[tuple[int, int]],
    design: Callable[[int, int], FloatArray],
    y: FloatArray,
    level: IntArray,
) -> tuple[OrderScore, ...]:
    """Score pairs of orders; empty where there are too few temperatures to leave one out.

    Parameters
    ----------
    candidates : orders of bias and of scale factor
    design : (bias, scale) -> (n, p) design of that model
    y : (n,) outputs
    level : (n,) which temperature a row belongs to, from 0

    Notes
    -----
    The outermost temperatures are left out only where too few lie between: what is never done in
    use, to extrapolate, should not decide.
    """
    last = int(level.max())
    folds = range(1, last) if last - 1 >= _FEWEST_INSIDE else range(last + 1)
    if last < 2:
        return ()
    scores: list[OrderScore] = []
    for bias, scale in candidates:
        raw = design(bias, scale)
        matrix: FloatArray = raw / np.sqrt(np.sum(raw**2, axis=0))
        squares, count = 0.0, 0
        for fold in folds:
            held, kept = np.flatnonzero(level == fold), np.flatnonzero(level != fold)
            values = np.linalg.lstsq(matrix[kept], y[kept], rcond=None)[0]
            squares += float(np.sum((y[held] - matrix[held] @ values) ** 2))
            count += held.size
        scores.append(OrderScore(bias, scale, float(np.sqrt(squares / count))))
    return tuple(scores)


def lowest_orders(scores: Sequence[OrderScore]) -> OrderScore:
    """The lowest orders that leave hardly more than the least."""
    least = min(score.rms for score in scores)
    good = [score for score in scores if score.rms <= _AS_GOOD * least]
    return min(good, key=lambda score: (score.bias + score.scale, score.rms))
