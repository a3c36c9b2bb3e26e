"""Bends, asymmetry, hysteresis, dead band: one injected at a time, only its own number moves."""

import json
from pathlib import Path

import numpy as np
import pytest

from core.fit.linear import Rows, fit_sensor
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.procedures.characteristic import (
    Points,
    Shape,
    bends,
    bias_asymmetry,
    hysteresis,
    nonlinearity,
    slopes,
    threshold,
)
from core.samples.run import Conditions

TABLE_3_2 = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))[
    "source001"
]["table_3_2"]
RATES = np.arange(-100.0, 101.0, 20.0)
UP_DOWN = np.concatenate([RATES, RATES[-2::-1]])
K = -79.4


def points(
    x: np.ndarray, y: np.ndarray, se: np.ndarray | None = None, full_scale: float = 100.0
) -> Points:
    none = np.zeros((len(x), 3))
    w = none.copy()
    w[:, 2] = x
    model = SensorModel(Sensor("gyro", "z", "code"), (CATALOGUE["bias"], CATALOGUE["scale_factor"]))
    fit = fit_sensor(model, Stimulus(none, w, none, none), Rows.of(y, se), Conditions())
    came = np.sign(np.diff(x, prepend=np.nan))
    relative = fit.sigma / fit.sigma.max()
    return Points(Shape.of(x, relative, np.nan_to_num(came)), y, fit, full_scale)


def line(x: np.ndarray) -> np.ndarray:
    return -438.0 + K * x


def noise(n: int, sigma: float, seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).normal(0.0, sigma, n)


@pytest.fixture
def table_3_2() -> Points:
    given = TABLE_3_2["input"]
    return points(np.array(given["omega_dps"]), np.array(given["U"]))


def test_nonlinearity_of_table_3_2(table_3_2: Points):
    found = nonlinearity(table_3_2)
    assert abs(found.largest.value) == pytest.approx(TABLE_3_2["max_abs_residual_dps"], rel=1e-7)
    assert found.at == -100.0
    assert abs(found.ppm.value) == pytest.approx(TABLE_3_2["nonlinearity_ppm_of_100dps"], rel=1e-7)
    assert found.full_scale == 100.0


def test_the_straight_line_of_table_3_2_is_rejected(table_3_2: Points):
    quadratic, cubic = bends(table_3_2, "code")
    assert quadratic.statistic == pytest.approx(25.0, abs=0.05)
    assert quadratic.p_value == pytest.approx(0.001, abs=1e-4)
    coefficients = TABLE_3_2["cubic_fit"]["coeffs"]
    assert quadratic.coefficient.value == pytest.approx(coefficients[2], rel=1e-7)
    assert cubic.coefficient.value == pytest.approx(coefficients[3], rel=1e-7)
    assert quadratic.coefficient.unit == "code/(deg/s)^2"
    assert cubic.coefficient.dof == TABLE_3_2["cubic_fit"]["dof"]
    assert cubic.p_value > 0.05


def test_asymmetry_of_table_3_2(table_3_2: Points):
    halves = slopes(table_3_2)
    assert halves is not None
    positive, negative, asymmetry = halves
    golden = TABLE_3_2["asymmetry"]
    assert positive.value == pytest.approx(golden["k_pos"], rel=1e-7)
    assert negative.value == pytest.approx(golden["k_neg"], rel=1e-7)
    assert asymmetry.value == pytest.approx(golden["asymmetry_ppm"], rel=1e-6)
    assert asymmetry.significant
    assert asymmetry.dof == 7


def test_a_parabola_shows_as_a_parabola():
    y = line(RATES) + 3e-4 * RATES**2 + noise(11, 0.05)
    quadratic, cubic = bends(points(RATES, y, np.full(11, 0.05)), "code")
    assert abs(quadratic.coefficient.value - 3e-4) < 3 * quadratic.coefficient.u
    assert quadratic.bend_ppm == pytest.approx(3e-4 * 100.0 / K / 1e-6, rel=0.05)
    assert quadratic.p_value < 1e-6
    assert cubic.p_value > 0.01


def test_a_cubic_shows_as_a_cubic():
    y = line(RATES) + 2e-6 * RATES**3 + noise(11, 0.02)
    quadratic, cubic = bends(points(RATES, y, np.full(11, 0.02)), "code")
    assert abs(cubic.coefficient.value - 2e-6) < 3 * cubic.coefficient.u
    assert cubic.p_value < 1e-6
    assert quadratic.p_value > 0.01


@pytest.mark.parametrize("known", [True, False])
def test_a_straight_line_is_rarely_accused(known: bool):
    rng = np.random.default_rng(2)
    accused = np.zeros(2)
    for _ in range(1500):
        y = line(RATES) + rng.normal(0.0, 0.7, 11)
        terms = bends(points(RATES, y, np.full(11, 0.7) if known else None), "code")
        accused += [term.p_value < 0.05 for term in terms]
    assert np.all((accused > 0.035 * 1500) & (accused < 0.065 * 1500)), accused / 1500


