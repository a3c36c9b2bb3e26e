"""The noise floor: parts, their sizes from replicates, what must not be taken for noise."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.components import components_of, positions
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.reml import find_sizes
from core.discrepancy.settings import Settings
from tests.core.discrepancy.hidden import APART, ARCSEC, FORTY_EIGHT, WHITE, K, head_run, table_run

SETTINGS = Settings()


def ratios(problem: Problem) -> dict[str, float]:
    return dict(Floor.of(problem, SETTINGS, ()).result("V").ratios)


def test_parts_have_the_stated_sizes_where_the_sensor_is_level():
    problem = Problem.of(head_run(noise=0.0))
    parts = {part.name: part.matrix for part in components_of(problem, SETTINGS)}
    level = int(np.argmin(np.abs(problem.stimulus.a[:, 2])))
    assert np.sqrt(parts["white"][level, level]) == pytest.approx(K * WHITE)
    assert np.sqrt(parts["head"][level, level]) == pytest.approx(K * 5.0 * ARCSEC, rel=1e-3)
    assert np.sqrt(parts["setting"][level, level]) == pytest.approx(K * 3.0 * ARCSEC, rel=1e-3)


def test_the_error_of_the_head_repeats_at_the_same_dial_angle_and_nowhere_else():
    problem = Problem.of(head_run())
    head = next(part for part in components_of(problem, SETTINGS) if part.name == "head")
    place = positions(problem)
    assert np.all(head.matrix[place[:, None] != place] == 0.0)
    slope = problem.slope()
    both = np.flatnonzero(place == place[3])
    i, j = int(both[0]), int(both[-1])
    assert head.matrix[i, j] == pytest.approx((5.0 * ARCSEC) ** 2 * slope[i] * slope[j])


def test_speed_errors_grow_with_the_rate():
    problem = Problem.of(table_run())
    parts = {part.name: part.matrix for part in components_of(problem, SETTINGS)}
    still = int(np.argmin(np.abs(problem.run.set_rate_dps)))
    fast = int(np.argmax(problem.run.set_rate_dps))
    assert parts["setting"][still, still] == pytest.approx(0.0, abs=1e-12)
    assert np.sqrt(parts["setting"][fast, fast]) == pytest.approx(100.0 * 150e-6, rel=1e-2)


@pytest.mark.parametrize(("times", "low", "high"), [(1.0, 0.75, 1.3), (3.0, 1.7, 3.6)])
def test_replicates_tell_the_noise_of_the_accumulations(times: float, low: float, high: float):
    run = head_run(seed=4)
    louder = times * run.y_se * np.random.default_rng(5).standard_normal(run.y.shape)
    y = run.y + np.sqrt(1.0 - 1.0 / times**2) * louder
    assert low < ratios(Problem.of(replace(run, y=y)))["white"] < high


def test_what_repeats_at_a_position_is_no_noise():
    plain = ratios(Problem.of(head_run(seed=6)))
    bent = ratios(Problem.of(head_run(lambda q: 1e-3 * np.sin(2 * np.radians(q.head)), seed=6)))
    assert bent == pytest.approx(plain, rel=1e-3)


def test_a_real_drift_with_temperature_is_not_eaten_by_the_noise():
    plain = ratios(Problem.of(head_run(seed=6)))["drift"]
    warm = ratios(Problem.of(head_run(lambda q: 2e-3 * (q.temperature - 25.0), seed=6)))["drift"]
    assert warm < 1.5 * plain


def test_without_replicates_the_certificates_stand_and_it_is_said():
    floor = Floor.of(Problem.of(head_run(rows=APART)), SETTINGS, ())
    assert floor.source == "y_se"
    none = replace(head_run(rows=APART), y_se=np.full((len(APART), 1), np.nan))
    assert Floor.of(Problem.of(none), SETTINGS, ()).source == "residual"


def test_few_contrasts_leave_the_stated_sizes():
    parts = components_of(Problem.of(head_run()), SETTINGS)
    sizes = find_sizes(parts, np.zeros(96), np.eye(96))
    assert np.array_equal(sizes.ratio, np.ones(len(parts)))
    assert sizes.dof == 0


def test_simulated_noise_has_the_covariance_that_was_found():
    problem = Problem.of(head_run())
    floor = Floor.of(problem, SETTINGS, ())
    space = floor.space(problem.design())
    # A dozen draws of the sizes scatter; the mean of several dozen lies near what was found.
    nulls = np.hstack([floor.nulls(space, np.random.default_rng(seed)) for seed in range(5)])
    assert np.mean(np.sum(nulls**2, axis=0)) == pytest.approx(space.dof, rel=0.35)
    assert np.max(np.abs(space.basis.T @ nulls)) < 1e-9


def test_rows_without_a_replicate_do_not_make_the_noise_small():
    """What no replicate contradicts has no residual; it must not set the limit for the others."""
    once = [(3, "Z_from", angle) for angle in np.arange(0.0, 360.0, 3.0)]
    found = [
        ratios(Problem.of(head_run(rows=[*FORTY_EIGHT, *once], seed=seed))) for seed in range(6)
    ]
    assert np.mean([each["white"] for each in found]) == pytest.approx(1.0, abs=0.2)
    assert np.mean([each["setting"] for each in found]) > 0.6
