from pathlib import Path

import numpy as np
import pytest

from core.allan.confidence import (
    edf_of_model,
    edf_of_types,
    interval,
    local_slopes,
    noise_types,
)
from core.allan.deviation import overlapping
from core.allan.model import NoiseModel

PHASEDAT = Path(__file__).parents[2] / "data" / "allan_reference" / "phasedat"


@pytest.mark.parametrize(
    ("term", "a0", "a1"),
    [
        ("random_walk", 2.0 / 3.0, 1.0 / 3.0),
        ("bias_instability", 0.852, 0.375),
        ("rate_random_walk", 1.079, 0.368),
    ],
)
@pytest.mark.parametrize("m", [20, 50, 200, 400])
def test_asymptotic_formula_of_greenhall_and_riley(term, a0, a1, m):
    """1/edf = (a0 - a1/r)/r with r = M/m > 3, stated to 1 %."""
    pairs = 3001 - 2 * m
    r = pairs / m
    edf = edf_of_types([term], np.array([m]), np.array([pairs]))[0]
    assert edf == pytest.approx(r / (a0 - a1 / r), rel=0.012)


@pytest.mark.parametrize("m", [1, 2, 5, 20, 100, 400])
def test_simple_formula_of_nist_for_white_noise(m):
    """[3 (N - 1) / 2m - 2 (N - 2) / N] 4 m^2 / (4 m^2 + 5), within 2 % for r > 3."""
    points = 3001
    simple = (3.0 * (points - 1) / (2.0 * m) - 2.0 * (points - 2) / points) * (
        4.0 * m * m / (4.0 * m * m + 5.0)
    )
    edf = edf_of_types(["random_walk"], np.array([m]), np.array([points - 2 * m]))[0]
    assert edf == pytest.approx(simple, rel=0.02)


def test_limits_of_stable32():
    table = np.loadtxt(PHASEDAT / "phase_dat_oadev_octave.txt")
    m = table[:, 0].astype(np.int64)
    edf = edf_of_types(["random_walk"] * len(m), m, 1001 - 2 * m)
    lower, upper = interval(table[:, 5], edf, 0.683)
    np.testing.assert_allclose(lower, table[:, 4], rtol=0.003)
    np.testing.assert_allclose(upper, table[:, 6], rtol=0.003)


def test_slopes_of_power_laws_on_any_grid():
    taus = np.array([1.0, 2.0, 3.0, 4.0, 8.0, 16.0, 17.0, 18.0, 40.0])
    np.testing.assert_allclose(local_slopes(taus, 3.0 * taus**-0.5), -0.5)
    np.testing.assert_allclose(local_slopes(taus[:2], taus[:2]), 1.0)


@pytest.mark.parametrize(
    ("power", "name"),
    [
        (-1.0, "quantization"),
        (-0.5, "random_walk"),
        (0.0, "bias_instability"),
        (0.5, "rate_random_walk"),
        (1.0, "rate_ramp"),
        (-2.0, "quantization"),
        (2.0, "rate_ramp"),
    ],
)
def test_types_are_named_by_slope(power, name):
    m = np.array([1, 2, 4, 8])
    assert noise_types(m * 1.0, m**power, m, 10_000) == (name,) * 4


def test_a_chance_dip_at_long_tau_is_not_quantisation():
    m = 2 ** np.arange(12)
    deviation = m**-0.5
    deviation[8:] *= [0.9, 0.5, 0.3, 0.1]
    assert set(noise_types(m * 1.0, deviation, m, 4096 * 4)) == {"random_walk"}


def test_a_type_gives_way_to_a_steeper_one_until_twenty_averages():
    m = 2 ** np.arange(14)
    deviation = np.maximum(m**-0.5, 0.05)
    types = noise_types(m * 1.0, deviation, m, 2**14 * 4)
    assert types[0] == "random_walk"
    assert types[-1] == "bias_instability"


def test_one_point_is_taken_for_white_noise():
    assert noise_types(np.array([1.0]), np.array([2.0]), np.array([1]), 9) == ("random_walk",)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("term", "coefficient", "expected"),
    [("N", 1.0, "random_walk"), ("B", 1.0, "bias_instability"), ("K", 1.0, "rate_random_walk")],
)
def test_types_are_found_in_simulated_records(noise, term, coefficient, expected):
    right = total = 0
    for seed in range(20):
        y = noise(np.random.default_rng(seed), 20_000, 1.0, **{term: coefficient})
        curve = overlapping(y, 1.0)
        sure = (curve.n / curve.m >= 100) & (curve.m >= 10)
        types = noise_types(curve.taus, curve.deviation, curve.m, curve.n)
        right += sum(one == expected for one, flag in zip(types, sure, strict=True) if flag)
        total += int(sure.sum())
    assert right / total > 0.97


def test_composite_lies_between_its_parts_and_tends_to_the_stronger():
    m, pairs = np.array([10, 100, 1000]), np.array([9980, 9800, 8000])
    white = edf_of_types(["random_walk"] * 3, m, pairs)
    walk = edf_of_types(["rate_random_walk"] * 3, m, pairs)
    both = edf_of_model(NoiseModel(random_walk=1.0, rate_random_walk=0.017), m, pairs, 1.0)
    assert np.all((walk <= both) & (both <= white * 1.01))
    assert both[0] == pytest.approx(white[0], rel=0.02)
    assert both[2] == pytest.approx(walk[2], rel=0.02)


@pytest.mark.parametrize("level", [0.683, 0.95])
def test_chi_square_interval(level):
    from scipy.stats import chi2

    lower, upper = interval(np.array([2.0]), np.array([7.3]), level)
    tail = 0.5 * (1.0 - level)
    assert lower[0] == pytest.approx(2.0 * np.sqrt(7.3 / chi2.ppf(1.0 - tail, 7.3)))
    assert upper[0] == pytest.approx(2.0 * np.sqrt(7.3 / chi2.ppf(tail, 7.3)))


@pytest.mark.slow
def test_intervals_cover_what_they_claim(noise):
    """Composite degrees of freedom, a gyro with all three noises, taus to a tenth of the record."""
    model = NoiseModel(0.0025, 0.001, 1e-4)
    m = np.array([1, 10, 100, 1000])
    truth = np.sqrt(model.variance(m / 10.0))
    hits = np.zeros(len(m))
    for seed in range(400):
        y = noise(np.random.default_rng(seed + 5000), 10_000, 10.0, N=0.0025, B=0.001, K=1e-4)
        curve = overlapping(y, 10.0, m=m)
        edf = edf_of_model(model, curve.m, curve.pairs, 10.0)
        lower, upper = interval(curve.deviation, edf, 0.95)
        hits += (lower <= truth) & (truth <= upper)
    assert np.all(hits / 400 > 0.92)
    assert np.all(hits / 400 < 0.98)
