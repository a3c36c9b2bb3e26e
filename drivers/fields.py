"""Tables of fields: matrices of frame bytes to matrices of numbers, and back."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray
from core.samples.block import Channel
from drivers.profile_types import TYPES, FieldSpec
from drivers.shape import ByteArray

_KIND = {"u": "u", "i": "i", "f": "f"}


def _dtype(spec: FieldSpec) -> str:
    order = "<" if spec.endian == "little" else ">"
    return f"{order}{_KIND[spec.type[0]]}{TYPES[spec.type]}"


def _read24(raw: ByteArray, spec: FieldSpec) -> NDArray[np.int32]:
    """Return three-byte integers; (n, 3 k) uint8 -> (n, k)."""
    triples = raw.reshape(len(raw), -1, 3).astype(np.int32)
    low, high = (0, 2) if spec.endian == "little" else (2, 0)
    top = triples[:, :, high] << 24
    whole = top | (triples[:, :, 1] << 16) | (triples[:, :, low] << 8)
    return whole >> 8 if spec.type[0] == "i" else (whole >> 8) & 0xFFFFFF


def _numbers(raw: ByteArray, spec: FieldSpec) -> NDArray[Any]:
    """Return the unscaled numbers in some bytes; (n, m) uint8 -> (n, k)."""
    numbers = _read24(raw, spec) if TYPES[spec.type] == 3 else raw.view(_dtype(spec))
    if spec.bits is not None:
        low, high = spec.bits
        return (numbers >> low) & ((1 << (high - low + 1)) - 1)
    return numbers


def read_raw(rows: ByteArray, spec: FieldSpec) -> NDArray[Any]:
    """Return the unscaled numbers of a field; (n, length) uint8 -> (n, k)."""
    return _numbers(rows[:, spec.at : spec.end], spec)


def write_raw(rows: ByteArray, spec: FieldSpec, numbers: NDArray[Any]) -> None:
    """Write unscaled numbers into frames, in place; bits are added to what stands there."""
    size = TYPES[spec.type]
    order = "<" if spec.endian == "little" else ">"
    if spec.bits is not None:
        numbers = (numbers.astype(np.int64) << spec.bits[0]) | read_raw(
            rows, FieldSpec(spec.channels, spec.type, spec.at, endian=spec.endian)
        ).astype(np.int64)
    if size == 3:
        wide = numbers.astype(f"{order}i4").reshape(len(rows), -1, 1).view(np.uint8)
        part = wide[:, :, :3] if order == "<" else wide[:, :, 1:]
        rows[:, spec.at : spec.end] = part.reshape(len(rows), -1)
        return
    data = np.ascontiguousarray(numbers.astype(_dtype(spec)))
    rows[:, spec.at : spec.end] = data.view(np.uint8).reshape(len(rows), -1)


@dataclass(frozen=True, slots=True, eq=False)
class _Group:
    """Fields of one type, wherever they stand: read at once and put into their columns."""

    spec: FieldSpec
    taken: slice | IntArray
    columns: slice | IntArray

    def numbers(self, rows: ByteArray) -> NDArray[Any]:
        if isinstance(self.taken, slice):
            return _numbers(rows[:, self.taken], self.spec)
        return _numbers(rows.take(self.taken, axis=1), self.spec)


def _groups(fields: Sequence[FieldSpec]) -> list[_Group]:
    found: dict[object, list[tuple[FieldSpec, int]]] = {}
    column = 0
    for spec in fields:
        key = (spec.type, spec.endian, spec.bits, spec.bits and spec.at)
        found.setdefault(key, []).append((spec, column))
        column += len(spec.channels)
    return [
        _Group(
            members[0][0],
            _compact([place for spec, _ in members for place in range(spec.at, spec.end)]),
            _compact([at + n for spec, at in members for n in range(len(spec.channels))]),
        )
        for members in found.values()
    ]


def _compact(places: list[int]) -> slice | IntArray:
    """Return neighbouring places as a slice, which costs no copy."""
    if places == list(range(places[0], places[0] + len(places))):
        return slice(places[0], places[0] + len(places))
    return np.array(places, dtype=np.int64)


class FieldTable:
    """The fields of one kind of frame.

    Parameters
    ----------
    fields : in the order of the columns; hidden ones are no columns
    """

    def __init__(self, fields: Sequence[FieldSpec]) -> None:
        self._fields = tuple(fields)
        self._shown = tuple(spec for spec in fields if not spec.hide)
        self._groups = _groups(self._shown)
        self._scales = np.array([spec.scale for spec in self._shown for _ in spec.channels])
        self._offsets = np.array([spec.offset for spec in self._shown for _ in spec.channels])
        self._scaled = bool((self._scales != 1.0).any())
        self._shifted = bool(self._offsets.any())
        self.channels: tuple[Channel, ...] = tuple(
            channel for spec in self._shown for channel in spec.channels
        )

    def values(self, rows: ByteArray) -> FloatArray:
        """Return the scaled values; (n, length) uint8 -> (n, c) float64."""
        data = np.empty((len(rows), len(self.channels)))
        with np.errstate(invalid="ignore"):  # a signalling NaN in a damaged or unset float
            for group in self._groups:
                data[:, group.columns] = group.numbers(rows)
            if self._scaled:
                data *= self._scales
            if self._shifted:
                data += self._offsets
        return data

    def counts(self, rows: ByteArray, name: str) -> IntArray:
        """Return the unscaled numbers of one field, shown or hidden; (n,) int64."""
        spec, position = self._find(name)
        return read_raw(rows, spec)[:, position].astype(np.int64)

    def write_counts(self, rows: ByteArray, name: str, counts: IntArray) -> None:
        """Write the unscaled numbers of one field, in place."""
        spec, position = self._find(name)
        at = spec.at + position * TYPES[spec.type]
        one = FieldSpec((spec.channels[position],), spec.type, at, 1, 0, spec.endian, spec.bits)
        write_raw(rows, one, counts.reshape(-1, 1))

    def write(self, rows: ByteArray, data: FloatArray, skip: str = "") -> None:
        """Write values into frames, in place, rounded and held within each field's range.

        Parameters
        ----------
        rows : (n, length) uint8, zero where fields stand
        data : (n, c) values of the columns
        skip : name of a channel that is not written
        """
        column = 0
        for spec in self._shown:
            end = column + len(spec.channels)
            numbers = (data[:, column:end] - spec.offset) / spec.scale
            if spec.type[0] != "f":
                low, high = limits(spec)
                numbers = np.clip(np.rint(numbers), low, high).astype(np.int64)
            for position, channel in enumerate(spec.channels):
                if channel.name == skip:
                    numbers[:, position] = 0
            write_raw(rows, spec, numbers)
            column = end

    def _find(self, name: str) -> tuple[FieldSpec, int]:
        for spec in self._fields:
            for position, channel in enumerate(spec.channels):
                if channel.name == name:
                    return spec, position
        raise ValueError(f'no field "{name}"')


def limits(spec: FieldSpec) -> tuple[int, int]:
    """Return the lowest and highest raw number of an integer field."""
    if spec.bits is not None:
        return 0, (1 << (spec.bits[1] - spec.bits[0] + 1)) - 1
    bits = 8 * TYPES[spec.type]
    return (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if spec.type[0] == "i" else (0, 2**bits - 1)
