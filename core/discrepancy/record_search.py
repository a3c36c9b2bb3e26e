"""The best sets of names for a long record, pairs and all.

A record has few names, and many of them go with the temperature: two that nearly cancel explain
little one by one and much together, so that no search that adds one name at a time finds them.
All pairs are looked at, what is best of each set of names goes on, and the likeliest sets are
refined: shapes, paths of a telegraph, and one or two names exchanged at once.
"""

from collections.abc import Collection, Iterable
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Projected
from core.discrepancy.record_refined import NameSet, is_needed, refined, without
from core.discrepancy.record_shapes import Shapes
from core.discrepancy.search import Scored, Search
from core.discrepancy.slots import Slot
from core.discrepancy.space import orthonormal

_STARTERS = 30
"""Instances of one name from which pairs begin: all shapes of most, the likeliest of jumps."""
_WIDTHS = (24, 14, 8)
"""Sets of two, three, four names that go on."""
_REFINED = 6
_PAID = ("telegraph",)
_AGAIN = ("bias_jump", "pickup")
"""Names that may stand twice in a set; two shapes of any other are one thing of another shape."""
NEAR = 3.0
"""Nats within which sets cannot be told apart."""
_RIVAL = 6.0
"""Nats by which unknown structure may lead names that are told none the less, in doubt."""


@dataclass(frozen=True, slots=True, eq=False)
class _Node:
    """A set of instances of the bank on the way.

    Parameters
    ----------
    instances, names : places in the bank, in the order of being added, and sorted
    added, residual : as those of a state, without the last instance
    score : evidence of the names, one after the other
    """

    instances: tuple[int, ...]
    names: tuple[int, ...]
    added: FloatArray
    residual: FloatArray
    score: float

    def complete(self, bank: Projected) -> tuple[FloatArray, FloatArray]:
        """What all instances add, and what they leave."""
        if not self.instances:
            return self.added, self.residual
        columns = bank.columns[:, bank.bank.block(self.instances[-1])]
        own = orthonormal(columns - self.added @ (self.added.T @ columns))
        residual = self.residual - own @ (own.T @ self.residual)
        return np.hstack([self.added, own]), residual


def likeliest(shapes: Shapes, known: Iterable[tuple[Slot, ...]] = ()) -> list[NameSet]:
    """Refined sets of names, best first; the empty set is one of them.

    Parameters
    ----------
    shapes : of the record in one space
    known : sets that were likely under another noise; refined here, and no others are looked for
        but those that come of exchanges
    """
    search = shapes.search
    found: dict[tuple[str, ...], NameSet] = {(): NameSet(shapes.state(()), 0.0)}

    begun_with: set[frozenset[object]] = set()

    def take(slots: tuple[Slot, ...]) -> None:
        keys = frozenset((slot.key, slot.raw.shape[1]) for slot in slots)
        if keys in begun_with:
            return
        begun_with.add(keys)
        one = refined(shapes, slots)
        old = found.get(one.names)
        if old is None or old.worth < one.worth:
            found[one.names] = one

    begun = list(known)
    if not begun:
        bank = search.bank.bank
        begun = [
            tuple(shapes.made(bank.instances[place].effect) for place in node.instances)
            for node in _promising(search, _grown(search))
        ]
    for slots in begun:
        take(slots)
    for slots in _exchanged(shapes, _best(found.values()).state.slots):
        take(slots)
    best = _best(found.values()).state.slots
    for place in range(len(best)):
        take(without(best, place))
    kept = [one for one in found.values() if is_needed(shapes, one)]
    return sorted(kept, key=_worth, reverse=True)


def leavings(search: Search) -> list[FloatArray]:
    """What the best sets of one and of two names leave (n,), whitened."""
    nodes = _grown(search, _WIDTHS[:1])
    return [node.complete(search.bank)[1] for node in nodes]


def _best(sets: Iterable[NameSet]) -> NameSet:
    return max(sets, key=_worth)


def _worth(one: NameSet) -> float:
    return one.worth


