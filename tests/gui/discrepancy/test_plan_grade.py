"""What a plan can show, before anything is measured; asked for in the real window."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from core.plans.plan import load_plans
from gui.discrepancy.cards import lights_of
from gui.discrepancy.plan_grade import counts_of, graded, nominal_run
from gui.discrepancy.scene import judgement_of
from gui.discrepancy.tab import TITLE, DiscrepancyTab
from gui.measuring.tab import MeasuringTab
from gui.widgets.states import Tone
from tests.gui.window_driver import Driver

PLANS = load_plans()


def test_more_positions_show_more():
    few, many = graded(PLANS["pointer_8"], 1).told, graded(PLANS["clbacc_24"], 1).told
    assert counts_of(few)[0] < counts_of(many)[0]
    assert sum(counts_of(few)) == sum(counts_of(many))
    lights = lights_of(few)
    assert len(lights) == sum(counts_of(few))
    order = [row.tone for row in lights]
    assert order == sorted(order, key=[Tone.GOOD, Tone.DOUBT, Tone.BAD].index)
    assert Tone.BAD in order
    tied = next(row for row in lights if "looks the same" in row.detail)
    assert tied.tone is Tone.DOUBT


def test_rows_are_those_of_the_plan_as_often_as_it_is_walked():
    plan = PLANS["rate_table_up_down"]
    run = nominal_run(plan, 2)
    assert len(run) == 2 * len(plan.steps)
    assert run.set_rate_dps[: len(plan.steps)].tolist() == [s.rate_dps for s in plan.steps]
    assert run.channels == ("gyro_z",)
    told = graded(plan, 2).told
    assert told.verdict in ("adequate", "excess_noise")
    once = {each.effect: each.size for each in graded(plan, 1).told.smallest}
    twice = {each.effect: each.size for each in told.smallest}
    assert twice["second_order_nonlinearity"] < once["second_order_nonlinearity"]


def test_gyros_at_rest_and_a_plan_that_can_show_nothing():
    assert graded(PLANS["g_sensitivity_8"], 1).ladder is not None
    story = graded(PLANS["accelerometer_4"], 1)
    assert story.ladder is None
    words, meaning, tone = judgement_of(story.told, None, alone="plan")
    assert "nothing" in words
    assert "each twice" in meaning
    assert tone is Tone.BAD
    free = PLANS["accelerometer_4"]
    longer = replace(free, accumulation_s=100.0)
    assert nominal_run(longer, 1).y_se[0, 0] < nominal_run(free, 1).y_se[0, 0]


@pytest.mark.timeout(240)
@pytest.mark.parametrize("title", ["Dividing head", "Rate table"])
def test_the_question_mark_beside_the_plan_answers(open_app: "Callable[[], Driver]", title: str):
    driver = open_app()
    tab, other = driver.app.tabs[title], driver.app.tabs[TITLE]
    assert isinstance(tab, MeasuringTab)
    assert isinstance(other, DiscrepancyTab)
    driver.app.window.tabs.setCurrentWidget(tab.widget)
    driver.until(lambda: tab.view.grade.isVisible())
    driver.bot.wait(50)
    driver.click(tab.view.grade)
    assert driver.app.window.tabs.currentWidget() is other.widget
    driver.until(lambda: other.presenter.story is not None, 60_000)
    driver.until(lambda: not other.presenter.busy, 60_000)
    state = other.presenter.state
    assert state.verdict == "What this plan can show"
    assert state.lights
    assert other.view.findings.pages.currentIndex() == 2
    assert not other.view.action_bar.button("find").isEnabled()
    assert other.exporting.propose("pdf") == ""
