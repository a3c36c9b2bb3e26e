"""The table of lab 6 from the practicum's own numbers, with cells that stay empty."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError
from core.fit.estimate import Estimate
from core.procedures.comparison import NOT_MEASURED, ROWS, Gyro, compare_gyros, difference
from core.procedures.g_sensitivity import GSensor, fit_g_sensitivity
from core.procedures.rate_table import RateSensor, calibrate_rate_table
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))[
    "source001"
]


def run_of(test: str, y: np.ndarray, rates: np.ndarray) -> Run:
    n = len(y)
    return plain_run(
        test=test,
        sensor="gyro",
        device="G",
        channels=("gyro_1",),
        axes=("z",),
        y=y,
        mount=("X_from",) * n if test != "rate_table" else ("",) * n,
        head_deg=np.arange(n) * 90.0,
        set_rate_dps=rates,
    )


@pytest.fixture(scope="module")
def rate() -> RateSensor:
    rates, u = (np.array(GOLDEN["table_3_2"]["input"][key]) for key in ("omega_dps", "U"))
    return calibrate_rate_table(run_of("rate_table", u, rates), Conditions()).sensors[0]


@pytest.fixture(scope="module")
def head(rate: RateSensor) -> GSensor:
    u = np.array(GOLDEN["table_3_3"]["input"]["U"])
    run = run_of("static_positions", u, np.full(4, np.nan))
    slope = {"gyro_1": rate.line.slope}
    return fit_g_sensitivity(run, Conditions(g_mps2=9.8106), scale_factors=slope).sensors[0]


def test_the_table_of_lab_6(rate: RateSensor, head: GSensor):
    walk = Estimate(0.02, 0.001, math.inf, "deg/s/sqrt(Hz)")
    cvg = Gyro("CVG-25", bias_instability=Estimate(1e-5, math.nan, 0.0, "deg/s"))
    table = compare_gyros([Gyro("ADXRS610", rate, head, walk), cvg])
    assert table.columns == ("ADXRS610", "CVG-25")
    cells = {row.id: row.cells for row in table.rows}
    assert list(cells) == [row[0] for row in ROWS]
    assert cells["scale_factor"][0].value == pytest.approx(-79.378668, rel=1e-7)
    assert cells["g_sensitivity"][0].value == pytest.approx(-0.014703005, rel=1e-7)
    assert cells["g_sensitivity"][0].unit == "(deg/s)/(m/s^2)"
    assert cells["bias"][0].value == pytest.approx(5.5189089, rel=1e-7)
    assert abs(cells["nonlinearity"][0].value) == pytest.approx(252.3577, rel=1e-6)
    assert cells["asymmetry"][0].value == pytest.approx(850.93639, rel=1e-6)
    assert cells["random_walk"] == (walk, None)
    heading, *lines = table.texts()
    assert heading == ["", "ADXRS610", "CVG-25"]
    assert lines[0] == ["Scale factor, code/(deg/s)", "-79.3787 +- 0.014", NOT_MEASURED]
    assert lines[-1] == ["Bias instability, deg/s", NOT_MEASURED, "1e-05 (no uncertainty)"]


def test_a_gyro_without_a_table_run_takes_its_bias_from_the_head(head: GSensor):
    gyro = Gyro("G", head=head)
    bias = gyro.quantity("bias")
    assert bias is not None
    assert bias.value == pytest.approx(9.0457552, rel=1e-6)
    assert gyro.quantity("nonlinearity") is None
    assert Gyro("empty").quantity("g_sensitivity") is None
    with pytest.raises(KeyError):
        gyro.quantity("colour")


def test_the_best_is_marked_where_small_is_better():
    def gyro(name: str, walk: float, unit: str = "deg/s/sqrt(Hz)") -> Gyro:
        return Gyro(name, random_walk=Estimate(walk, walk / 10, math.inf, unit))

    walks = compare_gyros([gyro("a", 0.02), gyro("b", 0.005), Gyro("c")]).rows[5]
    assert walks.best == 1
    assert compare_gyros([gyro("a", 0.02), Gyro("c")]).rows[5].best == -1
    assert compare_gyros([gyro("a", 0.02), gyro("b", 1.0, "deg/rth")]).rows[5].best == -1


def test_scale_factors_have_no_best(rate: RateSensor):
    table = compare_gyros([Gyro("a", rate), Gyro("b", rate)])
    assert table.rows[0].best == -1


def test_names_must_tell_the_gyros_apart():
    with pytest.raises(FitError, match="same name"):
        compare_gyros([Gyro("a"), Gyro("a")])
    with pytest.raises(FitError, match="no gyro"):
        compare_gyros([])


def test_a_difference_counts_in_its_own_uncertainty():
    one, other = Estimate(5.0, 0.3, 9.0, "V"), Estimate(4.0, 0.4, 9.0, "V")
    assert difference(one, other) == pytest.approx(2.0)
    with pytest.raises(FitError, match="V and code"):
        difference(one, Estimate(4.0, 0.4, 9.0, "code"))
