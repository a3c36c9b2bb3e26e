"""The parameters of source 002 at each temperature of a cycle: k, T, mounting."""

from dataclasses import dataclass, replace

import numpy as np

from core.errors import FitError
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.six_position import SixPosition, calibrate_six
from core.procedures.thermal.plateaus import Plateau, plateaus_of
from core.samples.run import Conditions, Run


@dataclass(frozen=True, slots=True, eq=False)
class SplitPoint:
    """One plateau by itself; `temperature_c` and `came` as in `Plateau`."""

    temperature_c: float
    came: int
    six: SixPosition


def splits_of(
    run: Run, conditions: Conditions, base: BaseOrientation = LEVEL
) -> tuple[SplitPoint, ...]:
    """Calibrate every plateau whose positions allow it, by twelve and by nine parameters.

    Parameters
    ----------
    run : rows of a triad on the dividing head; without temperatures all rows are one plateau
    conditions : g with its uncertainty, u of a head setting
    base : how the head's base plate stands

    Returns
    -------
    tuple
        Empty where no plateau holds a triad in enough positions.
    """
    found: list[SplitPoint] = []
    for plateau in _plateaus(run):
        try:
            six = calibrate_six(run.rows(plateau.rows), conditions, base)
        except FitError:
            continue
        found.append(SplitPoint(plateau.temperature_c, plateau.came, six))
    return tuple(found)


def _plateaus(run: Run) -> tuple[Plateau, ...]:
    if np.all(np.isnan(run.temperature_c)):
        whole = plateaus_of(np.zeros(len(run)), run.order)
        return tuple(replace(one, temperature_c=float("nan")) for one in whole)
    return plateaus_of(run.temperature_c, run.order)
