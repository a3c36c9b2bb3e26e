"""Uncertainties of what a record shows: never below the fit, wider by what is not known."""

import numpy as np
import pytest

from core.discrepancy.bank import Bank
from core.discrepancy.engine import Engine, under
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.record_engine import record_regressors
from core.discrepancy.record_floor import record_floor, usual_floor
from core.discrepancy.record_problem import Samples, record_problem
from core.discrepancy.record_shapes import Shapes
from core.discrepancy.record_spread import noise_factors, spread_of, widened
from core.discrepancy.reml import Sizes
from core.discrepancy.settings import Settings
from core.discrepancy.slots import State
from core.discrepancy.steps import steps_of
from tests.core.discrepancy.recorded import hour_run


@pytest.fixture(scope="module")
def problem() -> Problem:
    hidden = lambda h: 5e-4 * np.exp(-h.t / 900.0)  # noqa: E731
    return record_problem(Samples.of(hour_run(hidden, seed=3)))


def engine_of(problem: Problem, floor: Floor) -> Engine:
    regressors = record_regressors(problem, np.sqrt(np.diag(floor.covariance)))
    return under(problem, Settings(), Bank.of(problem), floor, regressors)


def named(shapes: Shapes, name: str) -> State:
    plain = shapes.state(())
    slot = shapes.search.scores(plain)[name].slot
    assert slot is not None
    return shapes.state((shapes.polished(shapes.made(slot.instance.effect), plain),))


def test_a_floor_that_is_sure_widens_nothing_and_one_that_is_not_widens_slow_effects_most(
    problem: Problem,
):
    usual = usual_floor(problem)
    sure = Floor(
        usual.parts,
        Sizes(usual.sizes.ratio, 1e-12 * usual.sizes.spread, 0),
        usual.covariance,
        usual.prior,
        usual.source,
    )
    certain, guessed = engine_of(problem, sure), engine_of(problem, usual)
    state = named(Shapes(certain.search, {}), "bias_drift")
    assert noise_factors(certain, state)[0] == pytest.approx([1.0])
    drift = noise_factors(guessed, state)[0][0]
    line = noise_factors(guessed, named(Shapes(guessed.search, {}), "pickup"))[0][0]
    assert drift > line >= 1.0


def test_the_spread_over_shapes_is_at_least_that_of_the_best_of_them(problem: Problem):
    engine = engine_of(problem, record_floor(problem))
    shapes = Shapes(engine.search, {})
    plain = shapes.state(())
    slot = named(shapes, "warm_up").slots[0]
    rest = shapes.rest(slot)[:, 0]
    assert spread_of(shapes, slot, plain) > 0.9 / float(np.linalg.norm(rest))


def test_steps_keep_their_values_and_become_less_certain(problem: Problem):
    engine = engine_of(problem, record_floor(problem))
    shapes = Shapes(engine.search, {})
    state = named(shapes, "warm_up")
    before = steps_of(engine, state, 0)
    after = widened(shapes, engine, state, before)
    old, new = before[0].parameters[0], after[0].parameters[0]
    assert new.value == old.value
    assert 1.0 <= new.u / old.u < 4.0
    assert after[0].parameters[1:] == before[0].parameters[1:]
