import numpy as np
import pytest
from scipy.integrate import quad

from core.allan.model import FLOOR, TERMS, NoiseModel, from_squares, spectral_columns


@pytest.mark.parametrize(
    ("term", "tau", "expected"),
    [
        ("random_walk", 1.0, 2.0),
        ("bias_instability", 7.0, 0.6642824702679600 * 2.0),
        ("rate_random_walk", 3.0, 2.0),
        ("rate_ramp", np.sqrt(2.0), 2.0),
        ("quantization", np.sqrt(3.0), 2.0),
    ],
)
def test_each_asymptote_is_read_where_lab_6_says(term, tau, expected):
    model = NoiseModel(**{term: 2.0})
    assert np.sqrt(model.variance(np.array([tau])))[0] == pytest.approx(expected, rel=1e-12)
    assert TERMS[term].reading in (0.0, pytest.approx(tau))


@pytest.mark.parametrize("term", ["random_walk", "bias_instability", "rate_random_walk"])
def test_variance_is_the_integral_of_the_two_sided_density(term):
    """(6.3): the factor 4 goes with S(f) on both sides of zero."""
    tau = 5.0
    model = NoiseModel(**{term: 0.3})

    def integrand(x):
        f = x / (np.pi * tau)
        density = model.density(np.array([f]), 1e-4)[0]
        return 4.0 * density * np.sin(x) ** 4 / x**2 / (np.pi * tau)

    pieces = [quad(integrand, k * np.pi, (k + 1) * np.pi)[0] for k in range(800)]
    tail = integrand(800.5 * np.pi) * 800.5 * np.pi * 3.0 / 8.0 if term == "random_walk" else 0.0
    assert sum(pieces) + tail == pytest.approx(model.variance(np.array([tau]))[0], rel=4e-4)


def test_the_floor_is_printed_as_0_664():
    assert FLOOR == pytest.approx(0.66428247, abs=1e-8)


def test_squares_become_coefficients_and_negative_ones_nothing():
    model = from_squares(("random_walk", "rate_ramp"), np.array([4.0, -1.0]))
    assert (model.random_walk, model.rate_ramp, model.bias_instability) == (2.0, 0.0, 0.0)


def test_cosine_transform_of_white_noise_and_walk_has_exactly_these_variances():
    from scipy.fft import dct

    n, dt = 64, 0.1
    basis = dct(np.eye(n), type=2, norm="ortho", axis=0)
    walk = np.tril(np.ones((n, n))) * np.sqrt(dt)
    w = np.pi * np.arange(1, n) / n
    columns = spectral_columns(("random_walk", "rate_random_walk"), w, dt)
    covariance = (basis @ walk @ walk.T @ basis.T)[1:, 1:]
    np.testing.assert_allclose(np.diag(covariance), columns[:, 1], rtol=1e-10)
    off = covariance - np.diag(np.diag(covariance))
    assert np.abs(off).max() < 1e-10 * covariance.max()
    np.testing.assert_allclose(columns[:, 0], 1.0 / dt)
