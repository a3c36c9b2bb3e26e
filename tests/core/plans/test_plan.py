"""Plan files: the packaged ones hold the practicum's lists, damaged ones are refused by key."""

from pathlib import Path

import numpy as np
import pytest

from core.errors import FormatError
from core.plans.plan import Plan, Step, load_plan, load_plans, plan_from_dict

PLANS = load_plans()
ANGLES = [0, 30, 60, 80, 100, 120, 150, 180, 210, 240, 260, 280, 300, 330, 360]
"""Practicum, fig. 2.6."""


def test_every_packaged_plan_can_be_read():
    assert set(PLANS) >= {
        "accelerometer_8",
        "pointer_16",
        "rate_table_100",
        "rate_table_cvg40",
        "rate_table_up_down",
        "rate_table_xyz",
        "g_sensitivity_4",
        "g_sensitivity_8",
        "pitch_accuracy",
        "roll_accuracy",
    }
    for name, plan in PLANS.items():
        assert plan.id == name
        assert plan.steps
        assert plan.accumulation_s > 0


def test_eight_positions_are_table_2_1():
    force = [step.specific_force(1.0) for step in PLANS["accelerometer_8"].steps]
    expected = [
        [0, 0, 1], [0, -1, 0], [0, 0, -1], [0, 1, 0],
        [0, 0, 1], [1, 0, 0], [0, 0, -1], [-1, 0, 0],
    ]  # fmt: skip
    assert np.array_equal(force, expected)


def test_rates_of_the_practicum():
    rates = [step.rate_dps for step in PLANS["rate_table_100"].steps]
    assert rates == list(range(-100, 101, 20))
    assert [step.rate_dps for step in PLANS["rate_table_cvg40"].steps] == [-40, -20, 0, 20, 40]
    assert {step.axis for step in PLANS["rate_table_100"].steps} == {"z"}
    assert {step.mount for step in PLANS["rate_table_100"].steps} == {"Z_from"}


def test_the_hysteresis_plan_comes_to_every_rate_from_both_sides():
    rates = np.array([step.rate_dps for step in PLANS["rate_table_up_down"].steps])
    came = np.sign(np.diff(rates))
    for rate in range(-80, 81, 20):
        ways = set(came[np.flatnonzero(rates[1:] == rate)])
        assert {-1.0, 1.0} <= ways


def test_three_axes_by_re_mounting():
    axes = [step.axis for step in PLANS["rate_table_xyz"].steps]
    assert axes == ["x"] * 7 + ["y"] * 7 + ["z"] * 7


@pytest.mark.parametrize("plan", ["pitch_accuracy", "roll_accuracy"])
def test_accuracy_plans_go_through_the_angles_of_the_practicum(plan: str):
    angles = []
    for step in PLANS[plan].steps:
        x, y, z = step.specific_force(1.0)
        angle = np.arctan2(y, z) if plan == "pitch_accuracy" else np.arctan2(-x, z)
        angles.append(round(np.rad2deg(angle)) % 360)
    assert angles == [angle % 360 for angle in ANGLES]


def test_steps_are_found_by_the_number_that_operators_know():
    plan = PLANS["pointer_8"]
    assert plan.step(14).head_deg == 90.0
    assert plan.step(14).mount == "Y_from"
    with pytest.raises(KeyError):
        plan.step(5)


def test_a_free_list_replaces_the_steps():
    step = Step(1, "free", "X_from", 37.5)
    plan = PLANS["accelerometer_4"].with_steps((step,))
    assert plan.steps == (step,)
    assert plan.test == "dividing_head"


def test_a_step_knows_the_rate_of_the_earth():
    step = PLANS["g_sensitivity_4"].steps[0]
    assert step.earth_rate(90.0)[2] * 3600.0 == pytest.approx(15.041, abs=1e-3)


def document(**changes: object) -> dict[str, object]:
    head = {"title": "t", "test": "dividing_head", "accumulation_s": 10}
    group = {"title": "g", "mount": "X_from", "head_deg": [0, 90]}
    for key, value in changes.items():
        table, _, name = key.partition("__")
        (head if table == "plan" else group)[name] = value
    return {"plan": head, "group": [group]}


def plan_of(**changes: object) -> Plan:
    return plan_from_dict(document(**changes), "p", "p.toml")


def test_numbers_go_on_through_the_groups_unless_they_are_given():
    assert [step.number for step in plan_of().steps] == [1, 2]
    assert [step.number for step in plan_of(group__numbers=[7, 9]).steps] == [7, 9]


def test_a_mount_on_the_table_names_the_axis_that_turns():
    plan = plan_of(
        plan__test="rate_table", group__head_deg=[], group__rates_dps=[5], group__mount="Y_to"
    )
    assert (plan.steps[0].axis, plan.steps[0].mount) == ("y", "Y_to")


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"plan__test": "tumble"}, "tumble"),
        ({"plan__title": ""}, "title"),
        ({"plan__accumulation_s": 0}, "above zero"),
        ({"plan__accumulation_s": "10"}, "no number"),
        ({"plan__settle_s": True}, "settle_s"),
        ({"plan__temperatures_c": 20}, "list of numbers"),
        ({"group__mount": "X"}, "unknown mount"),
        ({"group__head_deg": []}, "either head_deg or rates_dps"),
        ({"group__rates_dps": [1]}, "either head_deg or rates_dps"),
        ({"group__head_deg": ["a"]}, "'a'"),
        ({"group__numbers": [1]}, "1 numbers for 2 steps"),
        ({"group__numbers": [1, 1]}, "used twice"),
    ],
)
def test_a_damaged_plan_is_refused_by_file_and_key(changes: dict[str, object], says: str):
    with pytest.raises(FormatError, match=says) as raised:
        plan_of(**changes)
    assert raised.value.path == "p.toml"


@pytest.mark.parametrize(
    "broken", [{}, {"plan": 3, "group": []}, {"plan": document()["plan"], "group": []}]
)
def test_a_plan_without_its_tables_is_refused(broken: dict[str, object]):
    with pytest.raises(FormatError):
        plan_from_dict(broken, "p", "p.toml")


def test_what_is_no_toml_is_refused(tmp_path: Path):
    path = tmp_path / "bad.toml"
    path.write_text("[plan\n", encoding="utf-8")
    with pytest.raises(FormatError, match="not TOML"):
        load_plan(path)


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"\xff\xfe[plan]", "cannot be read"),
        (b"a = " + b"[" * 5000, "not TOML"),
        (b"a = " + b"1" * 5000, "not TOML"),
    ],
)
def test_a_file_that_is_no_text_is_no_plan(tmp_path: Path, content: bytes, why: str):
    path = tmp_path / "a.toml"
    path.write_bytes(content)
    with pytest.raises(FormatError, match=why):
        load_plan(path)


@pytest.mark.parametrize(
    ("group", "why"),
    [
        (1, "as a table"),
        ({"title": "A", "head_deg": [float("nan")]}, "nan, which is no number"),
        ({"title": "A", "head_deg": [10**400]}, "which is no number"),
        ({"title": "A", "head_deg": [0.0], "numbers": [float("inf")]}, "inf, which is no number"),
    ],
)
def test_a_group_that_is_none(group: object, why: str):
    head = {"title": "T", "test": "dividing_head", "accumulation_s": 7.0}
    with pytest.raises(FormatError, match=why):
        plan_from_dict({"plan": head, "group": [group]}, "a", "a.toml")
