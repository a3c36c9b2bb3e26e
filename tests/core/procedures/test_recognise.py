"""Every wrong position of the practicum's unit is recognised as soon as it can be."""

import numpy as np
import pytest

from core.plans.plan import load_plans
from core.procedures.recognise import Expectation, Nominal, Verdict

G = 9.8106
STEPS = load_plans()["accelerometer_8"].steps
INPUTS = np.array([step.specific_force(G) for step in STEPS])
LABELS = tuple(f"position {step.number}" for step in STEPS)
# Practicum, Table 2.2: a unit with two negative scale factors.
OUTPUTS = np.array(
    [
        [-1092.89, -77.13, 12866.30],
        [-252.76, 12942.89, -370.99],
        [334.90, -308.34, -13329.13],
        [-504.34, -13326.64, -88.55],
        [-1086.04, -82.90, 12867.33],
        [-13478.3, 152.03, -214.92],
        [333.63, -311.28, -13324.92],
        [12715.78, -548.21, -243.23],
    ]
)
SAME = {0: {0, 4}, 4: {0, 4}, 2: {2, 6}, 6: {2, 6}}


def walked(count: int) -> Expectation:
    expectation = Expectation(G, ("x", "y", "z"))
    for place in range(count):
        expectation.learn(INPUTS[place], OUTPUTS[place])
    return expectation


@pytest.mark.parametrize("chosen", range(8))
def test_the_right_position_is_never_accused(chosen: int) -> None:
    found = walked(chosen).recognise(OUTPUTS[chosen], INPUTS, LABELS, chosen)
    assert found.acceptable
    assert not found.text


@pytest.mark.parametrize("chosen", range(8))
def test_a_wrong_position_is_named(chosen: int) -> None:
    """Signs are unknown until an axis has been seen, so its two ends look alike until then."""
    seen_axes = {int(np.argmax(np.abs(INPUTS[place]))) for place in range(chosen)}
    for true in range(8):
        if true in SAME.get(chosen, {chosen}):
            continue
        found = walked(chosen).recognise(OUTPUTS[true], INPUTS, LABELS, chosen)
        axis = int(np.argmax(np.abs(INPUTS[true])))
        mirrored = axis == int(np.argmax(np.abs(INPUTS[chosen]))) and axis not in seen_axes
        assert found.acceptable == mirrored, (chosen, true, found)
        if not mirrored:
            assert found.verdict is Verdict.OTHER_POSITION
            assert true in found.candidates
            assert found.text.startswith("this looks like position")
            assert found.text.endswith(f"not position {chosen + 1}")


def test_position_three_not_four() -> None:
    found = walked(3).recognise(OUTPUTS[2], INPUTS, LABELS, 3)
    assert found.text == "this looks like position 3 or position 7, not position 4"


def test_after_the_first_position_only_those_are_named_that_the_outputs_allow() -> None:
    """The head still stands where it stood; the operator pressed Space without turning it."""
    found = walked(1).recognise(OUTPUTS[0], INPUTS, LABELS, 1)
    assert found.text == "this looks like position 1 or position 5, not position 2"
    for chosen in range(1, 8):
        for true in range(8):
            told = walked(chosen).recognise(OUTPUTS[true], INPUTS, LABELS, chosen)
            assert told.acceptable or chosen not in told.candidates


def test_a_reversed_axis_is_named_when_the_polarity_is_known() -> None:
    nominal = Nominal(np.diag([-1335.0, -1335.0, 1335.0]), np.zeros(3), "certificate")
    expectation = Expectation(G, ("x", "y", "z"), nominal)
    reversed_x = OUTPUTS * [-1.0, 1.0, 1.0]
    found = expectation.recognise(reversed_x[5], INPUTS, LABELS, 5)
    assert found.verdict is Verdict.AXIS_REVERSED
    assert found.text.startswith("X axis reversed")
    assert expectation.recognise(reversed_x[0], INPUTS, LABELS, 0).verdict is Verdict.FITS


def test_an_angle_between_positions_is_no_position() -> None:
    """The head stands at 40 degrees; nothing of the plan is near."""
    halfway = (OUTPUTS[0] * np.cos(np.radians(40)) + OUTPUTS[1] * np.sin(np.radians(40))).round(1)
    for chosen in (1, 2):
        found = walked(chosen).recognise(halfway, INPUTS, LABELS, chosen)
        assert found.verdict is Verdict.NO_POSITION
        assert LABELS[chosen] in found.text


def test_a_single_sensor_of_unknown_axis_claims_nothing_at_first() -> None:
    """Table 1.2: one column, axis unknown."""
    column = np.array([[13185.47], [521.57], [-12872.84], [-595.04]])
    expectation = Expectation(G, ("",))
    for true in range(4):
        found = expectation.recognise(column[true], INPUTS[:4], LABELS[:4], 0)
        assert found.verdict is Verdict.CANNOT_TELL
    for place in (0, 1):
        expectation.learn(INPUTS[place], column[place])
    assert expectation.recognise(column[2], INPUTS[:4], LABELS[:4], 2).verdict is Verdict.FITS
    other = expectation.recognise(column[0], INPUTS[:4], LABELS[:4], 2)
    assert other.verdict is Verdict.OTHER_POSITION
    assert other.candidates == (0,)


def test_fifteen_degree_steps_are_told_apart() -> None:
    steps = load_plans()["clbacc_24"].steps[:25]
    inputs = np.array([step.specific_force(G) for step in steps])
    labels = tuple(f"{step.head_deg:g} deg" for step in steps)
    k = np.array([[-1335.0, -12.8, -72.6], [35.7, -1338.8, 11.7], [1.4, 14.4, 1335.0]])
    outputs = inputs @ k.T + [-378.0, -195.0, -230.0]
    expectation = Expectation(G, ("x", "y", "z"))
    for place in (0, 6, 12):
        expectation.learn(inputs[place], outputs[place])
    found = expectation.recognise(outputs[4], inputs, labels, 3)
    assert found.text == "this looks like 60 deg, not 45 deg"
    assert expectation.recognise(outputs[3], inputs, labels, 3).acceptable


@pytest.mark.parametrize("axes", [("x",), ("y",), ("x", "y")])
def test_sensors_that_begin_across_gravity_are_not_accused(axes: tuple[str, ...]) -> None:
    """Level sensors give their bias alone, which looks like full output until more is known."""
    k = np.array([[-1335.0, -12.8, -72.6], [35.7, -1338.8, 11.7]])
    chosen = ["xy".index(axis) for axis in axes]
    outputs = (INPUTS @ k.T + [-1378.0, 995.0])[:, chosen]
    expectation = Expectation(G, axes)
    for place in range(8):
        found = expectation.recognise(outputs[place], INPUTS, LABELS, place)
        assert found.acceptable, found.text
        expectation.learn(INPUTS[place], outputs[place])
    along, across = (5, 4) if "x" in axes else (1, 0)
    assert not expectation.recognise(outputs[along], INPUTS, LABELS, across).acceptable
