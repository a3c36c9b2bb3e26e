"""The knots are the best of all that are possible, also against trying every one."""

from itertools import combinations

import numpy as np
import pytest

from core.procedures.drift.knots import chord_costs, optimal_knots


def left(t: np.ndarray, curves: np.ndarray, places: tuple[int, ...]) -> float:
    chosen = list(places)
    return sum(float(np.sum((c - np.interp(t, t[chosen], c[chosen])) ** 2)) for c in curves)


def test_chord_costs_are_the_sums_that_they_stand_for():
    rng = np.random.default_rng(3)
    t = np.cumsum(rng.uniform(0.5, 2.0, 15))
    curves = rng.normal(size=(3, 15)) + 100.0
    cost = chord_costs(t, curves)
    for i, j in combinations(range(15), 2):
        inside = slice(i, j + 1)
        assert cost[i, j] == pytest.approx(left(t[inside], curves[:, inside], (0, j - i)), abs=1e-9)
    assert np.all(np.isinf(cost[np.tril_indices(15)]))


@pytest.mark.parametrize("seed", range(5))
def test_no_other_choice_is_better(seed: int):
    rng = np.random.default_rng(seed)
    t = np.arange(12.0)
    curves = np.cumsum(rng.normal(size=(2, 12)), axis=1)
    for knots, places in enumerate(optimal_knots(t, curves, 6), start=2):
        assert len(places) == knots
        assert (places[0], places[-1]) == (0, 11)
        every = (
            left(t, curves, (0, *inner, 11)) for inner in combinations(range(1, 11), knots - 2)
        )
        assert left(t, curves, tuple(places)) == pytest.approx(min(every), abs=1e-9)


def test_the_bends_of_a_broken_line_are_found():
    t = np.arange(100.0)
    line = np.interp(t, [0, 20, 35, 80, 99], [0, 1, -1, 4, 3.5])
    other = np.interp(t, [0, 20, 35, 80, 99], [0, -2, 1, 1.5, -3])
    assert optimal_knots(t, np.array([line, other]), 5)[-1].tolist() == [0, 20, 35, 80, 99]
