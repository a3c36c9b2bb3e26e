"""Averaging times from noise coefficients; the figures of the source, by simulation."""

import numpy as np
import pytest

from core.allan.model import NoiseModel
from core.errors import FitError
from core.procedures.gyrocompass import find_north, run_of_headings
from core.procedures.north_seeking import (
    Seeking,
    averaging_advice,
    heading_uncertainty,
    held_uncertainty,
)
from core.samples.run import Conditions

KYIV = Seeking(50.45)
LEVEL_DPS = 15.041067 / 3600.0 * np.cos(np.radians(50.45))
SOURCE = NoiseModel(random_walk=2.07e-5)
"""White noise that gives 0.1 deg by steps of 90 degrees and 10 s: 0.00124 deg/sqrt(h)."""
UNIT = NoiseModel(random_walk=2.0e-5, bias_instability=1.5e-6, rate_random_walk=6e-8)


def rates(noise: NoiseModel, seconds: float, dt: float, rng: np.random.Generator) -> np.ndarray:
    """White noise and random walk, step by step."""
    n = round(seconds / dt)
    walk = np.cumsum(noise.rate_random_walk * np.sqrt(dt) * rng.standard_normal(n))
    return walk + noise.random_walk / np.sqrt(dt) * rng.standard_normal(n)


def test_white_noise_by_hand():
    expected = np.degrees(SOURCE.random_walk / np.sqrt(10.0) / np.sqrt(2.0) / LEVEL_DPS)
    assert heading_uncertainty(SOURCE, KYIV, 10.0) == pytest.approx(expected)
    assert expected == pytest.approx(0.1, abs=0.002)
    south = Seeking(-50.45)
    assert heading_uncertainty(SOURCE, south, 10.0) == pytest.approx(expected)
    assert heading_uncertainty(SOURCE, Seeking(80.0), 10.0) > 3.0 * expected


def test_there_is_a_best_time():
    advice = averaging_advice(UNIT, KYIV, target_deg=0.1)
    assert 10.0 < advice.best_s < 500.0
    assert advice.u_deg[-1] > 1.05 * advice.best_deg
    assert 5.0 < advice.enough_s < 20.0
    assert heading_uncertainty(UNIT, KYIV, advice.enough_s) <= 0.1
    assert np.isnan(averaging_advice(UNIT, KYIV, target_deg=1e-4).enough_s)
    assert averaging_advice(SOURCE, KYIV).best_s == pytest.approx(1000.0)


def test_what_finds_no_heading_is_refused():
    with pytest.raises(FitError, match="use steps of 90 deg"):
        heading_uncertainty(UNIT, Seeking(50.0, (0.0, 180.0)), 10.0)
    with pytest.raises(FitError, match="finds no heading"):
        heading_uncertainty(UNIT, Seeking(90.0), 10.0)


def test_flicker_counts_though_averaging_does_not_help():
    flicker = NoiseModel(bias_instability=1e-6)
    short, long = (
        heading_uncertainty(flicker, Seeking(50.45, pause_s=0.0), s) for s in (1.0, 100.0)
    )
    assert short == pytest.approx(long)
    assert short > 0.0


@pytest.mark.slow
def test_the_figures_of_the_source():
    """0.1 deg by steps of 90 degrees with 10 s each; 0.5 deg over hours of keeping the heading."""
    rng = np.random.default_rng(21)
    noise = NoiseModel(random_walk=2.0e-5, rate_random_walk=6e-8)
    quarters, dt, hours = np.array([0.0, 90.0, 180.0, 270.0]), 0.5, 3.0
    psi, drift = 33.0, 0.4 / 3600.0
    errors, kept = [], []
    for _ in range(300):
        total = rates(noise, 60.0 + hours * 3600.0, dt, rng) + drift
        means = []
        for place, delta in enumerate(quarters):
            start = round((15.0 * place + 5.0) / dt)
            earth = LEVEL_DPS * np.cos(np.radians(psi + delta))
            means.append(earth + total[start : start + round(10.0 / dt)].mean())
        se = np.full(4, noise.random_walk / np.sqrt(10.0))
        run = run_of_headings(quarters, np.array(means), "deg/s", se=se)
        found = find_north(run, Conditions(latitude_deg=50.45))
        errors.append(found.heading.value - psi)
        after = total[round(60.0 / dt) :]
        kept.append(errors[-1] + np.sum(after - found.drift.value / 3600.0) * dt)
    predicted = held_uncertainty(noise, KYIV, 10.0, np.array([0.0, hours * 3600.0]))
    assert np.std(errors) == pytest.approx(predicted[0], rel=0.12)
    assert predicted[0] == pytest.approx(0.1, abs=0.01)
    assert np.std(kept) == pytest.approx(predicted[1], rel=0.12)
    assert predicted[1] < 0.5


def test_a_heading_kept_by_a_walking_gyro():
    """The drift found at the start is the better the less the walk has gone on since."""
    rng = np.random.default_rng(8)
    walk, hold, dt = NoiseModel(rate_random_walk=1e-6), 300.0, 0.5
    rate = np.cumsum(1e-6 * np.sqrt(dt) * rng.standard_normal((2000, 720)), axis=1)
    means = np.column_stack([rate[:, a : a + 20].mean(axis=1) for a in (10, 40, 70, 100)])
    delta = np.radians([0.0, 90.0, 180.0, 270.0])
    inverse = np.linalg.pinv(np.column_stack([np.cos(delta), -np.sin(delta), np.ones(4)]))
    north, east, drift = inverse @ means.T
    kept = rate[:, 120:].sum(axis=1) * dt - drift * hold
    found = held_uncertainty(walk, KYIV, 10.0, np.array([hold]))[0]
    spread = [
        np.std(np.degrees((np.cos(psi) * east - np.sin(psi) * north) / LEVEL_DPS) + kept)
        for psi in np.radians(np.arange(0.0, 360.0, 45.0))
    ]
    assert found == pytest.approx(max(spread), rel=0.05)
