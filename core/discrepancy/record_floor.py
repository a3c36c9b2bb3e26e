"""The noise floor of a long record: white, flicker and random walk of the bias, by likelihood.

An hour tells the white noise well, and flicker only where no effect can hide: what is slower than
that is known from the class of the sensor, and stays uncertain. The uncertainty of the sizes is in
the threshold, for the simulated records without any effect are drawn with sizes as they could be.
"""

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.components import Component, times
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.reml import find_sizes, stated_sizes
from core.discrepancy.slots import Slot

_FLICKER, _WALK = 0.16, 0.12
"""Flicker and walk over the record beside the white noise of a block, in sensors as they are."""
_WHITE_SPREAD, _SLOW_SPREAD, _LOUD_SPREAD = 0.2, 0.7, 1.6
_MEMORIES = 4
_DECAYS = (0.05, 0.2, 0.6)
_CERTAIN = 60.0
_MOST = 0.58
"""Flicker and walk together beside the white noise of a block, beyond which no such sensor goes."""


def record_parts(problem: Problem, slow: float = 1.0) -> tuple[Component, ...]:
    """Parts of the noise of block means at their usual sizes.

    Parameters
    ----------
    problem : the slow view of a record
    slow : by how much flicker and walk are larger than usual

    Notes
    -----
    Flicker is a sum of Markov noises whose memories go from some blocks to a part of the record.
    """
    t = times(problem)
    apart = np.abs(t[:, None] - t[None, :])
    span, step = float(np.ptp(t)), float(np.median(np.diff(t)))
    white = problem.se**2
    spread = _SLOW_SPREAD if slow == 1.0 else _LOUD_SPREAD
    size = float(np.median(problem.se)) ** 2
    memories = np.geomspace(4.0 * step, 0.25 * span, _MEMORIES)
    flicker: FloatArray = np.mean([np.exp(-apart / tau) for tau in memories], axis=0)
    walk = np.exp(-apart / (0.6 * span))
    return (
        Component("white", np.diag(white), _WHITE_SPREAD),
        Component("drift", (slow * _FLICKER) ** 2 * size * flicker, spread),
        Component("slow_drift", (slow * _WALK) ** 2 * size * walk, spread),
    )


def usual_floor(problem: Problem) -> Floor:
    """The noise as it usually is beside the white noise that the blocks show."""
    parts = record_parts(problem)
    sizes = stated_sizes(parts)
    return Floor(parts, sizes, sizes.total(parts), _CERTAIN, "residual")


def record_floor(problem: Problem, slots: tuple[Slot, ...] = (), slow: float = 1.0) -> Floor:
    """Find the noise of a record; what may be an effect is left out of it."""
    parts = record_parts(problem, slow)
    own = [slot.raw for slot in slots]
    nuisance = np.hstack([problem.design(), _timely(problem), *own])
    sizes = find_sizes(parts, problem.y, nuisance)
    return Floor(parts, sizes, sizes.total(parts), _CERTAIN, "residual")


def wanders(floor: Floor) -> bool:
    """Whether the slow noise is far larger than in sensors as they are.

    What goes slowly and fits no effect looks so, be it noise or not.
    """
    sizes = {
        part.name: ratio * np.sqrt(np.mean(np.diag(part.matrix)))
        for part, ratio in zip(floor.parts, floor.sizes.ratio, strict=True)
    }
    return bool(np.hypot(sizes["drift"], sizes["slow_drift"]) > _MOST * sizes["white"])


def _timely(problem: Problem) -> FloatArray:
    """(n, q) what goes with time and with the channels: noise must not eat them."""
    t = times(problem)
    x = (t - t[0]) / float(np.ptp(t))
    columns = [x, *(np.exp(-x / decay) for decay in _DECAYS)]
    for name, values in problem.stimulus.columns.items():
        if name not in ("t_s", "mount", "run"):
            columns.append((values - values.mean()) / float(np.ptp(values)))
    return np.column_stack(columns)
