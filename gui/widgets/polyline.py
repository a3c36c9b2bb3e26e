"""Arrays of points as polygons that QPainter draws, without a Python object for each point."""

import math
from typing import Any

import numpy as np
from PySide6.QtGui import QPolygonF
from shiboken6 import VoidPtr

from core.arrays import FloatArray
from gui.widgets.pyramid import Columns

# The stubs know neither the length nor the buffer that it offers.
_memory_of: Any = VoidPtr
_FAR = 30_000.0
"""Pixels beyond which the raster engine of Qt loses its footing."""


def polygon(x: FloatArray, y: FloatArray) -> QPolygonF:
    """Return the points (x, y), both (n,), n >= 1."""
    made = QPolygonF()
    made.resize(x.size)
    memory = np.frombuffer(_memory_of(made.data(), x.size * 16, True), dtype=np.float64)
    memory[0::2] = x
    memory[1::2] = np.clip(y, -_FAR, _FAR)
    return made


def polygons(
    columns: Columns, left: float, per_sample: float, top: float, per_unit: float
) -> list[QPolygonF]:
    """Return the lines of a stretch, broken where samples are missing.

    Parameters
    ----------
    left, per_sample : pixels of sample number 0, and from one number to the next
    top, per_unit : pixels of value 0, and from one value to the next
    """
    if columns.step == 1:
        x = left + per_sample * (columns.first + np.arange(columns.low.size, dtype=np.float64))
        y = top + per_unit * columns.low
    else:
        x, low, high = _pixel_columns(columns, left, per_sample)
        x = np.repeat(x, 2)
        # Down one column and up the next, so that the joins between them are short.
        y = np.empty(x.size)
        y[0::4], y[1::4] = low[0::2], high[0::2]
        y[2::4], y[3::4] = high[1::2], low[1::2]
        y = top + per_unit * y
    missing = np.isnan(y)
    if not missing.any():
        return [polygon(x, y)] if x.size else []
    edges = np.flatnonzero(np.diff(missing, prepend=True, append=True))
    return [
        polygon(x[begin:end], y[begin:end])
        for begin, end in zip(edges[0::2], edges[1::2], strict=True)
    ]


def _pixel_columns(
    columns: Columns, left: float, per_sample: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """One column a pixel: a bin that covers two is drawn twice, or the curve would be a comb."""
    start, width = left + per_sample * columns.first, per_sample * columns.step
    if width <= 1.0:
        x = start + width * (0.5 + np.arange(columns.low.size, dtype=np.float64))
        return x, columns.low, columns.high
    first, last = math.floor(start), math.ceil(start + width * columns.low.size)
    x = np.arange(first, last, dtype=np.float64) + 0.5
    bins = np.clip(((x - start) / width).astype(np.int64), 0, columns.low.size - 1)
    return x, columns.low[bins], columns.high[bins]
