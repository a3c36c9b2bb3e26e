"""Nonlinear effects by their formulas, in g and deg/s, along the axis that a sensor really has."""

import numpy as np
import pytest

from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.nonlinear import CrossAxisSquare, CrossCoupling, Saturation
from core.model.catalogue.terms import MEMORIES, hours, own, previous, setups, small_unit, sweeps
from core.model.effect import Sensor
from core.model.stimulus import Stimulus
from core.units import STANDARD_GRAVITY

A = STANDARD_GRAVITY * np.array([[0.0, 0.6, 0.8], [0.5, -0.5, -0.7], [0.0, 0.0, 1.0]])
STIMULUS = Stimulus(A, A, 0.0 * A, 0.0 * A)
K = 3.0 / STANDARD_GRAVITY
Z = Sensor("accelerometer", "z", "V", (0.0, 0.0, K))
GYRO = Sensor("gyro", "z", "V", (0.0, 0.0, -2.0))


@pytest.mark.parametrize(
    ("name", "shape"),
    [
        ("second_order_nonlinearity", lambda x: x**2),
        ("third_order_nonlinearity", lambda x: x**3),
        ("odd_quadratic_nonlinearity", lambda x: x * np.abs(x)),
        ("scale_factor_asymmetry", lambda x: np.abs(x) / 2.0),
        ("bias_asymmetry", lambda x: np.sign(x) / 2.0),
    ],
)
def test_one_unit_of_each_is_a_thousandth_of_a_g_at_one_g(name: str, shape):
    x = A[:, 2] / STANDARD_GRAVITY
    columns = CATALOGUE[name].columns(STIMULUS, Z)
    assert columns[:, 0] == pytest.approx(3.0 * 1e-3 * shape(x))


def test_on_a_gyro_they_are_stated_in_degrees_a_second_and_turn_with_its_sign():
    w = A[:, 2]
    second = CATALOGUE["second_order_nonlinearity"]
    assert second.columns(STIMULUS, GYRO)[:, 0] == pytest.approx(-2.0 * w**2)
    assert small_unit(GYRO, 2) == "deg/s/(deg/s)^2"
    assert CATALOGUE["dead_band"].columns(STIMULUS, GYRO)[:, 0] == pytest.approx(2.0 * np.sign(w))
    asymmetry = CATALOGUE["scale_factor_asymmetry"].columns(STIMULUS, GYRO)[:, 0]
    assert asymmetry == pytest.approx(-1e-6 * np.abs(w))


def test_a_sensor_that_stands_askew_feels_along_its_own_axis():
    askew = Sensor("accelerometer", "z", "V", (0.02 * K, 0.0, K))
    assert own(STIMULUS, askew) == pytest.approx((A[:, 2] + 0.02 * A[:, 0]) / STANDARD_GRAVITY)


def test_squares_and_products_across_the_axis():
    a = A / STANDARD_GRAVITY
    (x, y) = CrossAxisSquare().instances(STIMULUS, Z)
    assert x.columns(STIMULUS, Z)[:, 0] == pytest.approx(3e-3 * a[:, 0] ** 2)
    assert y.columns(STIMULUS, Z)[:, 0] == pytest.approx(3e-3 * a[:, 1] ** 2)
    yz = CrossCoupling("yz")
    assert yz.columns(STIMULUS, Z)[:, 0] == pytest.approx(3e-3 * a[:, 1] * a[:, 2])
    assert [p.name for p in yz.parameters(Z)] == ["product_yz"]


def test_saturation_takes_away_what_is_beyond_the_level_on_its_side():
    x = A[:, 2] / STANDARD_GRAVITY
    high, low, both = (Saturation(0.75, side).columns(STIMULUS, Z)[:, 0] for side in (1, -1, 0))
    assert high == pytest.approx(-0.03 * np.maximum(x - 0.75, 0.0))
    assert low == pytest.approx(0.0 * x)
    assert Saturation(0.6, 0).columns(STIMULUS, Z)[1, 0] == pytest.approx(0.03 * 0.1)
    assert np.allclose(both, high)
    near, far = Saturation(0.75, 1, 0.1).near(0.5)
    assert (near.shape[0][1], far.shape[0][1]) == pytest.approx((0.70, 0.80))


def columns(**given: list[float]) -> Stimulus:
    n = len(next(iter(given.values())))
    return Stimulus(
        *np.zeros((4, n, 3)), {name: np.array(values, float) for name, values in given.items()}
    )


def test_mountings_and_sweeps_are_counted_as_they_come():
    rows = columns(
        mount=[0, 0, 0, 0, 1, 1, 0], run=[1, 1, 1, 1, 1, 2, 2], head_deg=[0, 90, 0, 90, 0, 90, 0]
    )
    assert setups(rows).tolist() == [0, 0, 0, 0, 1, 1, 2]
    assert sweeps(rows).tolist() == [0, 0, 1, 1, 2, 3, 4]


def test_the_row_before_is_known_as_far_as_the_memory_reaches():
    rows = columns(mount=[0, 0, 0, 1, 1], run=[1, 1, 2, 2, 2])
    before = {memory: previous(rows, memory).tolist() for memory in MEMORIES}
    assert before == {
        "all": [0, 0, 1, 2, 3],
        "mounting": [0, 0, 1, 3, 3],
        "run": [0, 0, 2, 3, 3],
    }


def test_time_is_counted_in_hours_from_the_first_row():
    assert hours(columns(t_s=[100.0, 3700.0])).tolist() == [0.0, 1.0]
    assert hours(columns(run=[1.0, 1.0])).tolist() == [0.0, 1.0 / 60.0]
