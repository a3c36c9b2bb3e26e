"""Coverage of the interval of a mean, for the noises that sensors and their filters make."""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.signal import butter, lfilter

from core.fit.quantiles import student_t
from core.samples.mean_error import standard_error

Series = Callable[[np.random.Generator, int], np.ndarray]


def filtered(b: np.ndarray, a: np.ndarray) -> Series:
    return lambda rng, n: lfilter(b, a, rng.normal(size=n + 500))[500:]


NOISES: dict[str, Series] = {
    "white": lambda rng, n: rng.normal(size=n),
    "ar 0.5": filtered(np.array([1.0]), np.array([1.0, -0.5])),
    "ar 0.9": filtered(np.array([1.0]), np.array([1.0, -0.9])),
    "2 poles at 25 Hz of 200": filtered(*butter(2, 0.25)),
    "4 poles at 8 Hz of 200": filtered(*butter(4, 0.08)),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", NOISES)
def test_intervals_of_ten_seconds_at_200_hz_cover(name: str) -> None:
    rng = np.random.default_rng(20)
    trials, n = 1000, 2000
    hits = 0
    for _ in range(trials):
        x = NOISES[name](rng, n)
        se, dof = standard_error(x[:, None], [False])
        hits += abs(x.mean()) < student_t(0.95, round(float(dof[0]), 1)) * se[0]
    # 3 sigma of a binomial of 1000 about 95 % is 2.1 %.
    assert 0.92 < hits / trials < 0.975


@pytest.mark.slow
def test_a_weak_slow_component_under_white_noise_is_seen() -> None:
    """White noise with a hidden drift of half a second: s / sqrt(n) covers 50 %."""
    rng = np.random.default_rng(21)
    hits = naive = 0
    for _ in range(600):
        slow = lfilter([0.06], [1.0, -0.98], rng.normal(size=2500))[500:]
        x = rng.normal(size=2000) + slow
        se, dof = standard_error(x[:, None], [False])
        hits += abs(x.mean()) < student_t(0.95, round(float(dof[0]), 1)) * se[0]
        naive += abs(x.mean()) < 1.96 * x.std() / np.sqrt(2000)
    assert naive / 600 < 0.65
    assert hits / 600 > 0.80


def test_rounding_is_the_floor_of_codes_but_not_of_volts() -> None:
    data = np.full((100, 2), 7.0)
    se, _ = standard_error(data, [True, False])
    np.testing.assert_allclose(se, [1.0 / np.sqrt(12.0), 0.0])


def test_noise_that_dithers_the_codes_has_no_floor() -> None:
    data = np.round(np.random.default_rng(3).normal(0.0, 4.0, (4000, 1)))
    se, dof = standard_error(data, [True])
    assert se[0] == pytest.approx(4.0 / np.sqrt(4000), rel=0.1)
    assert dof[0] > 300


def test_a_number_that_the_mean_cannot_hold_has_no_error_of_its_own() -> None:
    se, _ = standard_error(np.full((100, 1), 0.1), [False])
    assert se[0] == 0.0
