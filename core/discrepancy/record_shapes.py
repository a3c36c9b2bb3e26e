"""Slots of a record beside each other, none of their columns made or whitened twice.

A search over sets of names comes back to the same shapes again and again, under one noise and the
next; the columns of a lag or a hysteresis are recursions, and slow to make.
"""

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Instance
from core.discrepancy.search import Search
from core.discrepancy.slots import Slot, State
from core.discrepancy.space import orthonormal
from core.model.effect import Effect

_COARSEST, _FINEST = 1.0, 0.1

Key = tuple[str, int, tuple[float, ...]]


class Shapes:
    """All shapes of the effects of one record in one whitened space.

    Parameters
    ----------
    search : all hypotheses in that space
    raw : columns that were made already, shared by all spaces of the record
    """

    def __init__(self, search: Search, raw: dict[Key, FloatArray]) -> None:
        self.search = search
        self._raw = raw
        self._rest: dict[Key, FloatArray] = {}
        self._y = search.state(()).residual
        self._sensor = search.problem.models[0].sensor

    def _key(self, effect: Effect) -> Key:
        shape = tuple(value for _, value in effect.shape)
        return effect.id, len(effect.parameters(self._sensor)), shape

    def made(self, effect: Effect) -> Slot:
        """An instance of an effect as a slot."""
        key = self._key(effect)
        if key not in self._raw:
            self._raw[key] = self.search.problem.columns(effect, 0)
        raw = self._raw[key]
        return Slot(effect.id, Instance(effect, 0), raw, np.zeros(len(raw)))

    def rest(self, slot: Slot) -> FloatArray:
        """Whitened columns (n, p) of a slot without the plain model."""
        key = self._key(slot.instance.effect)
        if key not in self._rest:
            self._rest[key] = self.search.bank.space.rest(slot.raw)
        return self._rest[key]

    def state(self, slots: tuple[Slot, ...], evidence: float = 0.0) -> State:
        """The state of a set of slots."""
        if not slots:
            return State((), np.zeros((len(self._y), 0)), self._y, evidence)
        added = orthonormal(np.hstack([self.rest(slot) for slot in slots]))
        return State(slots, added, self._y - added @ (added.T @ self._y), evidence)

    def gain(self, slot: Slot, others: State) -> float:
        """Sum of squares that a slot takes away beside others."""
        rest = self.rest(slot)
        left = orthonormal(rest - others.added @ (others.added.T @ rest))
        return float(np.sum((left.T @ others.residual) ** 2))

    def polished(self, slot: Slot, others: State) -> Slot:
        """The slot with its shape refined to a tenth of a step of the grid."""
        best, gain, fraction = slot, self.gain(slot, others), _COARSEST
        while fraction > _FINEST:
            trials = [self.made(effect) for effect in best.instance.effect.near(fraction)]
            if not trials:
                break
            gains = [self.gain(trial, others) for trial in trials]
            if max(gains) > gain:
                best, gain = trials[int(np.argmax(gains))], max(gains)
            else:
                fraction /= 2.0
        return best
