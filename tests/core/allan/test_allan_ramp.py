import numpy as np
import pytest

from core.allan.model import RANDOM
from core.allan.ramp import fit_ramp
from core.allan.spectrum import transform
from core.allan.whittle import Bins, maximise


def fitted(y, rate=10.0):
    spectrum = transform(y, 0, len(y), rate)
    bins = Bins(spectrum.power(), spectrum.counts, spectrum.columns(RANDOM))
    return fit_ramp(spectrum, RANDOM, bins, maximise(bins))


@pytest.mark.parametrize("slope", [2e-4, -2e-4])
def test_a_ramp_in_white_noise_has_the_value_and_u_of_a_straight_line(slope):
    n, dt = 20_000, 0.1
    t = np.arange(n) * dt
    y = slope * t + np.random.default_rng(0).normal(size=n)
    ramp, bins, noise = fitted(y)
    line = np.polyfit(t, y, 1)[0]
    u = 1.0 / np.sqrt(((t - t.mean()) ** 2).sum())
    assert ramp.significant
    assert ramp.value == pytest.approx(line, abs=0.3 * u)
    # What random walk there might be unseen makes it less certain than a straight line's.
    assert u < ramp.u < 12.0 * u
    assert noise.squares[0] == pytest.approx(dt, rel=0.03)
    assert len(bins.power) == len(bins.counts)


def test_a_random_walk_is_not_called_a_ramp(noise):
    found = [
        fitted(noise(np.random.default_rng(seed), 5000, 10.0, N=0.01, K=0.003))[0].significant
        for seed in range(60)
    ]
    assert sum(found) <= 2


def test_without_a_ramp_the_noise_fit_is_left_as_it_is():
    spectrum = transform(np.random.default_rng(0).normal(size=4000), 0, 4000, 10.0)
    bins = Bins(spectrum.power(), spectrum.counts, spectrum.columns(RANDOM))
    best = maximise(bins)
    ramp, same_bins, same = fit_ramp(spectrum, RANDOM, bins, best)
    assert not ramp.significant
    assert same_bins is bins
    assert same is best


@pytest.mark.slow
@pytest.mark.parametrize("k", [0.0, 1e-4])
def test_its_uncertainty_covers_beside_a_random_walk(noise, k):
    slope, hits, walks = 4e-5, 0, []
    for seed in range(100):
        y = noise(np.random.default_rng(seed), 18_000, 5.0, N=0.0025, K=k, R=slope)
        ramp, _, found = fitted(y, 5.0)
        assert ramp.significant
        hits += abs(ramp.value - slope) < 1.96 * ramp.u
        walks.append(found.squares[2])
    assert hits >= 91
    if k:
        # The ramp is taken off without taking a share of the walk with it.
        assert np.mean(walks) == pytest.approx(k * k, rel=0.1)
