"""Which channels a plan is walked by, and how its steps are called."""

import numpy as np
import pytest

from core.errors import FitError
from core.plans.plan import load_plans
from core.procedures.walk import checked_role, label_of, walk_of
from core.samples.block import Channel

PLANS = load_plans()
AHRS = tuple(Channel(r, "code", r) for r in ("rate.x", "acc.x", "acc.y", "acc.z", "temp"))
BOARD = (Channel("U1", "code", "adc.1"), Channel("T1", "code", "temp.adc.1"))


@pytest.mark.parametrize(
    ("plan", "channels", "role"),
    [
        ("accelerometer_8", AHRS, "acc."),
        ("accelerometer_8", BOARD, "adc."),
        ("rate_table_100", AHRS, "rate."),
        ("rate_table_100", BOARD, "adc."),
    ],
)
def test_a_plan_is_walked_by_what_it_moves(
    plan: str, channels: tuple[Channel, ...], role: str
) -> None:
    assert checked_role(PLANS[plan], channels) == role


def test_a_device_without_sensors_is_refused_in_words() -> None:
    with pytest.raises(FitError, match="no sensor output"):
        walk_of(PLANS["accelerometer_8"], (Channel("t", "degC", "temp"),), 100.0, 9.8106)


def test_steps_are_called_as_operators_call_them() -> None:
    head, table = PLANS["accelerometer_8"], PLANS["rate_table_100"]
    assert label_of(head, head.steps[2]) == "position 3 (180 deg)"
    assert label_of(table, table.steps[1]) == "rate 2 (-80 deg/s)"


def test_a_walk_starts_at_the_first_step_with_the_plans_times() -> None:
    walk = walk_of(PLANS["accelerometer_8"], AHRS, 200.0, 9.8106)
    assert walk.status.step == PLANS["accelerometer_8"].steps[0]
    walk.start()
    assert walk.status.remaining_s == pytest.approx(10.0)
    assert np.isclose(walk.status.progress, 0.0)
