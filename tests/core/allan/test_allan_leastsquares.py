from dataclasses import replace

import numpy as np
import pytest

from core.allan.deviation import overlapping
from core.allan.leastsquares import fit_variance
from core.allan.model import RANDOM, NoiseModel
from core.arrays import frozen
from core.errors import FitError

TERMS = (*RANDOM, "rate_ramp")
TRUTH = NoiseModel(0.02, 0.0125, 1e-3, 1e-5)


@pytest.fixture
def curve():
    return overlapping(np.random.default_rng(0).normal(size=40_000), 10.0)


def test_an_exact_curve_gives_its_coefficients_back(curve):
    exact = replace(curve, deviation=frozen(np.sqrt(TRUTH.variance(curve.taus))))
    model = fit_variance(exact, TERMS).model
    for term in TERMS:
        assert model.coefficient(term) == pytest.approx(TRUTH.coefficient(term), rel=1e-6)


def test_one_more_term_moves_only_itself(curve):
    exact = replace(curve, deviation=frozen(np.sqrt(TRUTH.variance(curve.taus))))
    model = fit_variance(exact, (*TERMS, "quantization")).model
    assert model.quantization < 1e-5
    assert model.random_walk == pytest.approx(0.02, rel=1e-6)


def test_points_below_the_shortest_tau_are_left_out(curve):
    fit = fit_variance(curve, TERMS, 5.0)
    assert fit.taus[0] >= 5.0
    assert len(fit.taus) <= 24
    assert fit_variance(curve, TERMS).taus[0] == pytest.approx(0.1)


def test_too_few_points_are_refused(curve):
    with pytest.raises(FitError, match="terms need more"):
        fit_variance(curve, TERMS, curve.taus[-3])


@pytest.mark.slow
def test_sandwich_says_how_the_estimates_scatter(noise):
    squares, spreads = [], []
    for seed in range(70):
        y = noise(np.random.default_rng(seed), 8_000, 5.0, N=0.0025, B=0.002, K=3e-4)
        fit = fit_variance(overlapping(y, 5.0), RANDOM)
        squares.append(fit.squares)
        spreads.append(np.sqrt(np.diag(fit.covariance)))
    scatter = np.std(squares, axis=0)
    np.testing.assert_allclose(np.mean(spreads, axis=0), scatter, rtol=0.25)
    bias = (np.mean(squares, axis=0) - [0.0025**2, 0.002**2, 9e-8]) / scatter
    assert np.all(np.abs(bias) < 0.4)
