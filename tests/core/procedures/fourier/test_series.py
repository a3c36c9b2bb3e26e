"""Columns of the series, and the drift that is fitted beside it."""

import numpy as np
import pytest

from core.model.effect import Sensor
from core.model.stimulus import Stimulus
from core.procedures.fourier.series import Harmonics, LinearDrift

SENSOR = Sensor("accelerometer", "x", "V")


def stimulus(alpha: np.ndarray) -> Stimulus:
    a = 9.8 * np.column_stack([np.sin(alpha), np.cos(alpha), 0.0 * alpha])
    derivative = 9.8 * np.column_stack([np.cos(alpha), -np.sin(alpha), 0.0 * alpha])
    order = np.arange(len(alpha), dtype=float)
    return Stimulus(a, 0.0 * a, derivative, 0.0 * a, {"order": order})


def test_columns_are_the_harmonics_whatever_g_is():
    alpha = np.radians([0.0, 30.0, 90.0, 200.0])
    series = Harmonics(3, "y")
    columns = series.columns(stimulus(alpha), SENSOR)
    orders = [f(n * alpha) for n in (1, 2, 3) for f in (np.sin, np.cos)]
    assert columns == pytest.approx(np.column_stack([np.ones(4), *orders]))
    assert series.columns(stimulus(alpha).scaled_force(2.0), SENSOR) == pytest.approx(columns)
    assert [p.symbol for p in series.parameters(SENSOR)] == [
        "C0",
        "C1",
        "C2",
        "C3",
        "C4",
        "C5",
        "C6",
    ]


def test_columns_follow_a_small_turn_of_the_head():
    alpha = np.radians([10.0, 120.0])
    series = Harmonics(2, "y")
    turned = series.columns(stimulus(alpha).turned(1e-4), SENSOR)
    assert turned == pytest.approx(series.columns(stimulus(alpha + 1e-4), SENSOR), abs=1e-8)


def test_the_drift_goes_from_minus_to_plus_one_half():
    column = LinearDrift().columns(stimulus(np.zeros(5)), SENSOR)[:, 0]
    assert column.tolist() == [-0.5, -0.25, 0.0, 0.25, 0.5]
