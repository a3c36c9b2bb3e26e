"""What frames look like in a stream, and frames that were found."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from core.arrays import IntArray

ByteArray = NDArray[np.uint8]
BoolArray = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """What the frames of a stream look like.

    Parameters
    ----------
    starts : for each of the first bytes the values that may stand there; None for any
    header : most bytes that tell the length, at least those of `starts`
    longest : bytes of the longest frame
    lengths : length of every frame, or (n, header) uint8 -> (n,) whole lengths, 0 for impossible
    intact : (n, length + follow) uint8 -> (n,) which of them are frames
    tail : bytes that may stand behind a frame without being garbage
    follow : bytes behind a frame that `intact` must see, for frames without a checksum
    least : fewest bytes that tell the length, 0 for `header`; where only these have come, or the
        frame ends within the header, `lengths` sees zeros for the others, and where it needed
        them it must tell a length that reaches beyond what it needed
    """

    starts: tuple[tuple[int, ...] | None, ...]
    header: int
    longest: int
    lengths: int | Callable[[ByteArray], IntArray]
    intact: Callable[[ByteArray], BoolArray]
    tail: bytes = b""
    follow: int = 0
    least: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Batch:
    """Frames that were found together.

    Parameters
    ----------
    buffer : the bytes; read-only
    starts, lengths : (n,) where the frames stand in it
    gaps : (n,) garbage bytes between each frame and the one before, of whatever batch
    garbage : bytes of this batch that belong to no frame
    sample : the first few of them
    bad : places where everything but the checksum fits
    """

    buffer: ByteArray
    starts: IntArray
    lengths: IntArray
    gaps: IntArray
    garbage: int
    sample: bytes
    bad: int

    def rows(self, select: IntArray | slice, width: int) -> ByteArray:
        """Return the first `width` bytes of some frames as a matrix; (k, width) uint8."""
        return gather(self.buffer, self.starts[select], width)


def gather(buffer: ByteArray, starts: IntArray, width: int) -> ByteArray:
    """Return `width` bytes from each place; a view where the places are evenly spaced."""
    count = len(starts)
    if not count:
        return np.empty((0, width), dtype=np.uint8)
    pitch = int(starts[1] - starts[0]) if count > 1 else width
    if count < 3 or bool(np.all(starts[1:] - starts[:-1] == pitch)):
        return np.ndarray((count, width), np.uint8, buffer, int(starts[0]), (pitch, 1))
    windows = np.ndarray((len(buffer) - width + 1, width), np.uint8, buffer, 0, (1, 1))
    return windows[starts]


@cache
def _table(allowed: tuple[int, ...]) -> BoolArray:
    table = np.zeros(256, dtype=np.bool_)
    table[list(allowed)] = True
    return table


def among(values: ByteArray, allowed: tuple[int, ...]) -> BoolArray:
    """Return which bytes are allowed."""
    return values == allowed[0] if len(allowed) == 1 else _table(allowed)[values]
