"""Which names cannot be told from a step: statistical ties and structural aliases."""

from dataclasses import dataclass

import numpy as np

from core.discrepancy.engine import Engine
from core.discrepancy.search import Scored, ranking
from core.discrepancy.slots import State

_TIE = 3.0
_FAST, _FOLDED_ONTO = "head_periodic_error", ("head_eccentricity", "head_ellipticity")
"""On few equal steps a fast error of the dial has the columns of a slow one and none of its own."""

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
    tied = [name for name, one, _ in ranked if one.evidence > top - _TIE and name != slot.name]
    # A whole number of degrees tells a wrong angle from all that merely looks like it.
    told = slot.instance.effect.step > 0.0 and search.whole(slot, others) > 0.0
    twins = () if told else aliases(engine, state, place)
    return Rivals(
        others=others,
        ranked=ranked,
        names=tuple(dict.fromkeys([*tied, *twins, *_folded(engine, (*tied, *twins))])),
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
    left = np.linalg.qr(rest)[0]
    fitted = left @ (left.T @ others.residual)
    explained, _ = search.bank.explained(fitted, others.added)
    same = explained > _ALIAS * float(fitted @ fitted)
    found = tuple(
        name
        for number, name in enumerate(bank.names)
        if name != slot.name and np.any(same & (bank.name == number))
    )
    return (*found, *_folded(engine, (slot.name,)))


def _folded(engine: Engine, names: tuple[str, ...]) -> tuple[str, ...]:
    """A fast error of the dial, where these rows show it as a slow one among the names."""
    offered = any(effect.id == _FAST for effect in engine.problem.effects)
    folds = offered and _FAST not in engine.bank.names
    return (_FAST,) if folds and not set(names).isdisjoint(_FOLDED_ONTO) else ()
