"""Rows of the head where tied effects would read most differently (Atkinson and Fedorov 1975).

Row by row those are added at which the nearest of the rivals, fitted to all rows so far, is
furthest from the truth; what the errors of head and accumulation leave of it counts.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import permutations

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.discrepancy.components import components_of
from core.discrepancy.engine import Engine
from core.discrepancy.followups import TIMES
from core.discrepancy.problem import Problem
from core.discrepancy.rivals import Tie, fitted
from core.samples.run import Run

_BATCH = 12
_FEWEST = 6
"""Rows for which no unit is bolted on again."""
_SLOW = "drift"

Place = tuple[str, float]


@dataclass(frozen=True, slots=True, eq=False)
class Pool:
    """All rows that could be added.

    Parameters
    ----------
    old : rows that are there
    places : mounting and head angle of each row that could be added
    pairs : per pair of rivals what the one adds (n c,), and what the other may take of it
        (n c, q), both in units of the noise
    channels : of a row
    """

    old: int
    places: tuple[Place, ...]
    pairs: tuple[tuple[FloatArray, FloatArray], ...]
    channels: int

    @classmethod
    def of(
        cls, engine: Engine, run: Run, places: tuple[Place, ...], ties: tuple[Tie, ...]
    ) -> "Pool":
        """The rows of a run that begins with those of the engine and goes on with all places."""
        both = replace(Problem.of(run), models=engine.problem.models)
        parts = components_of(both, engine.settings)
        ratios = zip(parts, engine.floor.sizes.ratio, strict=True)
        fresh = np.tile(np.arange(both.rows) >= engine.problem.rows, both.channels)
        # A drift goes slowly: mixed rows are compared with their neighbours.
        variance = sum(
            np.diag(part.matrix) * ratio**2 / np.where(fresh & (not part.repeats), TIMES, 1)
            for part, ratio in ratios
            if _SLOW not in part.name
        )
        sigma = np.sqrt(variance)[:, None]
        plain = both.design() / sigma
        pairs: list[tuple[FloatArray, FloatArray]] = []
        for tie in ties:
            others = [both.columns(s.instance.effect, s.instance.channel) for s in tie.others]
            taken = np.hstack([plain, *(one / sigma for one in others)])
            steady = [m for m in tie.members if m.slots[-1].instance.effect.instant]
            own = {
                m: both.columns(m.slots[-1].instance.effect, m.slots[-1].instance.channel) / sigma
                for m in steady
            }
            for truth, other in permutations(steady, 2):
                if truth.name == other.name:
                    continue
                shown = own[truth] @ fitted(engine, truth)
                pairs.append((shown, np.hstack([taken, own[other]])))
        return cls(engine.problem.rows, places, tuple(pairs), both.channels)

    def chosen(self, counts: tuple[int, ...]) -> Iterator[tuple[tuple[Place, ...], float]]:
        """So many places, the best for the pair that is told apart least; more begin with fewer.

        With each, the distance of that pair that its rows leave at most, in chi-squares.
        """
        taken = np.arange(self.old + len(self.places)) < self.old
        left = [self._left(taken, *pair) for pair in self.pairs]
        for count in range(_BATCH, max(counts) + 1, _BATCH):
            worst = min(left, key=lambda one: float(np.sum(one[taken])))
            gain = np.where(taken, -1.0, worst)
            taken[np.argsort(-gain, kind="stable")[:_BATCH]] = True
            left = [self._left(taken, *pair) for pair in self.pairs]
            if count in counts:
                distance = min(float(np.sum(one[taken])) for one in left)
                yield self._worth_bolting(taken[self.old :]), distance

    def _worth_bolting(self, taken: BoolArray) -> tuple[Place, ...]:
        """Places that are taken, but for mountings with a few of them."""
        found = [self.places[i] for i in np.flatnonzero(taken)]
        mounts = [mount for mount, _ in found]
        return tuple(place for place in found if mounts.count(place[0]) >= _FEWEST)

    def _left(self, taken: BoolArray, shown: FloatArray, other: FloatArray) -> FloatArray:
        """Squares (n,) of what the other cannot take, fitted to the rows that are taken."""
        rows = np.tile(taken, self.channels)
        size = np.linalg.norm(other, axis=0)
        other = other / np.where(size > 0.0, size, 1.0)
        values = np.linalg.lstsq(other[rows], shown[rows], rcond=1e-9)[0]
        return np.sum((shown - other @ values).reshape(self.channels, -1) ** 2, axis=0)
