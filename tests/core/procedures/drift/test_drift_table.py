"""Interpolation by values; no correction where nothing was measured."""

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.drift.curves import Alignment
from core.procedures.drift.table import DriftTable, knots_within

ALIGNMENT = Alignment(1.5, 2.0, 1e-3)


def made(temperatures: list[float], values: list[list[float]]) -> DriftTable:
    numbers = np.array(values)
    return DriftTable(
        "deg/s",
        np.array([2.0, 10.0, 60.0]),
        np.array(temperatures),
        numbers,
        np.full_like(numbers, 0.01),
        np.full(len(temperatures), 4.0),
        ALIGNMENT,
    )


TABLE = made([-20.0, 20.0], [[0.0, 1.0, 2.0], [0.0, 3.0, -2.0]])


def test_linear_in_time_and_in_temperature():
    assert TABLE.correction(np.array([2.0, 6.0, 10.0, 35.0]), -20.0) == pytest.approx(
        [0, 0.5, 1, 1.5]
    )
    assert TABLE.correction(np.array([10.0, 60.0]), 10.0) == pytest.approx([2.5, -1.0])


def test_beyond_the_measured_is_refused_unless_asked_for():
    with pytest.raises(FitError, match=r"30\.0 degC is outside the measured -20\.0 \.\.\. 20\.0"):
        TABLE.correction(np.array([5.0]), 30.0)
    with pytest.raises(FitError, match=r"leave the measured 2 \.\.\. 60 s"):
        TABLE.correction(np.array([5.0, 61.0]), 0.0)
    held = TABLE.correction(np.array([1.0, 70.0]), 30.0, extrapolate=True)
    assert held == pytest.approx([0.0, -2.0])
    assert TABLE.correction(np.array([60.0]), 20.4) == pytest.approx([-2.0])


def test_one_temperature_holds_there_only():
    lonely = made([25.0], [[0.0, 1.0, 2.0]])
    assert lonely.correction(np.array([6.0]), 25.6) == pytest.approx([0.5])
    with pytest.raises(FitError, match="outside the measured"):
        lonely.correction(np.array([6.0]), 40.0)


def test_bytes_are_counted():
    assert TABLE.bytes == 2 * (3 + 2 + 6)


@pytest.mark.parametrize(
    ("memory", "temperatures", "knots"), [(262, 11, 10), (261, 11, 9), (4, 11, 0)]
)
def test_how_many_knots_a_memory_holds(memory: int, temperatures: int, knots: int):
    assert knots_within(memory, temperatures) == knots
    assert 2 * (knots + temperatures + knots * temperatures) <= memory or knots == 0
