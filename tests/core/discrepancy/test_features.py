"""One hump, step, wave or late follower is told as structure that no name describes."""

from collections.abc import Callable

import numpy as np
import pytest

from core.discrepancy.bank import Bank
from core.discrepancy.curves import Regressor
from core.discrepancy.engine import Engine
from core.discrepancy.features import Features, features_of, unnamed
from core.discrepancy.floor import Floor
from core.discrepancy.locate import locate
from core.discrepancy.problem import Problem
from core.discrepancy.settings import Settings
from tests.core.discrepancy.hidden import FORTY_EIGHT, NOTHING, Hidden, head_run, table_run


def asked(hidden: Hidden = NOTHING) -> Engine:
    return Engine.of(Problem.of(head_run(hidden, FORTY_EIGHT, seed=3)), Settings())


@pytest.mark.parametrize(
    ("regressor", "hidden"),
    [
        ("a_z", lambda q: 3e-4 * np.exp(-0.5 * ((q.a[:, 2] - 0.2) / 0.15) ** 2)),
        ("a_z", lambda q: 2e-4 * np.sin(9.0 * q.a[:, 2] + 0.7)),
        ("head_deg", lambda q: 4e-4 * np.exp(-0.5 * ((q.head - 140.0) / 32.0) ** 2)),
        ("t_s", lambda q: 2e-4 * (-1.0) ** np.arange(len(q.t))),
    ],
)
def test_one_feature_is_told_where_it_is(regressor: str, hidden: Hidden):
    engine = asked(hidden)
    state, unknown = engine.found()
    assert state.slots == ()
    assert unknown is not None
    assert engine.regressors[unknown.regressor].name == regressor


@pytest.mark.parametrize(
    "hidden",
    [
        lambda w: 0.09 * np.tanh((w - 44.0) / 6.0),
        lambda w: 0.09 * np.exp(-0.5 * ((w + 33.0) / 15.0) ** 2),
    ],
)
def test_the_same_in_the_rate(hidden: Callable[[np.ndarray], np.ndarray]):
    engine = Engine.of(Problem.of(table_run(hidden, seed=4)), Settings())
    state, unknown = engine.found()
    assert state.slots == ()
    assert unknown is not None
    assert engine.regressors[unknown.regressor].name == "set_rate_dps"


def test_what_nobody_could_take_for_noise_has_a_p_value_that_says_so():
    """However many regressors there are, and however few draws of noise."""
    engine = asked(lambda q: 6e-4 * np.exp(-0.5 * ((q.a[:, 2] - 0.2) / 0.15) ** 2))
    first = locate(engine, engine.search.state(()))[0]
    assert first.p_value < 0.005


def test_what_a_name_explains_is_no_feature():
    problem = Problem.of(table_run())
    floor = Floor.stated(problem, Settings())
    bank = Bank.of(problem).in_space(floor.space(problem.design()))
    n = len(problem.y)
    square = (problem.run.set_rate_dps / 100.0) ** 2
    hump = np.exp(-0.5 * ((problem.run.set_rate_dps - 20.0) / 18.0) ** 2)
    both = Regressor("set_rate_dps", "deg/s", square, np.column_stack([square, hump]), True, 1)
    kept = unnamed(both, bank)
    assert kept.basis.shape == (n, 1)
    assert kept.basis[:, 0] == pytest.approx(hump)


def test_evidence_of_one_residual_and_of_many_is_the_same():
    engine = asked()
    space = engine.search.bank.space
    sigma = np.sqrt(np.diag(engine.floor.covariance))
    none = np.zeros((len(sigma), 0))
    residuals = space.project(np.random.default_rng(5).standard_normal((len(sigma), 3)))
    for described in features_of(engine.problem, sigma):
        features = Features.of(described, space)
        many = features.evidence(residuals, space)
        for one, value in zip(residuals.T, many, strict=True):
            # A table of the explained share stands behind that of many.
            assert features.evidence(one, space) == pytest.approx(value)
            assert features.beside(one, none, space) == pytest.approx(value, abs=2e-3)


def test_the_fit_is_the_feature_that_was_hidden():
    engine = asked()
    space = engine.search.bank.space
    sigma = np.sqrt(np.diag(engine.floor.covariance))
    for described in features_of(engine.problem, sigma):
        features = Features.of(described, space)
        place = int(np.flatnonzero(features.shown)[-1])
        hidden = features.blocks[:, place].sum(axis=1)
        assert features.fitted(hidden) == pytest.approx(hidden, abs=1e-6 * np.abs(hidden).max())
