"""Checksums of many frames at once.

Every function takes a matrix of bytes, one frame a row, and gives one number a row. A CRC is
linear over GF(2): it is the exclusive-or of one table entry a byte, where the table depends only on
the distance of that byte from the end. With the tables of all distances at hand, a thousand frames
cost two numpy calls instead of a loop over bytes; dummy zero bytes after the end (STIM300) only
shift the distances.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.arrays import IntArray

Bytes2D = NDArray[np.uint8]
Words = NDArray[np.uint32]


@dataclass(frozen=True, slots=True)
class CrcSpec:
    """The parameters of a CRC in the notation of the public CRC catalogues.

    Parameters
    ----------
    width : 8, 16 or 32 bits
    poly, init, xorout : as written in the catalogues (not reflected)
    refin, refout : whether bytes enter, and the result leaves, least significant bit first
    """

    width: int
    poly: int
    init: int = 0
    refin: bool = False
    refout: bool = False
    xorout: int = 0


CRC_PRESETS: Mapping[str, CrcSpec] = {
    "crc-8": CrcSpec(8, 0x07),
    "crc-8/maxim": CrcSpec(8, 0x31, refin=True, refout=True),
    "crc-8/stim300": CrcSpec(8, 0x07, init=0xFF),
    "crc-16/arc": CrcSpec(16, 0x8005, refin=True, refout=True),
    "crc-16/modbus": CrcSpec(16, 0x8005, init=0xFFFF, refin=True, refout=True),
    "crc-16/kermit": CrcSpec(16, 0x1021, refin=True, refout=True),
    "crc-16/x-25": CrcSpec(16, 0x1021, init=0xFFFF, refin=True, refout=True, xorout=0xFFFF),
    "crc-16/xmodem": CrcSpec(16, 0x1021),
    "crc-16/ccitt-false": CrcSpec(16, 0x1021, init=0xFFFF),
    "crc-16/aug-ccitt": CrcSpec(16, 0x1021, init=0x1D0F),
    "crc-32": CrcSpec(32, 0x04C11DB7, init=0xFFFFFFFF, refin=True, refout=True, xorout=0xFFFFFFFF),
    "crc-32/bzip2": CrcSpec(32, 0x04C11DB7, init=0xFFFFFFFF, xorout=0xFFFFFFFF),
    "crc-32/mpeg-2": CrcSpec(32, 0x04C11DB7, init=0xFFFFFFFF),
}


def _reflect(value: int, width: int) -> int:
    return int(f"{value:0{width}b}"[::-1], 2)


class Crc:
    """A CRC of any parameters, with tables that grow to the longest frame met.

    Parameters
    ----------
    spec : the parameters
    zeros : dummy zero bytes that are counted after the end but never sent
    """

    def __init__(self, spec: CrcSpec, zeros: int = 0) -> None:
        self._spec = spec
        self._zeros = zeros
        self._mask = (1 << spec.width) - 1
        init = _reflect(spec.init, spec.width) if spec.refin else spec.init
        self._inits: list[int] = [init]
        self._byte = self._byte_table()
        self._tables: Words = self._byte.reshape(1, 256)

    def _byte_table(self) -> Words:
        """Return the register after each byte value, from a zero register."""
        spec = self._spec
        top, poly = 1 << (spec.width - 1), spec.poly
        reflected = _reflect(poly, spec.width)
        table: list[int] = []
        for value in range(256):
            register = value if spec.refin else value << (spec.width - 8)
            for _ in range(8):
                if spec.refin:
                    register = (register >> 1) ^ (reflected if register & 1 else 0)
                else:
                    register = ((register << 1) & self._mask) ^ (poly if register & top else 0)
            table.append(register)
        return np.array(table, dtype=np.uint32)

    def _zero_byte(self, register: Words) -> Words:
        """Return the registers after one more zero byte."""
        if self._spec.refin:
            return np.bitwise_xor(register >> 8, self._byte[register & 0xFF], dtype=np.uint32)
        kept = np.bitwise_and(register << 8, self._mask, dtype=np.uint32)
        return np.bitwise_xor(kept, self._byte[register >> (self._spec.width - 8)])

    def _grow(self, length: int) -> None:
        tables = list(self._tables)
        while len(tables) < length:
            tables.append(self._zero_byte(tables[-1]))
        self._tables = np.array(tables)
        while len(self._inits) <= length:
            last = np.array([self._inits[-1]], dtype=np.uint32)
            self._inits.append(int(self._zero_byte(last)[0]))

    def __call__(self, rows: Bytes2D) -> IntArray:
        """Return the CRC of each row; (n, m) uint8 -> (n,) int64."""
        spec = self._spec
        count = int(rows.shape[1])
        whole = count + self._zeros
        if len(self._inits) <= whole:
            self._grow(whole)
        distance = np.arange(whole - 1, self._zeros - 1, -1, dtype=np.int64) * 256
        parts = self._tables.ravel().take(rows + distance)
        result = np.bitwise_xor(_exclusive_or(parts), self._inits[whole], dtype=np.int64)
        if spec.refin != spec.refout:
            turned = [_reflect(value, spec.width) for value in result.tolist()]
            result = np.array(turned, dtype=np.int64)
        return np.bitwise_xor(result, spec.xorout, dtype=np.int64)


def _exclusive_or(rows: Words | Bytes2D) -> IntArray:
    return np.bitwise_xor.reduce(rows, axis=1).astype(np.int64)


def sum8(rows: Bytes2D) -> IntArray:
    """Return the sum of the bytes of each row, mod 256."""
    return np.add.reduce(rows, axis=1, dtype=np.uint8).astype(np.int64)


def sum16(rows: Bytes2D) -> IntArray:
    """Return the sum of the bytes of each row, mod 65536."""
    return np.add.reduce(rows, axis=1, dtype=np.uint16).astype(np.int64)


def sum16w(rows: Bytes2D, endian: str) -> IntArray:
    """Return the sum of the 16-bit words of each row, mod 65536.

    Parameters
    ----------
    rows : (n, m) uint8, m even
    endian : byte order of the words, ``"little"`` or ``"big"``
    """
    words = rows.view("<u2" if endian == "little" else ">u2")
    return np.add.reduce(words, axis=1, dtype=np.uint16).astype(np.int64)


def xor8(rows: Bytes2D) -> IntArray:
    """Return the exclusive-or of the bytes of each row."""
    return _exclusive_or(rows)


def fletcher16(rows: Bytes2D) -> IntArray:
    """Return Fletcher's sum of each row: high byte the second sum, low byte the first, mod 255."""
    wide = rows.astype(np.int64)
    weights = np.arange(rows.shape[1], 0, -1, dtype=np.int64)
    return ((wide @ weights) % 255 << 8) | (wide.sum(axis=1) % 255)


