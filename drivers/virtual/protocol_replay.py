"""pyserial's handler of ``replay://PATH?speed=...``: a raw log as a port.

The path stands as it is, ``replay://C:/logs/run.calrec`` or ``replay:///home/me/run.calrec``;
speed 1, the default, keeps the recorded times, ``max`` gives the bytes as fast as they are read.
"""

import errno
import math
import time
from collections.abc import Iterator
from pathlib import Path

import serial

from core.errors import FormatError
from drivers.rawlog import Chunk, read_rawlog
from drivers.transport import EndOfStream
from drivers.virtual.fed_port import FedPort

_AT_ONCE = 1 << 15


class Serial(FedPort):
    """A port that says again what was recorded, and then ends."""

    _chunks: Iterator[Chunk]

    def attach(self, url: str) -> None:
        """Open the raw log."""
        address = url.partition("://")[2]
        path, mark, query = address.rpartition("?speed=")
        if not mark:
            path, query = address, "1"
        self._speed = math.inf if query == "max" else float(query)
        if not self._speed > 0:
            raise ValueError(f"speed={query} must be above zero, or max")
        self.patient = math.isinf(self._speed)
        if not Path(path).is_file():
            raise serial.SerialException(errno.ENOENT, f"there is no file {path}")
        try:
            self._chunks = (part for part in read_rawlog(Path(path)) if isinstance(part, Chunk))
            self._chunk = next(self._chunks, None)
        except FormatError as error:
            raise serial.SerialException(str(error)) from error
        self._began = time.monotonic()
        self._zero = self._chunk.t if self._chunk else 0.0

    def detach(self) -> None:
        """Close the raw log."""
        self._chunks = iter(())

    def due(self) -> bytes:
        """Return what the recording holds up to now."""
        data = bytearray()
        now = (time.monotonic() - self._began) * self._speed if not self.patient else math.inf
        while self._chunk is not None and self._chunk.t - self._zero <= now:
            data += self._chunk.data
            self._chunk = next(self._chunks, None)
            if len(data) >= _AT_ONCE:
                break
        if not data and self._chunk is None and not self._pending:
            raise EndOfStream
        return bytes(data)
