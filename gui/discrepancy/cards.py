"""A story -> proposals, the chosen candidate, next measurements, what the rows can show."""

import math

from PySide6.QtCore import QCoreApplication

from core.arrays import FloatArray
from core.discrepancy.result import UNKNOWN, Candidate, Explanation, NextMeasurement, Step
from core.model.catalogue.listing import CATALOGUE
from core.plans.plan import Plan
from gui.discrepancy.state import CandidateRow, DetailState, LightRow, NextCard, ProposalCard
from gui.discrepancy.words import effect_words, numbers_of, plain_words, unit_words
from gui.discrepancy.working import RECORD, Story, is_fact, is_noise, rivals_of
from gui.widgets.number_text import fixed, significant
from gui.widgets.states import TableState, Tone

_OTHERS = 4
_LARGE = 100.0
"""Evidence from which its decimals say nothing."""


def proposals_of(story: Story) -> tuple[ProposalCard, ...]:
    """One card for each effect that was found and not yet added, one for what else could be."""
    cards = [_card(number, step, story.seconds) for number, step in enumerate(story.proposals, 1)]
    if cards or story.proposed is None:
        return tuple(cards)
    rest = story.told.candidates
    if not rest:
        return ()
    title = QCoreApplication.translate("Discrepancy", "Could still be added; nothing asks for it")
    best = max(each.evidence for each in rest)
    return (
        ProposalCard(
            title, (), "", tuple(_row(each, best, story.seconds) for each in rest[:_OTHERS])
        ),
    )


def chosen_of(story: Story, wanted: str) -> Candidate | None:
    """The candidate that the operator chose, or the first of all."""
    candidates = story.candidates
    for each in candidates:
        if each.effect == wanted:
            return each
    proposals = story.proposals
    if proposals:
        return next((c for c in candidates if c.effect == proposals[0].effect), None)
    return None


def detail_of(candidate: Candidate) -> DetailState:
    """All words about a candidate."""
    effect = CATALOGUE.get(candidate.effect)
    lines: list[tuple[str, str]] = []
    if effect is not None and effect.seen_as:
        lines.append((QCoreApplication.translate("Discrepancy", "How it shows"), effect.seen_as))
    if effect is not None and effect.remedy:
        lines.append((QCoreApplication.translate("Discrepancy", "What to do"), effect.remedy))
    return DetailState(
        candidate.effect,
        candidate.name,
        plain_words(candidate.plain),
        candidate.equation,
        tuple(lines),
    )


def following_of(story: Story) -> tuple[NextCard, ...]:
    """What to measure next, best first."""
    return tuple(_next(each) for each in measurements_of(story))


def measurements_of(story: Story) -> tuple[NextMeasurement, ...]:
    """The measurements behind the cards."""
    if story.known is not None and story.proposed is None:
        return ()
    best = story.proposed or story.told
    return best.next_measurements


def grade_of(told: Explanation) -> tuple[TableState, ...]:
    """What these rows can show, what they cannot tell apart, what they cannot show at all."""
    if not told.smallest and not told.invisible:
        return ()
    header = (
        QCoreApplication.translate("Discrepancy", "effect"),
        QCoreApplication.translate("Discrepancy", "named from"),
        QCoreApplication.translate("Discrepancy", "usual"),
    )
    visible = TableState(
        QCoreApplication.translate("Discrepancy", "Smallest effects that these rows would name"),
        QCoreApplication.translate(
            "Discrepancy", "size at which eight sigmas of the effect are visible"
        ),
        header,
        tuple(
            (
                each.name,
                f"{significant(each.size, 3)} {unit_words(each.unit)}",
                "" if math.isnan(each.typical) else significant(each.typical, 2),
            )
            for each in told.smallest
        ),
    )
    tables = [visible]
    tied = tuple(
        (each.name, ", ".join(effect_words(alias) for alias in each.aliases))
        for each in told.smallest
        if each.aliases
    )
    if tied:
        title = QCoreApplication.translate("Discrepancy", "Looks the same in these rows")
        head = (
            QCoreApplication.translate("Discrepancy", "effect"),
            QCoreApplication.translate("Discrepancy", "as"),
        )
        tables.append(TableState(title, "", head, tied, 2))
    hidden = [
        *(
            (
                effect_words(each),
                QCoreApplication.translate("Discrepancy", "invisible, whatever its size"),
            )
            for each in told.invisible
        ),
        *(
            (
                effect_words(each),
                QCoreApplication.translate("Discrepancy", "needs the column {name}").format(
                    name=column
                ),
            )
            for each, column in told.untested.items()
        ),
    ]
    if not hidden:
        return tuple(tables)
    title = QCoreApplication.translate("Discrepancy", "Not to be seen in these rows")
    head = (QCoreApplication.translate("Discrepancy", "effect"), "")
    return (*tables, TableState(title, "", head, tuple(hidden), 2))


