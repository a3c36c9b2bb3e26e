"""An effect's columns times the powers of the temperature."""

import numpy as np
import pytest

from core.errors import FitError
from core.model.catalogue.common import Bias, CrossAxis
from core.model.effect import Sensor
from core.model.stimulus import Stimulus
from core.procedures.thermal.over_temperature import OverTemperature

SENSOR = Sensor("accelerometer", "x", "code")
A = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])


def stimulus(**columns: np.ndarray) -> Stimulus:
    return Stimulus(A, 0.0 * A, 0.0 * A, 0.0 * A, columns)


def test_parameters_and_columns_by_power():
    effect = OverTemperature(CrossAxis("yz"), 2, 20.0)
    columns = effect.columns(stimulus(temperature_c=np.array([30.0, 15.0])), SENSOR)
    assert columns == pytest.approx(
        np.array([[2, 3, 20, 30, 200, 300], [5, 6, -25, -30, 125, 150]], dtype=float)
    )
    assert [(p.name, p.symbol, p.unit) for p in effect.parameters(SENSOR)[2:5]] == [
        ("cross_axis_y_t1", "k_xy_T1", "code/(m/s^2)/degC"),
        ("cross_axis_z_t1", "k_xz_T1", "code/(m/s^2)/degC"),
        ("cross_axis_y_t2", "k_xy_T2", "code/(m/s^2)/degC^2"),
    ]


def test_order_zero_is_the_effect_itself():
    assert OverTemperature(Bias(), 0, 20.0).columns(stimulus(), SENSOR) == pytest.approx(1.0)


def test_a_missing_temperature_is_named():
    gap = stimulus(temperature_c=np.array([20.0, np.nan]))
    with pytest.raises(FitError, match="temperature_c"):
        OverTemperature(Bias(), 1, 20.0).columns(gap, SENSOR)