def test_few_rates_test_what_they_can():
    three = np.array([-10.0, 0.0, 10.0])
    assert bends(points(three, line(three) + np.eye(3)[1]), "code") == ()
    (quadratic,) = bends(points(three, line(three) + np.eye(3)[1], np.full(3, 0.1)), "code")
    assert quadratic.power == 2
    twice = np.tile(three, 2)
    assert [t.power for t in bends(points(twice, line(twice) + noise(6, 0.1)), "code")] == [2]


@pytest.mark.parametrize("ppm", [500.0, -500.0])
def test_unequal_slopes_show_as_asymmetry(ppm: float):
    y = line(RATES) + ppm * 1e-6 / 2.0 * K * np.abs(RATES) + noise(11, 0.05)
    halves = slopes(points(RATES, y, np.full(11, 0.05)))
    assert halves is not None
    assert abs(halves[2].value - ppm) < 3 * halves[2].u
    assert abs(halves[2].value - ppm) < 0.05 * 500.0


@pytest.mark.parametrize("known", [True, False])
def test_the_uncertainty_of_the_asymmetry_covers(known: bool):
    rng = np.random.default_rng(3)
    inside = 0
    for _ in range(1500):
        y = line(RATES) + 0.0003 * K * np.abs(RATES) + rng.normal(0.0, 0.7, 11)
        halves = slopes(points(RATES, y, np.full(11, 0.7) if known else None))
        assert halves is not None
        inside += abs(halves[2].value - 600.0) < halves[2].expanded()
    assert 0.93 < inside / 1500 < 0.97


def test_one_sided_rates_have_no_asymmetry():
    x = np.arange(0.0, 101.0, 20.0)
    assert slopes(points(x, line(x) + noise(6, 1.0))) is None
    assert bias_asymmetry(points(x, line(x) + noise(6, 1.0))) is None


def test_a_dead_band_is_a_bias_asymmetry_of_the_other_sign():
    x = np.array([-8, -6, -4, -2, 0, 2, 4, 6, 8], dtype=float)
    width = 1.0
    y = -438.0 + K * np.sign(x) * np.maximum(np.abs(x) - width / 2, 0.0) + noise(9, 0.1)
    found = bias_asymmetry(points(x, y, np.full(9, 0.1)))
    assert found is not None
    assert abs(found.value + width) < 3 * found.u
    assert found.unit == "deg/s"


def test_the_threshold_lies_between_two_tried_rates():
    x = np.array([-8.0, -4, -2, -1, -0.5, 0, 0.5, 1, 2, 4, 8])
    y = -438.0 + K * np.where(np.abs(x) < 1.5, 0.2 * x, x)
    found = threshold(points(x, y))
    assert found is not None
    assert (found.above, found.below) == (1.0, 2.0)


def test_a_threshold_below_all_rates_is_only_bounded():
    found = threshold(points(RATES, line(RATES) + noise(11, 1.0)))
    assert found is not None
    assert (found.above, found.below) == (0.0, 20.0)
    x = np.arange(0.0, 101.0, 20.0)
    assert threshold(points(x, line(x) + noise(6, 1.0))) is None


def test_hysteresis_is_the_difference_between_the_two_ways():
    came = np.concatenate([np.ones(11), -np.ones(10)])
    y = line(UP_DOWN) + 0.5 * 0.08 * K * came + noise(21, 0.05)
    found = hysteresis(points(UP_DOWN, y, np.full(21, 0.05)))
    assert found is not None
    assert abs(found.mean.value - 0.08) < 3 * found.mean.u
    assert found.mean.significant
    assert abs(found.largest.value) >= abs(found.mean.value)


def test_no_hysteresis_none_found():
    rng = np.random.default_rng(4)
    inside = 0
    for _ in range(1000):
        found = hysteresis(points(UP_DOWN, line(UP_DOWN) + rng.normal(0.0, 1.0, 21)))
        assert found is not None
        inside += abs(found.mean.value) < found.mean.expanded()
    assert 0.93 < inside / 1000 < 0.97


def test_one_sweep_shows_no_hysteresis():
    assert hysteresis(points(RATES, line(RATES) + noise(11, 1.0))) is None


def test_full_scale_is_stated_and_used():
    y = line(RATES) + noise(11, 1.0)
    small, large = (nonlinearity(points(RATES, y, full_scale=fs)) for fs in (100.0, 400.0))
    assert small.ppm.value == pytest.approx(4.0 * large.ppm.value)
    assert large.full_scale == 400.0
