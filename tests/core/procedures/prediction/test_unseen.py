"""What a plan cannot see is named, and is named no longer once positions are added."""

import numpy as np
import pytest

from core.allan.model import NoiseModel
from core.plans.plan import Plan, Step, load_plans
from core.procedures.prediction.bench import Bench
from core.procedures.prediction.propose import predict, with_positions
from core.procedures.prediction.unseen import unseen
from core.samples.run import Conditions

PLANS = load_plans()
BENCH = Bench(
    "accelerometer", NoiseModel(random_walk=3e-3), Conditions(g_mps2=9.8106, latitude_deg=50.0)
)


def subjects(method: str, plan: Plan, bench: Bench = BENCH) -> set[str]:
    return {note.subject for note in unseen(method, plan, bench, predict(method, plan, bench))}


def test_four_upright_positions_leave_most_unseen():
    found = subjects("positions", PLANS["accelerometer_4"])
    assert {"free_cross_axis_x", "cubic", "product", "temperature", "drift"} <= found


def test_positions_between_the_upright_ones_show_what_hid():
    four = PLANS["accelerometer_4"]
    between = [Step(0, "", "X_from", angle) for angle in (20.0, 45.0, 110.0, 250.0)]
    found = subjects("positions", with_positions(four, add=between))
    assert not {"cubic", "product", "quadratic"} & found
    assert "free_cross_axis_x" in found


def test_what_is_said_of_k2_and_k3_holds_in_a_fit():
    """The column really lies in the space of the model, or really does not."""
    steps = PLANS["accelerometer_4"].steps
    force = np.array([step.specific_force(9.8106) for step in steps])
    model = np.column_stack([np.ones(4), force[:, 1], force[:, 2]])
    with_square = np.column_stack([model, force[:, 2] ** 2])
    with_cube = np.column_stack([model, force[:, 2] ** 3])
    sees = {
        "quadratic": np.linalg.matrix_rank(with_square, tol=1e-6) == 4,
        "cubic": np.linalg.matrix_rank(with_cube, tol=1e-6) == 4,
    }
    found = subjects("positions", PLANS["accelerometer_4"])
    assert sees == {name: name not in found for name in sees}


def test_a_plan_without_redundancy_says_so():
    plan = with_positions(PLANS["accelerometer_4"], drop=[4])
    notes = unseen("positions", plan, BENCH, predict("positions", plan, BENCH))
    assert any(note.subject == "no_check" and "any reading fits" in note.text for note in notes)


def test_the_overlap_of_a_tumble_shows_drift():
    bench = Bench(
        "accelerometer", NoiseModel(random_walk=3e-3), Conditions(g_mps2=9.8106), axis="x"
    )
    assert "drift" not in subjects("tumble", PLANS["fourier_400"], bench)


@pytest.mark.parametrize("plan", ["gyrocompass_4"])
def test_a_gyrocompass_needs_its_tilt(plan: str):
    gyro = Bench("gyro", NoiseModel(random_walk=1e-5), BENCH.conditions)
    found = subjects("gyrocompass", PLANS[plan], gyro)
    assert "tilt" in found
    assert "drift" not in found


def test_rates_of_both_signs_and_two_sizes_show_a_quadratic_term():
    gyro = Bench("gyro", NoiseModel(random_walk=1e-3), BENCH.conditions)
    table = PLANS["rate_table_100"]
    assert "quadratic" not in subjects("rate_table", table, gyro)
    two = Plan(
        "two",
        "two rates",
        "rate_table",
        "",
        10.0,
        3.0,
        (),
        tuple(Step(n, "", "Z_from", 0.0, rate) for n, rate in enumerate((-50.0, 50.0, -50.0), 1)),
    )
    assert "quadratic" in subjects("rate_table", two, gyro)
