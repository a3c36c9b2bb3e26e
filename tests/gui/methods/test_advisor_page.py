"""The page Which procedure?: plans for the rig, steps ticked off and added, the plan opened."""

import json
import time
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.plans.plan import Plan, load_plan, load_plans
from gui.advisor.page import AdvisorPage
from gui.methods.tab import MethodsTab


@pytest.fixture
def page(tab: MethodsTab, qtbot: QtBot) -> AdvisorPage:
    tab.open("advisor")
    made = tab.pages["advisor"]
    assert isinstance(made, AdvisorPage)
    done(made, qtbot)
    return made


def done(page: AdvisorPage, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not page.presenter._busy, timeout=20_000)


def take(page: AdvisorPage, plan_id: str, qtbot: QtBot) -> None:
    keys = [row.key[1] for row in page.presenter.state.proposals]
    page.content.proposals.setCurrentRow(keys.index(plan_id))
    done(page, qtbot)


def u(page: AdvisorPage, name: str) -> float:
    after = page.presenter.advised.after
    assert after is not None
    return after.u(name)


def tick(page: AdvisorPage, number: int, on: bool, qtbot: QtBot) -> None:
    steps = page.content.steps
    rows = [steps.item(i) for i in range(steps.count())]
    item = next(row for row in rows if row.data(Qt.ItemDataRole.UserRole) == number)
    item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
    done(page, qtbot)


def test_the_best_plan_for_the_rig_stands_first_with_its_prediction(page: AdvisorPage):
    state = page.presenter.state
    assert state.current == state.proposals[0].key
    assert state.frame.findings is not None
    table = state.frame.findings.tables[0]
    assert table.rows[0][0] == "U0, m/s²"
    assert len(table.header) == 3
    assert page.content.proposals.count() == len(state.proposals) > 4


def test_without_its_tool_a_plan_is_not_proposed(page: AdvisorPage, qtbot: QtBot):
    page.side.tools["climate chamber"].setChecked(False)
    done(page, qtbot)
    assert "thermal" not in {row.key[0] for row in page.presenter.state.proposals}
    page.side.tools["dividing head"].setChecked(False)
    done(page, qtbot)
    state = page.presenter.state
    assert state.proposals == ()
    assert "tools" in state.frame.hint
    assert not page.widget.action_bar.button("open").isEnabled()


def test_a_gyro_gets_other_plans_and_other_noise(page: AdvisorPage, qtbot: QtBot):
    page.side.kind.setCurrentIndex(1)
    done(page, qtbot)
    state = page.presenter.state
    assert {row.key[0] for row in state.proposals} == {
        "rate_table",
        "g_sensitivity",
        "gyrocompass",
    }
    assert page.side.noise.fields[0].value() == pytest.approx(0.01, abs=1e-4)
    assert state.on_table


def test_a_step_less_makes_the_prediction_worse_and_a_step_more_better(
    page: AdvisorPage, qtbot: QtBot
):
    take(page, "accelerometer_8", qtbot)
    whole = u(page, "bias")
    tick(page, 3, False, qtbot)
    fewer = u(page, "bias")
    assert fewer > 1.05 * whole
    table = page.presenter.state.frame.findings.tables[0]
    assert table.header[2] == "whole plan"
    page.content.mount.setCurrentText("X_from")
    page.content.value.setValue(180.0)
    page.content.add.click()
    done(page, qtbot)
    assert u(page, "bias") == pytest.approx(whole, rel=1e-6)
    page.presenter.act("restore")
    done(page, qtbot)
    assert u(page, "bias") == pytest.approx(whole, rel=1e-12)
    assert len(page.presenter.state.frame.findings.tables[0].header) == 3


def test_an_added_step_that_is_ticked_off_goes_altogether(page: AdvisorPage, qtbot: QtBot):
    take(page, "accelerometer_8", qtbot)
    page.presenter.add("X_from", 45.0)
    done(page, qtbot)
    assert page.presenter.state.steps[-1].number == -1
    tick(page, -1, False, qtbot)
    assert page.presenter.choices.added == ()


def test_a_plan_that_determines_too_little_says_what_stays_free(page: AdvisorPage, qtbot: QtBot):
    take(page, "accelerometer_4", qtbot)
    for number in (2, 3, 4):
        tick(page, number, False, qtbot)
    advised = page.presenter.advised
    assert advised.after is None
    findings = page.presenter.state.frame.findings
    assert findings is not None
    assert findings.notes[0].text == advised.why != ""
    assert not page.widget.action_bar.button("open").isEnabled()


