"""Coverage factors and tail probabilities against printed tables."""

import math

import numpy as np
import pytest

from core.fit.quantiles import chi2_sf, f_sf, normal_cdf, student_t, student_t_dof


@pytest.mark.parametrize(
    ("level", "dof", "factor"),
    [(0.95, 1, 12.706), (0.95, 4, 2.776), (0.95, 9, 2.262), (0.99, 5, 4.032), (0.95, 120, 1.980)],
)
def test_student_t_of_the_tables(level: float, dof: float, factor: float):
    assert student_t(level, dof) == pytest.approx(factor, abs=5e-4)


def test_infinite_degrees_of_freedom_are_normal():
    assert student_t(0.95, math.inf) == pytest.approx(1.959964, abs=1e-6)


@pytest.mark.parametrize("dof", [0.0, -1.0])
def test_no_degrees_of_freedom_no_interval(dof: float):
    assert student_t(0.95, dof) == math.inf


@pytest.mark.parametrize("dof", [0.7, 1.0, 4.0, 9.0, 57.3])
def test_degrees_of_freedom_of_a_factor(dof: float):
    assert student_t_dof(student_t(0.95, dof)) == pytest.approx(dof, rel=1e-6)


@pytest.mark.parametrize("factor", [1.95, 1.0])
def test_a_factor_below_the_normal_one_is_normal(factor: float):
    assert student_t_dof(factor) == math.inf


def test_tail_probabilities_of_the_tables():
    assert chi2_sf(16.919, 9) == pytest.approx(0.05, abs=1e-5)
    assert f_sf(5.117, 1, 9) == pytest.approx(0.05, abs=1e-4)
    assert np.allclose(normal_cdf(np.array([0.0, 1.959964])), [0.5, 0.975])
