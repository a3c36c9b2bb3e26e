"""Verdicts at, inside and outside the guard band."""

import numpy as np
import pytest

from core.procedures.conformity import RULES, Verdict, judge, worst

PASS, FAIL, UNDECIDED = Verdict.PASS, Verdict.FAIL, Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("value", "expanded", "rule", "expected"),
    [
        (0.03, 0.02, "guarded", PASS),
        (0.03, 0.021, "guarded", UNDECIDED),
        (-0.03, 0.02, "guarded", PASS),
        (0.07, 0.0199, "guarded", FAIL),
        (-0.07, 0.0199, "guarded", FAIL),
        (0.07, 0.03, "guarded", UNDECIDED),
        (0.05, 0.0, "guarded", PASS),
        (0.049, 0.5, "simple", PASS),
        (-0.051, 0.5, "simple", FAIL),
    ],
)
def test_verdicts(value: float, expanded: float, rule: str, expected: Verdict):
    assert judge(value, expanded, 0.05, RULES[rule]) is expected


def test_the_risk_of_a_wrong_pass_is_at_most_a_fortieth():
    rng = np.random.default_rng(1)
    # A unit exactly at its limit, measured with u = 0.01.
    measured = 0.05 + rng.normal(0.0, 0.01, 20_000)
    passed = sum(judge(m, 1.96 * 0.01, 0.05, RULES["guarded"]) is PASS for m in measured)
    assert passed / 20_000 == pytest.approx(0.025, abs=0.003)


@pytest.mark.parametrize(
    ("verdicts", "expected"),
    [
        ((PASS, PASS), PASS),
        ((PASS, UNDECIDED), UNDECIDED),
        ((UNDECIDED, FAIL, PASS), FAIL),
    ],
)
def test_the_worst_row_decides(verdicts: tuple[Verdict, ...], expected: Verdict):
    assert worst(verdicts) is expected


def test_nonsense_is_refused():
    with pytest.raises(ValueError, match="above zero"):
        judge(0.0, 0.0, 0.0, RULES["simple"])
    with pytest.raises(ValueError, match="nothing"):
        worst(())


@pytest.mark.parametrize("rule", RULES.values(), ids=RULES.keys())
def test_every_rule_states_itself(rule):
    assert "pass" in rule.text
    assert "fail" in rule.text
