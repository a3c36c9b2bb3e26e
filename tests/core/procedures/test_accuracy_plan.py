"""Plans of an accuracy check: the angle to reach beside the angle to set, free lists."""

import pytest

from core.errors import FitError, FormatError
from core.plans.plan import load_plans
from core.procedures.accuracy_plan import (
    accuracy_plans,
    angles_of_text,
    kind_of,
    wanted_deg,
    with_angles,
)
from core.procedures.angle_errors import PITCH, ROLL

LIST = (0, 30, 60, 80, 100, 120, 150, 180, 210, 240, 260, 280, 300, 330, 360)


@pytest.mark.parametrize("kind", [PITCH, ROLL])
def test_the_practicums_list_is_the_first_and_the_head_runs_against_it(kind):
    plans = accuracy_plans(kind)
    assert next(iter(plans)) == f"{kind}_accuracy"
    assert all(kind_of(plan) == kind for plan in plans.values())
    plan = plans[f"{kind}_accuracy"]
    assert tuple(wanted_deg(plan).values()) == LIST
    assert [step.head_deg for step in plan.steps][:3] == [0.0, 330.0, 300.0]


def test_a_plan_that_sets_neither_is_refused():
    with pytest.raises(FitError, match="pitch is set with X"):
        kind_of(load_plans()["pointer_8"])


@pytest.mark.parametrize("kind", [PITCH, ROLL])
def test_a_free_list_reaches_its_angles(kind):
    plan = with_angles(accuracy_plans(kind)[f"{kind}_accuracy"], (-15.0, 0.5, 45.0, 270.0))
    assert tuple(wanted_deg(plan).values()) == (345.0, 0.5, 45.0, 270.0)
    assert [step.head_deg for step in plan.steps] == [15.0, 359.5, 315.0, 90.0]
    # No legacy row may be taken for one of the practicum's list.
    assert min(step.number for step in plan.steps) > len(LIST)


def test_a_part_of_the_practicums_list_keeps_its_numbers():
    plan = with_angles(accuracy_plans(PITCH)["pitch_accuracy"], (0.0, 60.0, 180.0, 360.0))
    assert [step.number for step in plan.steps] == [1, 3, 8, 15]


def test_no_angles_at_all():
    with pytest.raises(FitError, match="1 to"):
        with_angles(accuracy_plans(ROLL)["roll_accuracy"], ())


@pytest.mark.parametrize(
    ("text", "angles"),
    [
        ("0, 30, 60", (0, 30, 60)),
        ("0,30,60", (0, 30, 60)),
        ("0 30,5 -60", (0, 30.5, -60)),
        (" 0;30°; 60 ", (0, 30, 60)),
        ("45", (45,)),
    ],
)
def test_lists_as_they_are_typed(text, angles):
    assert angles_of_text(text) == angles


@pytest.mark.parametrize("text", ["", " , ", "0, thirty", "0, 400", "nan"])
def test_what_is_no_list(text):
    with pytest.raises(FormatError, match="Angles"):
        angles_of_text(text)
