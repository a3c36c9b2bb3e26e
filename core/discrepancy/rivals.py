"""The explanations that a set of steps leaves tied, each with the slots that would stand for it."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Instance
from core.discrepancy.engine import Engine
from core.discrepancy.problem import COMMON
from core.discrepancy.result import UNKNOWN
from core.discrepancy.sets import rivals_of
from core.discrepancy.slots import Slot, State
from core.discrepancy.space import orthonormal
from core.model.effect import Effect, Kind

_FAST = "head_periodic_error"
"""What equal steps of the dial show as one of its slow errors."""

_MOST = 6
_NEAREST = 3
_LEAST_WEIGHT = 0.05
_LIKELIEST = 16
_NEAR = 10.0
"""Nats behind the best name within which a name may come up again on further rows."""
_ORDERS = range(3, 13)
_SAME, _DUST = 0.998, 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Rival:
    """One explanation of the data: all slots, its own the last."""

    name: str
    slots: tuple[Slot, ...]
    weight: float


@dataclass(frozen=True, slots=True, eq=False)
class Tie:
    """What is tied in one step.

    Parameters
    ----------
    others : the steps beside it
    members : the rivals, those of one name one behind the other
    near : what may come up on further rows, the members among it: the likeliest instances of each
        name
    share : of these in all instances of the name, natural logarithm
    unknown : structure without a name may come up as well
    """

    others: tuple[Slot, ...]
    members: tuple[Rival, ...]
    near: tuple[Instance, ...]
    share: Mapping[str, float]
    unknown: bool


def ties_of(
    engine: Engine, state: State, doubtful: frozenset[int] = frozenset()
) -> tuple[Tie, ...]:
    """The rivals of each step that has any, or that is doubtful.

    Parameters
    ----------
    doubtful : places of steps that may be structure which no effect explains; that behind the
        last is such a step itself
    """
    found = [_tie(engine, state, place, place in doubtful) for place in range(len(state.slots))]
    if len(state.slots) in doubtful:
        near = sorted(engine.search.scores(state).values(), key=lambda one: -one.evidence)
        slots = [one.slot for one in near if one.slot is not None and one.slot.raw.shape[1]]
        members = [Rival(s.name, (*state.slots, s), 1.0) for s in slots[:_NEAREST]]
        found.append(_with_near(engine, state, members, set(), unknown=True))
    return tuple(one for one in found if len(one.members) > 1)


def fitted(engine: Engine, truth: Rival) -> FloatArray:
    """Values of a rival's own effect in the rows that are there."""
    space = engine.search.bank.space
    others = engine.search.state(truth.slots[:-1])
    rest = space.rest(truth.slots[-1].raw)
    rest = rest - others.added @ (others.added.T @ rest)
    values = np.linalg.lstsq(rest, others.residual, rcond=None)[0]
    return np.asarray(values, dtype=np.float64)


def _tie(engine: Engine, state: State, place: int, doubtful: bool) -> Tie:
    own = state.slots[place]
    rivals = rivals_of(engine, state, place)
    scored = {name: (one, weight) for name, one, weight in rivals.ranked}
    names = [own.name, *rivals.names][:_MOST]
    named = [name for name in names if name != UNKNOWN]
    if len(named) == 1 and (UNKNOWN in names or doubtful):
        # What is unknown predicts nothing; the nearest names stand for it.
        names += [name for name, one, _ in rivals.ranked if one.slot is not None][:_NEAREST]
        names = list(dict.fromkeys(names))
    members: list[Rival] = []
    for name in names:
        one, weight = scored.get(name, (None, 0.0))
        slots = [own] if name == own.name else []
        if not slots and one is not None and one.slot is not None:
            slots = [engine.search.polished(one.slot, rivals.others)]
        if name == _FAST and one is None:
            slots = _folded(engine, own, rivals.others)
        members += [
            Rival(name, (*rivals.others.slots, slot), max(weight, _LEAST_WEIGHT))
            for slot in slots
            if slot.raw.shape[1]
        ]
    top = rivals.ranked[0][1].evidence
    near = {name for name, one, _ in rivals.ranked if one.evidence > top - _NEAR}
    return _with_near(engine, rivals.others, members, near, unknown=UNKNOWN in near or doubtful)


def _with_near(
    engine: Engine, others: State, members: list[Rival], names: set[str], *, unknown: bool
) -> Tie:
    """A tie with what may come up on further rows."""
    projected = engine.search.bank
    bank, evidence = projected.bank, projected.evidence(others.residual, others.added)
    wanted = names | {member.name for member in members}
    near: list[Instance] = []
    share: dict[str, float] = {}
    for place, name in enumerate(bank.names):
        own = np.flatnonzero(bank.name == place)
        if name not in wanted and not _steady(bank.instances[int(own[0])].effect):
            continue
        best: list[int] = own[np.argsort(-evidence[own], kind="stable")[:_LIKELIEST]].tolist()
        near += [bank.instances[i] for i in best]
        share[name] = float(np.log(len(best) / len(own)))
    # A name of which these rows have nothing of its own is no instance of theirs.
    unseen = [member for member in members if member.name not in bank.names]
    near += [member.slots[-1].instance for member in unseen]
    share |= {member.name: 0.0 for member in unseen}
    return Tie(others.slots, tuple(members), tuple(near), share, unknown)


def _steady(effect: Effect) -> bool:
    """What may come up on new angles though it has nothing to say of the old ones."""
    return effect.kind is Kind.BLOCK and effect.instant and not effect.timed


def _folded(engine: Engine, own: Slot, others: State) -> list[Slot]:
    """Fast errors of the dial that these rows show as the slow one that has the step."""
    fast = next(effect for effect in engine.problem.effects if effect.id == _FAST)
    space = engine.search.bank.space
    rest = space.rest(own.raw)
    rest = rest - others.added @ (others.added.T @ rest)
    left = _span(rest)
    shown = left @ (left.T @ others.residual)
    found: list[Slot] = []
    for order in _ORDERS:
        instance = Instance(fast.shaped(float(order)), COMMON)
        raw = engine.problem.columns(instance.effect)
        seen = space.rest(raw)
        basis = _span(seen - others.added @ (others.added.T @ seen))
        if float(np.sum((basis.T @ shown) ** 2)) > _SAME * float(shown @ shown):
            found.append(Slot(_FAST, instance, raw, np.zeros(len(raw))))
    return found[:_NEAREST]


def _span(columns: FloatArray) -> FloatArray:
    """Orthonormal basis of columns, without those that are but rounding."""
    size = np.linalg.norm(columns, axis=0)
    return orthonormal(columns[:, size > _DUST * float(size.max(initial=0.0))])
