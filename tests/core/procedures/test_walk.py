"""Which channels a plan is walked by, and how its steps are called."""

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.errors import FitError
from core.plans.plan import load_plans
from core.procedures.earth import level_dps
from core.procedures.gyrocompass import find_north, run_of_headings
from core.procedures.walk import checked_role, label_of, walk_of
from core.samples.block import Channel, SampleBlock
from core.samples.run import Conditions
from core.units import DPH_PER_DPS

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
        ("gyrocompass_4", AHRS, "rate."),
        ("gyrocompass_4", BOARD, "adc."),
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
    base = PLANS["gyrocompass_4"]
    assert label_of(base, base.steps[1]) == "heading 2 (90 deg)"


def test_a_walk_starts_at_the_first_step_with_the_plans_times() -> None:
    walk = walk_of(PLANS["accelerometer_8"], AHRS, 200.0, 9.8106)
    assert walk.status.step == PLANS["accelerometer_8"].steps[0]
    walk.start()
    assert walk.status.remaining_s == pytest.approx(10.0)
    assert np.isclose(walk.status.progress, 0.0)


@pytest.mark.parametrize("role", ["rate.z", "adc.1"])
def test_headings_are_walked_hands_free_and_north_is_found(role: str) -> None:
    """The base turns between the readings; nothing tells one heading from another, or has to."""
    plan, rate, rng = PLANS["gyrocompass_4"], 50.0, np.random.default_rng(4)
    channels = (Channel("w", "deg/h", role),)
    walk = walk_of(plan, channels, rate, 9.8106)
    walk.set_hands_free(True)
    level = level_dps(50.45) * DPH_PER_DPS
    rows: list[tuple[float, float, float]] = []
    count = 0

    def feed(seconds: float, psi: float, turn_dps: float = 0.0) -> None:
        """Rest at an azimuth, or a turn that begins and ends gently."""
        nonlocal count
        blocks, n = round(seconds * 2), round(rate / 2)
        for block in range(blocks):
            w = level * np.cos(np.radians(psi)) + 0.8 + rng.normal(0.0, 0.5, n)
            way = np.pi * (block + np.arange(n) / n) / blocks
            w += turn_dps * DPH_PER_DPS * np.sin(way)
            index = frozen_int(np.arange(count, count + n))
            count += n
            outcome = walk.feed(SampleBlock(channels, index, frozen(w[:, None]), rate))
            if outcome is not None:
                assert outcome.acceptable, outcome.recognition.text
                found = outcome.accumulation
                rows.append((outcome.step.head_deg, float(found.mean[0]), float(found.se[0])))
                walk.accept(outcome)

    for step in plan.steps:
        feed(4.0, 0.0, turn_dps=35.0)
        feed(20.0, 37.3 + step.head_deg)
    headings, means, errors = np.array(rows).T
    assert headings.tolist() == [0.0, 90.0, 180.0, 270.0, 360.0]
    run = run_of_headings(headings, means, "deg/h", se=errors)
    found = find_north(run, Conditions(latitude_deg=50.45))
    assert found.heading.low < 37.3 < found.heading.high
    assert found.heading.value == pytest.approx(37.3, abs=0.5)
