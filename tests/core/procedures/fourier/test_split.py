"""(18) with the sign and branch that it lost; separable or not; Monte Carlo intervals."""

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.fourier.readings import run_of_angles
from core.procedures.fourier.split import Split, split
from core.procedures.fourier.tumble import TumbleResult, calibrate_tumble
from core.samples.run import Conditions

UNIT_G = Conditions(g_mps2=1.0)
HEAD = np.arange(5.0, 401.0, 5.0)


def tumbled(paper, noise: float = 1e-7, seed: int = 0, repeats: int = 5, **how) -> TumbleResult:
    rng = np.random.default_rng(seed)
    u = paper(HEAD, **how)[:, None] + noise * rng.standard_normal((80, repeats))
    return calibrate_tumble(run_of_angles(HEAD, u, "V", u_se=np.full_like(u, noise)), UNIT_G)


def printed(c: np.ndarray) -> tuple[float, float, float, float]:
    """(18) as printed, in the source's signs."""
    alpha0 = 0.5 * np.arctan2(c[4], c[3])
    k_xy = 2.0 * np.hypot(c[3], c[4])
    k_x = -(c[1] * np.cos(alpha0) + c[2] * np.sin(alpha0))
    k_y = c[1] * np.sin(alpha0) - c[2] * np.cos(alpha0)
    return np.degrees(alpha0), k_x, k_y, k_xy


def numbers(found: Split) -> list[float]:
    return [found.alpha0.value, found.k_x.value, found.k_y.value, found.k_xy.value]


def test_the_parameters_of_the_source_come_back(paper):
    found = split(tumbled(paper), gravity_projection=True)
    assert found.separable
    assert numbers(found) == pytest.approx([0.1121, 1.0, 0.0098, 0.001], abs=1e-3)
    assert numbers(found)[1:] == pytest.approx([1.0, 0.0098, 0.001], abs=1e-5)
    assert [note.subject for note in found.notes] == ["k2_assumed_zero"]
    force = split(tumbled(paper))
    assert (force.k_x.value, force.k_y.value) == (-found.k_x.value, -found.k_y.value)
    assert force.k_xy.value == found.k_xy.value


def test_a_negative_product_term_keeps_its_sign(paper):
    result = tumbled(paper, kxy=-0.001)
    found = split(result, gravity_projection=True)
    assert numbers(found) == pytest.approx([0.1121, 1.0, 0.0098, -0.001], abs=1e-3)
    # The printed formula finds the axes swapped.
    wrong = printed(result.fit.values)
    assert wrong == pytest.approx((-89.888, -0.0098, 1.0, 0.001), abs=2e-3)


def test_a_negative_polarity_is_no_branch(paper):
    found = split(tumbled(paper, kx=-1.0, ky=0.02, kxy=0.002, alpha0=-3.0), gravity_projection=True)
    assert numbers(found) == pytest.approx([-3.0, -1.0, 0.02, 0.002], abs=1e-3)


def test_a_quadratic_term_breaks_the_assumption(paper):
    found = split(tumbled(paper, k2=0.0005), gravity_projection=True)
    assert numbers(found)[:3] == pytest.approx([-13.17, 0.971, 0.239], abs=0.01)


def test_noise_of_millivolts_forbids_the_split(paper):
    assert split(tumbled(paper, noise=1e-3)).alpha0.u == pytest.approx(4.1, rel=0.1)
    # The well-conditioned sum is fine with the same data.
    assert tumbled(paper, noise=1e-3).misalignment.u == pytest.approx(0.004, rel=0.05)
    found = split(tumbled(paper, noise=2e-3))
    assert not found.separable
    assert "not_separable" in [note.subject for note in found.notes]
    fine = split(tumbled(paper, noise=1e-5))
    assert fine.alpha0.u == pytest.approx(0.041, rel=0.05)
    assert fine.k_y.u == pytest.approx(0.00071, rel=0.05)


@pytest.mark.parametrize(
    ("ratio", "half", "linear"), [(1.0, 70.0, 56.0), (3.0, 20.4, 18.7), (10.0, 5.66, 5.61)]
)
def test_intervals_grow_beyond_the_linear_rule(paper, ratio: float, half: float, linear: float):
    # One realisation of 80 angles: u(C) = noise sqrt(2/80).
    noise = 0.0005 / ratio / np.sqrt(2.0 / 80.0)
    exact = paper(HEAD)
    run = run_of_angles(HEAD, exact, "V", u_se=np.full(80, noise))
    found = split(calibrate_tumble(run, UNIT_G))
    assert found.ratio == pytest.approx(ratio, rel=0.05)
    assert (found.alpha0.high - found.alpha0.low) / 2.0 == pytest.approx(half, rel=0.06)
    assert 1.96 * np.degrees(0.5 / found.ratio) == pytest.approx(linear, rel=0.06)


def test_no_second_harmonic_is_no_division_by_zero(paper):
    exact = paper(HEAD, kxy=0.0)
    run = run_of_angles(HEAD, exact, "V", u_se=np.full(80, 1e-3))
    found = split(calibrate_tumble(run, UNIT_G))
    assert np.isfinite(numbers(found)).all()
    assert not found.separable


def test_without_uncertainty_there_is_no_split(paper):
    head = np.array([0.0, 72.0, 144.0, 216.0, 288.0])
    with pytest.raises(FitError, match="no uncertainty"):
        split(calibrate_tumble(run_of_angles(head, paper(head), "V"), UNIT_G))


@pytest.mark.slow
def test_monte_carlo_intervals_hold_the_truth(paper):
    trials, hits = 200, np.zeros(4)
    truth = (0.1121, 1.0, 0.0098, 0.001)
    for seed in range(trials):
        found = split(tumbled(paper, 2.0e-4, seed, repeats=1), gravity_projection=True)
        spreads = (found.alpha0, found.k_x, found.k_y, found.k_xy)
        hits += [one.low < true < one.high for one, true in zip(spreads, truth, strict=True)]
    # k_x departs from its truth by a cosine: its interval is one-sided there.
    assert np.all(hits[[0, 2, 3]] / trials > 0.91)
    assert np.all(hits[[0, 2, 3]] / trials < 0.985)
