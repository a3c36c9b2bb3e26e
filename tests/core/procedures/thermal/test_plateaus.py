"""The cycle of the dividing head cut at its temperatures."""

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.thermal.plateaus import plateaus_of


def test_the_cycle_of_the_dividing_head():
    nominal = [27, -10, -40, -10, 27, 50, 70, 50, 27]
    rng = np.random.default_rng(0)
    t = np.repeat(nominal, 8) + rng.uniform(-1.0, 1.0, 72)
    found = plateaus_of(t, np.arange(72))
    assert [round(one.temperature_c) for one in found] == pytest.approx(nominal, abs=1)
    assert [one.came for one in found] == [0, -1, -1, 1, 1, 1, 1, -1, -1]
    assert [one.level for one in found] == [2, 1, 0, 1, 2, 3, 4, 3, 2]
    assert found[3].rows.tolist() == list(range(24, 32))


def test_rows_are_taken_in_the_order_of_measuring():
    t = np.array([50.0, 20.0, 51.0, 21.0])
    found = plateaus_of(t, np.array([2, 0, 3, 1]))
    assert [one.rows.tolist() for one in found] == [[1, 3], [0, 2]]


def test_a_missing_temperature_is_refused():
    with pytest.raises(FitError, match="row 2: the temperature is missing"):
        plateaus_of(np.array([20.0, np.nan]), np.arange(2))
