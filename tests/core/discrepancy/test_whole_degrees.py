"""An angle that is wrong by whole degrees is more than an outlier."""

import numpy as np

from core.discrepancy.ladder import explain
from core.discrepancy.result import Step
from core.discrepancy.settings import Settings
from tests.core.discrepancy.hidden import Truth, felt, head_run

ROW = 30


def off_by(degrees: float) -> Step:
    def hidden(truth: Truth) -> np.ndarray:
        extra = np.zeros(len(truth.t))
        there = felt(str(truth.mount[ROW]), truth.head[ROW] + degrees)
        extra[ROW] = (there - truth.a[ROW]) @ np.array([0.012, -0.008, 1.0])
        return extra

    (step,) = explain(head_run(hidden), Settings(advise=False)).steps
    return step


def test_whole_degrees_speak_for_a_wrong_angle_and_other_angles_do_not():
    whole, other = off_by(1.0), off_by(1.37)
    assert whole.effect == "wrong_angle"
    assert "outlier" not in whole.indistinguishable_from
    assert {"wrong_angle", "outlier"} <= {other.effect, *other.indistinguishable_from}
    assert abs(whole.parameters[0].value - 1.0) < 3.0 * whole.parameters[0].u
