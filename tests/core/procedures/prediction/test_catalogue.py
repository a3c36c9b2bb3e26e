"""Every method says what it gives and needs, and has its page."""

from pathlib import Path

import pytest

from core.allan.model import NoiseModel
from core.errors import FitError, RankDeficient
from core.plans.plan import load_plans
from core.procedures.prediction.bench import TOOLS, Bench
from core.procedures.prediction.catalogue import METHODS
from core.samples.run import Conditions

ROOT = Path(__file__).parents[4]
PLANS = load_plans()
LAB = Conditions(g_mps2=9.8106, latitude_deg=50.45)


@pytest.mark.parametrize("name", METHODS)
def test_every_method_explains_itself(name: str):
    method = METHODS[name]
    assert method.gives
    assert method.needs
    assert set(method.tools) <= set(TOOLS)
    assert (ROOT / "docs" / "methods" / f"{method.page}.md").is_file()


@pytest.mark.parametrize(
    ("name", "plan", "axis"),
    [
        ("positions", "six_positions", "x"),
        ("tumble", "fourier_400", "x"),
        ("thermal", "thermal_8", "y"),
        ("rate_table", "rate_table_xyz", "z"),
        ("g_sensitivity", "g_sensitivity_8", "z"),
        ("gyrocompass", "gyrocompass_4", "x"),
    ],
)
def test_every_method_predicts_from_a_packaged_plan(name: str, plan: str, axis: str):
    method = METHODS[name]
    assert method.predict is not None
    found = method.predict(PLANS[plan], Bench(method.kind, NoiseModel(random_walk=1e-3), LAB, axis))
    assert found.free == ()
    assert all(one.u > 0 for one in found.parameters)


def test_g_sensitivity_names_what_four_positions_leave_free():
    bench = Bench("gyro", NoiseModel(random_walk=1e-3), LAB)
    method = METHODS["g_sensitivity"]
    assert method.predict is not None
    assert method.predict(PLANS["g_sensitivity_4"], bench).free == ("g_sensitivity_x",)


def test_a_tumble_needs_one_mount_across_the_axis_and_angles_between_the_quarters():
    tumble = METHODS["tumble"].predict
    assert tumble is not None
    bench = Bench("accelerometer", NoiseModel(random_walk=1e-3), LAB, axis="x")
    with pytest.raises(FitError, match="one mount"):
        tumble(PLANS["fourier_flip"], bench)
    with pytest.raises(FitError, match="along the shaft"):
        tumble(PLANS["accelerometer_4"], bench)
    across = Bench("accelerometer", NoiseModel(random_walk=1e-3), LAB, axis="z")
    with pytest.raises(RankDeficient, match="invisible"):
        tumble(PLANS["accelerometer_4"], across)


def test_a_gyrocompass_needs_a_latitude_that_is_no_pole():
    compass = METHODS["gyrocompass"].predict
    assert compass is not None
    for conditions in (Conditions(), Conditions(latitude_deg=90.0)):
        with pytest.raises(FitError, match="no pole"):
            compass(PLANS["gyrocompass_4"], Bench("gyro", NoiseModel(random_walk=1e-5), conditions))
