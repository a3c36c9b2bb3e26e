import numpy as np
import pytest

from core.allan.covariance import degrees_of_freedom, variance_covariance
from core.allan.model import NoiseModel

N_SAMPLES = 3000
DT = 0.01
M = np.array([1, 2, 3, 7, 20, 33, 100, 330, 700, 999])
PAIRS = N_SAMPLES + 1 - 2 * M
MODELS = {
    "white": NoiseModel(random_walk=1.0),
    "flicker": NoiseModel(bias_instability=1.0),
    "walk": NoiseModel(rate_random_walk=1.0),
    "quantization": NoiseModel(quantization=1.0),
    "gyro": NoiseModel(0.02, 0.0125, 3e-4),
    "all": NoiseModel(0.02, 0.1, 0.3, 0.0, 1e-3),
}


def autocovariance(model, t):
    """s(t) of phase, term by term."""
    t = np.abs(t)
    log = np.log(np.where(t > 0.0, t, 1.0))
    return (
        -0.5 * model.random_walk**2 * DT * t
        + (model.bias_instability * DT) ** 2 / (2.0 * np.pi) * t * t * log
        + model.rate_random_walk**2 * DT**3 / 12.0 * t**3
        + model.quantization**2 * (t == 0.0)
    )


def full_sum(model, m1, m2):
    """The covariance of two estimates from every pair of their differences."""
    places1, places2 = N_SAMPLES + 1 - 2 * m1, N_SAMPLES + 1 - 2 * m2
    j = np.arange(-places1 + 1, places2).astype(float)
    c = np.zeros_like(j)
    for a, first in enumerate((1.0, -2.0, 1.0)):
        for b, second in enumerate((1.0, -2.0, 1.0)):
            c += first * second * autocovariance(model, j + b * m2 - a * m1)
    count = np.minimum(places1, places2 - j) - np.maximum(0.0, -j)
    total = 2.0 * float((count * c * c).sum()) / (places1 * places2)
    return total / (4.0 * (m1 * DT) ** 2 * (m2 * DT) ** 2)


@pytest.mark.parametrize("name", MODELS)
def test_matrix_against_the_full_double_sums(name):
    model = MODELS[name]
    full = np.array([[full_sum(model, min(a, b), max(a, b)) for b in M] for a in M])
    got = variance_covariance(model, M, PAIRS, DT)
    scale = np.sqrt(np.outer(np.diag(full), np.diag(full)))
    assert np.abs((got - full) / scale).max() < 0.008
    np.testing.assert_array_equal(got, got.T)


@pytest.mark.parametrize("name", MODELS)
def test_degrees_of_freedom_against_the_full_sums(name):
    model = MODELS[name]
    taus = M * DT
    variance = model.variance(taus)
    for place, (m, pairs) in enumerate(zip(M.tolist(), PAIRS.tolist(), strict=True)):
        shares = np.array(
            [
                model.part(term, taus)[place] / variance[place]
                for term in (
                    "random_walk",
                    "bias_instability",
                    "rate_random_walk",
                    "quantization",
                    "rate_ramp",
                )
            ]
        )
        exact = 2.0 * variance[place] ** 2 / full_sum(model, m, m)
        assert degrees_of_freedom(shares, m, pairs) == pytest.approx(exact, rel=0.003)


def test_white_noise_of_neighbouring_samples_by_hand():
    """rho is 1, -1/2, 0: edf = M / (1 + 2 (1 - 1/M) / 4)."""
    white = np.array([1.0, 0.0, 0.0, 0.0, 0.0])
    assert degrees_of_freedom(white, 1, 999) == pytest.approx(999 / (1 + 0.5 * 998 / 999))


def test_a_pure_ramp_under_white_noise_adds_the_cross_term():
    """Var(mean of (s + mu)^2) = that of s^2 + 4 mu^2 Var(mean s); the latter is almost nothing."""
    rng = np.random.default_rng(0)
    m, pairs, share = 4, 60, 0.7
    estimates = []
    mean = np.sqrt(share / (1.0 - share) * 2.0 * m)
    for _ in range(20_000):
        phase = np.cumsum(rng.normal(size=pairs + 2 * m))
        second = phase[2 * m :] - 2.0 * phase[m:-m] + phase[: -2 * m]
        estimates.append(np.mean((second + mean) ** 2))
    measured = 2.0 * np.mean(estimates) ** 2 / np.var(estimates)
    shares = np.array([1.0 - share, 0.0, 0.0, 0.0, share])
    assert degrees_of_freedom(shares, m, pairs) == pytest.approx(measured, rel=0.03)
