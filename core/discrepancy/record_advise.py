"""What record to make next where names are tied: each follow-up judged by a simulated record.

Each rival is played in the next record with the size that it has in the one that was made. Both
records together must leave the other rivals behind; each record has a bias of its own, and of what
a rival explains in one of them nothing may be missing in the other.
"""

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.advise import Rival, chance_of, tied_sets
from core.discrepancy.engine import Engine
from core.discrepancy.record_followups import FollowRecord, follow_records
from core.discrepancy.result import NextMeasurement
from core.discrepancy.slots import State
from core.discrepancy.space import Space
from core.model.effect import Effect

_SHOWN = 3
_LEAST = 0.1


def advise_record(engine: Engine, state: State) -> tuple[NextMeasurement, ...]:
    """Return the records that separate the ambiguity sets best; none where nothing is tied."""
    sets = tied_sets(engine, state)
    if not sets:
        return ()
    found = [_judged(engine, sets, follow) for follow in follow_records(engine.problem)]
    found = [each for each in found if each.probability > _LEAST]
    found.sort(key=lambda each: (-round(each.probability, 2), each.minutes))
    return tuple(found[:_SHOWN])


def _judged(engine: Engine, sets: list[list[Rival]], follow: FollowRecord) -> NextMeasurement:
    rows = follow.measured > 0.0
    sensor = engine.problem.models[0].sensor

    def columns(effect: Effect, channel: int) -> FloatArray:
        new = effect.columns(follow.stimulus, sensor)[rows]
        return np.vstack([engine.problem.columns(effect, channel), new])

    old = engine.problem.rows
    n = old + int(rows.sum())
    own = (np.arange(n)[:, None] >= old) == np.array([False, True])
    space = Space.of(_covariance(engine, follow), own.astype(np.float64), engine.floor.prior)
    chance = 1.0
    for members in sets:
        chance *= chance_of(engine, columns, space, members)
    names = sorted({name for members in sets for one in members for name in one.names})
    return NextMeasurement(
        title=follow.title,
        why=f"{follow.why}; tells apart {', '.join(names)}",
        plan=follow.plan,
        probability=chance,
        minutes=follow.minutes,
    )


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
