"""Sum of squares by the BLAS, in pieces that it does not hand to threads.

OpenBLAS starts threads for vectors above 10 000. For a block that sits in the cache of one core
that gains nothing, and on a busy machine it waits a hundred times longer than it computes.
"""

import numpy as np

from core.arrays import FloatArray

ROW = 8192


def sum_of_squares(values: FloatArray) -> float:
    """Return the sum of squares of a contiguous (n,) array."""
    whole = len(values) & -ROW
    if not whole:
        return float(values.dot(values))
    rows = values[:whole].reshape(-1, ROW)
    total = sum(np.vecdot(rows, rows).tolist())
    if whole < len(values):
        rest = values[whole:]
        total += float(rest.dot(rest))
    return total
