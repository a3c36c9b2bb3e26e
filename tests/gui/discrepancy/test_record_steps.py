"""A record whose steps are added one after another, and facts that stay."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.discrepancy.ladder import Ladder, explain
from core.errors import FitError
from gui.discrepancy.ladder_rows import regressors_of, rungs_of
from gui.discrepancy.picture import picture_of, where_of
from gui.discrepancy.record_steps import place_of, with_steps
from gui.discrepancy.working import Story, added, all_added, is_fact, searched
from tests.core.discrepancy.hidden import head_run
from tests.core.discrepancy.recorded import Hour, hour_run


def _two(hour: Hour) -> np.ndarray:
    """Temperature, and a jump late in the hour."""
    jump = 4e-4 * (hour.t > 0.7 * hour.t[-1])
    return 2e-4 * (hour.temperature - 24.0) + jump


@pytest.fixture(scope="module")
def record() -> Story:
    run = hour_run(_two, seed=2)
    known = explain(run)
    story = Story(run, (Path("hour.calrec"),), None, with_steps(known, 0), known=known)
    return searched(story, lambda _: None)


def test_the_steps_come_one_after_another(record: Story):
    known = record.known
    assert known is not None
    assert len(known.steps) >= 2
    assert record.told.steps == ()
    first = added(record, known.steps[0].effect, lambda _: None)
    assert [rung.proposed for rung in rungs_of(first)][:3] == [False, False, True]
    assert first.told.after is known.steps[0].after
    before, after = record.told, first.told
    assert np.std(after.measured - after.predicted) < np.std(before.measured - before.predicted)
    left = where_of(first, after=True)
    assert left
    assert regressors_of(left)[0].detail.count("p ") == 0
    slow = next(one for one in left if len(one.x) == len(after.measured))
    picture = picture_of(first, slow, 0, after=True, again=None, candidate=None)
    assert "effects so far" in picture.title
    np.testing.assert_allclose(picture.residual, slow.residual)
    last = added(first, known.steps[-1].effect, lambda _: None)
    assert last.told is known
    assert all_added(record).told is known


def test_a_later_step_brings_those_before_it(record: Story):
    known = record.known
    assert known is not None
    assert added(record, known.steps[1].effect, lambda _: None).told.steps == known.steps[:2]
    assert place_of(known, 0, known.steps[1].effect) == 2
    with pytest.raises(FitError, match="was not found"):
        place_of(known, 1, "settling_lag")


def test_a_fault_of_the_data_is_no_rung_that_can_be_taken_back():
    run = head_run()
    stale = replace(run, temperature_c=np.full(len(run), 23.47))
    ladder = Ladder.of(stale)
    story = Story(stale, (Path("A1.run.csv"),), ladder, ladder.explanation)
    fault = story.told.steps[0]
    assert fault.effect == "stale_temperature"
    assert is_fact(fault)
    rung = rungs_of(story)[1]
    assert rung.kept
    assert not rung.proposed
    assert ladder.with_effect("bias_drift").without_last().slots == ()
    again = Story(stale, story.paths, ladder, ladder.without_last().explanation)
    assert [step.effect for step in again.told.steps] == ["stale_temperature"]
    assert where_of(story, after=False)
