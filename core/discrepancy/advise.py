"""What to measure next: follow-ups that can be done, ranked by their chance to decide.

Every rival is predicted with its fitted size; a follow-up is good where, on old and new rows
together, no other rival can imitate it (Box and Hill 1967; Hunter and Reiner 1965).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.components import components_of
from core.discrepancy.engine import Engine
from core.discrepancy.followups import FollowUp, followups_of
from core.discrepancy.problem import Problem
from core.discrepancy.result import UNKNOWN, NextMeasurement
from core.discrepancy.sets import rivals_of
from core.discrepancy.slots import Slot, State
from core.discrepancy.space import Space, orthonormal
from core.model.effect import Effect

_NEEDED = 14.0
"""Twice the nats by which one name must lead: three to be alone, four for the choice of shape."""

_SHOWN = 3
_MOST_RIVALS = 6
_NEAREST = 3
_SURE = 0.98
"""Chance from which on the shorter follow-up is the better one."""


@dataclass(frozen=True, slots=True, eq=False)
class Rival:
    """One explanation of the data: all slots, with values."""

    names: tuple[str, ...]
    slots: tuple[Slot, ...]
    weight: float


def advise(
    engine: Engine, state: State, doubtful: frozenset[int] = frozenset()
) -> tuple[NextMeasurement, ...]:
    """Return the follow-ups that separate the ambiguity sets best; none where nothing is tied.

    Parameters
    ----------
    doubtful : places of steps that may be structure which no effect explains; that behind the
        last is such a step itself
    """
    sets = tied_sets(engine, state, doubtful)
    if not sets:
        return ()
    found = [_judged(engine, sets, follow) for follow in followups_of(engine.problem.run)]
    found = [each for each in found if each.probability > 0.0]
    found.sort(key=lambda each: (-min(round(each.probability, 2), _SURE), each.minutes))
    return tuple(found[:_SHOWN])


def tied_sets(
    engine: Engine, state: State, doubtful: frozenset[int] = frozenset()
) -> list[list[Rival]]:
    """The rivals of each step that has any, or that is doubtful."""
    sets: list[list[Rival]] = []
    for place in range(len(state.slots)):
        rivals = rivals_of(engine, state, place)
        scored = {name: (one, weight) for name, one, weight in rivals.ranked}
        names = [state.slots[place].name, *rivals.names][:_MOST_RIVALS]
        named = [name for name in names if name != UNKNOWN]
        if len(named) == 1 and (UNKNOWN in names or place in doubtful):
            # What is unknown predicts nothing; the nearest names stand for it.
            names += [name for name, one, _ in rivals.ranked if one.slot is not None][:_NEAREST]
            names = list(dict.fromkeys(names))
        members: list[Rival] = []
        for name in names:
            one, weight = scored.get(name, (None, 0.0))
            slot = state.slots[place] if name == state.slots[place].name else None
            if slot is None and one is not None and one.slot is not None:
                slot = engine.search.polished(one.slot, rivals.others)
            if slot is not None and slot.raw.shape[1]:
                slots = (*rivals.others.slots, slot)
                members.append(Rival((name,), slots, max(weight, 0.05)))
        if len(members) > 1:
            sets.append(members)
    if len(state.slots) in doubtful:
        near = sorted(engine.search.scores(state).values(), key=lambda one: -one.evidence)
        slots = [one.slot for one in near if one.slot is not None and one.slot.raw.shape[1]]
        sets.append([Rival((s.name,), (*state.slots, s), 1.0) for s in slots[:_NEAREST]])
    return sets


def _judged(engine: Engine, sets: list[list[Rival]], follow: FollowUp) -> NextMeasurement:
    both = Problem.of(follow.run)
    # The response is known from the old rows; the new ones have no outputs yet.
    both = replace(both, models=engine.problem.models)
    parts = components_of(both, engine.settings)
    sizes = engine.floor.sizes.total(parts)
    space = Space.of(sizes, both.design(), engine.floor.prior)
    chance = 1.0
    for members in sets:
        chance *= chance_of(engine, both.columns, space, members)
    names = sorted({name for members in sets for one in members for name in one.names})
    return NextMeasurement(
        title=follow.title,
        why=f"{follow.why}; tells apart {', '.join(names)}",
        plan=follow.plan,
        probability=chance,
        minutes=follow.minutes,
    )


def chance_of(
    engine: Engine,
    columns: Callable[[Effect, int], FloatArray],
    space: Space,
    members: list[Rival],
) -> float:
    """Probability that the right one of these rivals ends alone in the rows of a space."""
    spans: list[FloatArray] = []
    means: list[FloatArray] = []
    for member in members:
        raw = [
            columns(s.instance.effect, s.instance.channel) for s in member.slots if s.raw.shape[1]
        ]
        white = space.rest(np.hstack(raw))
        spans.append(orthonormal(white))
        values = _values(engine, member)
        means.append(space.rest(raw[-1] @ values[:, None])[:, 0])
    total, weight = 0.0, 0.0
    for i, mean in enumerate(means):
        decided = 1.0
        for j, span in enumerate(spans):
            if i != j:
                left = mean - span @ (span.T @ mean)
                decided = min(decided, _decided(float(left @ left)))
        total += members[i].weight * decided
        weight += members[i].weight
    return total / weight


def _values(engine: Engine, member: Rival) -> FloatArray:
    """Fitted values of a rival's own effect in the data that are there."""
    others = engine.search.state(member.slots[:-1])
    rest = engine.search.bank.space.rest(member.slots[-1].raw)
    rest = rest - others.added @ (others.added.T @ rest)
    values = np.linalg.lstsq(rest, others.residual, rcond=None)[0]
    return np.asarray(values, dtype=np.float64)


def _decided(distance: float) -> float:
    """Probability that so many chi-squares of distance put the right name ahead enough."""
    if distance <= 0.0:
        return 0.0
    root = math.sqrt(distance)
    return 0.5 * (1.0 + math.erf((distance - _NEEDED) / (2.0 * root) / math.sqrt(2.0)))
