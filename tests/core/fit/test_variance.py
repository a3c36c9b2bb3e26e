"""Setting errors as changes of the output, against derivatives by hand."""

import numpy as np
import pytest

from core.fit.variance import RowVariance, rate_uncertainty, setting_errors
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions

RATES = np.array([-50.0, 0.0, 100.0, np.nan])
G = 9.81


def stimulus() -> Stimulus:
    """Three rows on the table about Z, one on the head with Y level, turning about X."""
    a = np.array([[0, 0, G], [0, 0, G], [0, 0, G], [0, -G, 0]])
    w = np.zeros((4, 3))
    w[:3, 2] = RATES[:3]
    da = np.zeros((4, 3))
    da[3] = [0, 0, -G]
    dw = np.zeros((4, 3))
    dw[:3, 2] = 1.0
    return Stimulus(a, w, da, dw, {"set_rate_dps": RATES})


def model() -> SensorModel:
    effects = (CATALOGUE["bias"], CATALOGUE["scale_factor"], CATALOGUE["g_sensitivity"])
    return SensorModel(Sensor("gyro", "z", "code"), effects)


VALUES = np.array([7.0, -79.0, 0.1, 0.2, 0.5])


def test_the_head_acts_through_gravity_and_the_table_through_the_rate():
    conditions = Conditions(head_u_arcsec=20.0, rate_u_dps=0.1, rate_u_ppm=1000.0)
    by_head, by_rate = setting_errors(model(), VALUES, stimulus(), conditions)
    assert np.allclose(by_head, [0, 0, 0, -0.5 * G * 20.0 / 206264.806], rtol=1e-6)
    u = np.hypot(0.1, 1e-3 * np.array([50.0, 0.0, 100.0]))
    assert np.allclose(by_rate, [*(-79.0 * u), 0.0], rtol=1e-9)


def test_nothing_stated_nothing_added():
    assert not setting_errors(model(), VALUES, stimulus(), Conditions()).any()


@pytest.mark.parametrize(
    ("conditions", "expected"),
    [
        (Conditions(), [0, 0, 0, 0]),
        (Conditions(rate_u_dps=0.1), [0.1, 0.1, 0.1, 0]),
        (Conditions(rate_u_ppm=100.0), [5e-3, 0, 1e-2, 0]),
    ],
)
def test_uncertainty_of_the_rate(conditions: Conditions, expected: list[float]):
    assert np.allclose(rate_uncertainty(stimulus(), conditions), expected)


def test_a_run_without_rates_has_no_table():
    none = np.zeros((2, 3))
    bare = Stimulus(none, none, none, none)
    assert not rate_uncertainty(bare, Conditions(rate_u_dps=1.0)).any()


@pytest.mark.parametrize(
    ("squares", "known"),
    [([1.0, 2.0], True), ([1.0, np.nan], False), ([1.0, 0.0], False)],
)
def test_known_means_every_row_brought_its_error(squares: list[float], known: bool):
    part = RowVariance(np.array(squares), np.zeros(2), np.full(2, np.inf))
    assert part.known is known
