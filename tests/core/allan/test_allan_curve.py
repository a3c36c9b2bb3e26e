import numpy as np

from core.allan.confidence import edf_of_model, interval
from core.allan.curve import with_model
from core.allan.deviation import overlapping
from core.allan.model import NoiseModel


def test_a_model_changes_the_limits_only():
    y = np.cumsum(np.random.default_rng(0).normal(size=3000))
    curve = overlapping(y, 10.0, level=0.9)
    model = NoiseModel(random_walk=1.0, rate_random_walk=5.0)
    other = with_model(curve, model)
    np.testing.assert_array_equal(other.deviation, curve.deviation)
    np.testing.assert_array_equal(other.edf, edf_of_model(model, curve.m, curve.pairs, 10.0))
    lower, upper = interval(curve.deviation, other.edf, 0.9)
    np.testing.assert_array_equal(other.lower, lower)
    np.testing.assert_array_equal(other.upper, upper)
    assert np.all((other.lower < other.deviation) & (other.deviation < other.upper))


def test_numbers_of_the_curve():
    curve = overlapping(np.random.default_rng(0).normal(size=3000), 10.0)
    assert curve.duration == 300.0
    np.testing.assert_allclose(curve.variance, curve.deviation**2)
    np.testing.assert_allclose(curve.taus, curve.m / 10.0)
    np.testing.assert_array_equal(curve.pairs, 3001 - 2 * curve.m)
