import numpy as np
import pytest

from core.allan.model import NoiseModel
from core.allan.noise import fit_noise
from core.allan.preview import preview
from core.errors import FitError

HOUR = 3600.0


@pytest.mark.parametrize(
    ("model", "n_bound", "b_bound"),
    [
        (NoiseModel(0.02, 0.0125, 3e-4), 0.0012, 0.035),
        (NoiseModel(0.0025, 0.001, 5e-5), 0.0012, 0.059),
        (NoiseModel(2e-4, 1.4e-5, 1e-7), 0.0012, 0.42),
    ],
)
def test_an_hour_at_100_hz_has_the_known_cramer_rao_bounds(model, n_bound, b_bound):
    (now,) = preview(model, 100.0, HOUR, factors=(1.0,))
    assert now.random_walk == pytest.approx(n_bound, rel=0.05)
    assert now.bias_instability == pytest.approx(b_bound, rel=0.02)
    assert (now.factor, now.duration) == (1.0, HOUR)


def test_a_longer_record_resolves_more():
    got = preview(NoiseModel(0.0025, 0.001, 5e-5), 100.0, HOUR)
    assert [one.factor for one in got] == [1.0, 2.0, 4.0, 8.0, 24.0]
    for name in (
        "random_walk",
        "bias_instability",
        "rate_random_walk",
        "smallest_bias_instability",
    ):
        values = [getattr(one, name) for one in got]
        assert values == sorted(values, reverse=True)
    assert got[0].random_walk / got[2].random_walk == pytest.approx(2.0, rel=0.01)


def test_what_the_model_lacks_is_infinitely_uncertain():
    (now,) = preview(NoiseModel(0.0025), 100.0, HOUR, factors=(1.0,))
    assert now.bias_instability == np.inf
    assert now.rate_random_walk == np.inf
    assert 0.0 < now.smallest_bias_instability < 0.0025


def test_a_narrow_band_costs_n():
    model = NoiseModel(0.0025, 0.001, 5e-5)
    (wide,) = preview(model, 100.0, HOUR, factors=(1.0,))
    (narrow,) = preview(model, 100.0, HOUR, band=5.0, factors=(1.0,))
    assert narrow.random_walk > 3.0 * wide.random_walk
    assert narrow.bias_instability == pytest.approx(wide.bias_instability, rel=0.1)


def test_nonsense_is_refused():
    with pytest.raises(FitError, match="random walk N above zero"):
        preview(NoiseModel(), 100.0, HOUR)
    with pytest.raises(FitError, match="holds no spectrum"):
        preview(NoiseModel(1.0), 100.0, 0.01)


@pytest.mark.slow
def test_the_smallest_b_is_found_four_times_in_five(noise):
    (now,) = preview(NoiseModel(0.0025, 0.0, 5e-5), 5.0, HOUR, factors=(1.0,))
    b = now.smallest_bias_instability
    found = 0
    for seed in range(40):
        y = noise(np.random.default_rng(seed), 18_000, 5.0, N=0.0025, B=b, K=5e-5)
        found += not fit_noise(y, 5.0).row("bias_instability").upper_limit
    assert 0.65 < found / 40 < 0.95
