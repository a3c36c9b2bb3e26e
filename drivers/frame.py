"""Decoder of the fixed frames that a device file describes."""

from collections.abc import Callable
from functools import partial

import numpy as np

from core.arrays import FloatArray, IntArray
from drivers.checksums import Checksum
from drivers.counter import SampleCounter
from drivers.fields import FieldTable
from drivers.profile_types import FrameSpec, LengthSpec
from drivers.shape import BoolArray, ByteArray, Shape
from drivers.stream import Layout, StreamDecoder

_NOWHERE = (np.empty(0, dtype=np.int64), np.empty(0, dtype=np.uint8))


def frame_shape(spec: FrameSpec) -> Shape:
    """Return what frames of this description look like in a stream."""
    starts = tuple(None if byte is None else (byte,) for byte in spec.sync)
    lengths: int | Callable[[ByteArray], IntArray]
    if isinstance(spec.length, int):
        header, longest, lengths = len(starts), spec.length, spec.length
    else:
        field = spec.length
        header, longest = max(len(starts), field.at + field.size), field.high
        lengths = partial(told_lengths, field=field)
    if spec.checksum is not None:
        return Shape(starts, header, longest, lengths, Checksum(spec.checksum).intact, spec.tail)
    count = len(starts)

    def followed(rows: ByteArray) -> BoolArray:
        good = np.ones(len(rows), dtype=np.bool_)
        for position, byte in enumerate(spec.sync):
            if byte is not None:
                good &= rows[:, position - count] == byte
        return good

    return Shape(starts, header, longest, lengths, followed, follow=count)


def told_lengths(heads: ByteArray, field: LengthSpec) -> IntArray:
    """Return the whole lengths that length fields tell, 0 where out of their range."""
    raw = heads[:, field.at : field.at + field.size].astype(np.int64)
    if field.size == 2:
        low, high = (0, 1) if field.endian == "little" else (1, 0)
        told = raw[:, low] | (raw[:, high] << 8)
    else:
        told = raw[:, 0]
    whole = told * field.mul + field.add
    return np.where((whole >= field.low) & (whole <= field.high), whole, 0)


class FrameDecoder(StreamDecoder):
    """Bytes to samples by a `FrameSpec`.

    Parameters
    ----------
    spec : the frames
    nominal_hz : declared samples per second, 0 if unknown
    """

    def __init__(self, spec: FrameSpec, nominal_hz: float) -> None:
        table = FieldTable(spec.fields)
        counter = spec.counter
        super().__init__(
            frame_shape(spec),
            SampleCounter(counter.bits, counter.step) if counter else SampleCounter(),
            nominal_hz,
            table.channels,
        )
        self._limit = spec.reject_abs
        name = counter.field if counter else ""
        self._layout = Layout(
            table.channels,
            table.values,
            partial(table.counts, name=name) if counter else None,
            _NOWHERE,
        )

    def layout(self, frame: bytes) -> Layout:
        """Return the one layout there is."""
        del frame
        return self._layout

    def accept(self, data: FloatArray) -> BoolArray | None:
        """Return which samples stay below the profile's limit; not-a-number does not."""
        if np.isinf(self._limit):
            return None
        return np.all(np.abs(data) < self._limit, axis=1)
