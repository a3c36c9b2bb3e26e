"""Which rows were measured at one temperature, and how it was reached."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray, frozen_int
from core.errors import FitError

_ONE_PLATEAU_C = 3.0
"""Rows nearer than this to the mean of those before them belong to the same plateau."""


@dataclass(frozen=True, slots=True, eq=False)
class Plateau:
    """Rows that were measured at one temperature, one after another.

    Parameters
    ----------
    rows : places in the run
    temperature_c : their mean temperature
    came : +1 reached by heating, -1 by cooling, 0 the first
    level : which of the temperatures visited, ascending from 0; visited again it is the same
    """

    rows: IntArray
    temperature_c: float
    came: int
    level: int


def plateaus_of(temperature_c: FloatArray, order: IntArray) -> tuple[Plateau, ...]:
    """Cut a run into plateaus, in the order of measuring.

    Parameters
    ----------
    temperature_c : (n,) temperature of each row
    order : (n,) place of each row in the order of measuring

    Raises
    ------
    FitError
        A temperature is missing.
    """
    missing = np.flatnonzero(~np.isfinite(temperature_c))
    if missing.size:
        raise FitError(
            f"row {missing[0] + 1}: the temperature is missing; a run over temperature needs it in"
            " every row"
        )
    groups: list[list[int]] = []
    for row in np.argsort(order, kind="stable").tolist():
        if groups:
            mean = float(np.mean(temperature_c[groups[-1]]))
            if abs(float(temperature_c[row]) - mean) <= _ONE_PLATEAU_C:
                groups[-1].append(row)
                continue
        groups.append([row])
    means = [float(temperature_c[group].mean()) for group in groups]
    levels = _levels(np.array(means))
    came = [0, *np.sign(np.diff(means)).astype(int).tolist()]
    return tuple(
        Plateau(frozen_int(group), mean, way, int(level))
        for group, mean, way, level in zip(groups, means, came, levels, strict=True)
    )


def _levels(means: FloatArray) -> IntArray:
    """Number of the temperature of each plateau, ascending."""
    by_temperature = np.argsort(means)
    levels = np.zeros(len(means), dtype=np.int64)
    steps = np.diff(means[by_temperature], prepend=means[by_temperature[0]]) > _ONE_PLATEAU_C
    levels[by_temperature] = np.cumsum(steps)
    return levels
