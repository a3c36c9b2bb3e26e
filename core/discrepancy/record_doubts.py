"""What makes a name of a record doubtful: a pickup that is no sine, a telegraph that moves..."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.engine import Engine
from core.discrepancy.evidence import block_evidence
from core.discrepancy.result import Fitted, Step
from core.discrepancy.slots import Slot, State
from core.discrepancy.space import orthonormal
from core.model.catalogue.record_slow import SlowPickup

_PICKUP, _TELEGRAPH, _JUMP = "pickup", "telegraph", "bias_jump"
_WITHIN = 2.5
_HARMONICS = (2, 3, 4)
_ENOUGH = 3.0
_FEWEST, _RATIOS = 4, 4


def doubtful_names(engine: Engine, state: State) -> frozenset[str]:
    """Names of a set for which something unknown could stand as well."""
    doubtful = {
        _PICKUP: has_harmonics(engine, state),
        _TELEGRAPH: moves_between(engine, state) or seldom_or_regular(state),
    }
    return frozenset((*of_no_channel(state), *(name for name, so in doubtful.items() if so)))


def has_harmonics(engine: Engine, state: State) -> bool:
    """Whether the slowest line that was named repeats itself in a form other than a sine.

    A sawtooth or a cycle of a thermostat is as regular as a line; its harmonics tell.
    """
    lines = [slot for slot in state.slots if slot.name == _PICKUP]
    if not lines:
        return False
    first = min(lines, key=_cycles)
    others = tuple(slot for slot in state.slots if slot.name != _PICKUP)
    columns = np.hstack(
        [engine.problem.columns(SlowPickup(k * _cycles(first)), 0) for k in _HARMONICS]
    )
    return _shows(engine, engine.search.state((*others, first)), columns)


def moves_between(engine: Engine, state: State) -> bool:
    """Whether the bias moves between the jumps of a telegraph, where it ought to stand still.

    Whatever goes up and down is followed by two levels; between their changes a wave is an arch,
    a sawtooth a slope.
    """
    others = tuple(slot for slot in state.slots if slot.name != _PICKUP)
    path = next((slot.raw[:, 0] for slot in others if slot.name == _TELEGRAPH), None)
    if path is None:
        return False
    high = path > 0.5 * (path.min() + path.max())
    side = np.where(high, 1.0, -1.0)
    stay = np.cumsum(np.diff(high, prepend=high[:1]) != 0)
    within = np.empty(len(path))
    for one in range(int(stay[-1]) + 1):
        rows = np.flatnonzero(stay == one)
        within[rows] = (np.arange(len(rows)) + 0.5) / len(rows)
    arch, slope = np.sin(np.pi * within), within - 0.5
    columns = np.column_stack([side * arch, slope, side * slope])
    return _shows(engine, engine.search.state(others), columns)


def seldom_or_regular(state: State) -> bool:
    """Whether the changes of a telegraph are too few, or come too regularly, for chance.

    Two levels are told by being come back to; one visit of the other is anything that passes. And
    chance leaves long stays beside short ones: the logarithm of the ratio of neighbours is 2 ln 2
    in the mean, and much less where something turns.
    """
    path = next((slot for slot in state.slots if slot.name == _TELEGRAPH), None)
    if path is None:
        return False
    changes = np.array([row for _, row in path.instance.effect.shape])
    if len(changes) < _FEWEST:
        return True
    ratios = np.abs(np.diff(np.log(np.diff(changes))))
    return len(ratios) >= _RATIOS and float(np.mean(ratios)) < np.log(2.0)


def of_no_channel(state: State) -> tuple[str, ...]:
    """Names that follow no channel where there are several of them, and a drift beside jumps.

    Jumps, lines and paths together can draw any curve over time that the catalogue does not know.
    """
    names = [slot.name for slot in state.slots]
    loose = [name for name in names if name in (_JUMP, _TELEGRAPH, _PICKUP)]
    if len(loose) < 2:
        return ()
    return (*dict.fromkeys(loose), *(["bias_drift"] if loose.count(_JUMP) > 1 else []))


def there_and_back(steps: Sequence[Step]) -> tuple[Step, ...]:
    """The steps, jumps of one size there and back tied with a telegraph, which is the same."""
    jumps = [step for step in steps if step.effect == _JUMP]
    if not any(_cancel(a.parameters[0], b.parameters[0]) for a, b in combinations(jumps, 2)):
        return tuple(steps)
    return tuple(
        replace(step, indistinguishable_from=(*step.indistinguishable_from, _TELEGRAPH))
        if step.effect == _JUMP and _TELEGRAPH not in step.indistinguishable_from
        else step
        for step in steps
    )


def _cancel(one: Fitted, other: Fitted) -> bool:
    return abs(one.value + other.value) < _WITHIN * float(np.hypot(one.u, other.u))


def _shows(engine: Engine, state: State, columns: FloatArray) -> bool:
    """Whether columns (n, q) beside a state explain more than chance does."""
    space = engine.search.bank.space
    rest = space.rest(columns)
    basis = orthonormal(rest - state.added @ (state.added.T @ rest))
    explained = float(np.sum((basis.T @ state.residual) ** 2))
    dof = space.dof - state.added.shape[1]
    evidence = block_evidence(explained, basis.shape[1], state.rss, space.prior, dof)
    return float(evidence) > _ENOUGH


def _cycles(slot: Slot) -> float:
    return slot.instance.effect.shape[0][1]
