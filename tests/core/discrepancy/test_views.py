"""Few rows are weighed under all sizes that their noise may have."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.bank import Bank
from core.discrepancy.engine import Engine
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.relabels import Relabels
from core.discrepancy.reml import even_normal, stated_sizes
from core.discrepancy.settings import Settings
from core.discrepancy.views import View, together, views_of
from tests.core.discrepancy.hidden import APART, FORTY_EIGHT, head_run

FEW = [row for row in FORTY_EIGHT if row[2] % 90.0 == 0.0]


def seen(problem: Problem) -> tuple[View, ...]:
    floor = Floor.stated(problem, Settings())
    relabels = Relabels.of(problem, floor.space(problem.design()), ())
    return views_of(problem, Bank.of(problem), floor, (), relabels)


def test_evidence_is_the_mean_of_all_views_by_how_well_they_fit():
    first, second = np.array([1.0, 3.0]), np.array([5.0, -1.0])
    heard = [np.log(0.25), np.log(0.75)]
    found = together([first, second], [np.float64(h) for h in heard])
    by_hand = 0.25 * np.exp(first) + 0.75 * np.exp(second)
    assert np.exp(found) == pytest.approx(by_hand)


def test_the_same_for_many_residuals_each_with_its_own_weights():
    first, second = np.array([[1.0, 2.0]]), np.array([[4.0, 0.0]])
    found = together([first, second], [np.array([0.0, 0.0]), np.array([-50.0, 50.0])])
    assert found == pytest.approx(np.array([[1.0, 0.0]]))


def test_views_that_leave_too_much_or_too_little_are_not_heard():
    problem = Problem.of(head_run(rows=FEW, seed=2))
    views = seen(problem)
    assert len(views) >= 10
    # Residuals twenty times as large as any of them speak for the largest sizes.
    sizes = [float(np.mean(np.diag(view.bank.space.chol))) for view in views]
    large = [
        float(view.heard(np.sum(view.bank.space.rest(20.0 * problem.y[:, None]) ** 2)))
        for view in views
    ]
    assert sizes[int(np.argmax(large))] > np.median(sizes)


def test_many_rows_need_one_floor_only():
    problem = Problem.of(head_run(rows=[*APART, *APART, *APART, *APART]))
    assert seen(problem) == ()


def test_what_an_unstated_scatter_would_hide_is_seen():
    """The scatter is guessed from residuals that hold the effect itself."""
    run = head_run(lambda q: 4e-4 * q.a[:, 2] ** 2, rows=APART, seed=6)
    run = replace(run, y_se=np.full_like(run.y_se, np.nan))
    engine = Engine.of(Problem.of(run), Settings())
    state, _ = engine.found()
    assert [slot.name for slot in state.slots] == ["second_order_nonlinearity"]


def test_sizes_are_drawn_evenly_in_each_dimension():
    drawn = even_normal(40, 3, np.random.default_rng(1))
    assert np.sort(drawn, axis=0) == pytest.approx(np.sort(drawn[:, :1], axis=0) @ np.ones((1, 3)))
    assert np.std(drawn) == pytest.approx(1.0, abs=0.03)
    assert np.abs(drawn).max() < 2.6


def test_white_noise_and_drift_that_are_guessed_together_are_wrong_together():
    run = head_run(rows=FEW, seed=2)
    stated = Floor.stated(Problem.of(run), Settings()).parts
    nothing = replace(run, y_se=np.full_like(run.y_se, np.nan))
    guessed = Floor.stated(Problem.of(nothing), Settings()).parts
    names = [part.name for part in guessed]
    both = names.index("white"), names.index("drift")
    assert stated_sizes(stated).spread[both] == pytest.approx(0.0)
    spread = stated_sizes(guessed).spread
    assert spread[both] / np.sqrt(np.prod(np.diag(spread)[list(both)])) > 0.8
