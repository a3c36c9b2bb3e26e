"""Plans of what to measure next: opened, kept, and those that are none."""

from dataclasses import replace
from pathlib import Path

import pytest

from core.discrepancy.result import NextMeasurement
from core.errors import StorageError
from core.plans.plan import Plan, load_plans
from gui.discrepancy.cards import following_of, measurements_of
from gui.discrepancy.follow_up import FollowUp, keep_plan, plan_of
from gui.discrepancy.working import Story
from gui.messages import Messages


def test_a_kept_plan_is_one_of_the_user_afterwards(story: Story, tmp_path: Path):
    plan = measurements_of(story)[0].plan
    assert isinstance(plan, Plan)
    path = keep_plan(plan, "PW 09", tmp_path / "plans")
    assert keep_plan(plan, "PW 09", tmp_path / "plans") == path
    own = load_plans(tmp_path / "plans")
    kept = own[path.stem]
    assert kept.steps == plan.steps
    assert kept.test == plan.test
    assert kept.title.endswith("(PW 09)")
    other = keep_plan(replace(plan, settle_s=plan.settle_s + 1.0), "PW 09", tmp_path / "plans")
    assert other != path
    assert len(load_plans(tmp_path / "plans")) == len(own) + 1


def test_a_folder_that_cannot_be_made_is_told(story: Story, tmp_path: Path):
    (tmp_path / "plans").write_text("", encoding="utf-8")
    plan = plan_of(measurements_of(story)[0])
    assert plan is not None
    with pytest.raises(StorageError):
        keep_plan(plan, "A1", tmp_path / "plans")


def test_a_profile_over_time_has_no_plan_to_open(story: Story, tmp_path: Path, qapp: object):
    proposed = story.proposed
    assert proposed is not None
    first = proposed.next_measurements[0]
    profile = replace(first, title="Heat by 10 degrees", plan=None, minutes=90.0)
    assert isinstance(profile, NextMeasurement)
    whole = replace(story, proposed=replace(proposed, next_measurements=(profile, first)))
    shown, other = following_of(whole)
    assert (shown.title, shown.facts, shown.opens) == ("Heat by 10 degrees", "90 min", False)
    assert shown.chance == first.probability
    assert other.opens
    opened: list[Plan] = []
    messages = Messages()

    def take(plan: Plan) -> bool:
        opened.append(plan)
        return False

    follow_up = FollowUp(lambda: whole, take, lambda: tmp_path, messages)
    follow_up.open(0)
    follow_up.keep(0)
    assert opened == []
    assert not (tmp_path / "plans").exists()
    assert messages.current is None
    follow_up.open(1)
    assert len(opened) == 1
    assert messages.current is not None
    assert "No tab" in messages.current.what
    follow_up.keep(1)
    assert messages.current is not None
    assert "kept" in messages.current.what
    assert len(list((tmp_path / "plans").glob("*.toml"))) == 1
