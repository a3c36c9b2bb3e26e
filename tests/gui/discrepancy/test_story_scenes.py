"""What a story becomes on the screen, without widgets."""

import json
from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.ladder import explain
from core.discrepancy.result import UNKNOWN
from core.model.catalogue.listing import CATALOGUE
from gui.discrepancy.cards import chosen_of, detail_of, following_of, grade_of, proposals_of
from gui.discrepancy.cause_view import _PICTURES, KINDS
from gui.discrepancy.certainty import certainty_words, tone_of
from gui.discrepancy.exporting import model_document
from gui.discrepancy.ladder_rows import regressors_of, rungs_of
from gui.discrepancy.overview import advice_of, found_of, gaps_of
from gui.discrepancy.picture import picture_of, where_of
from gui.discrepancy.plots_view import stretches
from gui.discrepancy.rerun import played
from gui.discrepancy.scene import judgement_of
from gui.discrepancy.words import fitted_words, summary_words, unit_words
from gui.discrepancy.working import Story, added, all_added, in_one, left_over
from gui.widgets.states import Tone
from tests.core.discrepancy.hidden import APART, head_run
from tests.gui.discrepancy.conftest import K2


def test_the_ladder_falls_to_the_floor(story: Story):
    plain, proposed = rungs_of(story)
    assert plain.gap > 4 > 1.3 > proposed.gap
    assert proposed.proposed
    assert not plain.proposed
    assert "Head eccentricity" in proposed.certainty
    assert proposed.tone is Tone.DOUBT
    assert plain.certainty == ""
    whole = rungs_of(all_added(story))
    assert [rung.proposed for rung in whole] == [False, False]


def test_an_ambiguity_set_is_one_card_with_the_truth_first(story: Story):
    (card,) = proposals_of(story)
    assert [row.key for row in card.tied] == ["second_order_nonlinearity", "head_eccentricity"]
    assert card.tied[0].share == 1.0
    assert all(0.0 < row.share <= 1.0 for row in card.tied)
    assert not {row.key for row in card.tied} & {row.key for row in card.others}
    assert "mg/g²" in card.tied[0].value


def test_any_candidate_can_be_chosen(story: Story):
    first, other = chosen_of(story, ""), chosen_of(story, "head_eccentricity")
    assert first is not None
    assert first.effect == "second_order_nonlinearity"
    assert other is not None
    assert other.effect == "head_eccentricity"
    detail = detail_of(other)
    assert detail.equation == CATALOGUE["head_eccentricity"].equation
    assert len(detail.lines) == 2


def test_the_disagreement_is_marked_where_it_is(story: Story):
    where = next(w for w in where_of(story, after=False) if w.regressor == "a_z")
    candidate = chosen_of(story, "")
    shown = picture_of(story, where, 0, after=False, again=None, candidate=candidate)
    # A parabola without its mean and slope leaves the band in the middle and at both ends.
    middle = int(np.argmin(np.abs(shown.knots)))
    assert shown.marked[[0, middle, -1]].all()
    assert shown.mean[middle] < 0 < shown.mean[0]
    assert shown.worst == middle
    assert "σ" in shown.worst_words
    explained = np.corrcoef(shown.preview, shown.mean)[0, 1]
    assert explained > 0.98
    assert len(shown.again) == 0


def test_after_the_effect_nothing_is_marked_in_any_regressor(story: Story):
    whole = all_added(story)
    for where in where_of(whole, after=True):
        shown = picture_of(whole, where, 0, after=True, again=None, candidate=None)
        assert not shown.marked.any()
        assert shown.worst == -1
    rows = regressors_of(where_of(whole, after=True))
    assert Tone.BAD not in {row.tone for row in rows}


def test_adding_by_hand_is_in_the_exported_model(story: Story):
    once = added(story, "second_order_nonlinearity", lambda _: None)
    assert [step.effect for step in once.told.steps] == ["second_order_nonlinearity"]
    assert not once.proposals
    (channel,) = json.loads(json.dumps(model_document(once)))["channels"]
    assert [term["effect"] for term in channel["terms"]] == [
        "bias",
        "scale_factor",
        "cross_axis",
        "second_order_nonlinearity",
    ]
    (k2,) = channel["terms"][-1]["parameters"]
    assert k2["value"] == pytest.approx(1e3 * K2, abs=0.06)
    assert k2["unit"] == "mg/g^2"


def test_unknown_structure_can_be_added_with_all_that_was_found(story: Story):
    assert added(story, UNKNOWN, lambda _: None).told is story.proposed


def test_the_model_played_is_like_the_data(story: Story):
    whole = all_added(story)
    again = played(whole, 3)
    assert again is not None
    before = np.std(left_over(whole, again, after=False))
    after = np.std(left_over(whole, again, after=True))
    assert before == pytest.approx(story.told.before.rms, rel=0.15)
    assert after == pytest.approx(whole.told.after.rms, rel=0.3)
    plain = played(story, 3)
    assert plain is not None
    assert np.std(left_over(story, plain, after=False)) < 0.3 * before


def test_a_ready_plan_is_proposed_with_its_chance(story: Story):
    cards = following_of(story)
    assert cards
    assert all(0.0 < card.chance <= 1.0 for card in cards)
    assert "Head eccentricity" in cards[0].why
    assert "_" not in cards[0].why


def test_what_the_rows_can_show_is_graded(story: Story):
    visible, tied, hidden = grade_of(story.told)
    assert ("Second-order nonlinearity K2", "Head eccentricity") in tied.rows
    assert len(visible.rows) == len(story.told.smallest)
    assert len(hidden.rows) == len(story.told.invisible) + len(story.told.untested)


