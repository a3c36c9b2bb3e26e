import numpy as np
import pytest

from core.allan.squares import ROW, sum_of_squares


@pytest.mark.parametrize("n", [0, 1, ROW - 1, ROW, ROW + 1, 3 * ROW, 4 * ROW + 17])
def test_every_length_is_summed_whole(n):
    values = np.arange(n, dtype=np.float64)
    assert sum_of_squares(values) == pytest.approx((n - 1) * n * (2 * n - 1) / 6, rel=1e-14)
