"""Knots of a broken line, common to all temperatures, by dynamic programming.

The source looks for the sharpest angles between neighbouring points, which is a local measure:
it puts all knots at one bend, and scored no better than a quartic. Dynamic programming finds the
best knots of all that the blocks allow.
"""

import numpy as np

from core.arrays import FloatArray, IntArray, frozen_int


def optimal_knots(t: FloatArray, curves: FloatArray, limit: int) -> tuple[IntArray, ...]:
    """Return the best knots for every number of them from 2 to `limit`.

    Parameters
    ----------
    t : (k,) times, ascending
    curves : (m, k) one curve a temperature
    limit : largest number of knots, at least 2 and at most k

    Returns
    -------
    tuple of (p,) places in `t`, p = 2 ... limit; the first and the last point always belong
        The sum over all curves of the squared distances from the chords between neighbouring
        knots is the least possible.
    """
    cost = chord_costs(t, curves)
    k = len(t)
    best = cost[0]
    before: list[IntArray] = []
    found = [frozen_int([0, k - 1])]
    for _ in range(3, limit + 1):
        total = best[:, None] + cost
        came = np.argmin(total, axis=0)
        best = total[came, np.arange(k)]
        before.append(came)
        places = [k - 1]
        for step in reversed(before):
            places.append(int(step[places[-1]]))
        found.append(frozen_int([0, *places[::-1]]))
    return tuple(found)


def chord_costs(t: FloatArray, curves: FloatArray) -> FloatArray:
    """Squared distance (k, k) of all points between i and j from the chord, inf unless i < j."""
    k = len(t)
    # Sums from the first point on; curves begin near zero, so the differences keep their digits.
    y = curves - curves[:, :1]
    x = t - t[0]
    sum_y, sum_yy, sum_xy = (_running(values) for values in (y, y * y, y * x))
    sum_x, sum_xx = _running(x[None, :])[0], _running((x * x)[None, :])[0]
    i, j = np.triu_indices(k, 1)
    n = (j - i).astype(np.float64)
    over_x = sum_x[j] - sum_x[i]
    over_xx = sum_xx[j] - sum_xx[i] - 2.0 * x[i] * over_x + n * x[i] ** 2
    cost = np.full((k, k), np.inf)
    total = np.zeros(len(i))
    for curve, s_y, s_yy, s_xy in zip(y, sum_y, sum_yy, sum_xy, strict=True):
        y_i = curve[i]
        slope = (curve[j] - y_i) / (x[j] - x[i])
        over_y = s_y[j] - s_y[i]
        yy = s_yy[j] - s_yy[i] - 2.0 * y_i * over_y + n * y_i**2
        xy = s_xy[j] - s_xy[i] - x[i] * over_y - y_i * over_x + n * x[i] * y_i
        total += yy - 2.0 * slope * xy + slope**2 * over_xx
    cost[i, j] = np.maximum(total, 0.0)
    return cost


def _running(values: FloatArray) -> FloatArray:
    """Sums (m, k) over the points before each one."""
    sums = np.zeros_like(values)
    np.cumsum(values[:, :-1], axis=1, out=sums[:, 1:])
    return sums
