"""Angles modulo a turn; saturation of either sign, and what is none."""

import numpy as np
import pytest

from core.errors import FitError, RankDeficient
from core.procedures.fourier.faults import check_angles, check_saturation

FULL = np.arange(0.0, 360.0, 5.0)


def test_angles_count_modulo_a_turn():
    check_angles(np.array([0.0, 72.0, 144.0, 216.0, 288.0]), 2)
    with pytest.raises(FitError, match="4 different"):
        check_angles(np.array([0.0, 360.0, 1e-9, 359.9999999999, 72.0, 144.0, 216.0]), 2)


def test_quarter_turns_hide_the_second_harmonic():
    with pytest.raises(RankDeficient) as four:
        check_angles(np.array([0.0, 90.0, 180.0, 270.0, 360.0, 450.0]), 2)
    assert four.value.free == ("C3",)
    with pytest.raises(RankDeficient) as two:
        check_angles(np.array([0.0, 180.0, 360.0, 540.0, 0.0]), 2)
    assert two.value.free == ("C3", "C4")
    check_angles(np.arange(0.0, 360.0, 45.0), 2)


def test_a_limit_of_the_output_is_seen():
    y = np.sin(np.radians(FULL))
    check_saturation(FULL, y)
    # Coarse codes are equal at a few neighbouring angles.
    check_saturation(FULL, np.round(y / 0.004))
    with pytest.raises(FitError, match=r"0\.9, its largest, over 50 degrees"):
        check_saturation(FULL, np.minimum(y, 0.9))
    with pytest.raises(FitError, match="smallest"):
        check_saturation(FULL, np.maximum(y, -0.9))
    with pytest.raises(FitError, match="largest, over 50"):
        check_saturation(FULL, np.minimum(np.cos(np.radians(FULL)), 0.9))
