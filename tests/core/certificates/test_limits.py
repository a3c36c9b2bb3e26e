"""Parameters against limits."""

import pytest

from core.certificates.limits import ParameterLimit, judge_stated, stated_of
from core.procedures.calibration import Calibration
from core.procedures.conformity import RULES, Verdict


def test_every_sensor_with_the_parameter_is_judged(calibration: Calibration):
    limits = (ParameterLimit("scale_factor", "", 1000.0, 5.0),)
    found = judge_stated(stated_of(calibration), limits, "guarded")
    assert found is not None
    assert [one.channel for one in found.judged] == ["Ux", "Uy", "Uz"]
    assert found.verdict is Verdict.PASS
    assert found.rule == RULES["guarded"].text
    fit = calibration.fits[0]
    assert found.judged[0].deviation == pytest.approx(fit.value("scale_factor") - 1000.0)
    assert found.judged[0].expanded == fit.expanded()[fit.index("scale_factor")]


def test_one_sensor_out_of_its_limit_fails_the_whole(calibration: Calibration):
    limits = (
        ParameterLimit("bias", "", 25.0, 10.0),
        ParameterLimit("bias", "Uy", 500.0, 10.0),
    )
    found = judge_stated(stated_of(calibration), limits, "guarded")
    assert found is not None
    assert found.verdict is Verdict.FAIL
    assert [one.channel for one in found.judged if one.verdict is Verdict.FAIL] == ["Uy"]


def test_a_limit_within_the_uncertainty_decides_nothing_under_the_guard(calibration: Calibration):
    fit = calibration.fits[0]
    value, half = fit.value("bias"), float(fit.expanded()[fit.index("bias")])
    limit = (ParameterLimit("bias", "Ux", value - half, 1.5 * half),)
    guarded, simple = (judge_stated(stated_of(calibration), limit, rule) for rule in RULES)
    assert guarded is not None
    assert simple is not None
    assert guarded.verdict is Verdict.UNDECIDED
    assert simple.verdict is Verdict.PASS


def test_limits_of_other_parameters_judge_nothing(calibration: Calibration):
    assert judge_stated(stated_of(calibration), (), "guarded") is None
    other = (ParameterLimit("g_sensitivity_x", "", 0.0, 1.0),)
    assert judge_stated(stated_of(calibration), other, "guarded") is None
