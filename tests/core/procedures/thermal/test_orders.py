"""Cross-validation over temperatures finds the order and no more."""

import numpy as np
import pytest

from core.procedures.thermal.orders import (
    OrderScore,
    highest_order,
    lowest_orders,
    order_scores,
)

T = np.repeat([-40.0, -10.0, 27.0, 50.0, 70.0], 8)
LEVEL = np.repeat(np.arange(5), 8)
UP = np.tile([1.0, -1.0], 20)


def design(bias: int, scale: int) -> np.ndarray:
    powers = (T - 27.0)[:, None] ** np.arange(4)
    return np.hstack([powers[:, : bias + 1], powers[:, : scale + 1] * UP[:, None]])


@pytest.mark.parametrize(("bias", "scale"), [(0, 0), (1, 0), (2, 1), (3, 1)])
def test_the_true_orders_are_found(bias: int, scale: int):
    rng = np.random.default_rng(10 * bias + scale)
    sizes = 30.0 / 50.0 ** np.arange(4)
    truth = np.concatenate([sizes[: bias + 1], sizes[: scale + 1]])
    y = design(bias, scale) @ truth + 0.5 * rng.standard_normal(40)
    every = [(b, s) for b in range(4) for s in range(4)]
    best = lowest_orders(order_scores(every, design, y, LEVEL))
    assert (best.bias, best.scale) == (bias, scale)
    assert best.rms == pytest.approx(0.5, rel=0.5)


def test_lower_orders_win_among_equals():
    scores = (OrderScore(3, 0, 1.0), OrderScore(1, 0, 1.05), OrderScore(0, 0, 3.0))
    assert lowest_orders(scores) == scores[1]


def test_too_few_temperatures_leave_none_out():
    two = LEVEL < 2
    assert order_scores([(0, 0)], lambda b, s: design(b, s)[two], T[two], LEVEL[two]) == ()
    assert [highest_order(levels, 3) for levels in (1, 2, 3, 4, 5, 9)] == [0, 1, 1, 2, 3, 3]
