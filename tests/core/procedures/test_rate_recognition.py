"""Rates that are not those of the plan, and their stories."""

import numpy as np
import pytest

from core.procedures.rate_recognition import RateExpectation
from core.procedures.recognise import Nominal, Verdict

RATES = np.arange(-100.0, 101.0, 20.0)
INPUTS = np.column_stack([np.zeros((11, 2)), RATES])
LABELS = tuple(f"rate {i + 1} ({rate:+g} deg/s)" for i, rate in enumerate(RATES))
SLOPES = np.array([-79.4, -80.1, -78.2])
ZEROS = np.array([-438.0, -600.0, -300.0])


def outputs(rate: float) -> np.ndarray:
    return SLOPES * rate + ZEROS


@pytest.fixture
def taught() -> RateExpectation:
    """Three rates accepted."""
    one = RateExpectation(100.0, ("z",) * 3)
    for i in range(3):
        one.learn(INPUTS[i], outputs(RATES[i]))
    return one


def test_nothing_is_claimed_of_the_first_rate_and_the_next_fit(taught: RateExpectation):
    fresh = RateExpectation(100.0, ("z",) * 3)
    assert fresh.recognise(outputs(-100.0), INPUTS, LABELS, 0).acceptable
    assert taught.recognise(outputs(-40.0), INPUTS, LABELS, 3).verdict is Verdict.FITS


@pytest.mark.parametrize(
    ("rate", "story"),
    [
        (40.0, "turned the wrong way"),
        (0.0, "stood still"),
        (-24.0, "turned for 60 % of the accumulation"),
    ],
)
def test_a_wrong_rate_has_its_story(taught: RateExpectation, rate: float, story: str):
    found = taught.recognise(outputs(rate), INPUTS, LABELS, 3)
    assert not found.acceptable
    assert story in found.text
    assert "rate 4 (-40 deg/s)" in found.text
    assert f"stand for {rate:+.3g} deg/s" in found.text


def test_a_large_zero_on_a_small_range_is_no_other_rate():
    one = RateExpectation(40.0, ("z",) * 3)
    one.learn(INPUTS[3], outputs(-40.0))
    assert one.recognise(outputs(0.0), INPUTS[3:8], LABELS[3:8], 2).acceptable


def test_an_earlier_calibration_tells_from_the_first_rate():
    known = Nominal(np.column_stack([np.zeros((3, 2)), SLOPES]), ZEROS, "last year")
    one = RateExpectation(100.0, ("z",) * 3, known)
    found = one.recognise(outputs(100.0), INPUTS, LABELS, 0)
    assert not found.acceptable
    assert "wrong way" in found.text


def test_each_axis_has_its_own_line(taught: RateExpectation):
    about_x = np.array([[rate, 0.0, 0.0] for rate in RATES])
    cross = np.array([0.2, -0.1, 0.3])
    inputs = np.vstack([INPUTS, about_x])
    labels = LABELS + tuple(f"x {label}" for label in LABELS)
    found = taught.recognise(cross * -100.0 + ZEROS, inputs, labels, 11)
    assert found.acceptable
