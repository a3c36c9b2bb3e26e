"""What to measure next: doable plans, a chance that means something."""

import numpy as np
import pytest

from core.discrepancy.advise import advise
from core.discrepancy.followups import followups_of
from core.discrepancy.ladder import Ladder, explain
from core.plans.orientation import Mount
from tests.core.discrepancy.hidden import APART, head_run, table_run

ONE = [(run, "X_from", angle) for run in (1, 2) for angle in np.arange(0.0, 360.0, 15.0)]


def test_every_follow_up_is_a_plan_and_rows_behind_those_that_were_measured():
    run = head_run(rows=ONE)
    found = followups_of(run)
    assert len({each.title for each in found}) == len(found)
    for each in found:
        assert len(each.run) == len(run) + len(each.plan.steps)
        assert np.array_equal(each.run.y[: len(run)], run.y)
        assert each.minutes > 0
        assert each.plan.test == "dividing_head"
        assert [Mount.parse(step.mount) for step in each.plan.steps]
        assert each.run.head_deg[-1] == each.plan.steps[-1].head_deg


def test_on_the_table_rates_are_set():
    run = table_run(mixed=False)
    for each in followups_of(run):
        assert each.run.set_rate_dps[-1] == each.plan.steps[-1].rate_dps


def test_a_tie_is_broken_by_another_mounting_and_not_by_the_same_again():
    story = explain(head_run(lambda q: 4e-4 * q.a[:, 2] ** 2, ONE, 1))
    assert story.verdict == "ambiguous"
    best = story.next_measurements[0]
    assert best.probability > 0.9
    assert best.title not in ("Reversed sweep", "Mixed sweep", "Back to the first mounting")
    assert "second_order_nonlinearity" in best.why


def test_the_advice_comes_true():
    """Measured with the proposed rows, the answer is unique and right."""
    hidden = lambda q: 4e-4 * q.a[:, 2] ** 2  # noqa: E731
    story = explain(head_run(hidden, ONE, 1))
    more = [(3, step.mount, step.head_deg) for step in story.next_measurements[0].plan.steps]
    again = explain(head_run(hidden, ONE + more, 1))
    assert [step.effect for step in again.steps] == ["second_order_nonlinearity"]
    assert again.steps[0].indistinguishable_from == ()


def test_where_nothing_is_tied_nothing_is_advised():
    assert explain(head_run(rows=ONE)).next_measurements == ()


def test_a_name_that_may_be_no_name_is_given_the_nearest_names_as_rivals():
    ladder = Ladder.of(head_run(lambda q: 4e-4 * q.a[:, 2] ** 2, APART, 1)).found()
    assert [slot.name for slot in ladder.slots] == ["second_order_nonlinearity"]
    assert advise(ladder.engine, ladder.state) == ()
    (best, *_) = advise(ladder.engine, ladder.state, frozenset({0}))
    assert best.probability > 0.5
    assert "second_order_nonlinearity" in best.why
    assert "," in best.why.partition("tells apart")[2]


def test_a_far_longer_series_is_only_offered_after_a_small_run():
    dense = "All mountings twice, twice as dense"
    small = [each for each in followups_of(head_run(rows=ONE)) if each.title == dense]
    assert [len(each.plan.steps) for each in small] == [5 * 48]
    assert len({step.head_deg for step in small[0].plan.steps}) == 48
    large = head_run(rows=[(run, "X_from", at) for run in range(8) for _, _, at in ONE[:24]])
    assert dense not in [each.title for each in followups_of(large)]


def test_lag_and_hysteresis_of_even_steps_are_told_apart_by_mixed_rates():
    def hidden(w):
        return 0.03 * np.sign(np.diff(w, prepend=w[0] - 1.0))

    story = explain(table_run(hidden, 4, mixed=False))
    tied = {story.steps[0].effect, *story.steps[0].indistinguishable_from}
    assert {"hysteresis", "settling_lag"} <= tied
    assert story.next_measurements[0].title.startswith("Mixed")
    assert story.next_measurements[0].probability == pytest.approx(1.0, abs=0.1)
