"""What record to make next where names are tied: each follow-up judged by a simulated record.

Each rival is played in the next record with the size that it has in the one that was made. Both
records together must leave the other rivals behind; each record has a bias of its own, and of what
a rival explains in one of them nothing may be missing in the other.
"""

import math
from collections.abc import Callable

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.advise import next_of
from core.discrepancy.engine import Engine
from core.discrepancy.record_followups import FollowRecord, follow_records
from core.discrepancy.result import NextMeasurement
from core.discrepancy.rivals import Tie, fitted, ties_of
from core.discrepancy.slots import Slot, State
from core.discrepancy.space import Space, orthonormal

_NEEDED = 14.0
"""Twice the nats by which one name must lead: three to be alone, four for the choice of shape."""


def advise_record(engine: Engine, state: State) -> tuple[NextMeasurement, ...]:
    """Return the records that separate the ambiguity sets best; none where nothing is tied."""
    ties = ties_of(engine, state)
    if not ties:
        return ()
    follows = sorted(follow_records(engine.problem), key=lambda each: each.minutes)
    return next_of(ties, ((each, _chance(engine, each)) for each in follows))


def _chance(engine: Engine, follow: FollowRecord) -> Callable[[Tie], float]:
    rows = follow.measured > 0.0
    sensor = engine.problem.models[0].sensor
    old = engine.problem.rows
    n = old + int(rows.sum())
    own = (np.arange(n)[:, None] >= old) == np.array([False, True])
    space = Space.of(_covariance(engine, follow), own.astype(np.float64), engine.floor.prior)

    def columns(slot: Slot) -> FloatArray:
        effect, channel = slot.instance.effect, slot.instance.channel
        new = effect.columns(follow.stimulus, sensor)[rows]
        return np.vstack([engine.problem.columns(effect, channel), new])

    def chance(tie: Tie) -> float:
        """Probability that the right one of these rivals ends alone."""
        spans: list[FloatArray] = []
        means: list[FloatArray] = []
        for member in tie.members:
            raw = [columns(slot) for slot in member.slots if slot.raw.shape[1]]
            spans.append(orthonormal(space.rest(np.hstack(raw))))
            means.append(space.rest((raw[-1] @ fitted(engine, member))[:, None])[:, 0])
        total, weight = 0.0, 0.0
        for member, mean in zip(tie.members, means, strict=True):
            others = [
                span
                for span, other in zip(spans, tie.members, strict=True)
                if other.name != member.name
            ]
            left = [mean - span @ (span.T @ mean) for span in others]
            decided = min((_decided(float(one @ one)) for one in left), default=1.0)
            total += member.weight * decided
            weight += member.weight
        return total / weight

    return chance


def _decided(distance: float) -> float:
    """Probability that so many chi-squares of distance put the right name ahead enough."""
    if distance <= 0.0:
        return 0.0
    root = math.sqrt(distance)
    return 0.5 * (1.0 + math.erf((distance - _NEEDED) / (2.0 * root) / math.sqrt(2.0)))


def _covariance(engine: Engine, follow: FollowRecord) -> FloatArray:
    """Noise of both records; flicker looks the same in as many blocks of another length."""
    old = float(np.median(np.diff(engine.problem.run.t_s)))
    parts = zip(engine.floor.parts, engine.floor.sizes.ratio, strict=True)
    new: FloatArray = np.sum(
        [
            part.matrix * ratio**2 * (old / follow.step_s if part.name == "white" else 1.0)
            for part, ratio in parts
        ],
        axis=0,
    )
    n = len(new)
    both = np.zeros((2 * n, 2 * n))
    both[:n, :n], both[n:, n:] = engine.floor.covariance, new
    return both
