"""A story -> rungs of the ladder, and the list of regressors."""

import math

from PySide6.QtCore import QCoreApplication

from core.arrays import FloatArray
from core.discrepancy.result import Explanation, Gap, Step, Where
from gui.discrepancy.certainty import certainty_words, tone_of
from gui.discrepancy.state import RegressorRow, RungState
from gui.discrepancy.words import numbers_of, p_words, regressor_words, unit_words
from gui.discrepancy.working import Story, is_fact
from gui.widgets.number_text import MINUS, fixed, significant
from gui.widgets.states import Tone

SIGNIFICANT = 0.05
_DOUBTFUL = 0.2


def rungs_of(story: Story) -> tuple[RungState, ...]:
    """The plain model, what was added, and what the search proposes on top of it."""
    told = story.told
    if math.isnan(told.before.gap):
        return ()
    plain = RungState(
        number=0,
        title=QCoreApplication.translate("Discrepancy", "Plain model"),
        gap=told.before.gap,
        held_out=told.held_out_before,
        facts=_facts(told.before, told.held_out_before),
        parameters=(_floor(told),),
    )
    count, seconds = len(told.steps), story.seconds
    return (
        plain,
        *(
            _rung(number, step, seconds, proposed=number > count)
            for number, step in enumerate((*told.steps, *story.proposals), 1)
        ),
    )


def regressors_of(where: tuple[Where, ...]) -> tuple[RegressorRow, ...]:
    """All regressors, the most significant first."""
    return tuple(_row(one) for one in where)


def place_words(one: Where) -> str:
    """Where the largest disagreement is."""
    value = f"{one.worst_value:.5g}".replace("-", MINUS)
    sigmas = fixed(one.worst_sigma, 1)
    sign = "+" if one.worst_sigma > 0 else ""
    template = QCoreApplication.translate("Discrepancy", "{sigmas} σ at {value}")
    # A joiner behind the stroke: a unit is not broken into two lines.
    unit = unit_words(one.unit).replace("/", "/\N{WORD JOINER}")
    gap = "" if unit == "°" or not unit else " "
    return template.format(sigmas=f"{sign}{sigmas}", value=f"{value}{gap}{unit}")


def _rung(number: int, step: Step, seconds: FloatArray, *, proposed: bool) -> RungState:
    return RungState(
        number=number,
        title=f"+ {step.name}",
        gap=step.gap_after,
        held_out=step.held_out_gap_after,
        facts=_facts(step.after, step.held_out_gap_after, step.evidence),
        parameters=numbers_of(step.parameters, seconds),
        tone=tone_of(step),
        certainty=certainty_words(step),
        proposed=proposed,
        kept=not proposed and is_fact(step),
    )


def _facts(gap: Gap, held_out: float, evidence: float = math.nan) -> tuple[str, ...]:
    parts = [
        QCoreApplication.translate("Discrepancy", "χ²/ν {value}").format(
            value=significant(gap.chi2_red, 3)
        )
    ]
    if not math.isnan(held_out):
        template = QCoreApplication.translate("Discrepancy", "held out {value}")
        parts.append(template.format(value=fixed(held_out, 2)))
    if not math.isnan(evidence):
        template = QCoreApplication.translate("Discrepancy", "evidence {value}")
        parts.append(template.format(value=fixed(evidence, 0)))
    elif not math.isnan(gap.p_value):
        parts.append(p_words(gap.p_value))
    return tuple(parts)


def _floor(told: Explanation) -> str:
    sources = {
        "replicates": QCoreApplication.translate("Discrepancy", "from replicates"),
        "y_se": QCoreApplication.translate("Discrepancy", "from standard errors"),
        "residual": QCoreApplication.translate("Discrepancy", "from the residuals"),
    }
    template = QCoreApplication.translate("Discrepancy", "noise floor {size} {unit}, {source}")
    noise = told.noise
    return template.format(
        size=significant(noise.sigma, 3),
        unit=unit_words(noise.unit),
        source=sources.get(noise.source, noise.source),
    )


def _row(one: Where) -> RegressorRow:
    tone = Tone.IDLE
    if one.p_value < SIGNIFICANT:
        tone = Tone.BAD
    elif one.p_value < _DOUBTFUL:
        tone = Tone.DOUBT
    known = () if math.isnan(one.p_value) else (p_words(one.p_value),)
    detail = " · ".join((*known, place_words(one)))
    return RegressorRow(one.regressor, regressor_words(one.regressor), detail, tone)
