"""What to measure next: follow-ups that can be done, ranked by their chance to decide.

Every rival is predicted with its fitted size; a follow-up is good where, on old and new rows
together, no other rival can imitate it (Box and Hill 1967; Hunter and Reiner 1965).
"""

import math
from collections.abc import Callable, Iterable, Iterator

from core.discrepancy.engine import Engine
from core.discrepancy.followups import (
    TIMES,
    FollowUp,
    everywhere,
    followups_of,
    most_rows,
    where_they_differ,
)
from core.discrepancy.outcomes import Outlook
from core.discrepancy.record_followups import FollowRecord
from core.discrepancy.result import NextMeasurement
from core.discrepancy.rivals import Tie, ties_of
from core.discrepancy.slots import State
from core.discrepancy.tailored import Pool

_SHOWN = 3
_COUNTS = (24, 48, 84, 120)
"""Places of the series that are chosen for the rivals."""
_SHORT_MIN = 50.0
"""Minutes up to which a usual series is looked at before those that are chosen for the rivals."""
_HOPELESS = 8.0
"""Chi-squares of distance after the shortest of those, below which no usual one is looked at."""
_SURE = 0.97
"""Chance from which on nothing longer is looked at."""
_LEAST, _AS_GOOD = 0.05, 0.005
"""Chance that is not worth showing, and difference of chances that is not worth more minutes."""


def advise(
    engine: Engine, state: State, doubtful: frozenset[int] = frozenset()
) -> tuple[NextMeasurement, ...]:
    """Return the follow-ups that separate the ambiguity sets best; none where nothing is tied.

    Parameters
    ----------
    doubtful : places of steps that may be structure which no effect explains; that behind the
        last is such a step itself
    """
    ties = ties_of(engine, state, doubtful)
    if not ties:
        return ()
    follows = _by_length(engine, ties)
    return next_of(ties, ((each, Outlook.of(engine, each.run).chance) for each in follows))


def next_of(
    ties: tuple[Tie, ...],
    follows: Iterable[tuple[FollowUp | FollowRecord, Callable[[Tie], float]]],
) -> tuple[NextMeasurement, ...]:
    """The few follow-ups that are worth showing: the shortest of the best first.

    Parameters
    ----------
    ties : what they are to decide
    follows : the shorter first, each with what gives the chance that it decides a tie; nothing is
        looked at behind one that is sure to decide
    """
    names = sorted({member.name for tie in ties for member in tie.members})
    left: list[NextMeasurement] = []
    for count, (follow, chance_of) in enumerate(follows, 1):
        chance = math.prod(map(chance_of, ties))
        if chance > _LEAST:
            left.append(
                NextMeasurement(
                    title=follow.title,
                    why=f"{follow.why}; tells apart {', '.join(names)}",
                    plan=follow.plan,
                    probability=chance,
                    minutes=follow.minutes,
                )
            )
        if chance > _SURE and count >= _SHOWN:
            break
    best: list[NextMeasurement] = []
    while left and len(best) < _SHOWN:
        enough = max(each.probability for each in left) - _AS_GOOD
        one = min((e for e in left if e.probability >= enough), key=lambda each: each.minutes)
        best.append(one)
        left.remove(one)
    return tuple(best)


def _by_length(engine: Engine, ties: tuple[Tie, ...]) -> Iterator[FollowUp]:
    """Usual series, those chosen for the rivals among them, the shorter first."""
    run = engine.problem.run
    usual = followups_of(run)
    chosen = _chosen(engine, ties)
    first = next(chosen, None)
    if first is None or first[1] > _HOPELESS:
        short = [each for each in usual if each.minutes <= _SHORT_MIN]
        yield from sorted(short, key=lambda each: each.minutes)
    long = [each for each in usual if each.minutes > _SHORT_MIN]
    if first is not None:
        long += [follow for follow, _ in (first, *chosen)]
    yield from sorted(long, key=lambda each: each.minutes)


def _chosen(engine: Engine, ties: tuple[Tie, ...]) -> Iterator[tuple[FollowUp, float]]:
    """Series that are chosen for the rivals, with the distance at which they leave them."""
    run = engine.problem.run
    if run.test != "dividing_head":
        return
    places, longer = everywhere(run)
    pool = Pool.of(engine, longer, places, ties)
    if pool.pairs:
        counts = tuple(count for count in _COUNTS if TIMES * count <= most_rows(run))
        for some, distance in pool.chosen(counts):
            yield where_they_differ(run, some), distance
