import numpy as np
import pytest
from scipy.fft import dct

from core.allan import spectrum
from core.allan.spectrum import bin_starts, block_means, ramp_amplitudes, transform


@pytest.mark.parametrize("n", [2, 3, 50, 65, 66, 1000, 360_000])
def test_bins_hold_every_coefficient_once(n):
    starts, counts = bin_starts(n)
    assert starts[0] == 0
    assert counts.sum() == n - 1
    assert np.all(counts[: min(64, n - 1)] == 1)
    np.testing.assert_array_equal(starts[1:], np.cumsum(counts)[:-1])
    if n == 360_000:
        assert len(starts) == 155


def test_ramp_amplitudes_are_the_transform_of_a_ramp():
    for n in (16, 17, 1000):
        expected = dct(0.02 * np.arange(n), type=2, norm="ortho")[1:]
        got = ramp_amplitudes(n, 0.02)
        np.testing.assert_allclose(got, expected, atol=1e-12 * np.abs(expected).max())


def test_power_of_white_noise_is_flat():
    y = 5.0 + np.random.default_rng(0).normal(size=100_000)
    got = transform(y, 0, len(y), 100.0)
    wide = got.counts > 1000
    np.testing.assert_allclose(got.power()[wide], 1.0, atol=0.1)
    assert got.top == 50.0
    assert got.edges[-1] == pytest.approx(50.0, rel=1e-4)


def test_leverage_is_given_back_and_counted():
    y = np.random.default_rng(0).normal(size=1000)
    got = transform(y, 0, 1000, 1.0)
    leverage = np.zeros(999)
    leverage[3] = 0.75
    power, counts = got.bins(leverage)
    assert counts[3] == pytest.approx(0.25)
    assert power[3] == pytest.approx(4.0 * got.power()[3])
    assert counts[4] == 1.0


def test_long_records_are_averaged_and_their_band_is_cut(monkeypatch):
    monkeypatch.setattr(spectrum, "LARGEST", 1 << 12)
    rng = np.random.default_rng(0)
    y = rng.normal(size=40_000) * 3.0
    got = transform(y, 0, 40_000, 100.0)
    assert got.averaged == 10
    assert got.dt == pytest.approx(0.1)
    assert got.top == pytest.approx(1.0)
    # White noise keeps its density: variance times dt.
    assert np.average(got.power(), weights=got.counts) * got.dt == pytest.approx(0.09, rel=0.05)


@pytest.mark.parametrize("size", [1, 3, 7, 100_000])
def test_block_means(size):
    values = np.random.default_rng(0).integers(-9, 9, 300_001).astype(np.int16)
    got = block_means(values, 1, 300_001, size)
    expected = values[1 : 1 + len(got) * size].reshape(-1, size).astype(float).mean(axis=1)
    np.testing.assert_allclose(got, expected, atol=1e-12)
    assert len(got) == 300_000 // size


def test_an_empty_bin_has_a_power_one_can_take_the_logarithm_of():
    y = np.tile([1.0, -1.0, -1.0, 1.0], 64)
    assert np.all(transform(y, 0, 256, 1.0).power() > 0.0)
