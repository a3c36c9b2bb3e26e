"""Angles and readings become rows in the order of measuring."""

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.fourier.readings import run_of_angles


def test_realisations_follow_one_another():
    u = np.array([[1.0, 10.0], [2.0, 20.0], [3.0, 30.0]])
    run = run_of_angles([0.0, 120.0, 240.0], u, "V", u_se=u / 100.0)
    assert run.y[:, 0].tolist() == [1.0, 2.0, 3.0, 10.0, 20.0, 30.0]
    assert run.y_se[:, 0] == pytest.approx(run.y[:, 0] / 100.0)
    assert run.run.tolist() == [1, 1, 1, 2, 2, 2]
    assert run.head_deg.tolist() == [0.0, 120.0, 240.0] * 2


def test_mixed_lengths_are_refused():
    with pytest.raises(FitError, match="one angle a row"):
        run_of_angles([0.0, 120.0], np.zeros((3, 2)), "V")
