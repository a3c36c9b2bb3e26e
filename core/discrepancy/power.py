"""What a plan could have shown: smallest sizes, aliases, what stays invisible."""

import math

import numpy as np

from core.discrepancy.engine import Engine
from core.discrepancy.result import Smallest
from core.model.catalogue.listing import CATALOGUE

_NAMED = 8.0
_ALIAS = 0.998


def smallest_of(engine: Engine) -> tuple[Smallest, ...]:
    """By name, the size at which 8 sigmas of an effect are visible, and what looks the same."""
    projected, bank = engine.search.bank, engine.bank
    problem = engine.problem
    squares = np.sum(projected.columns**2, axis=0)
    sums = np.add.reduceat(squares, bank.first) if len(squares) else squares
    typical: list[tuple[int, int, float]] = []
    for number in range(len(bank.names)):
        own = np.flatnonzero((bank.name == number) & projected.seen)
        if len(own):
            visible = np.sqrt(sums[own] / bank.count[own])
            middle = int(np.argsort(visible)[len(visible) // 2])
            typical.append((number, int(own[middle]), float(visible[middle])))
    columns = projected.columns[:, [int(bank.first[place]) for _, place, _ in typical]]
    explained, _ = projected.explained(columns, np.zeros((len(problem.y), 0)))
    found: list[Smallest] = []
    for (number, place, visible), column, taken in zip(
        typical, columns.T, explained.T, strict=True
    ):
        name, instance = bank.names[number], bank.instances[place]
        same = taken > _ALIAS * float(column @ column)
        twins = [
            other
            for rival, other in enumerate(bank.names)
            if rival != number and np.any(same & (bank.name == rival))
        ]
        sensor = problem.models[max(instance.channel, 0)].sensor
        parameter = instance.effect.parameters(sensor)[0]
        found.append(
            Smallest(
                effect=name,
                name=CATALOGUE[name].name,
                parameter=parameter.name,
                size=_NAMED / visible,
                unit=parameter.unit,
                typical=CATALOGUE[name].typical.get(sensor.kind, math.nan),
                aliases=tuple(twins),
            )
        )
    return tuple(found)


def invisible_of(engine: Engine) -> tuple[str, ...]:
    """Identifiers of the effects that the plan cannot show, whatever their size."""
    projected, bank = engine.search.bank, engine.bank
    seen = {bank.names[int(i)] for i in np.unique(bank.name[projected.seen])}
    seen |= set(engine.search.relabels.all_names)
    return tuple(effect.id for effect in engine.problem.effects if effect.id not in seen)