def test_before_anything_was_looked_for_nothing_is_named(story: Story):
    verdict, summary, tone = judgement_of(story.told, None)
    assert "rejected" in verdict
    assert summary == ""
    assert tone is Tone.DOUBT
    bare = replace(story, proposed=None)
    assert found_of(bare) == ()
    assert "→" not in gaps_of(bare)
    assert advice_of(bare, rejected=True, alone="").startswith("Find (Space)")


def test_at_one_glance_verdict_gap_names_and_what_to_do(story: Story):
    verdict, summary, tone = judgement_of(story.told, story.proposed)
    assert (verdict, summary) == ("An effect is missing; several names fit", "")
    assert tone is Tone.DOUBT
    before, after = (float(part) for part in gaps_of(story).split(" → "))
    assert before > 4 > 1.3 > after
    (row,) = found_of(story)
    assert row.name == "Second-order nonlinearity K2"
    assert row.certainty == "but could also be Head eccentricity"
    assert not row.added
    first = following_of(story)[0]
    assert first.title in advice_of(story, rejected=True, alone="")
    whole = all_added(story)
    verdict, _, _ = judgement_of(whole.told, whole.proposed)
    assert verdict == "They agree now; several names fit"
    assert found_of(whole)[0].added


def test_each_step_tells_how_sure_its_name_is(story: Story):
    assert story.proposed is not None
    step = replace(story.proposed.steps[0], indistinguishable_from=())
    for changed, tone, words in (
        (step, Tone.GOOD, "no other name fits"),
        (
            replace(step, indistinguishable_from=(UNKNOWN,)),
            Tone.DOUBT,
            "but could also be something outside the catalogue",
        ),
        (
            replace(step, indistinguishable_from=("head_eccentricity", UNKNOWN)),
            Tone.DOUBT,
            "but could also be Head eccentricity, or something outside the catalogue",
        ),
        (replace(step, effect=UNKNOWN), Tone.BAD, "no effect of the catalogue fits"),
        (replace(step, effect="outlier"), Tone.GOOD, "no other name fits"),
        (replace(step, effect="dropouts"), Tone.BAD, "a fault of the data, counted in them"),
        (replace(step, effect="rate_random_walk"), Tone.IDLE, "a term of the noise, no fault"),
    ):
        assert (tone_of(changed), certainty_words(changed)) == (tone, words)


def test_names_that_fit_but_did_not_compete_stand_on_the_card(story: Story):
    assert story.proposed is not None
    step = story.proposed.steps[0]
    wide = replace(
        step, indistinguishable_from=(*step.indistinguishable_from, "settling_lag", "hysteresis")
    )
    (card,) = proposals_of(replace(story, proposed=replace(story.proposed, steps=(wide,))))
    assert card.title == "1. These cannot be told apart yet"
    assert card.same == "Fits these rows as well: Settling lag, Hysteresis"


def test_advice_follows_the_verdict(story: Story):
    assert story.proposed is not None

    def told(verdict: str, **changes: object) -> str:
        best = replace(story.proposed, verdict=verdict, next_measurements=(), **changes)
        return advice_of(replace(story, proposed=best), rejected=True, alone="")

    assert "What can be seen" in told("adequate", steps=())
    assert "noise goes another way" in told("excess_noise", steps=())
    assert "elsewhere" in told("ambiguous")
    assert "more densely" in told("unexplained_structure")
    assert "Ctrl+Return" in told("explained")
    assert advice_of(story, rejected=True, alone="plan") == ""
    assert "Practice" in advice_of(story, rejected=True, alone="case")


def test_too_few_rows_are_told_and_nothing_else(story: Story):
    few = story.run.rows(range(4))
    told = explain(few)
    bare = Story(few, story.paths, None, told)
    assert rungs_of(bare) == ()
    assert proposals_of(bare) == ()
    assert played(bare, 1) is None
    assert judgement_of(told, None)[2] is Tone.IDLE
    assert summary_words(told) == told.summary


def test_a_second_file_goes_on_where_the_first_ended():
    first, second = head_run(), head_run(rows=APART, seed=1)
    whole = in_one([first, second])
    assert len(whole) == len(first) + len(second)
    assert np.all(np.diff(whole.t_s) > 0)
    assert len(set(whole.order.tolist())) == len(whole)
    assert set(whole.run[len(first) :].tolist()).isdisjoint(first.run.tolist())
    late = replace(first, meta={"measured_utc": "2026-02-01"})
    early = replace(second, meta={"measured_utc": "2026-01-01"})
    assert len(set(in_one([late, early]).mount[: len(second)])) == len(set(second.mount))


def test_marked_knots_next_to_each_other_are_one_stretch():
    knots = np.array([0.0, 1.0, 2.0, 4.0])
    assert stretches(knots, np.array([1.0, 1.0, 0.0, 1.0])) == [(0.0, 1.5), (3.0, 4.0)]
    assert stretches(np.zeros(0), np.zeros(0)) == []


def test_every_effect_that_can_be_proposed_has_its_picture():
    proposed = {name for name, effect in CATALOGUE.items() if effect.seen_as}
    assert proposed
    assert proposed <= set(KINDS)
    assert set(KINDS.values()) <= set(_PICTURES)


def test_units_are_printed_as_a_physicist_writes_them(story: Story):
    assert unit_words("mg/g^2") == "mg/g²"
    assert unit_words("V/(m/s^2)") == "V/(m/s²)"
    assert story.proposed is not None
    (number,) = story.proposed.steps[0].parameters
    assert fitted_words(number).startswith("second order = 0.5")