def lights_of(told: Explanation) -> tuple[LightRow, ...]:
    """What the rows can show of each effect: the good first."""
    rows: list[LightRow] = []
    for each in told.smallest:
        size = f"{significant(each.size, 2)} {unit_words(each.unit)}"
        usual = not math.isnan(each.typical)
        detail = QCoreApplication.translate("Discrepancy", "from {size} on").format(size=size)
        if usual:
            detail = QCoreApplication.translate(
                "Discrepancy", "from {size} on; usual {usual}"
            ).format(size=size, usual=significant(each.typical, 2))
        tone = Tone.DOUBT if usual and each.size > each.typical else Tone.GOOD
        if each.aliases:
            tone = Tone.DOUBT
            others = ", ".join(effect_words(alias) for alias in each.aliases)
            detail = QCoreApplication.translate(
                "Discrepancy", "{detail}; looks the same: {others}"
            ).format(detail=detail, others=others)
        rows.append(LightRow(tone, each.name, detail))
    unseen = QCoreApplication.translate("Discrepancy", "invisible, whatever its size")
    rows += [LightRow(Tone.BAD, effect_words(each), unseen) for each in told.invisible]
    lacks = QCoreApplication.translate("Discrepancy", "needs the column {name}")
    rows += [
        LightRow(Tone.BAD, effect_words(each), lacks.format(name=column))
        for each, column in told.untested.items()
    ]
    order = {Tone.GOOD: 0, Tone.DOUBT: 1, Tone.BAD: 2}
    return tuple(sorted(rows, key=lambda row: order[row.tone]))


def _card(number: int, step: Step, seconds: FloatArray) -> ProposalCard:
    rivals = rivals_of(step)
    best = max(each.evidence for each in rivals)
    same = {step.effect, *step.indistinguishable_from}
    tied = tuple(_row(each, best, seconds) for each in rivals if each.effect in same)
    others = tuple(_row(each, best, seconds) for each in rivals if each.effect not in same)
    shown = {row.key for row in tied}
    further = [name for name in step.indistinguishable_from if name not in shown]
    words = ""
    if further:
        template = QCoreApplication.translate("Discrepancy", "Fits these rows as well: {names}")
        words = template.format(names=", ".join(effect_words(name) for name in further))
    template = _heading(step)
    return ProposalCard(template.format(number=number), tied, words, others[:_OTHERS])


def _heading(step: Step) -> str:
    """What stands over the card of a step: how sure its name is."""
    if is_fact(step):
        return QCoreApplication.translate("Discrepancy", "{number}. A fault of the data")
    if step.effect == UNKNOWN:
        return QCoreApplication.translate("Discrepancy", "{number}. No effect explains this")
    if step.indistinguishable_from == (UNKNOWN,):
        return QCoreApplication.translate(
            "Discrepancy", "{number}. The best name, or something outside the catalogue"
        )
    if step.indistinguishable_from:
        return QCoreApplication.translate("Discrepancy", "{number}. These cannot be told apart yet")
    if is_noise(step):
        return QCoreApplication.translate("Discrepancy", "{number}. A term of the noise")
    return QCoreApplication.translate("Discrepancy", "{number}. Missing in the model")


def _row(candidate: Candidate, best: float, seconds: FloatArray) -> CandidateRow:
    evidence = QCoreApplication.translate("Discrepancy", "evidence {nats}, {share} %").format(
        nats=fixed(candidate.evidence, 0 if candidate.evidence >= _LARGE else 1),
        share=fixed(100.0 * candidate.probability, 0),
    )
    left = QCoreApplication.translate("Discrepancy", "gap {gap}").format(
        gap=fixed(candidate.gap_after, 2)
    )
    share = min(max(candidate.evidence / best, 0.0), 1.0) if best > 0 else 0.0
    return CandidateRow(
        candidate.effect,
        candidate.name,
        ", ".join(numbers_of(candidate.parameters, seconds)),
        share,
        evidence,
        left,
    )


def _next(each: NextMeasurement) -> NextCard:
    minutes = fixed(each.minutes, 0)
    plan: object = each.plan
    # A record is no walk through positions: no tab measures it by itself.
    steps = plan.steps if isinstance(plan, Plan) else ()
    walked = isinstance(plan, Plan) and plan.test != RECORD
    facts = QCoreApplication.translate("Discrepancy", "{minutes} min").format(minutes=minutes)
    if walked:
        facts = QCoreApplication.translate("Discrepancy", "{count} positions, {minutes} min")
        if each.plan.test == "rate_table":
            facts = QCoreApplication.translate("Discrepancy", "{count} rates, {minutes} min")
        facts = facts.format(count=len(steps), minutes=minutes)
    parts = () if walked else tuple(step.group for step in steps)
    head, _, tail = each.why.partition("; tells apart ")
    why = head[:1].upper() + head[1:]
    if tail:
        names = ", ".join(effect_words(name) for name in tail.split(", "))
        template = QCoreApplication.translate("Discrepancy", "{why}. Tells apart: {names}.")
        why = template.format(why=why, names=names)
    return NextCard(each.title, why, facts, each.probability, parts, walked)
