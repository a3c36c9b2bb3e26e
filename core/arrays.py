"""Array types and the one way of making an array that nobody can change."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


def frozen(values: ArrayLike) -> FloatArray:
    """Return a read-only float64 copy of `values`."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array


def frozen_int(values: ArrayLike) -> IntArray:
    """Return a read-only int64 copy of `values`."""
    array = np.array(values, dtype=np.int64)
    array.flags.writeable = False
    return array
