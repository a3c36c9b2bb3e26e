"""What the model of a long record lacks: faults, slow effects, lines and noise terms in one story.

The plain model of a record is a constant with white noise. Faults of the data are found sample by
sample and left out; lines and noise terms are found in the spectrum at full rate; everything slow
is found in the means of some 360 blocks by the search that runs use as well.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.discrepancy.gaps import gap_of, held_out_gap, predicted
from core.discrepancy.locate import locate
from core.discrepancy.power import invisible_of, smallest_of
from core.discrepancy.record_advise import advise_record
from core.discrepancy.record_doubts import doubtful_names, there_and_back
from core.discrepancy.record_engine import Found, search_record
from core.discrepancy.record_facts import Fact, facts_of
from core.discrepancy.record_floor import wanders
from core.discrepancy.record_problem import Samples
from core.discrepancy.record_spectrum import Line, NoiseTerm, Seen, lines_of, noise_terms
from core.discrepancy.result import UNKNOWN, Explanation, Fitted, Gap, NoiseFloor, Step, Where
from core.discrepancy.settings import Settings
from core.discrepancy.steps import candidates_of, steps_of, unknown_step
from core.discrepancy.verdict import doubted
from core.errors import FitError, Note, RankDeficient, Severity
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Kind
from core.samples.run import Run

NO_SETTINGS = Settings()
RECORD = "record"
"""The test of a run whose rows are samples."""
_TIE = 3.0
_LINE_SHARE = 0.5
"""Part of the probability of a false name that is given to lines."""


def explain_record(
    run: Run, settings: Settings = NO_SETTINGS, channel: int | str = 0
) -> Explanation:
    """What the model of one output of a record lacks.

    Parameters
    ----------
    run : of test ``"record"``, one row a sample, the channels of the device in `extra`
    settings : as for other runs; what goes with positions and rates has no meaning here
    channel : number or name of the output

    Returns
    -------
    Explanation
        Its rows are the means of blocks; `measured` and all curves have one value a block. With
        the verdict ``not_enough_data`` where the record leaves nothing to judge a model by.

    Raises
    ------
    FitError
        The run is of another test, or there is no such output.
    """
    if run.test != RECORD:
        raise FitError(f"a run of test {run.test!r} is no record")
    place = _place(run, channel)
    try:
        samples = Samples.of(run, place)
        facts = facts_of(samples)
        bad = [row for fact in facts for row in fact.rows.tolist()]
        if any(fact.effect == "stale_temperature" for fact in facts):
            unknown = np.full(len(run), np.nan)
            samples = replace(samples, run=replace(run, temperature_c=unknown))
        samples = samples.without(frozen_int(bad))
        lines, quiet, seen = lines_of(samples, _LINE_SHARE * settings.alpha)
        found = search_record(quiet, settings)
    except RankDeficient as error:
        return _not_enough(run, place, str(error))
    return _story(run, found, facts, lines, seen, quiet)


def _place(run: Run, channel: int | str) -> int:
    if isinstance(channel, int) and 0 <= channel < len(run.channels):
        return channel
    if channel in run.channels:
        return run.channels.index(str(channel))
    raise FitError(f"there is no output {channel!r}; there are: {', '.join(run.channels)}")


def _story(
    run: Run,
    found: Found,
    facts: Sequence[Fact],
    lines: Sequence[Line],
    seen: Seen | None,
    quiet: Samples,
) -> Explanation:
    engine, state = found.engine, found.state
    problem, plain = engine.problem, engine.search.state(())
    before = gap_of(engine, plain)
    floor = engine.floor.result(run.unit)
    left = locate(engine, state) if state.slots else ()
    slow = tuple(
        _tied(step, names)
        for step, names in zip(found.measured(steps_of(engine, state, 0)), found.tied, strict=True)
    )
    if found.unknown is not None:
        slow = (*slow, unknown_step(engine, state, found.unknown))
    noise = replace(floor, ratios={})
    slow = doubted(slow, noise, left, engine.settings.alpha)
    slow = there_and_back([_with_ties(step) for step in slow])
    doubtful = {*found.doubtful, *doubtful_names(engine, state)}
    slow = tuple(_tied(step, (UNKNOWN,)) if step.effect in doubtful else step for step in slow)
    after = slow[-1].after if slow else before
    curve = slow[-1].curve if found.unknown is not None else np.zeros(len(problem.y))
    terms, white = noise_terms(
        _without_curves(quiet, slow, problem.stimulus.column("t_s")), run.unit
    )
    zero = np.zeros(len(problem.y))
    steps = (
        *(fact_step(fact, before, zero) for fact in facts),
        *(_line_step(line, run.unit, before, problem.stimulus.column("t_s")) for line in lines),
        *slow,
        *(_noise_step(term, after, zero) for term in terms),
    )
    restless = wanders(engine.floor)
    verdict = _verdict(steps, restless)
    spectrum = (_spectrum_where(seen, lines),) if seen is not None else ()
    noise = replace(noise, components={**noise.components, **white})
    return Explanation(
        verdict=verdict,
        summary=_summary(verdict, steps, before, after),
        noise=noise,
        before=before,
        after=after,
        held_out_before=held_out_gap(engine, plain),
        where=(*locate(engine, plain), *spectrum),
        where_after=left,
        steps=steps,
        candidates=candidates_of(engine, state),
        threshold=engine.search.threshold,
        next_measurements=advise_record(engine, state) if engine.settings.advise else (),
        smallest=smallest_of(engine),
        invisible=invisible_of(engine),
        untested=problem.untested,
        notes=(*run.notes, *_notes(facts, verdict, steps, restless)),
        measured=frozen(problem.y),
        predicted_before=frozen(predicted(engine, plain)),
        predicted=frozen(predicted(engine, state) + curve),
        sigma=frozen(np.sqrt(np.diag(engine.floor.covariance))),
        channel=frozen_int(problem.channel),
        channels=problem.run.channels,
        unit=run.unit,
    )


def _with_ties(step: Step) -> Step:
    """A step with all names as good as its own, even where unknown structure is better still."""
    return _tied(
        step,
        [
            one.effect
            for one in step.candidates
            if one.effect != step.effect and one.evidence > step.evidence - _TIE
        ],
    )


def _tied(step: Step, names: Iterable[str]) -> Step:
    """A step with further names that it could be as well."""
    every = dict.fromkeys((*step.indistinguishable_from, *names))
    return replace(step, indistinguishable_from=tuple(every))


def _without_curves(samples: Samples, steps: Sequence[Step], t: FloatArray) -> Samples:
    """The samples less what the slow steps add."""
    if not steps:
        return samples
    added = np.sum([step.curve for step in steps], axis=0)
    y = np.array(samples.run.y)
    y[:, samples.channel] -= np.interp(samples.place / samples.rate, t, added)
    return replace(samples, run=replace(samples.run, y=y))


def _step(
    identifier: str,
    parameters: tuple[Fitted, ...],
    probability: float,
    chance: float,
    after: Gap,
    curve: FloatArray,
    *,
    evidence: float,
    rivals: tuple[str, ...] = (),
    text: str = "",
) -> Step:
    effect = CATALOGUE[identifier]
    return Step(
        effect=identifier,
        name=effect.name,
        plain=text or effect.plain,
        equation=effect.equation,
        seen_as=effect.seen_as,
        remedy=effect.remedy,
        parameters=parameters,
        probability=probability,
        p_value=chance,
        evidence=evidence,
        indistinguishable_from=rivals,
        after=after,
        held_out_gap_after=math.nan,
        advice=effect.remedy,
        curve=frozen(curve),
        candidates=(),
    )


def fact_step(fact: Fact, gap: Gap, curve: FloatArray) -> Step:
    """A fault of the data as a step, which changes nothing in the model."""
    evidence = -math.log(max(fact.chance, 1e-300))
    return _step(
        fact.effect,
        fact.parameters,
        1.0,
        fact.chance,
        gap,
        curve,
        evidence=evidence,
        text=fact.text,
    )


def _line_step(line: Line, unit: str, gap: Gap, t: FloatArray) -> Step:
    phase = math.degrees(math.atan2(line.cosine, line.sine))
    turn = math.degrees(line.u / max(line.amplitude, 1e-300))
    parameters = (
        Fitted("pickup_amplitude", line.amplitude, line.u, unit),
        Fitted("pickup_phase", phase, turn, "deg"),
        Fitted("frequency", line.frequency, math.nan, "Hz"),
    )
    evidence = -math.log(max(line.chance, 1e-300))
    return _step(
        "pickup", parameters, 1.0 - line.chance, line.chance, gap, line.at(t), evidence=evidence
    )


def _noise_step(term: NoiseTerm, gap: Gap, curve: FloatArray) -> Step:
    parameters = [Fitted(term.effect, term.value, term.u, term.unit)]
    if math.isfinite(term.memory):
        parameters.append(Fitted("memory", term.memory, math.nan, "s"))
    return _step(
        term.effect,
        tuple(parameters),
        term.probability,
        math.exp(-term.evidence),
        gap,
        curve,
        evidence=term.evidence,
        rivals=term.rivals,
    )


def _verdict(steps: Sequence[Step], restless: bool) -> str:
    """The verdict; terms of the noise accuse nobody unless they are far larger than usual."""
    kinds = {UNKNOWN: None, **{name: effect.kind for name, effect in CATALOGUE.items()}}
    telling = [step for step in steps if kinds[step.effect] is not Kind.NOISE]
    if any(step.effect == UNKNOWN for step in telling):
        return "unexplained_structure"
    if any(step.indistinguishable_from for step in telling):
        return "ambiguous"
    if not telling:
        return "excess_noise" if restless else "adequate"
    faults = all(kinds[step.effect] is Kind.FACT or step.effect in _FAULTS for step in telling)
    return "data_fault" if faults else "explained"


_FAULTS = ("stuck_reading", "outlier")


def _summary(verdict: str, steps: Sequence[Step], before: Gap, after: Gap) -> str:
    noise = [
        step.name
        for step in steps
        if step.effect != UNKNOWN and CATALOGUE[step.effect].kind is Kind.NOISE
    ]
    others = [step for step in steps if step.name not in noise]
    named = ", ".join(step.name for step in others)
    closing = f"The gap goes from {before.gap:.2f} to {after.gap:.2f} noise floors."
    tied = "; ".join(" or ".join([s.effect, *s.indistinguishable_from]) for s in others)
    scatter = "white noise" + (f" with {', '.join(noise).lower()}" if noise else " alone")
    texts = {
        "adequate": f"A constant explains the record; its scatter is {scatter}.",
        "excess_noise": "No effect stands out, but the bias wanders far more than in sensors of"
        f" this kind: it is {scatter}, or something that the catalogue does not know.",
        "explained": f"Missing in the model: {named}. {closing} The rest is {scatter}.",
        "data_fault": f"The data are at fault: {named}. The rest is {scatter}.",
        "ambiguous": "Something is missing, and this record cannot tell which of several effects: "
        f"{tied}. {closing}",
        "unexplained_structure": "There is structure that no effect of the catalogue explains: "
        + "; ".join(s.plain if s.effect == UNKNOWN else s.name for s in others)
        + ".",
    }
    return texts[verdict]


def _notes(
    facts: Sequence[Fact], verdict: str, steps: Sequence[Step], restless: bool
) -> list[Note]:
    found = [Note(Severity.WARNING, fact.effect, fact.text) for fact in facts]
    if restless:
        found.append(
            Note(
                Severity.WARNING,
                "excess_noise",
                "the bias wanders several times as much as in sensors of this kind: noise of this"
                " unit, or a cause that is not in the catalogue; a second record tells, for noise"
                " goes another way then",
            )
        )
    found.append(
        Note(
            Severity.INFO,
            "floor_from_record",
            "the noise floor is from the record itself: noise slower than a part of the record is"
            " known from sensors of this kind only",
        )
    )
    if verdict in ("explained", "ambiguous") and any(len(step.candidates) for step in steps):
        found.append(
            Note(
                Severity.INFO,
                "not_yet_confirmed",
                "named, not yet confirmed: only another record, with temperature and time going"
                " otherwise, confirms it",
            )
        )
    return found


def _spectrum_where(seen: Seen, lines: Sequence[Line]) -> Where:
    """The spectrum as a regressor: highest ordinate of each band."""
    best = int(np.argmax(seen.highest))
    chance = [-math.expm1(seen.count * math.log1p(-math.exp(-float(seen.highest[best]))))]
    limit = math.log(seen.count / 0.05)
    return Where(
        regressor="frequency_hz",
        unit="Hz",
        p_value=float(min([*chance, *(line.chance for line in lines)])),
        share=0.0,
        worst_value=lines[0].frequency if lines else float(seen.frequency[best]),
        worst_sigma=math.sqrt(2.0 * float(seen.highest[best])),
        x=seen.frequency,
        residual=frozen(np.sqrt(seen.highest) * seen.level),
        channel=frozen_int(np.zeros(len(seen.frequency))),
        knots=seen.frequency,
        curve=frozen(np.sqrt(seen.highest) * seen.level),
        band=frozen(math.sqrt(limit) * seen.level),
    )


def _not_enough(run: Run, place: int, why: str) -> Explanation:
    nothing = Gap(math.nan, math.nan, math.nan, 0, math.nan, math.nan)
    empty = frozen(np.zeros(0))
    return Explanation(
        verdict="not_enough_data",
        summary=f"This record cannot tell: {why}.",
        noise=NoiseFloor(math.nan, run.unit, {}, {}, "residual", 0),
        before=nothing,
        after=nothing,
        held_out_before=math.nan,
        where=(),
        where_after=(),
        steps=(),
        candidates=(),
        threshold=math.nan,
        next_measurements=(),
        smallest=(),
        invisible=(),
        untested={},
        notes=(*run.notes, Note(Severity.WARNING, "not_enough_data", why)),
        measured=empty,
        predicted_before=empty,
        predicted=empty,
        sigma=empty,
        channel=frozen_int([]),
        channels=(run.channels[place],),
        unit=run.unit,
    )
