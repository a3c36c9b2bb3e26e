"""How further rows would come out: played with every rival as the truth, judged as they will be.

What the rows that are there say stays: sizes are drawn as these rows leave them uncertain, and
the noise of the new rows goes on from that of the old ones.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.discrepancy.bank import Bank, Projected
from core.discrepancy.components import components_of
from core.discrepancy.curves import Curve, regressors_of
from core.discrepancy.engine import Engine
from core.discrepancy.problem import Problem
from core.discrepancy.rivals import Rival, Tie
from core.discrepancy.space import Space
from core.samples.run import Run

_DRAWS = 32
_SEED = 1965
_AHEAD = 3.0
"""Nats by which the right name must lead to stand alone."""
_UNKNOWN_COST = 0.5
_ALIAS = 0.998
_LEAST_SPREAD = 1.0
_RANK, _JITTER = 1e-9, 1e-12


@dataclass(frozen=True, slots=True, eq=False)
class Outlook:
    """Old and new rows under one noise.

    Parameters
    ----------
    engine : of the rows that are there
    both : old and new rows; of new ones the outputs mean nothing
    old : (n c,) which they are
    covariance : (n c, n c) of the noise
    space : of the plain model
    follows, fresh : noise of the new rows: what of the old noise goes on in them, and a root of
        the covariance of the rest
    """

    engine: Engine
    both: Problem
    old: BoolArray
    covariance: FloatArray
    space: Space
    follows: FloatArray
    fresh: FloatArray

    @classmethod
    def of(cls, engine: Engine, run: Run) -> "Outlook":
        """What a run promises that begins with the rows of the engine."""
        # The response is known from the old rows; so is the scatter of an accumulation.
        both = replace(Problem.of(_with_errors(engine, run)), models=engine.problem.models)
        covariance = engine.floor.sizes.total(components_of(both, engine.settings))
        space = Space.of(covariance, both.design(), engine.floor.prior)
        old = np.tile(np.arange(both.rows) < engine.problem.rows, both.channels)
        across = covariance[np.ix_(old, ~old)]
        solved = np.linalg.solve(covariance[np.ix_(old, old)], across)
        follows: FloatArray = np.asarray(solved.T, dtype=np.float64)
        rest: FloatArray = covariance[np.ix_(~old, ~old)] - follows @ across
        rest += _JITTER * float(np.mean(np.diag(rest))) * np.eye(len(rest))
        fresh: FloatArray = np.asarray(np.linalg.cholesky(rest), dtype=np.float64)
        return cls(engine, both, old, covariance, space, follows, fresh)

    def chance(self, tie: Tie) -> float:
        """Probability that the right one of these rivals ends alone."""
        raw = [self.both.columns(s.instance.effect, s.instance.channel) for s in tie.others]
        space = self.space.with_columns(np.hstack(raw)) if raw else self.space
        bank = self._bank(tie).in_space(space)
        curves = self._curves(space) if tie.unknown else ()
        total = sum(member.weight for member in tie.members)
        return (
            sum(member.weight * self._decided(member, tie, bank, curves) for member in tie.members)
            / total
        )

    def _bank(self, tie: Tie) -> Bank:
        """What may come up."""
        blocks = [self.both.columns(one.effect, one.channel) for one in tie.near]
        count = np.array([block.shape[1] for block in blocks], dtype=np.int64)
        ids = [one.effect.id for one in tie.near]
        names = tuple(dict.fromkeys(ids))
        return Bank(
            names=names,
            instances=tie.near,
            name=np.array([names.index(one) for one in ids], dtype=np.int64),
            first=np.cumsum(count) - count,
            count=count,
            raw=np.hstack(blocks),
        )

    def _curves(self, space: Space) -> tuple[Curve, ...]:
        sigma = np.sqrt(np.diag(self.covariance))
        every = regressors_of(self.both, sigma)
        return tuple(Curve.of(one, space) for one in every if one.competes)

    def _decided(self, truth: Rival, tie: Tie, bank: Projected, curves: tuple[Curve, ...]) -> float:
        names = bank.bank.names
        own = names.index(truth.name)
        outputs, shown = self._played(truth)
        rest = bank.space.rest(np.column_stack([outputs, shown]))
        residuals, shown = rest[:, :-1], rest[:, -1]
        none = np.zeros((len(shown), 0))
        explained, _ = bank.explained(shown, none)
        same = explained > _ALIAS * float(shown @ shown)
        if np.any(same & (bank.bank.name != own)):
            return 0.0
        scores = bank.bank.by_name(bank.evidence(residuals, none))
        first = {one.effect.id: one.effect.log_odds for one in bank.bank.instances}
        scores += np.array([[tie.share[name] + first[name]] for name in names])
        unknown = [curve.evidence(residuals, bank.space) - _UNKNOWN_COST for curve in curves]
        against = np.vstack([np.delete(scores, own, axis=0), *unknown, np.zeros(_DRAWS)])
        lead: FloatArray = scores[own] - np.max(against, axis=0)
        spread = max(float(np.std(lead)), _LEAST_SPREAD)
        z = (float(np.mean(lead)) - _AHEAD) / spread
        return 0.5 * (1.0 + math.erf(z / math.sqrt(2.0)))

    def _played(self, truth: Rival) -> tuple[FloatArray, FloatArray]:
        """Outputs (n c, k) without the plain model, and what the rival's own effect adds."""
        rng = np.random.default_rng(_SEED)
        engine, slots = self.engine, [slot for slot in truth.slots if slot.raw.shape[1]]
        design = np.hstack([engine.problem.design(), *(slot.raw for slot in slots)])
        size = np.linalg.norm(design, axis=0)
        size = np.where(size > 0.0, size, 1.0)
        design = design / size
        y = engine.problem.y + sum((s.change for s in truth.slots), 0.0 * engine.problem.y)
        white = engine.search.bank.space.white(np.column_stack([design, y]))
        left, singular, turn = np.linalg.svd(white[:, :-1], full_matrices=False)
        keep = singular > _RANK * singular[0]
        # Values as the old rows leave them, and the noise that the old rows then had.
        along = (left[:, keep].T @ white[:, -1])[:, None] + rng.standard_normal(
            (int(keep.sum()), _DRAWS)
        )
        along[:, 0] = left[:, keep].T @ white[:, -1]
        values = turn[keep].T @ (along / singular[keep][:, None])
        noise = np.zeros((len(self.old), _DRAWS))
        noise[self.old] = y[:, None] - design @ values
        fresh = rng.standard_normal((len(self.fresh), _DRAWS))
        noise[~self.old] = self.follows @ noise[self.old] + self.fresh @ fresh
        values = values / size[:, None]
        added = [self.both.columns(s.instance.effect, s.instance.channel) for s in slots]
        count = sum(one.shape[1] for one in added)
        own = added[-1].shape[1]
        shown = added[-1] @ values[len(values) - own :].mean(axis=1)
        return np.hstack(added) @ values[len(values) - count :] + noise, shown


def _with_errors(engine: Engine, run: Run) -> Run:
    """The run with the scatter that an accumulation has under the floor of the engine."""
    white = next(part for part in engine.floor.parts if part.name == "white")
    size = np.sqrt(np.diag(white.matrix)).reshape(engine.problem.channels, -1)
    return replace(run, y_se=np.tile(np.median(size, axis=1), (len(run), 1)))