def test_what_the_plan_cannot_see_changes_with_the_steps(page: AdvisorPage, qtbot: QtBot):
    take(page, "accelerometer_4", qtbot)

    def subjects() -> set[str]:
        return {note.subject for note in page.presenter.state.frame.findings.notes}

    assert "cubic" in subjects()
    for angle in (20.0, 110.0, 250.0):
        page.presenter.add("X_from", angle)
        done(page, qtbot)
    assert "cubic" not in subjects()


def test_a_tick_is_answered_within_a_tenth_of_a_second(page: AdvisorPage, qtbot: QtBot):
    take(page, "clbacc_24", qtbot)
    times = []
    for number in (2, 3, 5, 6, 8):
        begin = time.perf_counter()
        page.presenter.keep(number, False)
        done(page, qtbot)
        times.append(time.perf_counter() - begin)
    assert min(times) < 0.1


def test_longer_accumulation_helps_until_the_head_limits(page: AdvisorPage, qtbot: QtBot):
    page.presenter.set_noise((3e-2, 0.0, 0.0))
    done(page, qtbot)
    take(page, "accelerometer_8", qtbot)
    before = u(page, "bias")
    page.side.accumulation.setValue(100.0)
    done(page, qtbot)
    assert 0.25 * before < u(page, "bias") < 0.5 * before


def test_an_unchanged_plan_is_handed_over_as_it_is(
    tab: MethodsTab, page: AdvisorPage, opened: list[Plan], qtbot: QtBot
):
    take(page, "accelerometer_8", qtbot)
    page.widget.action_bar.button("open").click()
    assert opened == [load_plans()["accelerometer_8"]]
    assert not (tab.root / "plans").exists()


def test_a_changed_plan_is_saved_under_a_name_of_its_own(
    tab: MethodsTab, page: AdvisorPage, opened: list[Plan], qtbot: QtBot
):
    take(page, "accelerometer_8", qtbot)
    tick(page, 3, False, qtbot)
    page.presenter.add("X_from", 45.0)
    done(page, qtbot)
    page.widget.action_bar.button("open").click()
    (plan,) = opened
    assert tab.messages.current is None
    assert plan.id == "accelerometer_8_own1"
    assert load_plan(tab.root / "plans" / "accelerometer_8_own1.toml") == plan
    assert [step.number for step in plan.steps] == [1, 2, 4, 5, 6, 7, 8, 9]
    tick(page, 5, False, qtbot)
    page.widget.action_bar.button("open").click()
    assert opened[1].id == "accelerometer_8_own2"


def test_no_tab_for_the_plan_is_told(tab: MethodsTab, page: AdvisorPage, qtbot: QtBot):
    page.side.kind.setCurrentIndex(1)
    done(page, qtbot)
    take(page, "gyrocompass_4", qtbot)
    page.presenter.act("open")
    assert tab.messages.current is not None
    assert "headings" in tab.messages.current.meaning


def test_a_damaged_plan_of_ones_own_is_told(unseen_tab: MethodsTab, qtbot: QtBot):
    tab = unseen_tab
    (tab.root / "plans").mkdir()
    (tab.root / "plans" / "bad.toml").write_text("[plan", encoding="utf-8")
    tab.open("advisor")
    page = tab.pages["advisor"]
    assert isinstance(page, AdvisorPage)
    done(page, qtbot)
    assert tab.messages.current is not None
    assert "bad.toml" in tab.messages.current.meaning
    assert page.presenter.state.proposals


def test_without_noise_it_asks_for_it(page: AdvisorPage, qtbot: QtBot):
    page.presenter.set_noise((0.0, 0.0, 0.0))
    done(page, qtbot)
    assert "white noise N" in page.presenter.state.frame.hint


def test_what_is_decided_while_it_computes_is_not_lost(page: AdvisorPage, qtbot: QtBot):
    presenter = page.presenter
    for pause in (1.0, 2.0, 3.0):
        presenter.decide(replace(presenter.choices, pause_s=pause))
    done(page, qtbot)
    assert presenter.advised.choices.pause_s == 3.0


def test_the_prediction_is_exported(page: AdvisorPage, tmp_path: Path):
    page.exporting.export("json", str(tmp_path / "p.json"))
    data = json.loads((tmp_path / "p.json").read_text("utf-8"))
    assert data["prediction"]["parameters"][0]["u"] > 0
    assert [one["subject"] for one in data["unseen"]]
