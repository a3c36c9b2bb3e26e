"""The common scatter beside the settings: its two limits, and an independent integration."""

import numpy as np
import pytest
from scipy import integrate, stats

from core.fit.quantiles import student_t
from core.fit.scatter import common_scatter, extra_scatter, rounding_variance

X = np.column_stack([np.ones(11), np.linspace(-1.0, 1.0, 11)])


def sample(seed: int, common: float, setting: np.ndarray) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return X @ [5.0, -3.0] + rng.normal(size=11) * np.sqrt(setting + common)


def deviation(design: np.ndarray, variance: np.ndarray) -> np.ndarray:
    information = design.T @ (design / variance[:, None])
    return np.sqrt(np.diag(np.linalg.inv(information)))


def test_without_setting_errors_it_is_student_t():
    y = sample(1, 0.04, np.zeros(11))
    scatter = common_scatter(X, y, np.full(11, 1e-30))
    residual = y - X @ np.linalg.lstsq(X, y, rcond=None)[0]
    s2 = residual @ residual / 9
    assert np.allclose(scatter.variance, s2, rtol=2e-3)
    expected = student_t(0.95, 9) * deviation(X, np.full(11, s2))
    assert np.allclose(scatter.half_widths(), expected, rtol=2e-3)


def test_setting_errors_that_explain_everything_leave_the_normal_interval():
    setting = np.full(11, 1.0)
    # Residuals ten times smaller than the settings could have made them.
    y = sample(2, 0.0, np.full(11, 0.01))
    scatter = common_scatter(X, y, setting)
    known = 1.96 * deviation(X, setting)
    assert np.all(scatter.half_widths() >= known)
    assert np.all(scatter.half_widths() < 1.25 * known)


@pytest.mark.parametrize("seed", range(3))
def test_half_widths_agree_with_adaptive_integration(seed: int):
    setting = np.linspace(-1.0, 1.0, 11) ** 2 * 0.09
    y = sample(seed, 0.02, setting)
    scatter = common_scatter(X, y, setting)
    inverse = np.linalg.pinv(X)

    def parts(log_s2: float) -> tuple[float, np.ndarray]:
        w = 1.0 / (setting + np.exp(log_s2))
        covariance = np.linalg.inv(X.T @ (X * w[:, None]))
        p = np.diag(w) - (w[:, None] * X) @ covariance @ (w[:, None] * X).T
        log_density = (np.log(w).sum() + np.linalg.slogdet(covariance)[1] - y @ p @ y) / 2
        density = np.exp(log_density - 20.0) * np.trace(p) * np.exp(log_s2)
        # The estimates are those of equal weights: unbiased, with this deviation.
        return density, np.sqrt(inverse**2 @ (setting + np.exp(log_s2)))

    def mass(of: int | None, width: float) -> float:
        def inside(log_s2: float) -> float:
            density, u = parts(log_s2)
            if of is None:
                return density
            return density * (stats.norm.cdf(width / u[of]) - stats.norm.cdf(-width / u[of]))

        return integrate.quad(inside, -22.0, 6.0, limit=400, epsabs=0.0, epsrel=1e-9)[0]

    total = mass(None, 0.0)
    for which, width in enumerate(scatter.half_widths()):
        assert mass(which, float(width)) / total == pytest.approx(0.95, abs=2e-4)


def test_the_unit_of_the_outputs_does_not_matter():
    setting = np.linspace(0.0, 1.0, 11)
    y = sample(7, 0.3, setting)
    small, large = common_scatter(X, y, setting), common_scatter(X, 1e6 * y, 1e12 * setting)
    assert np.allclose(1e6 * small.half_widths(), large.half_widths(), rtol=1e-4)
    assert np.allclose(1e12 * small.variance, large.variance, rtol=1e-2)


def test_many_rows_are_resolved_by_the_grid():
    rng = np.random.default_rng(3)
    design = np.column_stack([np.ones(400), rng.normal(size=400)])
    setting = np.full(400, 0.5)
    y = design @ [1.0, 2.0] + rng.normal(size=400) * np.sqrt(1.5)
    scatter = common_scatter(design, y, setting)
    # Settings alike in all rows hide in the scatter: the sum is what the residuals show.
    residual = y - design @ np.linalg.lstsq(design, y, rcond=None)[0]
    assert np.allclose(scatter.variance, residual @ residual / 398, rtol=0.01)
    expected = student_t(0.95, 398) * deviation(design, scatter.variance)
    assert np.allclose(scatter.half_widths(), expected, rtol=0.01)


def test_rounding_is_that_of_the_largest_output():
    assert rounding_variance(np.array([0.0, -8e6])) == np.spacing(8e6) ** 2


def test_rows_that_agree_pay_little_for_the_doubt():
    known = np.full(11, 1.0)
    widths = []
    for seed in range(200):
        scatter = extra_scatter(X, sample(seed, 0.0, known), known)
        assert np.all(scatter.variance >= known)
        widths.append(scatter.half_widths() / (1.96 * deviation(X, known)))
    assert np.all(np.median(widths, axis=0) < 1.2)
    assert np.all(np.min(widths, axis=0) >= 1.0)


def test_extra_scatter_is_found_where_it_is_plain():
    known = np.full(11, 1.0)
    found = [extra_scatter(X, sample(seed, 24.0, known), known).variance for seed in range(200)]
    # The mean precision of a scatter told by 9 degrees of freedom.
    assert np.median(found) == pytest.approx(25.0, rel=0.15)


def test_extra_scatter_keeps_the_rows_that_are_known_better_ahead():
    known = np.linspace(0.1, 9.0, 11)
    scatter = extra_scatter(X, sample(3, 0.2, known), known)
    assert np.all(np.diff(scatter.variance) > 0)
