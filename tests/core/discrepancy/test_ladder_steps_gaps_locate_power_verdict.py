"""The ladder: rungs, parameters, gaps, where, what could have been seen, the verdict."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.ladder import Ladder, explain
from core.discrepancy.result import UNKNOWN, VERDICTS
from core.discrepancy.settings import Settings
from core.errors import FitError
from tests.core.discrepancy.hidden import APART, FORTY_EIGHT, G, K, head_run, table_run

K2 = 4e-4
CARDINAL = (0.0, 90.0, 180.0, 270.0)


def bent(seed: int = 0):
    return head_run(lambda q: K2 * q.a[:, 2] ** 2, APART, seed)


@pytest.fixture(scope="module")
def plain() -> Ladder:
    return Ladder.of(bent())


@pytest.fixture(scope="module")
def found(plain: Ladder) -> Ladder:
    return plain.found()


def test_a_rung_closes_the_gap_and_its_number_is_that_of_the_truth(found: Ladder):
    story = found.explanation
    (step,) = story.steps
    assert step.effect == "second_order_nonlinearity"
    (number,) = step.parameters
    assert number.unit == "mg/g^2"
    assert abs(number.value - 1e3 * K2) < 3.0 * number.u
    assert 0.0 < number.u < 0.05
    assert story.before.gap > 1.5 > story.after.gap
    assert story.closure > 0.9
    assert step.held_out_gap_after < story.held_out_before
    assert step.p_value < 0.01


def test_the_curve_of_a_step_is_what_it_adds(found: Ladder):
    story = found.explanation
    true = K * K2 * (found.engine.problem.stimulus.a[:, 2] / G) ** 2
    curve = story.steps[0].curve
    assert np.corrcoef(curve, true)[0, 1] > 0.999
    assert np.std(curve) == pytest.approx(np.std(true), rel=0.3)
    left = story.measured - story.predicted
    assert np.std(left) < np.std(story.measured - story.predicted_before)


def test_the_ladder_is_immutable_and_goes_up_and_down(plain: Ladder, found: Ladder):
    assert plain.explanation.steps == ()
    by_hand = plain.with_effect("scale_factor_asymmetry")
    assert [slot.name for slot in by_hand.slots] == ["scale_factor_asymmetry"]
    assert by_hand.explanation.steps[0].added_by_hand
    assert by_hand.without_last().slots == ()
    assert plain.slots == ()
    assert plain.without_last().slots == ()
    assert not found.explanation.steps[0].added_by_hand


def test_what_was_added_by_hand_stays_when_the_search_goes_on(plain: Ladder):
    names = [slot.name for slot in plain.with_effect("bias_drift").found().slots]
    assert names[0] == "bias_drift"
    assert "second_order_nonlinearity" in names


def test_an_effect_that_these_rows_cannot_show_is_refused(plain: Ladder):
    with pytest.raises(FitError, match="cannot show"):
        plain.with_effect("run_bias")


def test_the_model_that_is_exported_holds_the_effect(found: Ladder):
    ((model, values),) = found.models
    assert model.effects[-1].id == "second_order_nonlinearity"
    predicted = model.predict(found.engine.problem.stimulus, values)
    assert np.allclose(predicted, found.explanation.predicted, atol=1e-9)


def test_where_names_the_regressor_and_the_place(plain: Ladder):
    first = plain.explanation.where[0]
    assert first.p_value < 0.05
    by_name = {where.regressor: where for where in plain.explanation.where}
    along = by_name["a_z"]
    assert along.p_value < 0.05
    assert np.all(np.diff(along.knots) > 0)
    assert np.all(along.band > 0)
    assert np.max(np.abs(along.curve)) > 0
    assert by_name["a_z"].p_value <= by_name["t_s"].p_value


@pytest.mark.slow
def test_the_simultaneous_band_and_the_p_values_hold_in_clean_runs():
    outside, significant = 0, 0
    count = 40
    for seed in range(count):
        where = Ladder.of(head_run(seed=100 + seed)).explanation.where
        worst = next(w for w in where if w.regressor == "head_deg")
        sums = np.array([worst.residual[worst.x == x].mean() for x in np.unique(worst.x)])
        outside += bool(np.any(np.abs(sums) > worst.band))
        significant += where[0].p_value <= 0.05
    assert outside <= 7
    assert significant <= 7


def test_adequate_always_says_what_could_have_been_seen():
    story = explain(head_run(rows=APART))
    assert story.verdict == "adequate"
    sizes = {each.effect: each for each in story.smallest}
    assert 0.05 < sizes["second_order_nonlinearity"].size < 0.3
    assert 8.0 < sizes["head_eccentricity"].size < 60.0
    assert sizes["second_order_nonlinearity"].unit == "mg/g^2"
    assert "run_bias" in story.invisible


def test_aliases_of_a_plan_are_known_before_anything_is_hidden():
    rows = [(run, "X_from", angle) for run in (1, 2) for angle in np.arange(0.0, 360.0, 15.0)]
    sizes = {each.effect: each for each in explain(head_run(rows=rows)).smallest}
    assert "head_eccentricity" in sizes["second_order_nonlinearity"].aliases
    apart = {each.effect: each for each in explain(head_run(rows=APART)).smallest}
    assert "head_eccentricity" not in apart["second_order_nonlinearity"].aliases


def test_quarter_turns_cannot_show_third_order_or_coupling_and_it_is_said():
    rows = [(r, m, a) for r in (1, 2, 3) for m in ("X_from", "Y_from") for a in CARDINAL]
    story = explain(head_run(rows=rows))
    assert {"third_order_nonlinearity", "cross_coupling"} <= set(story.invisible)


def test_four_positions_are_not_enough():
    story = explain(head_run(rows=[(1, "X_from", angle) for angle in CARDINAL]))
    assert story.verdict == "not_enough_data"
    assert story.steps == ()
    assert "leave nothing" in story.summary


def test_noise_far_above_what_is_stated_is_a_finding_of_its_own():
    run = head_run(seed=3)
    louder = run.y + 4.0 * run.y_se * np.random.default_rng(1).standard_normal(run.y.shape)
    story = explain(replace(run, y=louder))
    assert story.verdict == "excess_noise"
    assert story.noise.ratios["white"] > 2.0


@pytest.mark.parametrize("lost", ["y_se", "temperature_c", "t_s"])
def test_a_missing_column_costs_power_and_no_truth(lost: str):
    run = bent(seed=1)
    run = replace(run, **{lost: np.full_like(getattr(run, lost), np.nan)})
    story = explain(run)
    assert story.verdict in VERDICTS
    names = [step.effect for step in story.steps]
    assert names == ["second_order_nonlinearity"]


def test_a_run_without_any_statement_of_noise_says_so():
    run = head_run(rows=APART, seed=2)
    bare = replace(run, y_se=np.full_like(run.y_se, np.nan))
    story = explain(bare)
    assert story.verdict == "adequate"
    assert story.noise.source == "residual"
    assert "floor_not_measured" in {note.subject for note in story.notes}


def test_structure_without_a_name_is_described_where_it_is():
    def bump(truth):
        away = (truth.head - 205.0 + 180.0) % 360.0 - 180.0
        return 8e-4 * np.exp(-0.5 * (away / 20.0) ** 2)

    story = explain(head_run(bump, FORTY_EIGHT, 7))
    assert story.verdict == "unexplained_structure"
    assert story.steps[-1].effect == UNKNOWN
    assert "head_deg" in story.steps[-1].plain or "position" in story.steps[-1].plain


def test_no_more_steps_than_are_asked_for():
    run = table_run(lambda w: 2e-3 * np.abs(w) + 0.2 * (w == w[3]) + 0.1 * (np.arange(84) > 50))
    assert len(explain(run, Settings(max_effects=1, advise=False)).steps) <= 2
    assert len(explain(run, Settings(advise=False)).steps) >= 3


@pytest.mark.slow
def test_intervals_of_named_parameters_hold_the_truth():
    inside = [
        abs(p.value - 1e3 * K2) < 1.96 * p.u
        for seed in range(40)
        for step in explain(bent(200 + seed), Settings(advise=False)).steps
        for p in step.parameters
        if step.effect == "second_order_nonlinearity"
    ]
    assert len(inside) >= 36
    assert np.mean(inside) >= 0.87
