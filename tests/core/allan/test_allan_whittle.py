import numpy as np
import pytest

from core.allan.model import RANDOM, spectral_columns
from core.allan.spectrum import transform
from core.allan.whittle import (
    Bins,
    band_limit,
    covariance_of,
    deviance_of,
    expected_squares,
    log_likelihood,
    maximise,
    misfit,
    profile_limit,
)
from core.errors import FitError

COUNTS = np.concatenate((np.ones(40), np.full(60, 200.0)))
W = np.geomspace(1e-4, 3.0, 100)
TRUTH = np.array([4.0, 1.0, 1e-5])
COLUMNS = spectral_columns(RANDOM, W, 0.01)


def drawn(seed, squares=TRUTH):
    power = COLUMNS @ squares * np.random.default_rng(seed).chisquare(COUNTS) / COUNTS
    return Bins(power, COUNTS, COLUMNS)


def test_exact_power_gives_exact_squares():
    best = maximise(Bins(COLUMNS @ TRUTH, COUNTS, COLUMNS))
    np.testing.assert_allclose(best.squares, TRUTH, rtol=1e-5)
    assert best.deviance == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize("seed", range(8))
def test_no_neighbour_is_more_likely(seed):
    bins = drawn(seed)
    best = maximise(bins)
    spread = np.sqrt(np.diag(covariance_of(bins, best.squares)))
    for place in range(3):
        for step in (-1e-2, 1e-2):
            other = best.squares.copy()
            other[place] += step * spread[place]
            if other[place] >= 0.0:
                assert deviance_of(bins, other) >= best.deviance - 1e-7


def test_deviance_differs_from_likelihood_by_a_constant():
    bins = drawn(0)
    other = TRUTH * [1.1, 0.7, 2.0]
    fall = -2.0 * (log_likelihood(bins, other) - log_likelihood(bins, TRUTH))
    assert deviance_of(bins, other) - deviance_of(bins, TRUTH) == pytest.approx(fall, rel=1e-9)


def test_estimates_scatter_as_the_information_says():
    estimates = np.array([maximise(drawn(seed)).squares for seed in range(400)])
    spread = np.sqrt(np.diag(covariance_of(drawn(0), TRUTH)))
    np.testing.assert_allclose(estimates.mean(axis=0), TRUTH, atol=0.25 * spread.max(), rtol=0.1)
    np.testing.assert_allclose(estimates[:, 0].std(), spread[0], rtol=0.15)
    np.testing.assert_allclose(estimates[:, 1].std(), spread[1], rtol=0.15)


def test_profile_intervals_cover():
    hits = np.zeros(3)
    for seed in range(100):
        bins = drawn(seed)
        best = maximise(bins)
        for place in range(3):
            low = profile_limit(bins, best, place, 3.8415, upward=False)
            high = profile_limit(bins, best, place, 3.8415, upward=True)
            assert low <= best.squares[place] <= high
            hits[place] += low <= TRUTH[place] <= high
    assert np.all(hits / 100 > 0.9)


def test_a_profile_ends_where_the_likelihood_has_fallen():
    bins = drawn(1)
    best = maximise(bins)
    for upward in (False, True):
        limit = profile_limit(bins, best, 1, 2.7, upward=upward)
        assert maximise(bins, 1, limit).deviance - best.deviance == pytest.approx(2.7, abs=1e-3)


def test_an_absent_term_has_no_lower_limit_but_an_upper_one():
    bins = drawn(3, np.array([4.0, 0.0, 1e-5]))
    best = maximise(bins)
    assert profile_limit(bins, best, 1, 3.84, upward=False) == 0.0
    assert 0.0 < profile_limit(bins, best, 1, 2.71, upward=True) < 1.0


def test_expected_squares_count_with_what_may_be():
    bins = drawn(3)
    spread = np.sqrt(np.diag(covariance_of(bins, np.array([4.0, 1.0, 0.0]))))
    got = expected_squares(bins, np.array([4.0, 1.0, 0.0]))
    assert got[0] == pytest.approx(4.0)
    assert got[2] == pytest.approx(spread[2] * np.sqrt(2.0 / np.pi))


def test_misfit_is_uniform_for_a_right_model_and_small_for_a_wrong_one():
    right = [misfit(drawn(seed), TRUTH) for seed in range(200)]
    assert 0.35 < np.mean(right) < 0.65
    assert np.mean(np.array(right) < 0.05) < 0.1
    assert misfit(drawn(0), TRUTH * 1.2) < 1e-4


def whole(y, rate):
    got = transform(y, 0, len(y), rate)
    return got, Bins(got.power(), got.counts, got.columns(RANDOM))


class TestBand:
    def test_the_whole_band_of_a_flat_record(self):
        got, bins = whole(np.random.default_rng(0).normal(size=50_000), 100.0)
        assert band_limit(got, bins) == (len(bins.power), False)

    @pytest.mark.parametrize("cut", [5.0, 10.0, 25.0])
    def test_a_filter_in_the_sensor_is_found(self, cut):
        from scipy.signal import butter, sosfilt

        white = np.random.default_rng(0).normal(size=200_000)
        got, bins = whole(sosfilt(butter(2, cut, fs=100.0, output="sos"), white), 100.0)
        used, limited = band_limit(got, bins)
        assert limited
        assert 0.05 * cut < got.edges[used - 1] < 0.5 * cut

    def test_a_stated_bandwidth_is_respected(self):
        got, bins = whole(np.random.default_rng(0).normal(size=50_000), 100.0)
        used, limited = band_limit(got, bins, 7.0)
        assert limited
        assert got.edges[used - 1] == pytest.approx(7.0, rel=0.15)

    def test_the_band_ends_below_a_strong_line(self):
        rng = np.random.default_rng(0)
        y = 10.0 * np.sin(2.0 * np.pi * 2.0 * np.arange(50_000) / 100.0) + rng.normal(size=50_000)
        got, bins = whole(y, 100.0)
        used, limited = band_limit(got, bins)
        assert limited
        assert got.edges[used - 1] < 2.0

    def test_a_signal_is_not_noise(self):
        phase = np.pi * (np.arange(256) + 0.5) / 256.0
        y = np.cos(4.0 * phase) + 1e-3 * np.random.default_rng(0).normal(size=256)
        got, bins = whole(y, 10.0)
        with pytest.raises(FitError, match="no noise model fits"):
            band_limit(got, bins)
