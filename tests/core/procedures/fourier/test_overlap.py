"""Drift is counted per turn, within each realisation."""

import numpy as np
import pytest

from core.procedures.fourier.readings import run_of_angles
from core.procedures.fourier.tumble import calibrate_tumble
from core.samples.run import Conditions


def test_two_turns_count_twice(paper):
    head = np.array([0.0, 40.0, 100.0, 160.0, 220.0, 280.0, 720.0, 760.0, 820.0])
    u = paper(head) + np.where(head > 700.0, 0.02, 0.0)
    run = run_of_angles(head, u, "V", u_se=np.full(9, 1e-3))
    overlap = calibrate_tumble(run, Conditions(g_mps2=1.0)).overlap
    assert overlap is not None
    assert overlap.pairs == 3
    assert overlap.drift.value == pytest.approx(0.01)
    assert overlap.drift.u == pytest.approx(1e-3 * np.sqrt(2.0 / 3.0) / 2.0)
    assert overlap.significant


def test_realisations_are_not_compared_with_each_other(paper):
    head = np.arange(0.0, 360.0, 30.0)
    run = run_of_angles(head, np.column_stack([paper(head), paper(head) + 0.5]), "V")
    assert calibrate_tumble(run, Conditions(g_mps2=1.0)).overlap is None
