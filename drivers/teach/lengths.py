"""Both readings of a byte that may tell the length: of the whole frame, or of what it carries.

Mistaking one for the other is the commonest error in describing a board, so neither is assumed:
each reading says how long frames would be, and on what share of the headers heard the next header
follows just there.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import IntArray
from drivers.shape import ByteArray

_DEEPEST = 8


@dataclass(frozen=True, slots=True)
class LengthReading:
    """One meaning of a length field.

    Parameters
    ----------
    at, type, endian : the field, ``"u8"`` or ``"u16"``
    value : what it says in these frames
    meaning : ``"total"``, or ``"payload"`` for what stands between the field and the checksum
    length : of a whole frame by this reading
    share : headers behind which the next one follows at that length, 0 to 1
    """

    at: int
    type: str
    endian: str
    value: int
    meaning: str
    length: int
    share: float

    @property
    def add(self) -> int:
        """What is added to the field for the whole length."""
        return self.length - self.value


def length_readings(
    data: ByteArray, starts: IntArray, length: int, behind: int
) -> list[LengthReading]:
    """Return both readings of each field in the header that fits one of them.

    Parameters
    ----------
    data : the stream
    starts : (n,) places of the headers
    length : of the frames, as they were found
    behind : bytes of checksum and tail behind the payload
    """
    starts = starts[starts + length <= len(data)]
    if len(starts) < 2:
        return []
    heads = data[starts[:, None] + np.arange(min(_DEEPEST, length))].astype(np.int64)
    steps: IntArray = starts[1:] - starts[:-1]
    found: list[LengthReading] = []
    for at in range(1, heads.shape[1]):
        for type_, endian in (("u8", "little"), ("u16", "little"), ("u16", "big")):
            size = 1 if type_ == "u8" else 2
            if at + size > heads.shape[1]:
                continue
            told = _told(heads, at, size, endian)
            values, counts = np.unique(told, return_counts=True)
            value = int(values[counts.argmax()])
            overhead = at + size + behind
            if counts.max() < 0.9 * len(told) or length not in (value, value + overhead):
                continue
            if size == 2 and not _two_bytes(heads, at, endian):
                continue
            for meaning, whole in (("total", value), ("payload", value + overhead)):
                share = float(np.count_nonzero(steps == whole) / len(steps))
                found.append(LengthReading(at, type_, endian, value, meaning, whole, share))
    return found


def _told(heads: IntArray, at: int, size: int, endian: str) -> IntArray:
    if size == 1:
        return heads[:, at]
    low, high = (at, at + 1) if endian == "little" else (at + 1, at)
    return heads[:, low] | (heads[:, high] << 8)


def _two_bytes(heads: IntArray, at: int, endian: str) -> bool:
    """Return whether the high byte is where a length of two bytes has it: zero or one."""
    high = at + 1 if endian == "little" else at
    return bool(np.all(heads[:, high] <= 1))
