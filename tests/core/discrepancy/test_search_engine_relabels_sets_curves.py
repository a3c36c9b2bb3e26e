"""Hidden effects are named, faults recognised, rivals listed, clean data left alone."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.engine import Engine
from core.discrepancy.problem import Problem
from core.discrepancy.result import UNKNOWN
from core.discrepancy.sets import rivals_of
from core.discrepancy.settings import Settings
from core.samples.run import Run
from tests.core.discrepancy.hidden import APART, FORTY_EIGHT, Hidden, head_run, table_run

BOTH_WAYS = [
    (run, mount, angle)
    for run, way in ((1, 1), (2, -1))
    for mount in ("X_from", "X_to", "Y_from")
    for angle in np.arange(0.0, 360.0, 15.0)[::way]
]


def names(run: Run) -> list[str]:
    state, unknown = Engine.of(Problem.of(run), Settings()).found()
    return [slot.name for slot in state.slots] + ([UNKNOWN] if unknown else [])


@pytest.mark.parametrize("seed", range(3))
def test_clean_runs_are_left_alone(seed: int):
    assert names(head_run(seed=seed)) == []
    assert names(table_run(seed=seed)) == []


@pytest.mark.parametrize(
    ("name", "hidden", "rows"),
    [
        ("second_order_nonlinearity", lambda q: 3e-4 * q.a[:, 2] ** 2, APART),
        ("third_order_nonlinearity", lambda q: 8e-4 * q.a[:, 2] ** 3, APART),
        ("cross_coupling", lambda q: 4e-4 * q.a[:, 1] * q.a[:, 2], APART),
        ("cross_axis_nonlinearity", lambda q: 4e-4 * q.a[:, 0] ** 2, APART),
        ("scale_factor_asymmetry", lambda q: 3e-4 * np.abs(q.a[:, 2]), APART),
        ("mounting_angle", lambda q: 2e-4 * q.slope * (q.mount == "X_to"), APART),
        ("bias_jump", lambda q: 3e-4 * (q.t > 40.0 * 30.5), FORTY_EIGHT),
        ("warm_up", lambda q: 1.5e-3 * np.exp(-q.t / 400.0), FORTY_EIGHT),
        ("run_bias", lambda q: 5e-4 * (q.run == 2), FORTY_EIGHT),
        ("outlier", lambda q: 1e-3 * (np.arange(len(q.t)) == 20), FORTY_EIGHT),
        ("saturation", lambda q: -0.02 * np.maximum(q.a[:, 2] - 0.8, 0.0), FORTY_EIGHT),
        ("pickup", lambda q: 2e-4 * np.sin(q.t * 0.0213), FORTY_EIGHT),
    ],
)
def test_a_hidden_effect_is_named(name: str, hidden: Hidden, rows: list):
    assert names(head_run(hidden, rows, seed=1)) == [name]


@pytest.mark.parametrize(
    ("name", "hidden"),
    [
        ("scale_factor_asymmetry", lambda w: 1e-3 * np.abs(w)),
        ("second_order_nonlinearity", lambda w: 1e-5 * w**2),
        ("dead_band", lambda w: -0.06 * np.sign(w)),
        ("hysteresis", lambda w: 0.03 * np.sign(np.diff(w, prepend=w[0]))),
        ("wrong_rate", lambda w: 0.15 * (w == w[5])),
    ],
)
def test_a_hidden_effect_on_the_table_is_named(name: str, hidden):
    assert names(table_run(hidden, seed=2)) == [name]


def test_two_positions_in_each_others_place_are_put_back():
    run = head_run(seed=3)
    y = run.y.copy()
    y[[10, 31]] = y[[31, 10]]
    engine = Engine.of(Problem.of(replace(run, y=y)), Settings())
    state, _ = engine.found()
    assert [slot.name for slot in state.slots] == ["positions_swapped"]
    assert sorted(value for _, value in state.slots[0].instance.effect.shape) == [11.0, 32.0]
    assert state.slots[0].raw.shape[1] == 0


def test_a_mount_written_the_wrong_way_round_is_recognised():
    run = head_run(rows=BOTH_WAYS, seed=4)
    wrong = tuple("X_from" if mount == "X_to" else mount for mount in run.mount)
    assert names(replace(run, mount=wrong)) == ["mount_reversed"]


def test_a_run_turned_the_other_way_is_recognised():
    run = table_run(seed=5)
    rates = np.where(run.run == 2, -run.set_rate_dps, run.set_rate_dps)
    assert names(replace(run, set_rate_dps=rates)) == ["rate_sign_reversed"]


def test_a_reading_stored_twice_is_no_mere_outlier():
    run = head_run(seed=6)
    y = run.y.copy()
    y[14] = y[13]
    assert names(replace(run, y=y)) == ["stuck_reading"]


def test_structure_outside_the_catalogue_is_not_given_a_name():
    def bump(truth):
        away = (truth.head - 205.0 + 180.0) % 360.0 - 180.0
        return 6e-4 * np.exp(-0.5 * (away / 20.0) ** 2)

    assert UNKNOWN in names(head_run(bump, seed=7))


def test_two_effects_are_both_named():
    run = head_run(lambda q: 4e-4 * q.a[:, 2] ** 2 + 6e-4 * (q.t > 40.0 * 52.5), APART, seed=8)
    assert sorted(names(run)) == ["bias_jump", "second_order_nonlinearity"]


def test_what_one_mounting_alone_cannot_tell_is_listed_as_alias():
    rows = [(run, "X_from", angle) for run in (1, 2) for angle in np.arange(0.0, 360.0, 15.0)]
    engine = Engine.of(Problem.of(head_run(lambda q: 5e-4 * q.a[:, 2] ** 2, rows, 9)), Settings())
    state, _ = engine.found()
    rivals = rivals_of(engine, state, 0)
    every = {state.slots[0].name, *rivals.names}
    assert {"second_order_nonlinearity", "cross_axis_nonlinearity", "head_eccentricity"} <= every
    assert rivals.aliases


def test_the_effect_keeps_its_name_when_the_thermometer_is_coarse():
    run = head_run(lambda q: 2e-3 * (q.temperature - 25.0), APART, seed=10)
    state, _ = Engine.of(Problem.of(run), Settings()).found()
    found = [slot.name for slot in state.slots]
    assert len(found) == 1
    assert found[0] in ("bias_temperature", "warm_up", "bias_drift")


def test_the_threshold_is_met_by_one_clean_set_in_a_hundred():
    engine = Engine.of(Problem.of(head_run()), Settings())
    above = np.mean(engine.top > engine.search.threshold)
    assert above <= 0.02
    assert engine.p_value(np.inf) == pytest.approx(1.0 / (len(engine.top) + 1.0))
    assert engine.p_value(-np.inf) == 1.0
