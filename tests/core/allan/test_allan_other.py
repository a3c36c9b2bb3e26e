import sys
from pathlib import Path

import numpy as np
import pytest

from core.allan import other
from core.allan.other import KINDS, other_deviation
from core.errors import FitError

PHASEDAT = Path(__file__).parents[2] / "data" / "allan_reference" / "phasedat"


@pytest.mark.parametrize(
    ("kind", "file"),
    [
        ("hadamard", "phase_dat_ohdev_octave.txt"),
        ("modified", "phase_dat_mdev_octave.txt"),
        ("total", "phase_dat_totdev_octave.txt"),
    ],
)
def test_stable32(kind, file):
    table = np.loadtxt(PHASEDAT / file)
    y = np.diff(np.loadtxt(PHASEDAT / "PHASE.DAT"))
    curve = other_deviation(y, 1.0, kind, count=400)
    assert curve.mode == kind
    shared = np.isin(table[:, 0], curve.m)
    assert shared.sum() >= 7
    at = np.searchsorted(curve.m, table[shared, 0])
    printed = [f"{one:.4e}" for one in curve.deviation[at]]
    assert printed == [f"{one:.4e}" for one in table[shared, 5]]


@pytest.mark.parametrize("kind", KINDS)
def test_limits_are_about_those_of_the_scatter(kind):
    variances = [
        other_deviation(np.random.default_rng(seed).normal(size=1000), 1.0, kind).variance
        for seed in range(40)
    ]
    curve = other_deviation(np.random.default_rng(0).normal(size=1000), 1.0, kind)
    edf = 2.0 * np.mean(variances, axis=0) ** 2 / np.var(variances, axis=0)
    place = int(np.searchsorted(curve.m, 30))
    assert curve.edf[place] == pytest.approx(edf[place], rel=0.4)
    assert np.all((curve.lower < curve.deviation) & (curve.deviation < curve.upper))


def test_hadamard_is_blind_to_a_ramp():
    y = np.random.default_rng(0).normal(size=3000)
    plain = other_deviation(y, 1.0, "hadamard")
    ramped = other_deviation(y + 0.05 * np.arange(3000), 1.0, "hadamard")
    np.testing.assert_allclose(ramped.deviation, plain.deviation, rtol=1e-6)


def test_gaps_leave_the_longest_stretch():
    y = np.random.default_rng(0).normal(size=3000)
    y[500] = np.nan
    curve = other_deviation(y, 1.0, "modified")
    assert curve.n == 2499
    assert [note.subject for note in curve.notes] == ["gaps"]
    with pytest.raises(ValueError, match="longest"):
        other_deviation(y, 1.0, "modified", gaps="stretches")


def test_very_long_records_are_refused(monkeypatch):
    monkeypatch.setattr(other, "MOST", 1000)
    with pytest.raises(FitError, match="up to 1000 samples"):
        other_deviation(np.random.default_rng(0).normal(size=1001), 1.0, "total")


def test_without_the_library_the_way_to_get_it_is_said(monkeypatch):
    monkeypatch.setitem(sys.modules, "allantools", None)
    with pytest.raises(FitError, match=r"pip install \"calrig\[allan\]\""):
        other_deviation(np.random.default_rng(0).normal(size=1000), 1.0, "hadamard")
