"""The slow view of a record: blocks, regressors, noise, paths between two levels."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.record_floor import record_floor, usual_floor
from core.discrepancy.record_problem import Samples, record_problem
from core.discrepancy.record_telegraph import telegraph_of
from core.errors import RankDeficient
from tests.core.discrepancy.recorded import WHITE, hour_run


def test_blocks_are_means_at_the_middle_of_their_time():
    run = hour_run(seed=1)
    problem = record_problem(Samples.of(run))
    assert problem.rows == 360
    assert problem.y[7] == pytest.approx(run.y[70:80, 0].mean())
    assert problem.stimulus.column("t_s")[7] == pytest.approx(75.0)
    assert np.median(problem.se) == pytest.approx(WHITE / np.sqrt(10.0), rel=0.15)


def test_regressors_come_without_their_noise_to_the_very_ends():
    run = hour_run(seed=2)
    problem = record_problem(Samples.of(run))
    t = np.arange(3600.0)
    true = 24.0 + 4.0 * np.sin(2.3 * t / 3599.0) ** 2 + 0.4 * np.sin(9.0 * t / 3599.0 + 2)
    means = true.reshape(360, 10).mean(axis=1)
    error = problem.stimulus.column("temperature_c") - means
    assert np.std(error) < 0.4 * 0.005 / np.sqrt(10.0) * 2.0
    assert np.max(np.abs(error[[0, 1, -2, -1]])) < 0.005


def test_a_gap_leaves_blocks_out_and_the_rest_in_place():
    run = hour_run(seed=3)
    there = np.ones(3600, dtype=bool)
    there[1000:1100] = False
    problem = record_problem(Samples.of(run.rows(np.flatnonzero(there))))
    assert problem.rows == 350
    assert np.max(np.diff(problem.stimulus.column("t_s"))) == pytest.approx(110.0)


def test_a_missing_column_names_what_cannot_be_tested():
    run = hour_run(seed=4)
    bare = replace(run, temperature_c=np.full(3600, np.nan), extra={})
    untested = record_problem(Samples.of(bare)).untested
    assert untested["thermal_lag"] == "temperature_c"
    assert untested["quadrature_leakage"] == "QuadratureAmpl"
    flat = replace(run, temperature_c=np.full(3600, 24.0))
    assert record_problem(Samples.of(flat)).untested["bias_temperature"] == "temperature_c"


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda run: run.rows(range(60)), "no record"),
        (lambda run: replace(run, t_s=np.where(run.t_s > 1000, np.nan, run.t_s)), "missing"),
        (lambda run: replace(run, t_s=run.t_s[::-1]), "backwards"),
        (lambda run: replace(run, t_s=np.cumsum(1.0 + 0.9 * np.sin(run.t_s))), "not uniform"),
        (lambda run: replace(run, y=np.full_like(run.y, 0.25)), "stuck"),
        (lambda run: replace(run, y=np.full_like(run.y, np.nan)), "are numbers"),
        (lambda run: replace(run, t_s=np.zeros(len(run))), "not uniform"),
    ],
)
def test_what_is_no_record_is_refused_in_words(change, words: str):
    with pytest.raises(RankDeficient, match=words):
        Samples.of(change(hour_run(seed=5)))


def test_the_floor_follows_the_slow_noise_of_the_record():
    quiet = record_floor(record_problem(Samples.of(hour_run(seed=6, drift=1e-5))))
    loud = record_floor(record_problem(Samples.of(hour_run(seed=6, drift=4e-4))))
    assert quiet.sizes.ratio[0] == pytest.approx(1.0, abs=0.15)
    assert quiet.sizes.ratio[1] < 2.0
    assert loud.sizes.ratio[1] > 6.0


def test_the_usual_floor_is_that_of_the_stated_sizes():
    floor = usual_floor(record_problem(Samples.of(hour_run(seed=7))))
    assert floor.sizes.ratio.tolist() == [1.0, 1.0, 1.0]
    assert floor.covariance == pytest.approx(floor.covariance.T)


def test_a_path_between_two_levels_is_found_and_paid_for():
    rng = np.random.default_rng(8)
    problem = record_problem(Samples.of(hour_run(seed=8)))
    sigma = float(np.median(problem.se))
    levels = np.zeros(360)
    for row in (60, 110, 150, 240, 300):
        levels[row:] = 1.0 - levels[row:]
    residual = sigma * (3.0 * levels + rng.standard_normal(360))
    effect = telegraph_of(problem, [residual - residual.mean()])
    assert effect is not None
    (best, *_) = sorted(
        effect.instances(problem.stimulus, problem.models[0].sensor), key=lambda e: -e.log_odds
    )
    rows = [value - 1.0 for _, value in best.shape]
    assert rows == pytest.approx([60, 110, 150, 240, 300], abs=3)
    # Five changes among 360 rows: about 5 (ln(360/12) + 1/3) nats, some of them given back.
    assert -35.0 < best.log_odds < -10.0


def test_white_noise_suggests_no_path_worth_its_price():
    rng = np.random.default_rng(9)
    problem = record_problem(Samples.of(hour_run(seed=9)))
    sigma = float(np.median(problem.se))
    effect = telegraph_of(problem, [sigma * rng.standard_normal(360)])
    for one in effect.instances(problem.stimulus, problem.models[0].sensor) if effect else ():
        assert one.log_odds < -10.0
