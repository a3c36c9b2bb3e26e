"""Columns of decimal numbers, read millions a second.

A number as ``%1.9f`` writes it, with up to six characters before the point, is read from two
machine words; the digits become one integer below 2^53 that is divided by 1e9, which is the
nearest double, as `float` gives it. Whatever looks different goes through `float`.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from core.arrays import BoolArray, FloatArray, IntArray
from core.errors import FormatError

_WORD = 8
_FRACTION = 9
_LONGEST = 16
_STRETCH = 1 << 18
_POINT, _MINUS, _ZERO = 0x2E, 0x2D, 0x30
_ZEROS = np.uint64(0x3030303030303030)
_CARRY = np.uint64(0x7676767676767676)
_HIGH_BITS = np.uint64(0x8080808080808080)
_PAIRS = np.uint64(0x000000FF000000FF)
_FOURS, _ONES = np.uint64(0x000F424000000064), np.uint64(0x0000271000000001)
_LOW_SIX = np.uint64(0x0000FFFFFFFFFFFF)
_ALL = np.uint64(0xFFFFFFFFFFFFFFFF)

Words = NDArray[np.uint64]


def read_decimals(content: bytes, path: Path | str, line: int) -> tuple[FloatArray, IntArray]:
    """Read all numbers of a text that are separated by blanks, tabs and line ends.

    Parameters
    ----------
    content : the text
    path, line : its file and the number of its first line, for messages

    Returns
    -------
    values : (m,) the numbers in their order
    per_line : (lines,) how many of them stand on each line

    Raises
    ------
    FormatError
        Something is no number; with its line and column.
    """
    values: list[FloatArray] = []
    per_line: list[IntArray] = []
    begin = 0
    while begin < len(content):
        end = content.find(b"\n", begin + _STRETCH) + 1 or len(content)
        some, counts = _stretch(content[begin:end], path, line)
        values.append(some)
        per_line.append(counts)
        line += len(counts)
        begin = end
    if not values:
        return np.empty(0), np.empty(0, dtype=np.int64)
    return np.concatenate(values), np.concatenate(per_line)


def _stretch(content: bytes, path: Path | str, line: int) -> tuple[FloatArray, IntArray]:
    """The same for a stretch of whole lines that fits the processor's cache."""
    whole = content if content.endswith(b"\n") else content + b"\n"
    text = b" " * _LONGEST + whole
    letters = np.frombuffer(text, dtype=np.uint8)
    blank: BoolArray = letters <= 32
    edges = np.flatnonzero(blank[1:] != blank[:-1]) + 1
    starts, ends = edges[0::2], edges[1::2]
    values, regular = _regular(text, letters, starts, ends)
    lines = np.flatnonzero(letters == 10)
    for place in np.flatnonzero(~regular).tolist():
        token = text[int(starts[place]) : int(ends[place])]
        try:
            values[place] = float(token)
        except ValueError:
            row = int(np.count_nonzero(lines < starts[place]))
            begin = int(lines[row - 1]) + 1 if row else _LONGEST
            shown = token.decode("utf-8", "replace")[:40]
            raise FormatError(
                path,
                f"{shown!r} is no number",
                line=line + row,
                column=int(starts[place]) - begin + 1,
            ) from None
    return values, np.diff(np.searchsorted(starts, lines), prepend=0)


def _regular(
    text: bytes, letters: NDArray[np.uint8], starts: IntArray, ends: IntArray
) -> tuple[FloatArray, BoolArray]:
    """Values of the numbers of the usual form, and which those are."""
    words: Words = np.ndarray(
        (len(text) - _WORD + 1,), dtype=np.dtype("<u8"), buffer=text, strides=(1,)
    )
    negative = letters[starts] == _MINUS
    digits = (ends - starts) - (_FRACTION + 1) - negative
    low, low_good = _eight(words[ends - _WORD])
    high = words[ends - 2 * _WORD]
    tenth = (high >> np.uint64(56)) - np.uint64(_ZERO)
    point = (high >> np.uint64(48)) & np.uint64(0xFF)
    inside = np.clip(digits, 1, 6)
    keep = _ALL << (np.uint64(64) - np.uint64(8) * inside.astype(np.uint64))
    whole, whole_good = _eight((((high & _LOW_SIX) << np.uint64(16)) & keep) | (_ZEROS & ~keep))
    regular = low_good & whole_good & (point == _POINT) & (tenth <= 9)
    regular &= (digits == inside) & (ends - starts <= _LONGEST)
    number = (whole * np.uint64(10) + tenth) * np.uint64(10**8) + low
    values = number.astype(np.int64) / 1e9
    return np.where(negative, -values, values), regular


def _eight(words: Words) -> tuple[Words, BoolArray]:
    """Eight digits in each word, first digit in its lowest byte, as a number."""
    digits = words - _ZEROS
    good = (((digits + _CARRY) | digits) & _HIGH_BITS) == 0
    pairs = digits * np.uint64(10) + (digits >> np.uint64(8))
    number = (pairs & _PAIRS) * _FOURS + ((pairs >> np.uint64(16)) & _PAIRS) * _ONES
    return number >> np.uint64(32), good
