"""Whitened space, scores of all instances at once, evidence."""

import numpy as np
import pytest

from core.discrepancy.bank import Bank
from core.discrepancy.evidence import block_evidence, curve_evidence, log_mean, relabel_evidence
from core.discrepancy.problem import Problem
from core.discrepancy.slots import state_of
from core.discrepancy.space import Space, orthonormal
from tests.core.discrepancy.hidden import head_run

RNG = np.random.default_rng(3)
CARDINAL = [
    (1, mount, angle) for mount in ("X_from", "Y_from") for angle in (0.0, 90.0, 180.0, 270.0)
]


def space_of(problem: Problem) -> Space:
    n = len(problem.y)
    root = np.tril(RNG.normal(size=(n, n))) * 0.1 + np.eye(n)
    return Space.of(root @ root.T, problem.design(), 12.0)


def test_the_sum_of_squares_is_that_of_generalised_least_squares():
    problem = Problem.of(head_run())
    space = space_of(problem)
    covariance = space.chol @ space.chol.T
    x = problem.design()
    inverse = np.linalg.inv(covariance)
    beta = np.linalg.solve(x.T @ inverse @ x, x.T @ inverse @ problem.y)
    rest = problem.y - x @ beta
    white = space.rest(problem.y[:, None])[:, 0]
    assert white @ white == pytest.approx(rest @ inverse @ rest)
    assert np.allclose(space.chol @ white, rest)


def test_rounding_is_no_effect():
    """Terms that vanish at the quarter turns are zero there, not 1e-16."""
    problem = Problem.of(head_run(rows=CARDINAL * 3, noise=0.0))
    bank = Bank.of(problem)
    projected = bank.in_space(space_of(problem))
    unseen = {bank.names[bank.name[i]] for i in np.flatnonzero(~projected.seen)}
    assert {"cross_coupling", "third_order_nonlinearity"} <= unseen


@pytest.mark.parametrize("added", [0, 2])
def test_all_instances_are_scored_as_each_alone_would_be(added: int):
    problem = Problem.of(head_run())
    bank, space = Bank.of(problem), space_of(problem)
    projected = bank.in_space(space)
    basis = orthonormal(space.rest(RNG.normal(size=(len(problem.y), added))))
    basis = basis if added else np.zeros((len(problem.y), 0))
    residual = space.rest(RNG.normal(size=(len(problem.y), 1)))[:, 0]
    residual = residual - basis @ (basis.T @ residual)
    explained, rank = projected.explained(residual, basis)
    for instance in range(0, len(bank.instances), 37):
        columns = projected.columns[:, bank.block(instance)]
        left = orthonormal(columns - basis @ (basis.T @ columns))
        assert rank[instance] == left.shape[1]
        assert explained[instance] == pytest.approx(np.sum((left.T @ residual) ** 2), abs=1e-9)


def test_the_state_of_a_slot_is_what_least_squares_leaves():
    problem = Problem.of(head_run())
    space = space_of(problem)
    plain = state_of((), space, problem.y)
    assert plain.rss == pytest.approx(float(np.sum(space.rest(problem.y[:, None]) ** 2)))
    assert plain.keys == frozenset()


def test_evidence_grows_with_what_is_explained_and_falls_with_parameters():
    one, two, three = (float(block_evidence(e, 1, 120.0, 12.0, 100.0)) for e in (0.0, 20.0, 60.0))
    assert one < 0.0 < two < three
    assert float(block_evidence(20.0, 3, 120.0, 12.0, 100.0)) < two


def test_a_relabelling_that_leaves_more_than_before_has_no_evidence():
    after = relabel_evidence(np.array([50.0, 100.0, 150.0]), 100.0, 12.0, 90.0)
    assert after[0] > 0.0 > after[2]
    assert after[1] == pytest.approx(0.0)


def test_a_curve_along_its_first_directions_is_believed_sooner():
    sizes = np.array([10.0, 1.0, 0.1])
    along = [float(curve_evidence(8.0 * np.eye(3)[i], sizes, 150.0, 12.0, 80.0)) for i in range(3)]
    assert along[0] > along[2]
    many = curve_evidence(np.eye(3)[:, :2] * 8.0, sizes, np.array([150.0, 150.0]), 12.0, 80.0)
    assert many[0] == pytest.approx(along[0])


def test_the_mean_of_exponentials_does_not_overflow():
    values = np.array([1000.0, 1000.0 + np.log(3.0)])
    assert log_mean(values, 0) == pytest.approx(1000.0 + np.log(2.0))
