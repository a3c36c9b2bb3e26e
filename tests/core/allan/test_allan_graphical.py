from dataclasses import replace

import numpy as np
import pytest

from core.allan.deviation import overlapping
from core.allan.graphical import read_curve
from core.allan.model import TERMS, NoiseModel
from core.arrays import frozen


@pytest.fixture
def curve():
    return overlapping(np.random.default_rng(0).normal(size=360_000), 100.0)


def readings(curve, model):
    exact = replace(curve, deviation=frozen(np.sqrt(model.variance(curve.taus))))
    return {one.term: one for one in read_curve(exact)}


@pytest.mark.parametrize("term", [name for name in TERMS if name != "bias_instability"])
def test_each_pure_slope_is_read_exactly(curve, term):
    got = readings(curve, NoiseModel(**{term: 0.37}))
    assert got[term].value == pytest.approx(0.37)
    assert not got[term].bound
    assert set(got) == {term, "bias_instability"}


def test_a_flat_curve_is_read_over_0_664(curve):
    assert readings(curve, NoiseModel(bias_instability=0.37))["bias_instability"].value == (
        pytest.approx(0.37)
    )


def test_figure_6_3(curve):
    """N = 0.02, B = 0.0083 / 0.664 = 0.012 deg/s: the reading of the figure's own curve."""
    got = readings(curve, NoiseModel(0.02, 0.0083 / 0.664, 3e-4))
    assert got["random_walk"].value == pytest.approx(0.02, rel=0.05)
    assert got["bias_instability"].value == pytest.approx(0.0125, rel=0.1)


def test_a_curve_that_still_falls_bounds_b_only(curve):
    got = readings(curve, NoiseModel(random_walk=1.0))
    assert got["bias_instability"].bound
    assert got["bias_instability"].tau <= 360.0


def test_only_the_terms_asked_for(curve):
    assert [one.term for one in read_curve(curve, ("random_walk",))] == ["random_walk"]


def test_a_short_curve_is_not_read():
    assert read_curve(overlapping(np.random.default_rng(0).normal(size=20), 1.0)) == ()
