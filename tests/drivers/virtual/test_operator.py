"""The operator gets every step of every plan where it belongs, in the time that he says."""

import numpy as np
import pytest

from core.plans.plan import Plan, Step, load_plans
from drivers.virtual.operator import Operator
from drivers.virtual.rig import Rig, RigOptions

PLANS = load_plans()


def let_go_on(rig: Rig, seconds: float) -> None:
    rig.produce(round(seconds * rig.rate_hz))


@pytest.mark.parametrize("name", ["pointer_8", "pointer_16", "accelerometer_4"])
def test_walks_a_plan_of_the_head(name):
    rig = Rig(RigOptions(device="pointer"))
    operator = Operator(rig, PLANS[name], seed=3)
    for step in PLANS[name].steps:
        seconds = operator.goto(step)
        let_go_on(rig, 0.1)
        let_go_on(rig, seconds + 0.1)
        state = rig.state
        assert (state.mount, state.head_deg, state.moving) == (step.mount, step.head_deg, False)
        assert 1.0 < seconds < 15.0


def test_sets_the_rates_of_a_table():
    steps = tuple(Step(k, "", rate_dps=rate) for k, rate in enumerate((-100.0, 0.0, 100.0)))
    plan = Plan("rates", "", "rate_table", "", 30.0, 3.0, (), steps)
    rig = Rig(RigOptions(device="clbdus"))
    operator = Operator(rig, plan)
    for step in steps:
        let_go_on(rig, operator.goto(step) + 0.2)
        assert rig.state.table_dps == step.rate_dps
        assert rig.state.axis == "z"


def test_setting_errors_have_their_deviation_and_the_seed_decides():
    def angles(seed: int) -> list[float]:
        rig = Rig(RigOptions(rate_hz=20.0))
        operator = Operator(rig, PLANS["accelerometer_4"], seed=seed, setting_arcsec=30.0)
        found = []
        for _ in range(20):
            for step in PLANS["accelerometer_4"].steps:
                let_go_on(rig, operator.goto(step) + 0.2)
                found.append(rig.state.head_deg - step.head_deg)
        return found

    errors = np.array(angles(1)) * 3600.0
    assert errors.std() == pytest.approx(30.0, rel=0.25)
    assert abs(errors.mean()) < 10.0
    assert angles(1) == angles(1) != angles(2)
