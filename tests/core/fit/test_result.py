"""What a result answers about itself."""

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


def test_expanded_uncertainty_by_its_own_degrees_of_freedom(fit: FitResult):
    assert np.allclose(fit.expanded(), [2.0 * 2.776445, 3.0 * 1.959964], rtol=1e-6)
    assert fit.expanded(0.99)[1] == pytest.approx(3.0 * 2.575829, rel=1e-6)


def test_an_unknown_parameter_is_named(fit: FitResult):
    with pytest.raises(KeyError, match="k_z"):
        fit.value("k_z")
