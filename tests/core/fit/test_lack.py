"""Tests of the model: replicates, stated errors, and the few degrees of freedom behind them."""

import numpy as np
import pytest

from core.fit.lack import lack_note, lack_of_fit, model_p_value, rejected_note
from core.fit.quantiles import chi2_sf

RATES = np.repeat(np.arange(-2.0, 3.0), 2)
LINE = np.column_stack([np.ones(10), RATES])
NONE = np.zeros(10)
GROUP = np.arange(10)


def residuals(y: np.ndarray) -> np.ndarray:
    return y - LINE @ np.linalg.lstsq(LINE, y, rcond=None)[0]


def test_the_f_test_is_that_of_the_handbook():
    rng = np.random.default_rng(1)
    y = RATES**2 + rng.normal(0.0, 0.5, 10)
    lack = lack_of_fit(GROUP // 2, 2, y, residuals(y), NONE)
    pairs = y.reshape(5, 2)
    pure = np.sum((pairs - pairs.mean(axis=1, keepdims=True)) ** 2) / 5
    of_fit = (np.sum(residuals(y) ** 2) - 5 * pure) / 3
    assert lack is not None
    assert lack.pure_dof == 5
    assert lack.pure_sd == pytest.approx(np.sqrt(pure))
    assert lack.statistic == pytest.approx(of_fit / pure)
    assert lack.p_value < 0.01


def test_no_replicates_no_test():
    assert (
        lack_of_fit(GROUP[::2] // 2, 2, RATES[::2] ** 2, residuals(RATES**2)[::2], NONE[::2])
        is None
    )


def test_replicates_that_agree_exactly_are_no_measure_of_noise():
    assert lack_of_fit(GROUP // 2, 2, RATES**2, residuals(RATES**2), NONE) is None


def test_a_setting_error_that_repeats_is_not_taken_for_a_lack_of_fit():
    rng = np.random.default_rng(3)
    alarms = 0
    for _ in range(400):
        of_setting = np.repeat(rng.normal(0.0, 3.0, 5), 2)
        y = of_setting + rng.normal(0.0, 1.0, 10)
        lack = lack_of_fit(GROUP // 2, 2, y, residuals(y), np.full(10, 9.0))
        assert lack is not None
        alarms += lack.p_value < 0.05
    assert alarms / 400 < 0.09


def test_false_alarms_of_the_f_test_are_as_many_as_promised():
    rng = np.random.default_rng(4)
    low = 0
    for _ in range(2000):
        y = rng.normal(0.0, 1.0, 10)
        lack = lack_of_fit(GROUP // 2, 2, y, residuals(y), NONE)
        low += lack is not None and lack.p_value < 0.05
    assert 0.038 < low / 2000 < 0.062


def test_known_variances_give_the_chi_square_test():
    assert model_p_value(20.0, 9, 0.0) == chi2_sf(20.0, 9)
    assert model_p_value(20.0, 9, 1e-9) == pytest.approx(chi2_sf(20.0, 9), rel=1e-4)


def test_doubt_about_the_variances_makes_a_large_chi_square_less_surprising():
    assert model_p_value(25.0, 9, 1.0) > 2.0 * chi2_sf(25.0, 9)


def test_notes_carry_the_numbers():
    y = RATES**2 + np.random.default_rng(1).normal(0.0, 0.5, 10)
    lack = lack_of_fit(GROUP // 2, 2, y, residuals(y), NONE)
    assert lack is not None
    assert f"{lack.pure_sd:.3g}" in lack_note(lack).text
    assert "3.0 times" in rejected_note(1e-4, 9.0, False).text


def test_false_alarms_with_variances_of_few_degrees_of_freedom():
    rng = np.random.default_rng(6)
    dof, n, trials = 6.0, 11, 4000
    low = {"allowed for": 0, "ignored": 0}
    for _ in range(trials):
        variance = rng.chisquare(dof, n) / dof
        y, weight = rng.normal(size=n), 1.0 / variance
        chi2 = float(np.sum(weight * (y - weight @ y / weight.sum()) ** 2))
        doubt = float(np.sum((1.0 - weight / weight.sum()) ** 2 / dof))
        low["allowed for"] += model_p_value(chi2, n - 1, doubt) < 0.05
        low["ignored"] += chi2_sf(chi2, n - 1) < 0.05
    assert 0.035 < low["allowed for"] / trials < 0.08
    assert low["ignored"] / trials > 0.15
