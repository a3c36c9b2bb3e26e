"""Fixture and sensor are told apart without assuming K2 = 0."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.plans.plan import load_plans
from core.procedures.fourier.flip import separate
from core.procedures.fourier.readings import run_of_angles
from core.procedures.fourier.tumble import TumbleResult, calibrate_tumble
from core.samples.run import Conditions

HEAD = np.arange(15.0, 376.0, 15.0)
CASE = Conditions(g_mps2=9.8106, u_g_mps2=1e-5)
TRUTH = {"bias": 2.5, "k": 0.1, "k_cross": 0.0015, "product": 4e-5, "quadratic": -3e-5}


def output(head_deg: np.ndarray, fixture_deg: float, flipped: bool) -> np.ndarray:
    """Specific force by turning vectors in the room: X out of the level, Y up or down."""
    angle = np.radians(head_deg + fixture_deg)
    level, up = np.array([1.0, 0.0]), np.array([0.0, 1.0])
    rows = []
    for a in angle:
        x = np.cos(a) * level + np.sin(a) * up
        y = (-np.sin(a) * level + np.cos(a) * up) * (-1.0 if flipped else 1.0)
        ax, ay = 9.8106 * x[1], 9.8106 * y[1]
        rows.append(
            TRUTH["bias"]
            + TRUTH["k"] * ax
            + TRUTH["k_cross"] * ay
            + TRUTH["product"] * ax * ay
            + TRUTH["quadratic"] * ax**2
        )
    return np.array(rows)


def tumbled(
    flipped: bool, fixture_deg: float = 0.4, noise: float = 0.0, seed: int = 0
) -> TumbleResult:
    u = output(HEAD, fixture_deg, flipped) + noise * np.random.default_rng(seed).normal(size=25)
    se = np.full(25, max(noise, 1e-9))
    return calibrate_tumble(run_of_angles(HEAD, u, "V", u_se=se, flipped=flipped), CASE)


def test_every_quantity_comes_back():
    found = separate(tumbled(False), tumbled(True))
    assert found.fixture.value == pytest.approx(0.4, abs=1e-8)
    assert found.misalignment.value == pytest.approx(np.degrees(np.arctan(0.015)), abs=1e-8)
    for name, value in TRUTH.items():
        assert getattr(found, name).value == pytest.approx(value, rel=1e-6), name


def test_the_order_of_the_two_does_not_matter():
    one, other = separate(tumbled(False), tumbled(True)), separate(tumbled(True), tumbled(False))
    assert one.fixture.value == pytest.approx(other.fixture.value)
    assert one.quadratic.value == pytest.approx(other.quadratic.value)


def test_the_plan_holds_both_mounts():
    steps = load_plans()["fourier_flip"].steps
    assert [step.head_deg for step in steps] == [*HEAD, *HEAD]
    runs = [run_of_angles(HEAD, np.zeros(25), "V", flipped=flipped) for flipped in (False, True)]
    assert [step.mount for step in steps] == [*runs[0].mount, *runs[1].mount]


def test_two_tumbles_that_are_no_flip_are_refused():
    upright = tumbled(False)
    with pytest.raises(FitError, match="was not turned over"):
        separate(upright, tumbled(False))
    with pytest.raises(FitError, match="one sensor is needed"):
        separate(upright, replace(tumbled(True), axis="z"))


@pytest.mark.slow
def test_intervals_hold_the_truth():
    truth = {**TRUTH, "fixture": 0.4, "misalignment": np.degrees(np.arctan(0.015))}
    trials, hits = 700, dict.fromkeys(truth, 0)
    for seed in range(trials):
        found = separate(
            tumbled(False, 0.4, 3e-4, 2 * seed), tumbled(True, 0.4, 3e-4, 2 * seed + 1)
        )
        for name, value in truth.items():
            one = getattr(found, name)
            hits[name] += abs(one.value - value) < one.expanded()
    assert all(0.93 < count / trials < 0.97 for count in hits.values()), hits
