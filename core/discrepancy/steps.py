"""Steps of the ladder: parameters with uncertainty, curves, rivals."""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.discrepancy.engine import Engine
from core.discrepancy.gaps import gap_of, held_out_gap
from core.discrepancy.problem import EACH
from core.discrepancy.result import UNKNOWN, Candidate, Fitted, Gap, Step
from core.discrepancy.search import Scored, ranking
from core.discrepancy.sets import Rivals, rivals_of
from core.discrepancy.slots import Slot, State
from core.discrepancy.space import solved
from core.discrepancy.views import spread_of
from core.model.catalogue.listing import CATALOGUE

_SHOWN = 8
_LEAST = 0.9
"""Part of the spread under one floor below which that under all of them does not go."""


def steps_of(engine: Engine, state: State, by_hand: int) -> tuple[Step, ...]:
    """Return one step for each slot; the first `by_hand` of them were added by hand."""
    fitted = fit_slots(engine, state)
    found: list[Step] = []
    for place, slot in enumerate(state.slots):
        until = engine.search.state(state.slots[: place + 1])
        rivals = rivals_of(engine, state, place)
        found.append(
            _step(
                engine, slot, fitted[place], rivals, gap_of(engine, until), until, place < by_hand
            )
        )
    return tuple(found)


def candidates_of(engine: Engine, state: State) -> tuple[Candidate, ...]:
    """What could be added next, best first; nothing that is below the threshold."""
    search = engine.search
    ranked = ranking(search.scores(state), search.unknown(state))
    return tuple(
        candidate_of(engine, state, name, one, weight, alias=False)
        for name, one, weight in ranked[:_SHOWN]
        if one.margin > search.threshold
    )


def candidate_of(
    engine: Engine, others: State, name: str, one: Scored, weight: float, *, alias: bool
) -> Candidate:
    """A name in the place of a step, as it would be fitted."""
    if one.slot is None:
        curve = unknown_curve(engine, others, one)
        left = others.residual - engine.search.bank.space.rest(curve[:, None])[:, 0]
        dof = max(engine.search.bank.space.dof - others.added.shape[1], 1)
        return Candidate(
            effect=UNKNOWN,
            name="Unexplained structure",
            plain=_in_words(engine, one),
            equation="a smooth curve",
            evidence=one.evidence,
            probability=weight,
            parameters=(),
            gap_after=math.sqrt(float(left @ left) / dof),
            alias=alias,
            curve=frozen(curve),
        )
    slot = engine.search.polished(one.slot, others)
    state = engine.search.state((*others.slots, slot))
    effect = CATALOGUE[name]
    fitted = fit_slots(engine, state)[-1]
    return Candidate(
        effect=name,
        name=effect.name,
        plain=effect.plain,
        equation=effect.equation,
        evidence=one.evidence,
        probability=weight,
        parameters=fitted.parameters,
        gap_after=gap_of(engine, state).gap,
        alias=alias,
        curve=frozen(fitted.curve),
    )


@dataclass(frozen=True, slots=True, eq=False)
class FittedSlot:
    """A slot with its numbers.

    Parameters
    ----------
    parameters : for people: amplitude and phase instead of sine and cosine
    values : (p,) of the columns
    curve : (n,) what it adds, output units
    """

    parameters: tuple[Fitted, ...]
    values: FloatArray
    curve: FloatArray


