"""Which names cannot be told from a step: statistical ties and structural aliases."""

from dataclasses import dataclass

import numpy as np

from core.discrepancy.engine import Engine
from core.discrepancy.result import UNKNOWN
from core.discrepancy.search import Scored, ranking
from core.discrepancy.slots import State
from core.discrepancy.space import orthonormal

_TIE, _TIE_UNKNOWN = 4.0, 3.0
"""Nats within which a name stays in the set, 1 : 50; and what has no name, 1 : 20."""
_FAST, _FOLDED_ONTO = "head_periodic_error", ("head_eccentricity", "head_ellipticity")
"""On few equal steps a fast error of the dial has the columns of a slow one and none of its own."""

_SHORT, _LIKE_SHORT = "short_accumulation", ("outlier", "wrong_angle")

_ALIAS = 0.998
"""Square of the cosine above which nothing can tell two effects apart."""


@dataclass(frozen=True, slots=True, eq=False)
class Rivals:
    """The names that compete for a step, given the other steps.

    Parameters
    ----------
    others : the model without the step
    ranked : all names, best first, each with its probability
    names : those that cannot be told from the step
    aliases : those of them that no analysis of these rows can tell from it
    probability, evidence, margin : of the step's own name
    """

    others: State
    ranked: list[tuple[str, Scored, float]]
    names: tuple[str, ...]
    aliases: tuple[str, ...]
    probability: float
    evidence: float
    margin: float


def rivals_of(engine: Engine, state: State, place: int) -> Rivals:
    """Score all names in the place of a step."""
    search = engine.search
    slot = state.slots[place]
    others = search.state((*state.slots[:place], *state.slots[place + 1 :]))
    ranked = ranking(search.scores(others), search.unknown(others))
    evidence = max(
        (one.evidence for name, one, _ in ranked if name == slot.name),
        default=ranked[0][1].evidence,
    )
    own = next((item for item in ranked if item[0] == slot.name), ranked[0])
    # A twin of the step gets evidence for nothing but its name: one of many places has less.
    top = max(evidence, ranked[0][1].evidence)
    tied = [
        name
        for name, one, _ in ranked
        if name != slot.name and one.evidence > top - (_TIE_UNKNOWN if name == UNKNOWN else _TIE)
    ]
    # A whole number of degrees tells a wrong angle from all that merely looks like it.
    told = slot.instance.effect.step > 0.0 and search.whole(slot, others) > 0.0
    twins = () if told else aliases(engine, state, place)
    return Rivals(
        others=others,
        ranked=ranked,
        names=tuple(dict.fromkeys([*tied, *twins, *_unseen(engine, (*tied, *twins, slot.name))])),
        aliases=twins,
        probability=own[2],
        evidence=evidence,
        margin=own[1].margin,
    )


def aliases(engine: Engine, state: State, place: int) -> tuple[str, ...]:
    """Names whose columns reproduce what a step adds: cosine above 0.999."""
    search, bank = engine.search, engine.bank
    slot = state.slots[place]
    if not slot.raw.shape[1]:
        return ()
    others = search.state((*state.slots[:place], *state.slots[place + 1 :]))
    rest = search.bank.space.rest(slot.raw)
    rest = rest - others.added @ (others.added.T @ rest)
    left = orthonormal(rest)
    fitted = left @ (left.T @ others.residual)
    explained, _ = search.bank.explained(fitted, others.added)
    same = explained > _ALIAS * float(fitted @ fitted)
    found = tuple(
        name
        for number, name in enumerate(bank.names)
        if name != slot.name and np.any(same & (bank.name == number))
    )
    return (*found, *_unseen(engine, (slot.name,)))


def _unseen(engine: Engine, names: tuple[str, ...]) -> tuple[str, ...]:
    """What these rows cannot show as itself, and would show as one of the names.

    A fast error of the dial as a slow one; without standard errors an accumulation that was too
    short as any other bad row.
    """
    offered = any(effect.id == _FAST for effect in engine.problem.effects)
    folds = offered and _FAST not in engine.bank.names and not set(names).isdisjoint(_FOLDED_ONTO)
    short = _SHORT in engine.problem.untested and not set(names).isdisjoint(_LIKE_SHORT)
    return (*((_FAST,) if folds else ()), *((_SHORT,) if short else ()))
