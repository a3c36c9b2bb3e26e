import numpy as np
import pytest

from core.allan.detrend import Regressor, detrend
from core.errors import FitError, RankDeficient

RATE = 10.0
N = 20_000
T = np.arange(N) / RATE
TEMPERATURE = 25.0 + 8.0 * (1.0 - np.exp(-T / 500.0)) + 0.3 * np.sin(2.0 * np.pi * T / 700.0)


def warm(values=TEMPERATURE):
    return Regressor("temp", "degC", values)


def test_a_slope_without_noise_comes_back():
    y = 0.3 + 0.004 * TEMPERATURE + 1e-9 * np.random.default_rng(0).normal(size=N)
    got = detrend(y, RATE, [warm()])
    assert got.names == ("temp",)
    assert got.units == ("deg/s/degC",)
    assert got.values[0] == pytest.approx(0.004, rel=1e-6)
    assert got.residual.mean() == pytest.approx(y.mean())
    assert got.residual.std() < 1.1e-9
    assert got.references[0] == pytest.approx(TEMPERATURE.mean())


def test_powers_are_taken_about_the_mean():
    x = TEMPERATURE - TEMPERATURE.mean()
    y = 0.01 * x - 0.002 * x**2 + 1e-9 * np.random.default_rng(0).normal(size=N)
    got = detrend(y, RATE, [warm()], order=2, unit="m/s^2")
    np.testing.assert_allclose(got.values, [0.01, -0.002], rtol=1e-5)
    assert got.names == ("temp", "temp^2")
    assert got.units == ("m/s^2/degC", "m/s^2/degC^2")


def test_two_channels(noise):
    y = noise(np.random.default_rng(0), N, RATE, N=0.0025)
    quadrature = np.cumsum(np.random.default_rng(1).normal(size=N)) * 0.01
    y = y + 0.004 * TEMPERATURE + 0.02 * quadrature
    got = detrend(y, RATE, [warm(), Regressor("quad", "code", quadrature)])
    np.testing.assert_allclose(got.values, [0.004, 0.02], atol=5.0 * got.u.max())
    assert np.all(np.abs(got.values - [0.004, 0.02]) < 4.0 * got.u)
    np.testing.assert_allclose(np.sqrt(np.diag(got.covariance)), got.u)


def test_the_curve_falls_where_temperature_made_it_rise(noise):
    y = noise(np.random.default_rng(0), N, RATE, N=0.0025) + 0.004 * TEMPERATURE
    got = detrend(y, RATE, [warm()])
    np.testing.assert_array_equal(got.before.m, got.after.m)
    assert got.after.deviation[-1] < 0.1 * got.before.deviation[-1]
    np.testing.assert_allclose(got.after.deviation[:5], got.before.deviation[:5], rtol=1e-3)
    assert got.notes == ()


def test_a_channel_that_explains_nothing_is_said(noise):
    y = noise(np.random.default_rng(0), N, RATE, N=0.0025, B=0.001)
    got = detrend(y, RATE, [warm()])
    assert [note.subject for note in got.notes] == ["insignificant"]


@pytest.mark.slow
@pytest.mark.parametrize("k", [5e-5, 2e-4])
def test_uncertainty_covers_although_the_bias_wanders(noise, k):
    hits = naive = 0
    for seed in range(60):
        y = (
            noise(np.random.default_rng(seed), N, RATE, N=0.0025, B=0.001, K=k)
            + 0.004 * TEMPERATURE
        )
        got = detrend(y, RATE, [warm()])
        hits += abs(got.values[0] - 0.004) < 1.96 * got.u[0]
        (slope, _), covariance = np.polyfit(TEMPERATURE, y, 1, cov="unscaled")
        naive += abs(slope - 0.004) < 1.96 * np.sqrt(covariance[0, 0]) * 0.0025 * np.sqrt(RATE)
    assert hits >= 53
    assert naive < 30


def test_gaps_and_start(noise):
    y = noise(np.random.default_rng(0), N, RATE, N=0.0025) + 0.004 * TEMPERATURE
    y[3000] = np.nan
    got = detrend(y, RATE, [warm()])
    assert got.start == 3001
    assert len(got.residual) == N - 3001
    assert [note.subject for note in got.notes] == ["gaps"]
    with pytest.raises(ValueError, match="longest"):
        detrend(y, RATE, [warm()], gaps="stretches")


def test_still_channels_and_twins_are_named():
    y = np.random.default_rng(0).normal(size=N)
    with pytest.raises(RankDeficient, match="temp; the channel did not move"):
        detrend(y, RATE, [warm(np.full(N, 24.7))])
    with pytest.raises(RankDeficient, match="temp, other; these move together"):
        detrend(y, RATE, [warm(), Regressor("other", "degF", 32.0 + 1.8 * TEMPERATURE)])


def test_holes_in_a_channel_are_refused():
    holed = TEMPERATURE.copy()
    holed[5] = np.nan
    with pytest.raises(FitError, match="channel temp has values that are not finite"):
        detrend(np.random.default_rng(0).normal(size=N), RATE, [warm(holed)])
