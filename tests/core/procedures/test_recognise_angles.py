"""Positions told by the unit's own angle."""

import numpy as np
import pytest

from core.procedures.accuracy_plan import accuracy_plans
from core.procedures.angle_errors import PITCH, ROLL
from core.procedures.recognise import Verdict
from core.procedures.recognise_angles import AngleExpectation


def inputs_of(kind: str) -> tuple[np.ndarray, tuple[str, ...]]:
    steps = accuracy_plans(kind)[f"{kind}_accuracy"].steps
    return np.array([s.specific_force(9.81) for s in steps]), tuple(str(s.number) for s in steps)


@pytest.mark.parametrize(
    ("kind", "chosen", "angle", "verdict"),
    [
        (ROLL, 1, 29.0, Verdict.FITS),
        (ROLL, 7, -179.6, Verdict.FITS),
        (ROLL, 7, 179.6, Verdict.FITS),
        (ROLL, 1, -30.0, Verdict.OTHER_POSITION),
        (ROLL, 1, 45.0, Verdict.NO_POSITION),
        (PITCH, 2, 60.3, Verdict.FITS),
        # Pitch ends at 90 deg: at 120 deg a right unit tells 60.
        (PITCH, 5, 60.3, Verdict.FITS),
        (PITCH, 5, -60.3, Verdict.OTHER_POSITION),
    ],
)
def test_angles_and_positions(kind, chosen, angle, verdict):
    inputs, labels = inputs_of(kind)
    expectation = AngleExpectation(kind)
    expectation.learn(inputs[0], np.zeros(1))
    found = expectation.recognise(np.array([angle]), inputs, labels, chosen)
    assert found.verdict is verdict
    assert bool(found.text) is not found.acceptable


def test_the_position_that_it_looks_like_is_named():
    inputs, labels = inputs_of(ROLL)
    found = AngleExpectation(ROLL).recognise(np.array([-30.0]), inputs, labels, 1)
    assert found.candidates[0] == 13
    assert "looks like 14, not 2" in found.text
