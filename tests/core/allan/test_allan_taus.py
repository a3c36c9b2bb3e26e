import numpy as np
import pytest

from core.allan.taus import averaging_factors, multitau_factors, quantised, stride_of
from core.errors import FitError


@pytest.mark.parametrize("n", [9, 10, 100, 1001, 360_000])
@pytest.mark.parametrize("grid", ["octave", "log", "all"])
def test_factors_are_distinct_and_end_at_a_third(n, grid):
    if grid == "all" and n > 2000:
        n = 2000
    m = averaging_factors(n, grid)
    assert m[0] == 1
    assert np.all(np.diff(m) > 0)
    assert m[-1] <= n // 3
    assert m[-1] == n // 3 or grid == "octave"


def test_all_means_every_factor_and_octave_powers_of_two():
    assert averaging_factors(31, "all").tolist() == list(range(1, 11))
    assert averaging_factors(100, "octave").tolist() == [1, 2, 4, 8, 16, 32]


def test_a_hundred_log_spaced_factors_of_an_hour():
    assert len(averaging_factors(360_000, "log", 100)) == 89


def test_too_short_is_said():
    with pytest.raises(FitError, match="at least 9"):
        averaging_factors(8)


def test_quantised_factors_are_multiples_of_their_stride_and_near():
    m = averaging_factors(86_400_000)
    rounded = quantised(m)
    for one in rounded.tolist():
        assert one % stride_of(one) == 0
        assert one <= 31 or 16 <= one / stride_of(one) <= 32
    assert max(np.abs(rounded / one - 1.0).min() for one in m) <= 1.0 / 32.0 + 1e-12


def test_multitau_grid_has_four_an_octave_above_sixteen():
    m = multitau_factors(28_800_000)
    assert m[:16].tolist() == list(range(1, 17))
    assert [one for one in m.tolist() if 32 <= one < 64] == [32, 38, 46, 54]
    assert m[-1] <= 28_800_000
    assert len(m) == 99
