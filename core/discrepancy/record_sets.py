"""Which names cannot be told apart in a set of several: credible sets over whole sets.

Where several effects go with the temperature, a name that is taken for another bends the shapes of
its neighbours, and two names may stand for two others. Whole sets are compared therefore, each
with the shapes that are best for it.
"""

from collections.abc import Iterable

from core.discrepancy.record_refined import NameSet, own_evidence, refined, valued, without
from core.discrepancy.record_search import NEAR
from core.discrepancy.record_shapes import Shapes
from core.discrepancy.slots import Slot, State

_LOOK = 12.0
"""Nats that a name may lie behind beside neighbours whose shapes are those of another."""


def tied_names(shapes: Shapes, state: State, sets: Iterable[NameSet]) -> list[tuple[str, ...]]:
    """Names that cannot be told from each slot of a state.

    Parameters
    ----------
    state : the set that is told
    sets : others that were refined
    """
    told = valued(shapes, state.slots)
    slots = state.slots
    found: list[dict[str, None]] = [{} for _ in slots]
    for place, slot in enumerate(slots):
        rest = without(slots, place)
        for name, other in _instead(shapes, rest, slot):
            if refined(shapes, (*rest, other)).worth > told.worth - NEAR:
                found[place][name] = None
    for one in sets:
        if one.worth <= told.worth - NEAR:
            continue
        gone, new = _difference(told.names, one.names), _difference(one.names, told.names)
        for place, slot in enumerate(slots):
            if slot.name in gone:
                found[place] |= dict.fromkeys(name for name in new if name != slot.name)
    return [tuple(names) for names in found]


def _instead(shapes: Shapes, rest: tuple[Slot, ...], slot: Slot) -> list[tuple[str, Slot]]:
    """Names that come near a slot in its place, each with its best shape."""
    others = shapes.state(rest)
    enough = own_evidence(shapes, slot, others) - _LOOK
    taken = {one.name for one in (*rest, slot)}
    return [
        (name, one.slot)
        for name, one in shapes.search.scores(others).items()
        if one.slot is not None and one.evidence > enough and name not in taken
    ]


def _difference(names: tuple[str, ...], others: tuple[str, ...]) -> list[str]:
    left = list(others)
    found: list[str] = []
    for name in names:
        if name in left:
            left.remove(name)
        else:
            found.append(name)
    return found
