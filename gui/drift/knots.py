"""Knots that are dragged: kept in their order, snapped to the blocks, put back."""

import numpy as np

from core.arrays import FloatArray
from core.procedures.drift.compensate import DriftResult, cost_of, moved, with_knots
from core.procedures.drift.table import DriftTable


class Knots:
    """The table as the operator has drawn it.

    Parameters
    ----------
    result : with the best knots
    """

    def __init__(self, result: DriftResult) -> None:
        self.optimal = result
        self.result = result
        self.table = result.table

    @property
    def changed(self) -> bool:
        """Whether a knot stands elsewhere than the search put it."""
        return self.result is not self.optimal

    @property
    def cost(self) -> float:
        """Root mean square of what the table leaves of the mean curves."""
        return cost_of(self.optimal.curves, self.table)

    @property
    def optimal_cost(self) -> float:
        """The same of the best knots."""
        return cost_of(self.optimal.curves, self.optimal.table)

    def drag(self, place: int, time_s: float, *, snap: bool) -> DriftTable:
        """Move one inner knot as far as its neighbours let it; the table follows at once.

        Parameters
        ----------
        place : 1 ... p - 2
        time_s : where to
        snap : stop at edges of blocks
        """
        times: FloatArray = self.table.times_s.copy()
        t = self.optimal.curves.t
        block = float(t[1] - t[0])
        low, high = float(times[place - 1]) + block, float(times[place + 1]) - block
        if snap:
            start = self.optimal.curves.alignment.stop_s
            time_s = start + round((time_s - start) / block) * block
        if low <= high:
            times[place] = min(max(time_s, low), high)
            self.table = with_knots(self.optimal.curves, self.table.unit, times)
        return self.table

    def drop(self) -> None:
        """The knot is let go of: judge the table on held-out turn-ons."""
        if not np.array_equal(self.table.times_s, self.result.table.times_s):
            self.result = moved(self.optimal, self.table.times_s)

    def reset(self) -> None:
        """Put the best knots back."""
        self.result, self.table = self.optimal, self.optimal.table