CHECKSUM_NAMES = (
    "none", "sum8", "sum16", "sum16w", "xor8", "fletcher16", "crc8", "crc16", "crc32",
    *CRC_PRESETS,
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class ChecksumSpec:
    """Which bytes of a frame a checksum covers and where it stands.

    Parameters
    ----------
    algorithm : one of `CHECKSUM_NAMES`
    start, stop : covered bytes of the frame, as in a slice; negative counts from the end
    at : place of the stored value; negative counts from the end
    size : bytes of the stored value
    endian : byte order of the stored value, and of the words of ``sum16w``
    negate : whether the two's complement is stored, so that the whole sums to zero
    pad_to : dummy zero bytes fill the covered bytes up to a multiple of this; 0 for none
    crc : parameters where the algorithm is a CRC
    """

    algorithm: str
    start: int
    stop: int
    at: int
    size: int
    endian: str
    negate: bool = False
    pad_to: int = 0
    crc: CrcSpec | None = None


def _sum_function(spec: ChecksumSpec) -> Callable[[Bytes2D], IntArray]:
    if spec.algorithm == "sum16w":
        return lambda rows: sum16w(rows, spec.endian)
    return {"sum8": sum8, "sum16": sum16, "xor8": xor8, "fletcher16": fletcher16}[spec.algorithm]


class Checksum:
    """A `ChecksumSpec` ready to check and to write."""

    def __init__(self, spec: ChecksumSpec) -> None:
        self.spec = spec
        self._mask = (1 << (8 * spec.size)) - 1
        self._functions: dict[int, Callable[[Bytes2D], IntArray]] = {}

    def _function(self, covered: int) -> Callable[[Bytes2D], IntArray]:
        if self.spec.crc is None:
            return _sum_function(self.spec)
        return Crc(self.spec.crc, -covered % self.spec.pad_to if self.spec.pad_to else 0)

    def expected(self, rows: Bytes2D) -> IntArray:
        """Return what should stand in each whole frame; (n, length) uint8 -> (n,) int64."""
        length = rows.shape[1]
        start, stop, _ = slice(self.spec.start, self.spec.stop).indices(length)
        covered = rows[:, start:stop]
        zeros = -(stop - start) % self.spec.pad_to if self.spec.pad_to else 0
        function = self._functions.get(zeros)
        if function is None:
            function = self._functions[zeros] = self._function(stop - start)
        value = function(covered)
        return (-value if self.spec.negate else value) & self._mask

    def _place(self, length: int) -> int:
        return self.spec.at if self.spec.at >= 0 else length + self.spec.at

    def intact(self, rows: Bytes2D) -> NDArray[np.bool_]:
        """Return which whole frames hold the checksum that they should."""
        at, size = self._place(rows.shape[1]), self.spec.size
        if size == 1:
            return rows[:, at] == self.expected(rows)
        order = "<" if self.spec.endian == "little" else ">"
        stored = rows[:, at : at + size].view(f"{order}u{size}")[:, 0]
        return stored == self.expected(rows)

    def stamp(self, rows: Bytes2D) -> None:
        """Write the checksum into each whole frame, in place."""
        at, size = self._place(rows.shape[1]), self.spec.size
        order = "<" if self.spec.endian == "little" else ">"
        values = self.expected(rows).astype(f"{order}u{size}")
        rows[:, at : at + size] = values.reshape(-1, 1).view(np.uint8)
