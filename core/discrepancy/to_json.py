"""An explanation as the JSON document of ``calrig explain --json``."""

import math
from collections.abc import Iterable
from typing import Any

from core.discrepancy.result import Explanation, Gap, NextMeasurement, Step, Where
from core.errors import Note


def explanation_to_json(explanation: Explanation) -> dict[str, Any]:
    """Return the document; a missing number is None, curves are left out."""
    noise = explanation.noise
    document: dict[str, Any] = {
        "verdict": explanation.verdict,
        "summary": explanation.summary,
        "noise": {
            "sigma": noise.sigma,
            "unit": noise.unit,
            "components": dict(noise.components),
            "ratios": dict(noise.ratios),
            "source": noise.source,
            "dof": noise.dof,
        },
        "before": {**_gap(explanation.before), "held_out_gap": explanation.held_out_before},
        "where": [_where(where) for where in explanation.where],
        "steps": [_step(step) for step in explanation.steps],
        "after": _gap(explanation.after),
        "where_after": [_where(where) for where in explanation.where_after],
        "threshold": explanation.threshold,
        "next_measurements": [_next(each) for each in explanation.next_measurements],
        "smallest": [
            {
                "effect": each.effect,
                "name": each.name,
                "parameter": each.parameter,
                "size": each.size,
                "unit": each.unit,
                "typical": each.typical,
                "aliases": list(each.aliases),
            }
            for each in explanation.smallest
        ],
        "invisible": list(explanation.invisible),
        "untested": dict(explanation.untested),
        "notes": _notes(explanation.notes),
    }
    return {key: _clean(value) for key, value in document.items()}


def _gap(gap: Gap) -> dict[str, Any]:
    return {
        "rms": gap.rms,
        "gap": gap.gap,
        "chi2_red": gap.chi2_red,
        "dof": gap.dof,
        "p_value": gap.p_value,
        "lack_of_fit_p_value": gap.lack_p,
    }


def _where(where: Where) -> dict[str, Any]:
    return {
        "regressor": where.regressor,
        "unit": where.unit,
        "p_value": where.p_value,
        "share": where.share,
        "worst": {"value": where.worst_value, "residual_sigma": where.worst_sigma},
    }


def _step(step: Step) -> dict[str, Any]:
    return {
        "effect": step.effect,
        "name": step.name,
        "description": step.plain,
        "equation": step.equation,
        "parameters": [
            {"name": each.name, "value": each.value, "u": each.u, "unit": each.unit}
            for each in step.parameters
        ],
        "probability": step.probability,
        "p_value": step.p_value,
        "evidence": step.evidence,
        "indistinguishable_from": list(step.indistinguishable_from),
        "gap_after": step.gap_after,
        "held_out_gap_after": step.held_out_gap_after,
        "advice": step.advice,
        "added_by_hand": step.added_by_hand,
    }


def _next(measurement: NextMeasurement) -> dict[str, Any]:
    plan = measurement.plan
    return {
        "title": measurement.title,
        "why": measurement.why,
        "probability": measurement.probability,
        "minutes": measurement.minutes,
        "plan": {
            "id": plan.id,
            "title": plan.title,
            "test": plan.test,
            "accumulation_s": plan.accumulation_s,
            "temperatures_c": list(plan.temperatures_c),
            "steps": [
                {"group": step.group}
                if plan.test == "record"
                else {"mount": step.mount, "head_deg": step.head_deg, "rate_dps": step.rate_dps}
                for step in plan.steps
            ],
        },
    }


def _notes(notes: Iterable[Note]) -> list[dict[str, str]]:
    return [
        {"severity": note.severity.value, "subject": note.subject, "text": note.text}
        for note in notes
    ]


def _clean(value: Any) -> Any:
    """JSON has neither NaN nor infinity."""
    if isinstance(value, dict):
        return {str(key): _clean(item) for key, item in value.items()}  # pyright: ignore
    if isinstance(value, list):
        return [_clean(item) for item in value]  # pyright: ignore
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
