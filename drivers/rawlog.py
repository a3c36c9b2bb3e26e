"""Raw bytes of a link, written before they are parsed.

A raw log is a block file (`drivers.framing`) with two tags:

``RAW0``
    f64 seconds since the start of the log, then the bytes of one read.
``EVT0``
    JSON: ``t`` seconds since the start, ``kind``, and what belongs to it: ``"link lost"``,
    ``"reconnected"``, ``"not stored"`` with the ``count`` of bytes that a full disk refused.

A recording (`drivers.recording`) is a raw log with decoded samples between the bytes.
"""

import json
import struct
import time
from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import cast

from core.errors import FormatError, StorageError
from drivers.framing import BlockWriter, Damage, Header, read_blocks, read_header, sync_file

RAW = b"RAW0"
EVENT = b"EVT0"
BYTES_ONLY, WITH_SAMPLES = "raw", "recording"
"""What the header of a log says of its content."""

_TIME = struct.Struct("<d")
_SYNC_S = 1.0
_SPOOL_BYTES = 16 << 20


class RawLog:
    """Writes a raw log; for the reader's thread, but for `sync` and `error`.

    When the disk refuses, the latest 16 MB wait in memory and every further block tries again; if
    the disk never recovers in that time, the oldest bytes go and the log says how many.

    Parameters
    ----------
    path : must not exist yet
    header : device, port, profile text, whatever tells later what the bytes are
    content : what else the log holds, `BYTES_ONLY` or `WITH_SAMPLES`

    Raises
    ------
    StorageError
        The file cannot be made.
    """

    def __init__(self, path: Path, header: Header, content: str = BYTES_ONLY) -> None:
        self.path = path
        self.error: StorageError | None = None
        """Why the latest bytes are not stored; None while all are. Any thread may look."""
        self._zero = time.monotonic()
        started = datetime.now(UTC).isoformat(timespec="milliseconds")
        self._file = BlockWriter(path, {**header, "content": content, "started_utc": started})
        self._synced = self._zero
        self._unsafe = False
        self._spool: deque[tuple[bytes, bytes]] = deque()
        self._spooled = 0
        self._dropped = 0

    def write(self, data: bytes, arrival: float) -> None:
        """Store the bytes of one read; `arrival` is their time on the monotonic clock."""
        self.append(RAW, _TIME.pack(arrival - self._zero) + data)
        if arrival - self._synced >= _SYNC_S:
            self._synced = arrival
            self._settle()

    def mark(self, kind: str, **fields: str | float) -> None:
        """Store that something happened to the link now."""
        event = {"t": time.monotonic() - self._zero, "kind": kind, **fields}
        self.append(EVENT, json.dumps(event).encode())

    def sync(self) -> None:
        """Wait until everything read so far is on the disk itself; for any thread.

        Raises
        ------
        StorageError
            Some of it is not.
        """
        if self.error is not None:
            raise self.error
        sync_file(self.path)

    def close(self) -> None:
        """Sync and close; what could not be stored stays in `error`."""
        if self._spool:
            self._flush()
        try:
            self._file.close()
        except StorageError as error:
            self.error = error

    def append(self, tag: bytes, payload: bytes) -> None:
        """Store a block of another kind."""
        self._spool.append((tag, payload))
        self._spooled += len(payload)
        self._flush()

    def _flush(self) -> None:
        try:
            if self._dropped:
                note = {"t": time.monotonic() - self._zero, "kind": "not stored"}
                self._file.append(EVENT, json.dumps({**note, "count": self._dropped}).encode())
                self._dropped = 0
            while self._spool:
                self._file.append(*self._spool[0])
                self._spooled -= len(self._spool.popleft()[1])
        except StorageError as error:
            self.error = error
            while self._spooled > _SPOOL_BYTES:
                tag, payload = self._spool.popleft()
                self._spooled -= len(payload)
                self._dropped += len(payload) - _TIME.size if tag == RAW else 0
        else:
            if not self._unsafe:
                self.error = None

    def _settle(self) -> None:
        try:
            self._file.sync()
        except StorageError as error:
            # The system reports a failed sync once and forgets the pages: this stays true.
            self.error = error
            self._unsafe = True


@dataclass(frozen=True, slots=True)
class Chunk:
    """The bytes of one read, `t` seconds after the start of the log."""

    t: float
    data: bytes


@dataclass(frozen=True, slots=True)
class Mark:
    """Something that happened to the link."""

    t: float
    kind: str
    fields: Mapping[str, object]


def rawlog_header(path: Path) -> dict[str, object]:
    """Return what the writer said about a raw log.

    Raises
    ------
    FormatError
        The file is no raw log.
    """
    header = read_header(path)
    if header.get("content") not in (BYTES_ONLY, WITH_SAMPLES):
        raise FormatError(path, f"holds {header.get('content')!r}; expected a raw log")
    return header


def read_rawlog(path: Path) -> Iterator[Chunk | Mark | Damage]:
    """Yield what a raw log holds, in the order of writing.

    Raises
    ------
    FormatError
        The file is no raw log.
    """
    rawlog_header(path)
    for block in read_blocks(path):
        if isinstance(block, Damage):
            yield block
        elif block.tag == RAW and len(block.payload) >= _TIME.size:
            (t,) = cast(tuple[float], _TIME.unpack_from(block.payload))
            yield Chunk(t, block.payload[_TIME.size :])
        elif block.tag == EVENT and (mark := event_of(block.payload)) is not None:
            yield mark
        elif block.tag in (RAW, EVENT):
            yield block.as_damage()


def event_of(payload: bytes) -> Mark | None:
    """Return what an ``EVT0`` block tells; None if it is no event of ours."""
    try:
        found: object = json.loads(payload)
    except (ValueError, RecursionError):
        return None
    if not isinstance(found, dict):
        return None
    fields = cast(dict[str, object], found)
    t, kind = fields.pop("t", None), fields.pop("kind", None)
    if isinstance(t, bool) or not isinstance(t, int | float) or not isinstance(kind, str):
        return None
    try:
        return Mark(float(t), kind, fields)
    except OverflowError:
        return None
