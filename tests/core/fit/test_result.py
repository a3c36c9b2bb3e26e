"""What a result answers about itself."""

from dataclasses import replace

import numpy as np
import pytest

from core.fit.result import FitResult
from core.model.effect import Parameter


@pytest.fixture
def fit() -> FitResult:
    return FitResult(
        parameters=(Parameter("bias", "U0", "code"), Parameter("scale_factor", "k_z", "code/g")),
        values=np.array([1.0, 2.0]),
        covariance=np.array([[4.0, 3.0], [3.0, 9.0]]),
        shared=np.zeros((2, 3)),
        t_dof=np.array([4.0, np.inf]),
        fitted=np.zeros(3),
        residuals=np.zeros(3),
        sigma=np.ones(3),
        free=np.full(3, 1.0 / 3.0),
        sigma_source="known",
        chi2=1.0,
        dof=1,
        p_value=0.3,
        condition=1.0,
        lack_of_fit=None,
        notes=(),
    )


def test_values_and_uncertainties_by_name(fit: FitResult):
    assert fit.names == ("bias", "scale_factor")
    assert fit.index("scale_factor") == 1
    assert fit.value("scale_factor") == 2.0
    assert fit.u("scale_factor") == 3.0
    assert np.allclose(fit.stderr, [2.0, 3.0])
    assert np.allclose(fit.correlation, [[1.0, 0.5], [0.5, 1.0]])


def test_the_limits_of_residuals_know_what_the_fit_took(fit: FitResult):
    assert fit.residual_limits() == pytest.approx(np.full(3, 1.95996 / np.sqrt(3.0)), rel=1e-5)
    assert np.all(np.isinf(replace(fit, sigma_source="none").residual_limits()))
    untold = replace(fit, free=np.full(3, np.nan))
    assert untold.residual_limits() == pytest.approx(1.95996, rel=1e-5)
    # Thompson's tau for 4 degrees of freedom: t of 3 is 3.18245.
    own = replace(fit, sigma_source="residual", dof=4)
    assert own.residual_limits() == pytest.approx(np.full(3, 1.75668 / np.sqrt(3.0)), rel=1e-5)
    one = replace(own, dof=1).residual_limits()
    assert one == pytest.approx(np.full(3, 1.0 / np.sqrt(3.0)))


def test_expanded_uncertainty_by_its_own_degrees_of_freedom(fit: FitResult):
    assert np.allclose(fit.expanded(), [2.0 * 2.776445, 3.0 * 1.959964], rtol=1e-6)
    assert fit.expanded(0.99)[1] == pytest.approx(3.0 * 2.575829, rel=1e-6)


def test_an_unknown_parameter_is_named(fit: FitResult):
    with pytest.raises(KeyError, match="k_z"):
        fit.value("k_z")
