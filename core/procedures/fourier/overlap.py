"""Angles that came again after a full turn: a free check of drift."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.fit.estimate import Estimate
from core.fit.result import FitResult
from core.samples.run import Run

_SURE = 0.99
_TURN = 0.5


@dataclass(frozen=True, slots=True)
class Overlap:
    """Angles that were reached again after a full turn.

    Parameters
    ----------
    pairs : how many
    drift : mean change of the output over the full turn
    """

    pairs: int
    drift: Estimate

    @property
    def significant(self) -> bool:
        """Whether the output drifted for certain."""
        return abs(self.drift.value) > self.drift.expanded(_SURE)


def overlap_of(run: Run, fit: FitResult, y: FloatArray) -> Overlap | None:
    """Compare the output at each angle before and after a full turn.

    Parameters
    ----------
    run : rows of the tumble; a realisation is compared with itself only
    fit : its fit, for the uncertainty of the rows
    y : (n,) the output

    Returns
    -------
    Overlap or None
        None where fewer than two angles came again.
    """
    angle = np.round(run.head_deg % 360.0, 6) % 360.0
    order = np.lexsort((run.head_deg, angle, run.run))
    new = np.diff(angle[order], prepend=np.nan) != 0.0
    new |= np.diff(run.run[order], prepend=-1) != 0
    starts = np.flatnonzero(new)
    first = order[starts]
    last = order[np.append(starts[1:], len(order)) - 1]
    turns = (run.head_deg[last] - run.head_deg[first]) / 360.0
    again = turns > _TURN
    first, last, turns = first[again], last[again], turns[again]
    differences = (y[last] - y[first]) / turns
    variances = (fit.sigma[last] ** 2 + fit.sigma[first] ** 2) / turns**2
    n = len(differences)
    if n < 2:
        return None
    u, dof = float(np.sqrt(variances.sum())) / n, float("inf")
    if fit.sigma_source != "known":
        u, dof = float(np.std(differences, ddof=1)) / float(np.sqrt(n)), n - 1.0
    return Overlap(n, Estimate(float(np.mean(differences)), u, dof, fit.parameters[0].unit))
