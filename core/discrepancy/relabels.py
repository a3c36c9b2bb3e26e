"""Hypotheses without parameters: rows that mean something else than they say."""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, IntArray
from core.discrepancy.bank import Instance
from core.discrepancy.evidence import log_mean, relabel_evidence
from core.discrepancy.problem import Problem
from core.discrepancy.slots import Slot, State
from core.discrepancy.space import Space
from core.model.effect import Effect, Kind


@dataclass(frozen=True, slots=True, eq=False)
class Relabelling:
    """What a relabelling would make of a run, whatever the noise.

    Parameters
    ----------
    effect : the relabelling
    change : (n,) what it does to the outputs
    design : (n, p) of the plain model where it means another stimulus; None where it does not
    """

    effect: Effect
    change: FloatArray
    design: FloatArray | None

    @classmethod
    def of(cls, problem: Problem, effect: Effect) -> "Relabelling":
        """Apply it."""
        y = problem.y.reshape(problem.channels, problem.rows).T
        stimulus, right = effect.relabel(problem.stimulus, y)
        other = None if stimulus is problem.stimulus else problem.design(stimulus)
        return cls(effect, (right - y).T.ravel(), other)

    def change_in(self, problem: Problem, space: Space) -> FloatArray:
        """What it adds to the outputs (n,).

        Another stimulus acts like outputs that differ by what the model says of the difference.
        """
        if self.design is None:
            return self.change
        values = np.linalg.lstsq(space.white(self.design), space.white(problem.y), rcond=None)[0]
        return self.change - (self.design - problem.design()) @ values


def relabellings_of(problem: Problem) -> tuple[Relabelling, ...]:
    """All relabellings of a run but the exchange of pairs."""
    return tuple(
        Relabelling.of(problem, one)
        for effect in problem.effects
        if effect.kind is Kind.RELABEL
        for one in effect.instances(problem.stimulus, problem.models[0].sensor)
    )


@dataclass(frozen=True, slots=True, eq=False)
class Relabels:
    """All relabellings and exchanges of a run in a whitened space.

    Parameters
    ----------
    problem, space : which
    names : (m,) identifiers of the relabellings
    effects : (m,) the relabellings
    changes : (n, m) what each adds to the outputs
    exchange : the effect whose pairs of rows are tried; None where there is none
    pairs : (k, 2) the pairs
    moved : (n, m) the same whitened, without the plain model
    identity : (n, n) whitened rows without the plain model
    inner : (n, n) products of its columns
    """

    problem: Problem
    space: Space
    names: tuple[str, ...]
    effects: tuple[Effect, ...]
    changes: FloatArray
    exchange: Effect | None
    pairs: IntArray
    moved: FloatArray
    identity: FloatArray
    inner: FloatArray

    @classmethod
    def of(cls, problem: Problem, space: Space, made: tuple[Relabelling, ...]) -> "Relabels":
        """Work out what each relabelling would change."""
        effects = [one.effect for one in made]
        changes = [one.change_in(problem, space) for one in made]
        n = len(problem.y)
        exchange = next((e for e in problem.effects if e.kind is Kind.EXCHANGE), None)
        none = np.zeros((0, 2), dtype=np.int64)
        return cls(
            problem=problem,
            space=space,
            names=tuple(effect.id for effect in effects),
            effects=tuple(effects),
            changes=np.column_stack(changes) if changes else np.zeros((n, 0)),
            exchange=exchange,
            pairs=none if exchange is None else exchange.exchanges(problem.stimulus),
            moved=np.zeros((n, 0)),
            identity=np.zeros((n, n)),
            inner=np.zeros((n, n)),
        ).in_space(space)

    def in_space(self, space: Space) -> "Relabels":
        """The same changes under another noise."""
        identity = space.rest(np.eye(len(self.problem.y)))
        moved = space.rest(self.changes)
        inner = identity.T @ identity
        return replace(self, space=space, moved=moved, identity=identity, inner=inner)

    @property
    def all_names(self) -> tuple[str, ...]:
        """Identifiers, the exchange of rows among them."""
        exchange = () if self.exchange is None else (self.exchange.id,)
        return (*dict.fromkeys(self.names), *exchange)

    def evidence(self, state: State) -> FloatArray:
        """Evidence (m + k,) of each relabelling and of the exchange of each pair."""
        dof = self.space.dof - state.added.shape[1]
        moved = self.moved - state.added @ (state.added.T @ self.moved)
        moved = state.residual[:, None] + moved
        after = np.sum(moved**2, axis=0)
        if self.exchange is not None and len(self.pairs):
            after = np.concatenate([after, self._exchanged(state)])
        return relabel_evidence(after, state.rss, self.space.prior, dof)

    def scores(self, evidence: FloatArray) -> dict[str, tuple[float, Slot]]:
        """Evidence of each name, and its best instance as a slot."""
        found: dict[str, tuple[float, Slot]] = {}
        count = len(self.names)
        for name in dict.fromkeys(self.names):
            own = np.flatnonzero([one == name for one in self.names])
            best = int(own[np.argmax(evidence[own])])
            slot = self._slot(self.effects[best], self.changes[:, best])
            found[name] = (float(log_mean(evidence[own], axis=0)), slot)
        if self.exchange is not None and len(self.pairs):
            pairs = evidence[count:]
            first, second = self.pairs[int(np.argmax(pairs))].tolist()
            effect = self.exchange.exchanged(first, second)
            change = Relabelling.of(self.problem, effect).change_in(self.problem, self.space)
            found[effect.id] = (float(log_mean(pairs, axis=0)), self._slot(effect, change))
        return found

    def _slot(self, effect: Effect, change: FloatArray) -> Slot:
        return Slot(effect.id, Instance(effect, -1), np.zeros((len(change), 0)), change)

    def _exchanged(self, state: State) -> FloatArray:
        """Sum of squares after the exchange of each pair of rows."""
        n, c = self.problem.rows, self.problem.channels
        shadow = state.added.T @ self.identity
        pull = self.identity.T @ state.residual
        inner = self.inner - shadow.T @ shadow
        change = sum((slot.change for slot in state.slots), np.zeros(n * c))
        y = self.problem.y + change
        i, j = self.pairs.T
        after = np.full(len(i), state.rss)
        for one in range(c):
            a, b = i + one * n, j + one * n
            step = y[b] - y[a]
            after += 2.0 * step * (pull[a] - pull[b])
            for other in range(c):
                p, q = i + other * n, j + other * n
                there = y[q] - y[p]
                after += step * there * (inner[a, p] - inner[a, q] - inner[b, p] + inner[b, q])
        return np.maximum(after, 0.0)
