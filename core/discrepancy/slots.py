"""What has been added to the plain model, and what is left then."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Instance
from core.discrepancy.space import Space, orthonormal


@dataclass(frozen=True, slots=True, eq=False)
class Slot:
    """One effect that was added.

    Parameters
    ----------
    name : identifier
    instance : where and of which shape
    raw : (n, p) output that one unit of each parameter adds; none for a relabelling
    change : (n,) what a relabelling adds to the outputs; zero for others
    """

    name: str
    instance: Instance
    raw: FloatArray
    change: FloatArray

    @property
    def key(self) -> tuple[str, int, tuple[float, ...]]:
        """What tells it from other slots."""
        shape = tuple(value for _, value in self.instance.effect.shape)
        return self.name, self.instance.channel, shape


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """A set of slots.

    Parameters
    ----------
    slots : in the order of being added
    added : (n, s) orthonormal basis of what they add to the plain model, whitened
    residual : (n,) whitened
    evidence : of all slots together
    """

    slots: tuple[Slot, ...]
    added: FloatArray
    residual: FloatArray
    evidence: float

    @property
    def rss(self) -> float:
        """Sum of squares that is left."""
        return float(self.residual @ self.residual)

    @property
    def keys(self) -> frozenset[tuple[str, int, tuple[float, ...]]]:
        """What tells it from other sets."""
        return frozenset(slot.key for slot in self.slots)


def state_of(slots: tuple[Slot, ...], space: Space, y: FloatArray, evidence: float = 0.0) -> State:
    """The state of a set of slots."""
    n = len(y)
    change = np.sum([slot.change for slot in slots], axis=0) if slots else np.zeros(n)
    residual = space.rest((y + change)[:, None])[:, 0]
    added = np.zeros((n, 0))
    if slots:
        added = orthonormal(space.rest(np.hstack([slot.raw for slot in slots])))
    residual = residual - added @ (added.T @ residual)
    return State(slots, added, residual, evidence)
