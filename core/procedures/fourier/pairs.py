"""Test turns by 180 degrees: (4), (5), (8), (11) of source 000.

An axis up and the same axis down give a bias and a response each. They are the least squares of
their positions; a full fit (`dividing_head`) uses all rows at once, the pairs show whether they
agree. In the text before (2), "a_x = -g" in position 1 must read +g.

Turning the head until the output is largest, as the source proposes, is not done here: it finds
hypot(k_x, k_y) in the place of k_x and destroys k_y.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import FitError
from core.fit.estimate import Estimate
from core.model.effect import AXES
from core.model.stimulus import stimulus_of
from core.plans.orientation import LEVEL, BaseOrientation
from core.samples.run import Conditions, Run

_ALONG = 1e-6


@dataclass(frozen=True, slots=True)
class TurnPair:
    """One case axis up and down.

    Parameters
    ----------
    axis : which
    bias : half the sum of the mean outputs, (4)
    response : half the difference over g, (5), (8), (11)
    """

    axis: str
    bias: Estimate
    response: Estimate


def turn_pairs(
    run: Run, conditions: Conditions, *, channel: int = 0, base: BaseOrientation = LEVEL
) -> tuple[TurnPair, ...]:
    """Return a pair for every case axis that stood up as well as down.

    Parameters
    ----------
    run : rows on the dividing head, each position any number of times
    conditions : g with its uncertainty
    channel : which output
    base : how the head's base plate stands

    Raises
    ------
    FitError
        g is missing, an output is no number, or no axis stood both ways.

    Notes
    -----
    With n realisations of standard deviation s, u(u0) = s/sqrt(2n) and u(k) = s/(g sqrt(2n)). The
    rows' own standard errors are taken where they have them, else the scatter of realisations.
    """
    g = conditions.g_mps2
    stimulus = stimulus_of(run, g, base=base)
    y, se = run.y[:, channel], run.y_se[:, channel]
    bad = np.flatnonzero(~np.isfinite(y))
    if bad.size:
        raise FitError(f"row {bad[0] + 1}: the output is not a number")
    found: list[tuple[str, IntArray, IntArray]] = []
    for place, axis in enumerate(AXES):
        share = stimulus.a[:, place] / g
        up, down = np.flatnonzero(share > 1.0 - _ALONG), np.flatnonzero(share < _ALONG - 1.0)
        if up.size and down.size:
            found.append((axis, up, down))
    if not found:
        raise FitError("no axis stood up and down; a test turn needs both positions")
    variance, dof = _row_variance(y, se, [rows for pair in found for rows in pair[1:]])
    unit, u_g = run.unit, float(np.nan_to_num(conditions.u_g_mps2))
    pairs: list[TurnPair] = []
    for axis, up, down in found:
        high, low = float(y[up].mean()), float(y[down].mean())
        parts = (float(variance[rows].sum()) / rows.size**2 for rows in (up, down))
        u = float(np.sqrt(sum(parts))) / 2.0
        response = (high - low) / (2.0 * g)
        pairs.append(
            TurnPair(
                axis,
                Estimate((high + low) / 2.0, u, dof, unit),
                Estimate(response, float(np.hypot(u, response * u_g)) / g, dof, f"{unit}/(m/s^2)"),
            )
        )
    return tuple(pairs)


def _row_variance(
    y: FloatArray, se: FloatArray, groups: list[IntArray]
) -> tuple[FloatArray, float]:
    """Variance of each row and its degrees of freedom."""
    used = np.concatenate(groups)
    if np.all(se[used] > 0):
        return se**2, float("inf")
    dof = float(sum(rows.size - 1 for rows in groups))
    if dof == 0:
        return np.full_like(y, np.nan), 0.0
    squares = sum(float(np.sum((y[rows] - y[rows].mean()) ** 2)) for rows in groups)
    return np.full_like(y, squares / dof), dof
