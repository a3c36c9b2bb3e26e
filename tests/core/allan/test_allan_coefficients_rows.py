"""The table of coefficients and the functions that fill it."""

import numpy as np
import pytest

from core.allan.graphical import Reading
from core.allan.leastsquares import VarianceFit
from core.allan.model import RANDOM, spectral_columns
from core.allan.noise import fit_noise
from core.allan.ramp import Ramp
from core.allan.rows import graphical_rows, likelihood_rows, ramp_row, variance_rows
from core.allan.whittle import Bins, maximise, profile_limit


@pytest.fixture
def bins():
    counts = np.concatenate((np.ones(40), np.full(60, 200.0)))
    columns = spectral_columns(RANDOM, np.geomspace(1e-4, 3.0, 100), 0.01)
    truth = np.array([4.0, 1.0, 0.0])
    drawn = np.random.default_rng(0).chisquare(counts) / counts
    return Bins(columns @ truth * drawn, counts, columns)


def test_likelihood_rows_detect_what_is_there_and_bound_the_rest(bins):
    best = maximise(bins)
    n, b, k = likelihood_rows(bins, best, RANDOM, "deg/s")
    assert (n.symbol, b.symbol, k.symbol) == ("N", "B", "K")
    assert (n.unit, b.unit, k.unit) == ("deg/sqrt(s)", "deg/s", "deg/s/sqrt(s)")
    for row in (n, b):
        assert not row.upper_limit
        assert row.lower < row.value < row.upper
        assert row.u == pytest.approx((row.upper - row.lower) / 3.92, rel=0.1)
    assert n.lower < 2.0 < n.upper
    assert k.upper_limit
    assert k.lower == 0.0
    assert k.upper**2 == pytest.approx(
        profile_limit(bins, best, 2, 2.7055434540954, upward=True), rel=1e-5
    )
    assert k.u == pytest.approx((k.upper - k.value) / 1.6448536)


def test_a_ramp_keeps_its_sign():
    row = ramp_row(Ramp(-3e-6, 1e-6, True), "deg/s")
    assert (row.value, row.symbol, row.unit) == (-3e-6, "R", "deg/s^2")
    assert row.lower == pytest.approx(-3e-6 - 1.96e-6, rel=1e-4)
    assert row.upper == pytest.approx(-3e-6 + 1.96e-6, rel=1e-4)


def test_variance_rows_turn_squares_into_coefficients():
    fit = VarianceFit(
        RANDOM, np.array([4.0, 1.0, 0.0]), np.diag([0.01, 0.36, 0.25]), np.array([1.0])
    )
    n, b, k = variance_rows(fit, "m/s^2")
    assert (n.value, n.u) == (2.0, pytest.approx(0.1 / 4.0))
    assert n.lower == pytest.approx(np.sqrt(4.0 - 0.19600), rel=1e-4)
    assert n.upper == pytest.approx(np.sqrt(4.0 + 0.19600), rel=1e-4)
    assert not b.upper_limit
    assert b.lower == 0.0
    assert k.upper_limit
    assert k.upper == pytest.approx(np.sqrt(1.6448536 * 0.5))
    assert (n.unit, b.unit) == ("m/s/sqrt(s)", "m/s^2")


def test_graphical_rows_carry_the_interval_of_their_point():
    from scipy.stats import chi2

    steady, falling = graphical_rows(
        (
            Reading("random_walk", 2.0, 50.0, 1.0, False),
            Reading("bias_instability", 3.0, 8.0, 99.0, True),
        ),
        "code",
    )
    assert steady.u == pytest.approx(0.2)
    assert steady.lower == pytest.approx(2.0 * np.sqrt(50.0 / chi2.ppf(0.975, 50.0)))
    assert falling.upper_limit
    assert falling.upper == pytest.approx(3.0 * np.sqrt(8.0 / chi2.ppf(0.025, 8.0)))
    assert falling.unit == "code"


def test_a_row_that_is_not_there_is_named():
    result = fit_noise(np.random.default_rng(0).normal(size=2000), 10.0)
    assert result.row("random_walk").method == "likelihood"
    assert result.row("random_walk", "least_squares").method == "least_squares"
    with pytest.raises(KeyError, match="graphical gives no rate_ramp"):
        result.row("rate_ramp", "graphical")