def fit_slots(engine: Engine, state: State) -> list[FittedSlot]:
    """Parameters and curve of each slot, all fitted together with the plain model.

    The uncertainty of a shape (time constant, level) is in that of the parameters: its derivative
    is fitted along with them.
    """
    problem, space = engine.problem, engine.search.bank.space
    blocks = [problem.design(), *(slot.raw for slot in state.slots)]
    count = sum(block.shape[1] for block in blocks)
    change = sum((slot.change for slot in state.slots), np.zeros(len(problem.y)))
    y = space.white(problem.y + change)
    design = np.hstack(blocks)
    values, _ = solved(space.white(design), y)
    starts = np.cumsum([block.shape[1] for block in blocks])
    extra = [
        _shape_slope(engine, slot, values[starts[i] : starts[i] + slot.raw.shape[1]])
        for i, slot in enumerate(state.slots)
    ]
    wide = np.hstack([design, *[e for e in extra if e is not None]])
    _, covariance = solved(space.white(wide), y)
    dof = space.dof - state.added.shape[1]
    # A lucky draw of the noise makes no parameter surer than the floor does; the spread of
    # Student's form is that of a floor which is known from so many degrees of freedom alone.
    known = max(space.prior + dof, 3.0)
    level = max((space.prior + state.rss) / known, 1.0) * known / (known - 2.0)
    u = np.sqrt(np.maximum(np.diag(covariance)[:count] * level, 0.0))
    if engine.search.views:
        outputs = problem.y + change
        u = np.maximum(spread_of(engine.search.views, outputs, design, wide, values), _LEAST * u)
    found: list[FittedSlot] = []
    for i, slot in enumerate(state.slots):
        own = slice(int(starts[i]), int(starts[i]) + slot.raw.shape[1])
        curve = slot.raw @ values[own] - slot.change
        parameters = _parameters(engine, slot, values[own], u[own])
        found.append(FittedSlot(parameters, values[own], curve))
    return found


def unknown_curve(engine: Engine, others: State, one: Scored) -> FloatArray:
    """(n,) curve of unknown structure, output units."""
    if one.path is not None:
        rest = engine.search.bank.space.rest(one.path[:, None])[:, 0]
        rest = rest - others.added @ (others.added.T @ rest)
        return one.path * float(rest @ others.residual) / max(float(rest @ rest), 1e-300)
    curve = engine.search.curves[one.regressor]
    smooth = curve.fitted(others.residual)
    return engine.search.bank.space.chol @ smooth


def unknown_step(engine: Engine, state: State, one: Scored) -> Step:
    """Structure that no effect explains, as the last step."""
    space = engine.search.bank.space
    curve = unknown_curve(engine, state, one)
    white = space.rest(curve[:, None])[:, 0]
    left = state.residual - white
    dof = max(space.dof - state.added.shape[1], 1)
    raw = space.chol @ left
    chi2 = float(left @ left)
    search = engine.search
    ranked = ranking(search.scores(state), one)
    weight = next(w for name, _, w in ranked if name == UNKNOWN)
    near = tuple(
        name for name, other, _ in ranked if name != UNKNOWN and other.evidence > one.evidence - 3.0
    )
    after = Gap(
        rms=float(np.sqrt(np.mean(raw**2))),
        gap=math.sqrt(chi2 / dof),
        chi2_red=chi2 / dof,
        dof=dof,
        p_value=math.nan,
        lack_p=math.nan,
    )
    size = float(np.sqrt(np.mean(curve**2)))
    return Step(
        effect=UNKNOWN,
        name="Unexplained structure",
        plain=_in_words(engine, one, curve),
        equation="a smooth curve" if one.path is None else "two levels",
        seen_as=_in_words(engine, one, curve),
        remedy="look at the rig and the sensor where the curve is largest",
        parameters=(Fitted("rms", size, math.nan, engine.problem.run.unit),),
        probability=weight,
        p_value=engine.p_value(one.margin),
        evidence=one.evidence,
        indistinguishable_from=near,
        after=after,
        held_out_gap_after=math.nan,
        advice="measure more densely where the curve is largest",
        curve=frozen(curve),
        candidates=tuple(
            candidate_of(engine, state, name, other, w, alias=False)
            for name, other, w in ranked[:_SHOWN]
            if other.margin > search.threshold
        ),
    )


