"""A file of checked blocks: what was written before a crash stays readable, to the last block.

Layout, little-endian::

    "CALREC1" and LF | u32 length of JSON | u32 CRC-32 of JSON | JSON, UTF-8 | zeros to n * 512
    then blocks:  tag, 4 bytes | u32 length | u32 CRC-32 of tag, length and payload | payload

Tags name what a payload holds (`drivers.rawlog` writes ``RAW0`` and ``EVT0``). A reader passes over
tags that it does not know, and over damage to the next block that checks.
"""

import json
import os
import re
import struct
import sys
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, cast

from core.errors import FormatError, StorageError
from core.records.atomic import sync_folder

MAGIC = b"CALREC1\n"
_HEAD = struct.Struct("<8sII")
_BLOCK = struct.Struct("<4sII")
_TAG = re.compile(rb"[A-Z]{3}[0-9]")
_PAGE = 512
_MAX_PAYLOAD = 1 << 26
_STEP = 1 << 20

Header = Mapping[str, object]
"""What a file's JSON header holds; the writer decides."""


@dataclass(frozen=True, slots=True)
class Block:
    """One block of a file; `offset` is where it begins."""

    tag: bytes
    payload: bytes
    offset: int

    def as_damage(self) -> "Damage":
        """The same stretch of the file, for one whose payload holds nothing that is known."""
        return Damage(self.offset, _BLOCK.size + len(self.payload))


@dataclass(frozen=True, slots=True)
class Damage:
    """A stretch of a file that holds no whole block: a torn tail or overwritten bytes."""

    offset: int
    count: int


class BlockWriter:
    """Appends blocks to a new file.

    Parameters
    ----------
    path : must not exist yet; nothing measured is ever overwritten
    header : what the readers must know

    Raises
    ------
    StorageError
        The file exists or cannot be made.
    """

    def __init__(self, path: Path, header: Header) -> None:
        self.path = path
        text = json.dumps(header, ensure_ascii=False).encode()
        head = _HEAD.pack(MAGIC, len(text), zlib.crc32(text)) + text
        head += bytes(-len(head) % _PAGE)
        flags = os.O_CREAT | os.O_EXCL | os.O_WRONLY | getattr(os, "O_BINARY", 0)
        try:
            self._fd = os.open(path, flags, 0o644)
        except OSError as error:
            raise StorageError(f"{path}: cannot be created: {error.strerror}") from error
        self._end = 0
        try:
            self._put(head)
            self.sync()
            # Without its name on the disk a power cut takes the whole file of the first seconds.
            sync_folder(path.parent)
        except (StorageError, OSError) as error:
            os.close(self._fd)
            path.unlink(missing_ok=True)
            if isinstance(error, StorageError):
                raise
            raise StorageError(f"{path}: not safe on disk: {error.strerror}") from error

    def append(self, tag: bytes, payload: bytes) -> None:
        """Write one block; it survives the end of this process, not yet of the machine.

        Raises
        ------
        StorageError
            The disk took no whole block; the file still ends with the block before.
        """
        head = _BLOCK.pack(tag, len(payload), _checksum(tag, payload))
        self._put(head + payload)

    def sync(self) -> None:
        """Wait until everything written is on the disk itself.

        Raises
        ------
        StorageError
            The disk reports that it is not.
        """
        try:
            _sync(self._fd)
        except OSError as error:
            raise StorageError(f"{self.path}: not safe on disk: {error.strerror}") from error

    def close(self) -> None:
        """Sync and close; may be called again."""
        if self._fd < 0:
            return
        fd, self._fd = self._fd, -1
        try:
            try:
                _sync(fd)
            finally:
                os.close(fd)
        except OSError as error:
            raise StorageError(f"{self.path}: not safe on disk: {error.strerror}") from error

    def _put(self, data: bytes) -> None:
        written = 0
        try:
            while written < len(data):
                written += os.write(self._fd, data[written:])
        except OSError as error:
            if written:
                self._take_back(written)
            raise StorageError(f"{self.path}: cannot be written: {error.strerror}") from error
        self._end += len(data)

    def _take_back(self, written: int) -> None:
        """Remove the beginning of a block; if even that fails, readers pass over it."""
        try:
            os.ftruncate(self._fd, self._end)
            os.lseek(self._fd, self._end, os.SEEK_SET)
        except OSError:
            # It stays, so that the next to be taken back must not begin before its end.
            self._end += written


