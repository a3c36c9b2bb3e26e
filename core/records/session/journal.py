"""An append-only file of events, each durable before the program goes on.

One line an event::

    {"crc32":"89abcdef","event":{...}}

The CRC-32 is that of the bytes of the event. A line that a crash or a power cut left unfinished
fails the check, is told and stays where it is; the next event begins on a line of its own.
"""

import os
import re
import zlib
from dataclasses import dataclass
from pathlib import Path

from core.errors import FormatError, Note, Severity
from core.records.atomic import append_durable, not_stored
from core.records.json_fields import Fields, Json, dump, load_object
from core.records.text import read_bytes

_LINE = re.compile(rb'\{"crc32":"([0-9a-f]{8})","event":(.*)\}')


class Journal:
    """The open journal of a session that is being measured.

    Parameters
    ----------
    path : the file; it must exist unless `create` is set, and must not if it is

    Raises
    ------
    StorageError
        It cannot be opened for writing.
    """

    def __init__(self, path: Path, *, create: bool = False) -> None:
        self.path = path
        flags = os.O_RDWR | os.O_APPEND | getattr(os, "O_BINARY", 0)
        try:
            self._handle = os.open(path, flags | (os.O_CREAT | os.O_EXCL if create else 0), 0o666)
        except OSError as error:
            raise not_stored(path, error, "what the session holds is untouched") from error

    def append(self, event: Json) -> None:
        """Write one event; it is on the disk when the function returns.

        Raises
        ------
        StorageError
            It is not; all earlier events are.
        """
        body = dump(event, indent=None).encode()
        line = b'{"crc32":"%08x","event":%b}\n' % (zlib.crc32(body), body)
        try:
            size = os.fstat(self._handle).st_size
            if size:
                os.lseek(self._handle, size - 1, os.SEEK_SET)
                if os.read(self._handle, 1) != b"\n":
                    line = b"\n" + line
            append_durable(self._handle, line)
        except OSError as error:
            saved = "all positions accepted before are stored, this one is not"
            raise not_stored(self.path, error, saved) from error

    def close(self) -> None:
        """Close the file."""
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1


@dataclass(frozen=True, slots=True)
class Damaged:
    """A line of a journal that holds no whole event.

    Parameters
    ----------
    line : its number, 1-based
    size : its bytes
    last : whether no whole event follows, as after a crash
    """

    line: int
    size: int
    last: bool

    @property
    def text(self) -> str:
        """Which line it is, for the event that tells that it was seen."""
        return f"line {self.line}, {self.size} bytes"

    def note(self, path: Path) -> Note:
        """What to tell the operator."""
        if self.last:
            return Note(
                Severity.WARNING,
                "torn_line",
                f"{path}, line {self.line}: the program ended while this was being written"
                f" ({self.size} bytes); it was never confirmed and is left out, everything before"
                " it is whole",
            )
        return Note(
            Severity.ERROR,
            "damaged_line",
            f"{path}, line {self.line}: damaged ({self.size} bytes) and left out; whole events"
            " follow it: look at the file and the disk before using this session",
        )


def read_journal(path: Path) -> tuple[tuple[Fields, ...], tuple[Damaged, ...]]:
    """Return the whole events of a journal, and what is damaged in it.

    Raises
    ------
    FormatError
        The file cannot be read at all.
    """
    events: list[Fields] = []
    broken: list[tuple[int, int]] = []
    last_whole = 0
    for number, line in enumerate(read_bytes(path).split(b"\n"), start=1):
        if not line:
            continue
        match = _LINE.fullmatch(line)
        event = None
        if match is not None and int(match[1], 16) == zlib.crc32(match[2]):
            event = _event(path, number, match[2])
        if event is None:
            broken.append((number, len(line)))
        else:
            events.append(event)
            last_whole = number
    damaged = tuple(Damaged(number, size, number > last_whole) for number, size in broken)
    return tuple(events), damaged


def _event(path: Path, number: int, body: bytes) -> Fields | None:
    try:
        return load_object(body.decode(), f"{path}, line {number}")
    except (FormatError, UnicodeDecodeError):
        return None
