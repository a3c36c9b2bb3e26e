"""Statements of conformity: a measured value, its uncertainty, a limit, and a stated rule.

ISO/IEC 17025, 7.8.6 asks that the rule be told with the verdict; the two here are those of JCGM 106
and ILAC-G8.
"""

from dataclasses import dataclass
from enum import Enum


class Verdict(Enum):
    """What can be stated."""

    PASS = "pass"
    FAIL = "fail"
    UNDECIDED = "undecided"
    """Within the uncertainty of the limit: neither can be stated under the guarded rule."""


@dataclass(frozen=True, slots=True)
class Rule:
    """A decision rule.

    Parameters
    ----------
    id : stable identifier
    guarded : whether the expanded uncertainty is a guard band on both sides of the limit
    text : the sentence that goes into the report
    """

    id: str
    guarded: bool
    text: str


RULES: dict[str, Rule] = {
    rule.id: rule
    for rule in (
        Rule(
            "guarded",
            True,
            "pass: the value and its expanded uncertainty (95 %) lie within the limit; fail: both"
            " lie beyond it; otherwise undecided (JCGM 106, guard band w = U)",
        ),
        Rule(
            "simple",
            False,
            "pass: the value lies within the limit, whatever its uncertainty; else fail (ILAC-G8,"
            " simple acceptance; the risk of a wrong verdict at the limit is up to 50 %)",
        ),
    )
}


def judge(value: float, expanded: float, limit: float, rule: Rule) -> Verdict:
    """Judge a deviation against a symmetric limit.

    Parameters
    ----------
    value, expanded : deviation and its expanded uncertainty
    limit : largest allowed size of the deviation, above zero
    rule : how the uncertainty counts

    Raises
    ------
    ValueError
        The limit is not above zero.
    """
    if not limit > 0:
        raise ValueError(f"a limit must be above zero, got {limit}")
    guard = expanded if rule.guarded else 0.0
    if abs(value) + guard <= limit:
        return Verdict.PASS
    if abs(value) - guard > limit:
        return Verdict.FAIL
    return Verdict.UNDECIDED


def worst(verdicts: tuple[Verdict, ...]) -> Verdict:
    """The verdict on all of them: one failure fails, one doubt leaves it undecided.

    Raises
    ------
    ValueError
        There are none.
    """
    if not verdicts:
        raise ValueError("nothing was judged")
    for verdict in (Verdict.FAIL, Verdict.UNDECIDED):
        if verdict in verdicts:
            return verdict
    return Verdict.PASS
