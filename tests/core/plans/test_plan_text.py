"""What is written is read as the same plan, and beside the packaged ones."""

from pathlib import Path

import pytest

from core.errors import FormatError
from core.plans.plan import Plan, Step, load_plan, load_plans
from core.plans.plan_text import plan_text
from core.procedures.prediction.propose import with_positions

PACKAGED = load_plans()


@pytest.mark.parametrize("plan_id", PACKAGED)
def test_every_packaged_plan_comes_back(plan_id: str, tmp_path: Path):
    path = tmp_path / f"{plan_id}.toml"
    path.write_text(plan_text(PACKAGED[plan_id]), encoding="utf-8")
    assert load_plan(path) == PACKAGED[plan_id]


def test_dropped_and_added_positions_keep_number_and_order(tmp_path: Path):
    plan = with_positions(
        PACKAGED["pointer_8"], drop=[2, 14], add=[Step(0, "", "X_from", 45.0), Step(0, "", "Y_to")]
    )
    path = tmp_path / "pointer_8.toml"
    path.write_text(plan_text(plan), encoding="utf-8")
    assert load_plan(path) == plan


def test_titles_may_hold_anything(tmp_path: Path):
    title = 'Стенд "2"\\\n\t±5°'
    plan = Plan("odd", title, "dividing_head", "", 1.5, 0.0, (), (Step(1, title),))
    path = tmp_path / "odd.toml"
    path.write_text(plan_text(plan), encoding="utf-8")
    assert load_plan(path) == plan


def test_own_plans_stand_beside_the_packaged_ones(tmp_path: Path):
    assert load_plans(tmp_path / "absent") == PACKAGED
    plan = with_positions(PACKAGED["accelerometer_4"], drop=[4])
    (tmp_path / "mine.toml").write_text(plan_text(plan), encoding="utf-8")
    found = load_plans(tmp_path)
    assert list(found) == [*PACKAGED, "mine"]
    assert found["mine"].steps == plan.steps
    (tmp_path / "broken.toml").write_text("[plan", encoding="utf-8")
    with pytest.raises(FormatError, match=r"broken\.toml"):
        load_plans(tmp_path)