def sync_file(path: Path) -> None:
    """Wait until all that any thread has written to this file is on the disk itself.

    Raises
    ------
    StorageError
        The disk reports that it is not.
    """
    try:
        fd = os.open(path, os.O_RDWR | getattr(os, "O_BINARY", 0))
        try:
            _sync(fd)
        finally:
            os.close(fd)
    except OSError as error:
        raise StorageError(f"{path}: not safe on disk: {error.strerror}") from error


def read_header(path: Path) -> dict[str, object]:
    """Return the JSON header of a block file.

    Raises
    ------
    FormatError
        The file is no block file or its header is damaged.
    """
    try:
        with path.open("rb") as file:
            return _read_header(file, path)[0]
    except OSError as error:
        raise FormatError(path, f"cannot be read: {error.strerror}") from error


def read_blocks(path: Path) -> Iterator[Block | Damage]:
    """Yield the blocks of a file, and what lies between whole blocks as `Damage`.

    Raises
    ------
    FormatError
        The file is no block file or its header is damaged.
    """
    try:
        file = path.open("rb")
    except OSError as error:
        raise FormatError(path, f"cannot be read: {error.strerror}") from error
    with file:
        offset = _read_header(file, path)[1]
        size = file.seek(0, os.SEEK_END)
        while offset < size:
            block = _block_at(file, offset, size)
            if block is None:
                following = _next_block(file, offset + 1, size)
                yield Damage(offset, following - offset)
                offset = following
            else:
                yield block
                offset += _BLOCK.size + len(block.payload)


def _block_at(file: BinaryIO, offset: int, size: int) -> Block | None:
    file.seek(offset)
    head = file.read(_BLOCK.size)
    if len(head) < _BLOCK.size:
        return None
    tag, length, checksum = cast(tuple[bytes, int, int], _BLOCK.unpack(head))
    if _TAG.fullmatch(tag) is None or length > min(_MAX_PAYLOAD, size - offset - _BLOCK.size):
        return None
    payload = file.read(length)
    if _checksum(tag, payload) != checksum:
        return None
    return Block(tag, payload, offset)


def _next_block(file: BinaryIO, offset: int, size: int) -> int:
    """Return where the next whole block begins, or the end of the file."""
    while offset < size:
        file.seek(offset)
        window = file.read(_STEP + 3)
        for match in _TAG.finditer(window):
            if _block_at(file, offset + match.start(), size) is not None:
                return offset + match.start()
        offset += _STEP
    return size


def _read_header(file: BinaryIO, path: Path) -> tuple[dict[str, object], int]:
    head = file.read(_HEAD.size)
    if len(head) < _HEAD.size or not head.startswith(MAGIC):
        raise FormatError(path, "no CalRig record: it does not begin with CALREC1")
    _, length, checksum = cast(tuple[bytes, int, int], _HEAD.unpack(head))
    text = file.read(length) if length <= _MAX_PAYLOAD else b""
    if zlib.crc32(text) != checksum or len(text) != length:
        raise FormatError(path, "the header of the record is damaged")
    try:
        header: object = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise FormatError(path, f"the header of the record is damaged: {error}") from error
    if not isinstance(header, dict):
        raise FormatError(path, "the header of the record is damaged: it is no JSON object")
    end = _HEAD.size + length
    return cast(dict[str, object], header), end + -end % _PAGE


def _checksum(tag: bytes, payload: bytes) -> int:
    return zlib.crc32(payload, zlib.crc32(tag + struct.pack("<I", len(payload))))


def _sync(fd: int) -> None:
    """Flush data to the disk; the file's times need not follow where they can stay behind."""
    if sys.platform == "linux":
        os.fdatasync(fd)
    else:
        os.fsync(fd)
