"""Names compete: gross faults first, a beam of sets, exchange of names, elimination."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Instance, Projected
from core.discrepancy.curves import Curve
from core.discrepancy.evidence import block_evidence
from core.discrepancy.features import Features
from core.discrepancy.problem import Problem
from core.discrepancy.relabels import Relabels
from core.discrepancy.result import UNKNOWN
from core.discrepancy.slots import Slot, State, state_of
from core.discrepancy.space import Space
from core.discrepancy.views import View, together

_WIDTH, _FIRST = 5, 8
_GROSS, _AHEAD = 60.0, 30.0
_UNKNOWN_COST = 0.5
_ROUNDS = 3
_FINEST = 0.02
_CHORDS = 4
_STRONG = 4
"""Curves that are weighed under all sizes of the noise, the strongest under the usual ones."""
_FAR, _IMPLAUSIBLE = 15.0, -4.6
_WORTH_A_LOOK, _COARSE, _MOST_BONUS = 10.0, 0.1, 4.0


@dataclass(frozen=True, slots=True, eq=False)
class Scored:
    """One name as the next step.

    Parameters
    ----------
    evidence : averaged over its instances
    margin : the same without what an unlucky guess of the noise alone can give this name
    slot : its best instance; None for unknown structure
    regressor : place of the curve of unknown structure; -1 for others
    path : (n,) two levels between which it goes to and fro; None where it is a smooth curve
    """

    evidence: float
    margin: float
    slot: Slot | None
    regressor: int = -1
    path: FloatArray | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Search:
    """All hypotheses of a run in one whitened space.

    Parameters
    ----------
    problem : the run
    bank : columns of all instances
    relabels : hypotheses without parameters
    curves : unknown structure, by regressor
    doubts : by name, evidence that an unlucky guess of the noise alone can give it
    curve_doubts : the same of each curve
    threshold : evidence beyond this that a name must have
    most : steps at most
    views : the run under other sizes of its noise; none where one floor is enough
    """

    problem: Problem
    bank: Projected
    relabels: Relabels
    curves: tuple[Curve | Features, ...]
    doubts: Mapping[str, float]
    curve_doubts: tuple[float, ...]
    threshold: float
    most: int
    views: tuple[View, ...] = ()

    def state(self, slots: tuple[Slot, ...], evidence: float = 0.0) -> State:
        """The state of a set of slots."""
        return state_of(slots, self.bank.space, self.problem.y, evidence)

    def scores(self, state: State) -> dict[str, Scored]:
        """All names as the next step of a state, without unknown structure."""
        bank = self.bank.bank
        evidence, relabelled = self._evidence(state)
        by_name = bank.by_name(evidence)
        found: dict[str, Scored] = {}
        for place, name in enumerate(bank.names):
            own = np.flatnonzero(bank.name == place)
            best = int(own[np.argmax(evidence[own])])
            if not np.any(self.bank.seen[own]):
                continue
            value = float(by_name[place])
            if value > 0.0:
                value += bank.instances[best].effect.log_odds + self._plausible(best, state)
            slot = self.slot(best)
            if slot.instance.effect.step > 0.0 and value > _WORTH_A_LOOK:
                value += self.whole(slot, state)
            found[name] = Scored(value, value - self.doubts.get(name, 0.0), slot)
        for name, (value, slot) in self.relabels.scores(relabelled).items():
            found[name] = Scored(value, value - self.doubts.get(name, 0.0), slot)
        return found

    def _evidence(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Evidence (m,) of all instances, and (k,) of all relabellings, under all views."""
        if not self.views:
            return self.bank.evidence(state.residual, state.added), self.relabels.evidence(state)

        def both(view: View, there: State) -> FloatArray:
            names = view.bank.evidence(there.residual, there.added)
            return np.concatenate([names, view.relabels.evidence(there)])

        found = self._heard(state, both)
        count = len(self.bank.bank.instances)
        return found[:count], found[count:]

    def _structure(self, state: State) -> FloatArray:
        """The same (k,) of all curves that compete; minus infinity of others, and of weak ones."""

        def of(curves: tuple[Curve | Features, ...], space: Space, there: State) -> FloatArray:
            return np.array([c.beside(there.residual, there.added, space) for c in curves])

        usable = np.array([curve.regressor.competes for curve in self.curves])
        found = np.where(usable, of(self.curves, self.bank.space, state), -np.inf)
        if not self.views:
            return found
        strong = np.argsort(-found)[:_STRONG]
        places: list[int] = strong.tolist()

        def few(view: View, there: State) -> FloatArray:
            return of(tuple(view.curves[place] for place in places), view.bank.space, there)

        heard = self._heard(state, few)
        found = np.full(len(usable), -np.inf)
        found[strong] = np.where(usable[strong], heard, -np.inf)
        return found

    def _heard(self, state: State, asked: Callable[[View, State], FloatArray]) -> FloatArray:
        """What all views say, each heard as far as the state fits it."""
        there = [view.state(state, self.problem.y) for view in self.views]
        each = [asked(view, one) for view, one in zip(self.views, there, strict=True)]
        heard = [view.heard(one.rss) for view, one in zip(self.views, there, strict=True)]
        return together(each, heard)

    def _plausible(self, instance: int, state: State) -> float:
        """What speaks against a size far beyond what sensors and rigs of this kind show."""
        one = self.bank.bank.instances[instance]
        typical = one.effect.typical.get(self.problem.run.sensor, 0.0)
        told = bool(self.problem.models[0].sensor.response)
        if typical <= 0.0 or not told or self.bank.bank.count[instance] > 1:
            return 0.0
        column = self.bank.columns[:, self.bank.bank.block(instance)][:, 0]
        column = column - state.added @ (state.added.T @ column)
        size = float(column @ state.residual) / max(float(column @ column), 1e-300)
        return _IMPLAUSIBLE if abs(size) > _FAR * typical else 0.0

    def whole(self, slot: Slot, others: State) -> float:
        """What speaks for, or against, a fault whose size is likely a whole number of steps.

        Half of such faults are; any other fault comes so close to a whole number by chance alone.
        """
        fine = self.polished(slot, others)
        rest = self.bank.space.rest(fine.raw)
        rest = rest - others.added @ (others.added.T @ rest)
        u = 1.0 / max(float(np.linalg.norm(rest)), 1e-300)
        steps = float(self._values(fine, others)[0]) / fine.instance.effect.step
        away, near = abs(steps - round(steps)), 2.0 * u / fine.instance.effect.step
        if near > _COARSE:
            return 0.0
        if round(steps) == 0 or away > near:
            return float(np.log(0.5))
        return float(min(np.log(0.5 + 0.25 / near), _MOST_BONUS))

    def slot(self, instance: int) -> Slot:
        """An instance of the bank as a slot."""
        bank = self.bank.bank
        one = bank.instances[instance]
        raw = bank.raw[:, bank.block(instance)]
        return Slot(one.effect.id, one, raw, np.zeros(len(raw)))

    def unknown(self, state: State) -> Scored:
        """Unknown structure as the next step of a state."""
        if not self.curves:
            return Scored(0.0, 0.0, None)
        values = self._structure(state)
        margins = values - np.array(self.curve_doubts)
        best = int(np.argmax(margins))
        value, margin = float(values[best]), float(margins[best])
        return Scored(value - _UNKNOWN_COST, margin - _UNKNOWN_COST, None, best)

    def run(self, forced: tuple[Slot, ...] = ()) -> tuple[State, Scored | None]:
        """Find the best set.

        Parameters
        ----------
        forced : steps that stay

        Returns
        -------
        State, Scored or None
            The set, and unknown structure if it ends with that.
        """
        start = self.gross(self.state(forced))
        best = self._beam(start)
        best = self._refined(best, len(forced))
        score = self.unknown(best)
        return best, score if score.margin > self.threshold else None

    def together(self, slots: tuple[Slot, ...], others: State) -> float:
        """Evidence of several names, one after the other beside `others`."""
        total, given = 0.0, others.slots
        for slot in slots:
            state = self.state(given)
            total += self.own_evidence(slot, state, self.scores(state))
            given = (*given, slot)
        return total

    def guess(self, state: State) -> State:
        """A state with the likeliest name, however weak; unchanged where none has any evidence."""
        best = max(self.scores(state).values(), key=lambda s: s.evidence, default=None)
        if best is None or best.slot is None or best.evidence <= 0.0:
            return state
        slot = self.polished(best.slot, state)
        return self.state((*state.slots, slot), state.evidence + best.evidence)

    def gross(self, state: State) -> State:
        """A state with all that stands out by far."""
        while len(state.slots) < self.most:
            ranked = sorted(self.scores(state).values(), key=lambda s: -s.evidence)
            if len(ranked) < 2 or ranked[0].evidence < _GROSS or ranked[0].slot is None:
                break
            if ranked[0].evidence - ranked[1].evidence < _AHEAD:
                break
            slot = self.polished(ranked[0].slot, state)
            state = self.state((*state.slots, slot), state.evidence + ranked[0].evidence)
        return state

    def _worth(self, state: State) -> float:
        return state.evidence - self.threshold * len(state.slots)

    def _beam(self, start: State) -> State:
        best, best_worth = start, self._worth(start)
        beam = [start]
        for depth in range(self.most - len(start.slots) + 1):
            for state in beam[:3]:
                # Unknown structure ends a set, for as a step of its own it swallows two effects.
                end = self.unknown(state)
                total = self._worth(state) + end.evidence - self.threshold
                if end.margin > self.threshold and total > best_worth:
                    best, best_worth = state, total
            if depth == self.most - len(start.slots):
                break
            beam = self._grown(beam, _FIRST if depth == 0 else _WIDTH)
            if not beam:
                break
            if self._worth(beam[0]) > best_worth:
                best, best_worth = beam[0], self._worth(beam[0])
        return best

    def _grown(self, beam: list[State], width: int) -> list[State]:
        """The best sets with one more step."""
        grown: dict[frozenset[tuple[str, int, tuple[float, ...]]], State] = {}
        for state in beam:
            ranked = sorted(self.scores(state).values(), key=lambda s: -s.evidence)
            for one in ranked[:width]:
                if one.slot is None or one.margin <= self.threshold:
                    continue
                slot = self.polished(one.slot, state)
                new = self.state((*state.slots, slot), state.evidence + one.evidence)
                old = grown.get(new.keys)
                if old is None or old.evidence < new.evidence:
                    grown[new.keys] = new
        return sorted(grown.values(), key=self._worth, reverse=True)[:_WIDTH]

    def polished(self, slot: Slot, others: State) -> Slot:
        """The slot with its shape refined, given what else is in the model."""
        best, gain, fraction = slot, self._gain(slot, others), 1.0
        while fraction > _FINEST:
            trials = [
                self.remade(slot, Instance(effect, slot.instance.channel))
                for effect in best.instance.effect.near(fraction)
            ]
            if not trials:
                break
            gains = [self._gain(trial, others) for trial in trials]
            if max(gains) > gain:
                best, gain = trials[int(np.argmax(gains))], max(gains)
            else:
                fraction /= 2.0
        for _ in range(_CHORDS):
            effect = best.instance.effect.at(self._values(best, others))
            if effect is best.instance.effect:
                break
            best = self.remade(slot, Instance(effect, slot.instance.channel))
        return best

    def _values(self, slot: Slot, others: State) -> FloatArray:
        """Values of a slot's columns given what else is in the model."""
        rest = self.bank.space.rest(slot.raw)
        rest = rest - others.added @ (others.added.T @ rest)
        values = np.linalg.lstsq(rest, others.residual, rcond=None)[0]
        return np.asarray(values, dtype=np.float64)

    def remade(self, slot: Slot, instance: Instance) -> Slot:
        """A slot of another instance of the same effect."""
        raw = self.problem.columns(instance.effect, instance.channel)
        return Slot(slot.name, instance, raw, slot.change)

    def _gain(self, slot: Slot, others: State) -> float:
        """Sum of squares that a slot takes away."""
        if not slot.raw.shape[1]:
            return 0.0
        rest = self.bank.space.rest(slot.raw)
        rest = rest - others.added @ (others.added.T @ rest)
        left = np.linalg.qr(rest)[0]
        return float(np.sum((left.T @ others.residual) ** 2))

    def _refined(self, state: State, forced: int) -> State:
        """Exchange every step for a better name given the others; drop what is not needed."""
        slots = list(state.slots)
        for _ in range(_ROUNDS):
            changed = False
            for place in range(len(slots) - 1, forced - 1, -1):
                others = self.state((*slots[:place], *slots[place + 1 :]))
                ranked = self.scores(others)
                best = max(ranked.values(), key=lambda s: s.evidence)
                own = self.own_evidence(slots[place], others, ranked)
                if max(one.margin for one in ranked.values()) <= self.threshold:
                    del slots[place]
                    changed = True
                elif best.slot is not None and best.evidence > own + 1e-6:
                    new = self.polished(best.slot, others)
                    if new.key != slots[place].key and new.name != slots[place].name:
                        slots[place], changed = new, True
            if not changed:
                break
        return self.state(tuple(slots), state.evidence)

    def own_evidence(self, slot: Slot, others: State, ranked: dict[str, Scored]) -> float:
        """Evidence of the name of a slot given the others."""
        return ranked[slot.name].evidence if slot.name in ranked else self._alone(slot, others)

    def _alone(self, slot: Slot, others: State) -> float:
        dof = self.bank.space.dof - others.added.shape[1]
        gain = self._gain(slot, others)
        count = slot.raw.shape[1]
        return float(block_evidence(gain, count, others.rss, self.bank.space.prior, dof))


def ranking(scores: dict[str, Scored], unknown: Scored) -> list[tuple[str, Scored, float]]:
    """Names with unknown structure, best first, each with its probability."""
    every = [*scores.items(), (UNKNOWN, unknown)]
    every.sort(key=lambda item: -item[1].evidence)
    values = np.array([one.evidence for _, one in every])
    weight: FloatArray = np.exp(values - values.max())
    weight = weight / weight.sum()
    return [(name, one, float(w)) for (name, one), w in zip(every, weight, strict=True)]
