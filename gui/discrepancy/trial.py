"""Sealed cases for practice: what the simulated bench measured with something hidden in it.

What is hidden is drawn by a seed and sealed by a hash before anyone looks; the operator names it,
the program names it, and then the seal is opened. Needs no Qt. This is practice and no measure of
the program: the cases are made by the same effects that it looks for.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core.discrepancy.ladder import Ladder, explain
from core.discrepancy.result import Explanation
from core.discrepancy.settings import Settings
from gui.discrepancy.record_steps import with_steps
from gui.discrepancy.trial_case import Case
from gui.discrepancy.trial_record import HIDDEN as IN_RECORDS
from gui.discrepancy.trial_record import record_case
from gui.discrepancy.trial_rows import ROWS, rows_case
from gui.discrepancy.working import RECORD, Story, is_fact, is_noise

KINDS = ("head", "table", "rest", "record")
"""Accelerometer on the dividing head, gyro on the rate table, gyro at rest, a long record."""


def hidden_in(kind: str) -> tuple[str, ...]:
    """What can be hidden in a case of this kind."""
    return ROWS[kind].hidden if kind in ROWS else IN_RECORDS


def make_case(seed: int, kind: str = KINDS[0]) -> Case:
    """Measure on the simulated bench with something hidden in it.

    Parameters
    ----------
    seed : number of the case; the same number gives the same case
    kind : one of `KINDS`
    """
    return rows_case(seed, ROWS[kind]) if kind in ROWS else record_case(seed)


def story_of(case: Case, settings: Settings, tell: Callable[[str], None]) -> Story:
    """The case as a run that was opened."""
    path = (Path(f"case {case.seed}"),)
    tell("floor")
    if case.run.test == RECORD:
        known = explain(case.run, settings)
        return Story(case.run, path, None, with_steps(known, 0), known=known)
    ladder = Ladder.of(case.run, settings)
    tell("where")
    return Story(case.run, path, ladder, ladder.explanation)


@dataclass(frozen=True, slots=True)
class Score:
    """Cases that were opened, how many of them each had right, and cases that were begun."""

    cases: int = 0
    operator: int = 0
    program: int = 0
    begun: int = 0

    def after(self, *, operator: bool, program: bool) -> "Score":
        """With one more case."""
        right = self.operator + operator, self.program + program
        return Score(self.cases + 1, *right, self.begun)

    def to_section(self) -> dict[str, int]:
        """For the settings."""
        return {
            "cases": self.cases,
            "operator": self.operator,
            "program": self.program,
            "begun": self.begun,
        }


def score_of(section: Mapping[str, Any]) -> Score:
    """The score in the settings; what is not there or impossible counts as nothing."""
    cases, *right = (_count(section.get(name)) for name in ("cases", "operator", "program"))
    operator, program = (min(one, cases) for one in right)
    return Score(cases, operator, program, max(_count(section.get("begun")), cases))


def is_right(truth: Sequence[str], named: Sequence[Sequence[str]]) -> bool:
    """Whether the names are those that are hidden, no more and no less.

    Parameters
    ----------
    truth : identifiers of what is hidden
    named : for each effect that was named, all identifiers that it stands for
    """
    left = [set(one) for one in named]
    if len(left) != len(truth):
        return False
    for name in truth:
        match = next((one for one in left if name in one), None)
        if match is None:
            return False
        left.remove(match)
    return True


def named_by_program(told: Explanation) -> list[tuple[str, ...]]:
    """For each step of the program's answer the names that it cannot tell apart."""
    return [
        (step.effect, *step.indistinguishable_from)
        for step in told.steps
        if not (is_fact(step) or is_noise(step))
    ]


def named_by_operator(told: Explanation, names: Sequence[str]) -> list[tuple[str, ...]]:
    """For each name of the operator that name with those that look the same in these rows."""
    aliases = {each.effect: each.aliases for each in told.smallest}
    return [(name, *aliases.get(name, ())) for name in names]


def _count(value: object) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else 0