def _step(
    engine: Engine,
    slot: Slot,
    fitted: FittedSlot,
    rivals: Rivals,
    after: Gap,
    until: State,
    by_hand: bool,
) -> Step:
    effect = CATALOGUE[slot.name]
    return Step(
        effect=slot.name,
        name=effect.name,
        plain=effect.plain,
        equation=effect.equation,
        seen_as=effect.seen_as,
        remedy=effect.remedy,
        parameters=fitted.parameters,
        probability=rivals.probability,
        p_value=engine.p_value(rivals.margin),
        evidence=rivals.evidence,
        indistinguishable_from=rivals.names,
        after=after,
        held_out_gap_after=held_out_gap(engine, until),
        advice=effect.remedy,
        curve=frozen(fitted.curve),
        candidates=tuple(
            candidate_of(engine, rivals.others, name, one, weight, alias=name in rivals.aliases)
            for name, one, weight in rivals.ranked[:_SHOWN]
            if one.evidence > rivals.evidence - 10.0
        ),
        added_by_hand=by_hand,
    )


def _shape_slope(engine: Engine, slot: Slot, values: FloatArray) -> FloatArray | None:
    near = slot.instance.effect.near()
    if len(near) != 2 or not len(values):
        return None
    low, high = (engine.problem.columns(e, slot.instance.channel) @ values for e in near)
    return (high - low)[:, None]


def _parameters(
    engine: Engine, slot: Slot, values: FloatArray, u: FloatArray
) -> tuple[Fitted, ...]:
    problem = engine.problem
    sensor = problem.models[max(slot.instance.channel, 0)].sensor
    channel, effect = slot.instance.channel, slot.instance.effect
    places = [f" ({name})" for name in problem.run.channels] if problem.channels > 1 else [""]
    labels = places if channel == EACH else [places[channel] if channel >= 0 else ""]

    def unit(text: str) -> str:
        # A gyro at rest has told no scale factor; its numbers are in units of the output.
        bare = sensor.kind == "gyro" and not sensor.response
        return text.replace("deg/s", problem.run.unit) if bare else text

    numbers = [
        Fitted(p.name + label, float(v), float(e), unit(p.unit))
        for (label, p), v, e in zip(
            ((label, p) for label in labels for p in effect.parameters(sensor)),
            values,
            u,
            strict=True,
        )
    ]
    fixed = [Fitted(p.name, value, math.nan, unit(p.unit)) for p, value in effect.shape]
    return (*_polar(numbers), *fixed)


def _polar(numbers: list[Fitted]) -> list[Fitted]:
    """Sine and cosine parts as amplitude and phase."""
    found: list[Fitted] = []
    while numbers:
        first, *numbers = numbers
        stem, _, label = first.name.partition("_sine")
        if stem == first.name:
            found.append(first)
            continue
        second, *numbers = numbers
        size = math.hypot(first.value, second.value)
        along = math.hypot(first.value * first.u, second.value * second.u) / size
        across = math.hypot(second.value * first.u, first.value * second.u) / size**2
        phase = math.degrees(math.atan2(second.value, first.value))
        found.append(Fitted(f"{stem}_amplitude{label}", size, along, first.unit))
        found.append(Fitted(f"{stem}_phase{label}", phase, math.degrees(across), "deg"))
    return found


def _in_words(engine: Engine, one: Scored, curve: FloatArray | None = None) -> str:
    regressor = engine.regressors[one.regressor]
    text = f"there is structure in {regressor.name} that no effect of the catalogue explains"
    if curve is None:
        return text
    worst = int(np.argmax(np.abs(curve)))
    unit = engine.problem.run.unit
    size = float(np.sqrt(np.mean(curve**2)))
    if one.path is not None:
        changes = int(np.sum(np.diff(curve[one.path != 0.0]) != 0.0))
        return (
            f"{text}: the output goes to and fro between two levels, {2.0 * abs(curve[worst]):.3g}"
            f" {unit} apart, {changes} times"
        )
    return (
        f"{text}: a smooth curve of {size:.3g} {unit} rms describes it, largest"
        f" ({curve[worst]:+.3g} {unit}) at {regressor.x[worst]:.6g} {regressor.unit}".rstrip()
    )
