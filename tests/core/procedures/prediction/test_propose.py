"""What is proposed for a sensor and a rig; dropping and adding positions."""

import pytest

from core.allan.model import NoiseModel
from core.errors import FitError
from core.plans.plan import Step, load_plans
from core.procedures.prediction.bench import HEAD, TABLE, Bench
from core.procedures.prediction.propose import predict, propose, with_positions
from core.samples.run import Conditions

PLANS = load_plans()
LAB = Conditions(g_mps2=9.8106, latitude_deg=50.45)
WHITE = NoiseModel(random_walk=3e-3)
ACCELEROMETER = Bench("accelerometer", WHITE, LAB)


def test_only_what_sensor_and_rig_allow_is_proposed():
    every = {one.method for one in propose(PLANS.values(), ACCELEROMETER)}
    assert every == {"positions", "thermal"}
    x = Bench("accelerometer", WHITE, LAB, axis="x", tools=frozenset({HEAD}))
    assert {one.method for one in propose(PLANS.values(), x)} == {"positions", "tumble"}
    table = Bench("gyro", WHITE, LAB, tools=frozenset({TABLE}))
    assert {one.method for one in propose(PLANS.values(), table)} == {"rate_table"}
    assert propose(PLANS.values(), Bench("gyro", WHITE, LAB, tools=frozenset())) == ()


def test_the_plan_that_determines_most_comes_first_and_the_shortest_of_equals():
    found = [one for one in propose(PLANS.values(), ACCELEROMETER) if one.method == "positions"]
    assert found[0].plan.id == "six_positions"
    assert [len(one.prediction.parameters) for one in found] == sorted(
        (len(one.prediction.parameters) for one in found), reverse=True
    )
    assert found[-1].plan.id == "accelerometer_4"


def test_the_shortest_plan_that_is_good_enough_comes_first():
    easy = propose(PLANS.values(), ACCELEROMETER, {"scale_factor": 1e3})
    assert (easy[0].plan.id, easy[0].reaches) == ("accelerometer_4", True)
    better = propose(PLANS.values(), ACCELEROMETER, {"bias": 3e-4, "cross_axis_x": 0.1})
    assert better[0].reaches
    assert better[0].plan.id == "pointer_16"
    nothing = propose(PLANS.values(), ACCELEROMETER, {"bias": 1e-9})
    assert not nothing[0].reaches
    free = propose(PLANS.values(), ACCELEROMETER, {"second_sine": 1.0})
    assert not any(one.reaches for one in free)


def test_positions_dropped_and_added_change_the_prediction():
    plan = PLANS["accelerometer_8"]
    whole = predict("positions", plan, ACCELEROMETER)
    fewer = with_positions(plan, drop=(5, 7))
    assert [step.number for step in fewer.steps] == [1, 2, 3, 4, 6, 8]
    assert predict("positions", fewer, ACCELEROMETER).u("bias") > whole.u("bias")
    more = with_positions(plan, add=[Step(0, "", "Y_from", 0.0), Step(0, "", "Y_from", 180.0)])
    assert [(step.number, step.group) for step in more.steps[-2:]] == [(9, "Added"), (10, "Added")]
    found = predict("positions", more, ACCELEROMETER)
    assert found.u("scale_factor") == pytest.approx(whole.u("scale_factor") * (4 / 6) ** 0.5)
    half = with_positions(plan, drop=(5, 6, 7, 8))
    assert predict("positions", half, ACCELEROMETER).free == ("cross_axis_x",)


def test_what_makes_no_sense_is_refused():
    with pytest.raises(FitError, match="has no step 9, 11"):
        with_positions(PLANS["accelerometer_8"], drop=(1, 9, 11))
    with pytest.raises(FitError, match="no position is left"):
        with_positions(PLANS["accelerometer_4"], drop=(1, 2, 3, 4))
    with pytest.raises(FitError, match="there is no method 'magic'"):
        predict("magic", PLANS["accelerometer_4"], ACCELEROMETER)
    with pytest.raises(FitError, match="is for a gyro, the sensor is a accelerometer"):
        predict("rate_table", PLANS["rate_table_100"], ACCELEROMETER)
    with pytest.raises(FitError, match="for another method"):
        predict("positions", PLANS["rate_table_100"], ACCELEROMETER)
    with pytest.raises(FitError, match="nothing can be predicted without a record"):
        predict("drift", PLANS["rate_table_100"], Bench("gyro", WHITE, LAB))
