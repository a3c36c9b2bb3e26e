"""Uncertainties of what a record shows, with what is not known of its noise and of the shapes.

The slow noise of a record is known from the record itself only where no effect could hide, and
several shapes of one name may explain it as well, each with a size of its own. Both are in the
uncertainty: the estimate stays, its spread is that under the noise as it could be as well, and
over all shapes by their weight (Hoeting et al. 1999).
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.engine import Engine
from core.discrepancy.evidence import block_evidence
from core.discrepancy.record_refined import without
from core.discrepancy.record_shapes import Shapes
from core.discrepancy.result import Step
from core.discrepancy.slots import Slot, State


def widened(shapes: Shapes, engine: Engine, state: State, steps: Sequence[Step]) -> list[Step]:
    """Steps of the slots of a state with all of their uncertainty."""
    factors = noise_factors(engine, state)
    found: list[Step] = []
    for place, (step, slot) in enumerate(zip(steps, state.slots, strict=True)):
        count = slot.raw.shape[1]
        least = 0.0
        if count == 1 and slot.instance.effect.near():
            least = spread_of(shapes, slot, shapes.state(without(state.slots, place)))
        own = [
            replace(each, u=factor * max(each.u, least))
            for each, factor in zip(step.parameters[:count], factors[place].tolist(), strict=True)
        ]
        found.append(replace(step, parameters=(*own, *step.parameters[count:])))
    return found


def noise_factors(engine: Engine, state: State) -> list[FloatArray]:
    """By how much each parameter of each slot is less certain than its floor says."""
    problem, space, floor = engine.problem, engine.search.bank.space, engine.floor
    white = space.white(np.hstack([problem.design(), *(slot.raw for slot in state.slots)]))
    unit = white / np.linalg.norm(white, axis=0)
    inverse: FloatArray = np.asarray(np.linalg.pinv(unit, rcond=1e-10), dtype=np.float64)
    # The size of a part is known but for a factor; its mean square is larger than that of the best.
    mean = floor.sizes.ratio**2 * np.exp(0.5 * np.diag(floor.sizes.spread))
    could: FloatArray = np.sum(
        [part.matrix * size for part, size in zip(floor.parts, mean, strict=True)], axis=0
    )
    back = space.white(space.white(could).T)
    factor = np.sqrt(np.sum((inverse @ back) * inverse, axis=1) / np.sum(inverse**2, axis=1))
    edges = np.cumsum([problem.design().shape[1], *(slot.raw.shape[1] for slot in state.slots)])
    return [np.maximum(part, 1.0) for part in np.split(factor, edges)[1:-1]]


def spread_of(shapes: Shapes, slot: Slot, others: State) -> float:
    """Standard uncertainty of a slot's size over all shapes of its name, each with its weight."""
    search = shapes.search
    bank, space = search.bank.bank, search.bank.space
    dof = space.dof - others.added.shape[1]
    every = [slot]
    if slot.name in bank.names:
        own = np.flatnonzero(bank.name == bank.names.index(slot.name))
        every += [shapes.made(bank.instances[int(one)].effect) for one in own]
    values, variances, evidence = list[float](), list[float](), list[float]()
    for one in every:
        rest = shapes.rest(one)[:, 0]
        rest = rest - others.added @ (others.added.T @ rest)
        size = float(rest @ rest)
        if size > 0.0:
            values.append(float(rest @ others.residual) / size)
            variances.append(1.0 / size)
            gain = values[-1] ** 2 * size
            evidence.append(float(block_evidence(gain, 1, others.rss, space.prior, dof)))
    weight = np.exp(np.array(evidence) - max(evidence))
    square = np.array(variances) + (np.array(values) - values[0]) ** 2
    return float(np.sqrt(weight @ square / weight.sum()))