def _children(
    search: Search, node: _Node, each: int = 1, taken: Collection[str] = ()
) -> list[_Node]:
    """All names as the next of a set, with their best instances."""
    bank = search.bank.bank
    added, residual = node.complete(search.bank)
    odds = np.array([one.effect.log_odds for one in bank.instances])
    evidence = search.bank.evidence(residual, added) + odds
    edges = np.flatnonzero(np.diff(bank.name, prepend=-1)).astype(np.int64)
    top = np.maximum.reduceat(evidence, edges)
    count = np.diff(edges, append=len(evidence))
    mean = np.log(np.add.reduceat(np.exp(evidence - top[bank.name]), edges) / count) + top
    found: list[_Node] = []
    for place, name in enumerate(bank.names):
        if (place in node.names and name not in _AGAIN) or name in taken:
            continue
        start = int(edges[place])
        own = evidence[start : start + int(count[place])]
        order = np.argsort(-own)[:each] if each > 1 else np.argmax(own, keepdims=True)
        names = tuple(sorted((*node.names, place)))
        for instance in (order.astype(np.int64) + start).tolist():
            if instance in node.instances or not search.bank.seen[instance]:
                continue
            # The odds of a path have paid for its choice already.
            own_mean = top[place] if name in _PAID else mean[place]
            score = node.score + float(own_mean + evidence[instance] - top[place])
            found.append(_Node((*node.instances, instance), names, added, residual, score))
    return found


def _best_of_each(nodes: Iterable[_Node], count: int) -> list[_Node]:
    """The best node of each set of names, so many."""
    found: dict[tuple[int, ...], _Node] = {}
    for node in nodes:
        old = found.get(node.names)
        if old is None or old.score < node.score:
            found[node.names] = node
    return sorted(found.values(), key=lambda node: node.score, reverse=True)[:count]


def _grown(search: Search, widths: tuple[int, ...] = _WIDTHS) -> list[_Node]:
    """Sets of one, two and more names, the best of each size."""
    plain = search.state(())
    first = _children(search, _Node((), (), plain.added, plain.residual, 0.0), _STARTERS)
    found = _best_of_each(first, len(search.bank.bank.names))
    beam = first
    for width in widths[: max(search.most - 1, 0)]:
        beam = _best_of_each((new for node in beam for new in _children(search, node)), width)
        found += beam
    return found


def _promising(search: Search, nodes: list[_Node]) -> list[_Node]:
    """The likeliest nodes of all sizes."""

    def worth(node: _Node) -> float:
        return node.score - search.threshold * len(node.instances)

    return sorted(nodes, key=worth, reverse=True)[:_REFINED]


def _exchanged(shapes: Shapes, slots: tuple[Slot, ...]) -> list[tuple[Slot, ...]]:
    """The likeliest sets with one or two other names in the place of some, or with one more."""
    search, bank = shapes.search, shapes.search.bank.bank
    found: list[tuple[Slot, ...]] = []
    for gone in (0, 1, 2):
        if len(slots) < gone + 1 or (gone == 0 and len(slots) >= search.most):
            continue
        for places in combinations(range(len(slots)), gone):
            rest = without(slots, *places)
            others = shapes.state(rest)
            taken = {slot.name for slot in rest}.difference(_AGAIN)
            nodes = [_Node((), (), others.added, others.residual, 0.0)]
            for each in range(max(gone, 1)):
                count = 4 if each + 1 < gone else 1
                nodes = [new for node in nodes for new in _children(search, node, count, taken)]
            for node in _best_of_each(nodes, 2):
                more = tuple(shapes.made(bank.instances[one].effect) for one in node.instances)
                found.append((*rest, *more))
    return found


def ended(search: Search, sets: list[NameSet]) -> tuple[NameSet, Scored | None, tuple[str, ...]]:
    """The best set, unknown structure where it ends with that, and names that may be unknown.

    Names that explain nearly as much as unknown structure in their place are told, in doubt.
    """
    left = [search.unknown(one.state) for one in sets]
    # What a set leaves speaks against it, though it may be too little to be told; never does it
    # speak for names where nothing at all is likelier.
    near = [
        (one.worth - max(score.evidence, 0.0), place)
        for place, (one, score) in enumerate(zip(sets, left, strict=True))
        if one.worth > sets[0].worth - NEAR
    ]
    told = sets[max(near)[1]] if sets[0].names else sets[0]
    best, end, top = told, None, sets[0].worth
    for one, score in zip(sets, left, strict=True):
        total = one.worth + score.evidence - search.threshold
        if score.margin > search.threshold and total > top:
            best, end, top = one, score, total
    if end is None or told.worth < top - _RIVAL or not told.names:
        return best, end, ()
    known = list(best.names)
    doubtful = [name for name in told.names if name not in known or known.remove(name)]
    return told, None, tuple(doubtful)
