"""A handful of rows, and faults of the data of accumulated rows."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.few import striking
from core.discrepancy.ladder import explain
from core.discrepancy.problem import Problem
from core.discrepancy.row_facts import row_facts
from core.discrepancy.settings import Settings
from tests.core.discrepancy.hidden import G, K, Rows, Truth, head_run

FOUR: Rows = [(1, "X_from", angle) for angle in (0.0, 90.0, 180.0, 270.0)]
QUICK = Settings(advise=False)


def uneven(truth: Truth) -> np.ndarray:
    return 0.02 * truth.a[:, 2] ** 2


@pytest.mark.parametrize("stated", [True, False])
def test_four_rows_strike_only_beyond_all_noise(stated: bool):
    for run, strikes in ((head_run(uneven, rows=FOUR), True), (head_run(rows=FOUR), False)):
        if not stated:
            run = replace(run, y_se=np.full(run.y_se.shape, np.nan))
        assert (striking(Problem.of(run), QUICK) is not None) is strikes


def test_a_fault_within_the_usual_scatter_of_a_sensor_does_not_strike_where_none_is_stated():
    run = head_run(lambda truth: 1e-3 * truth.a[:, 2] ** 2, rows=FOUR)
    assert striking(Problem.of(run), QUICK) is not None
    unstated = replace(run, y_se=np.full(run.y_se.shape, np.nan))
    assert striking(Problem.of(unstated), QUICK) is None


def test_a_temperature_that_never_changes_is_a_fault_of_the_data():
    run = head_run()
    assert row_facts(run) == ()
    still = replace(run, temperature_c=np.full(len(run), 25.34))
    (fact,) = row_facts(still)
    assert fact.effect == "stale_temperature"
    assert "25.34" in fact.text
    story = explain(still, QUICK)
    assert [step.effect for step in story.steps] == ["stale_temperature"]
    assert story.verdict == "data_fault"
    assert story.before.gap == story.after.gap


@pytest.mark.parametrize(
    "changed",
    [
        {"temperature_c": np.full(96, 25.5)},
        {"temperature_c": np.full(96, np.nan)},
        {"temperature_c": np.full(96, 25.34), "t_s": np.full(96, np.nan)},
        {"temperature_c": np.full(96, 25.34), "t_s": np.arange(96.0)},
    ],
    ids=["typed", "missing", "no time", "too short"],
)
def test_a_typed_temperature_and_a_short_run_are_no_fault(changed: dict[str, np.ndarray]):
    assert row_facts(replace(head_run(), **changed)) == ()


def test_an_output_whose_input_never_changes_is_left_out():
    run = head_run(rows=[(1, "X_from", angle) for angle in np.arange(0.0, 360.0, 15.0)] * 2)
    y = np.hstack([0.003 * K + 1e-5 * run.y, run.y])
    both = replace(run, y=y, y_se=np.tile(run.y_se, (1, 2)), channels=("x", "z"), axes=("x", "z"))
    problem = Problem.of(both)
    assert problem.run.channels == ("z",)
    assert [note.subject for note in problem.notes] == ["not_excited"]
    assert problem.models[0].sensor.response[2] == pytest.approx(K / G, rel=1e-3)
