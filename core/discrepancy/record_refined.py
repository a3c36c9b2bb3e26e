"""A set of names for a record: the shapes that are best beside each other, and what it is worth."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.evidence import block_evidence, log_mean
from core.discrepancy.record_shapes import Shapes
from core.discrepancy.record_telegraph import telegraph_of
from core.discrepancy.slots import Slot, State

_GRID_ROUNDS, _FINE_ROUNDS = 4, 2
_TELEGRAPH = "telegraph"
_DUST = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class NameSet:
    """A set of names with its best shapes.

    Parameters
    ----------
    state : its slots
    worth : evidence of all of them less what each must have
    """

    state: State
    worth: float

    @property
    def names(self) -> tuple[str, ...]:
        """Its names in alphabetical order."""
        return tuple(sorted(slot.name for slot in self.state.slots))


def refined(shapes: Shapes, slots: tuple[Slot, ...]) -> NameSet:
    """A set with the shapes that are best beside each other: first those of the grid, then all."""
    found = slots
    for fine, rounds in ((False, _GRID_ROUNDS), (True, _FINE_ROUNDS)):
        for _ in range(rounds):
            before = [slot.key for slot in found]
            for place, slot in enumerate(found):
                others = shapes.state(without(found, place))
                new = _reshaped(shapes, slot, others, fine)
                found = (*found[:place], new, *found[place + 1 :])
            if before == [slot.key for slot in found]:
                break
    return valued(shapes, found)


def valued(shapes: Shapes, slots: tuple[Slot, ...]) -> NameSet:
    """A set with its worth: what all explain, and what the choice of each shape costs."""
    left, order, total = list(slots), (), 0.0
    given = shapes.state(())
    while left:
        # What explains most comes first.
        each = [alone(shapes, slot, given) for slot in left]
        total += max(each)
        order = (*order, left.pop(int(np.argmax(each))))
        given = shapes.state(order)
    for place, slot in enumerate(order):
        others = shapes.state(without(order, place))
        total += min(own_evidence(shapes, slot, others) - alone(shapes, slot, others), 0.0)
    worth = total - shapes.search.threshold * len(order)
    return NameSet(shapes.state(order, total), worth)


def is_needed(shapes: Shapes, one: NameSet) -> bool:
    """Whether each name of a set stands out beside the others."""
    slots, search = one.state.slots, shapes.search
    return all(
        own_evidence(shapes, slot, shapes.state(without(slots, place)))
        > search.threshold + search.doubts.get(slot.name, 0.0)
        for place, slot in enumerate(slots)
    )


def own_evidence(shapes: Shapes, slot: Slot, others: State) -> float:
    """Evidence of the name of a slot beside others; of a path, of that path alone."""
    if slot.name == _TELEGRAPH:
        return alone(shapes, slot, others) + slot.instance.effect.log_odds
    return float(log_mean(_of_name(shapes, slot, others), axis=0))


def alone(shapes: Shapes, slot: Slot, others: State) -> float:
    """Evidence of a slot of this shape beside others."""
    space = shapes.search.bank.space
    dof = space.dof - others.added.shape[1]
    gain, count = shapes.gain(slot, others), slot.raw.shape[1]
    return float(block_evidence(gain, count, others.rss, space.prior, dof))


def without(slots: tuple[Slot, ...], *places: int) -> tuple[Slot, ...]:
    """The slots but for some."""
    return tuple(slot for i, slot in enumerate(slots) if i not in places)


def _of_name(shapes: Shapes, slot: Slot, others: State) -> FloatArray:
    """Evidence of all instances of the name of a slot beside others."""
    bank = shapes.search.bank
    own = np.flatnonzero(bank.bank.name == bank.bank.names.index(slot.name))
    if np.any(bank.bank.count[own] > 1):
        return bank.evidence(others.residual, others.added)[own]
    columns = bank.columns[:, bank.bank.first[own]]
    size = np.sum(columns**2, axis=0)
    columns = columns - others.added @ (others.added.T @ columns)
    left = np.sum(columns**2, axis=0)
    free = left > _DUST * np.maximum(size, 1e-300)
    gain = (columns.T @ others.residual) ** 2 / np.where(free, left, 1.0) * free
    dof = bank.space.dof - others.added.shape[1]
    evidence = block_evidence(gain, np.ones(len(own)), others.rss, bank.space.prior, dof)
    return np.where(free, evidence, 0.0)


def _reshaped(shapes: Shapes, slot: Slot, others: State, fine: bool) -> Slot:
    """The same name with the shape that is best beside the others."""
    if slot.name == _TELEGRAPH:
        return _another_path(shapes, slot, others) if fine else slot
    bank = shapes.search.bank.bank
    own = np.flatnonzero(bank.name == bank.names.index(slot.name))
    best = own[np.argmax(_of_name(shapes, slot, others))]
    other = shapes.made(bank.instances[int(best)].effect)
    if alone(shapes, slot, others) > alone(shapes, other, others):
        other = slot
    return shapes.polished(other, others) if fine else other


def _another_path(shapes: Shapes, slot: Slot, others: State) -> Slot:
    """The telegraph with the path that what the others leave suggests."""
    search = shapes.search
    made = telegraph_of(search.problem, [search.bank.space.chol @ others.residual])
    if made is None:
        return slot
    sensor = search.problem.models[0].sensor
    trials = [shapes.made(one) for one in made.instances(search.problem.stimulus, sensor)]
    return max((slot, *trials), key=lambda one: own_evidence(shapes, one, others))
