"""One number with its uncertainty: ratios, freedom, coverage."""

import math

import numpy as np
import pytest

from core.fit.estimate import Estimate, freedom, parameter, quotient, ratio
from core.fit.result import FitResult
from core.model.effect import Parameter


def fit(covariance: list[list[float]], dofs: tuple[float, float] = (9.0, 9.0)) -> FitResult:
    return FitResult(
        parameters=(Parameter("bias", "U0", "V"), Parameter("scale_factor", "k", "V/(deg/s)")),
        values=np.array([6.0, -2.0]),
        covariance=np.array(covariance),
        shared=np.zeros((2, 1)),
        t_dof=np.array(dofs),
        fitted=np.zeros(3),
        residuals=np.zeros(3),
        sigma=np.ones(3),
        free=np.full(3, 1.0 / 3.0),
        sigma_source="residual",
        chi2=1.0,
        dof=1,
        p_value=float("nan"),
        condition=1.0,
        lack_of_fit=None,
        notes=(),
    )


def test_a_parameter_of_a_fit():
    k = parameter(fit([[1.0, 0.0], [0.0, 4.0]]), "scale_factor")
    assert k == Estimate(-2.0, 2.0, 9.0, "V/(deg/s)")


def test_a_ratio_knows_the_correlation():
    rng = np.random.default_rng(1)
    covariance = [[0.04, 0.006], [0.006, 0.0025]]
    over, under = rng.multivariate_normal([6.0, -2.0], covariance, 400_000).T
    found = ratio(fit(covariance), "bias", "scale_factor", "deg/s")
    assert found.value == -3.0
    assert found.u == pytest.approx((over / under).std(), rel=0.01)
    assert found.dof == 9.0
    assert found.unit == "deg/s"


def test_a_ratio_of_unequal_freedom_lies_between():
    found = ratio(fit([[0.04, 0.0], [0.0, 0.0025]], (4.0, math.inf)), "bias", "scale_factor", "")
    assert 4.0 < found.dof < math.inf


def test_a_quotient_of_independent_estimates():
    over, under = Estimate(6.0, 0.06, 4.0, "a"), Estimate(3.0, 0.06, math.inf, "b")
    found = quotient(over, under, "a/b")
    assert found.value == 2.0
    assert found.u == pytest.approx(2.0 * math.hypot(0.01, 0.02))
    assert found.dof == pytest.approx(4.0 * (math.hypot(0.01, 0.02) / 0.01) ** 4)


@pytest.mark.parametrize(
    ("parts", "dofs", "expected"),
    [
        ((1.0, 0.0), (5.0, 3.0), 5.0),
        ((1.0, 1.0), (5.0, 5.0), 10.0),
        ((1.0, 1.0), (math.inf, math.inf), math.inf),
        ((0.0, 0.0), (5.0, 3.0), 3.0),
        ((1.0, 1.0), (5.0, 0.0), 0.0),
        ((1.0, 0.0), (5.0, 0.0), 5.0),
    ],
)
def test_welch_and_satterthwaite(parts, dofs, expected: float):
    assert freedom(parts, dofs) == pytest.approx(expected)


def test_expanded_and_scaled():
    estimate = Estimate(2.0, 0.5, 4.0, "deg/s")
    assert estimate.expanded() == pytest.approx(0.5 * 2.776445, rel=1e-6)
    assert estimate.scaled(-3600.0, "deg/h") == Estimate(-7200.0, 1800.0, 4.0, "deg/h")
    assert math.isnan(Estimate(2.0, math.nan, 0.0, "").expanded())
    assert Estimate(2.0, 0.0, 0.0, "").expanded() == 0.0


@pytest.mark.parametrize(
    ("value", "u", "dof", "expected"),
    [(2.0, 0.5, 9.0, True), (1.5, 0.5, 9.0, False), (9.0, math.nan, 0.0, False)],
)
def test_significant_means_outside_the_99_percent_interval(value, u, dof, expected):
    assert Estimate(value, u, dof, "").significant is expected
