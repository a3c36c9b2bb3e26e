"""A plan as the text of a plan file."""

import json
from itertools import groupby

from core.plans.plan import Plan

_ON_TABLE = "rate_table"


def plan_text(plan: Plan) -> str:
    """Return the TOML text that `load_plan` reads as this plan.

    Notes
    -----
    Steps that follow each other with the same group and mount stand in one table, with their
    numbers, so that the order of measuring and what the operator knows them by are kept. The axis
    of a table test is that of its mount; it is not written.
    """
    lines = [
        "[plan]",
        f"title = {_quoted(plan.title)}",
        f"test = {_quoted(plan.test)}",
        f"source = {_quoted(plan.source)}",
        f"accumulation_s = {plan.accumulation_s!r}",
        f"settle_s = {plan.settle_s!r}",
    ]
    if plan.temperatures_c:
        lines.append(f"temperatures_c = {_numbers(plan.temperatures_c)}")
    on_table = plan.test == _ON_TABLE
    for (title, mount), steps in groupby(plan.steps, lambda step: (step.group, step.mount)):
        chosen = list(steps)
        key = "rates_dps" if on_table else "head_deg"
        values = [step.rate_dps if on_table else step.head_deg for step in chosen]
        lines += [
            "",
            "[[group]]",
            f"title = {_quoted(title)}",
            f"mount = {_quoted(mount)}",
            f"{key} = {_numbers(values)}",
            f"numbers = {[step.number for step in chosen]}",
        ]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    # JSON's escapes are those of a basic string of TOML.
    return json.dumps(text, ensure_ascii=False)


def _numbers(values: "list[float] | tuple[float, ...]") -> str:
    return f"[{', '.join(repr(float(value)) for value in values)}]"
