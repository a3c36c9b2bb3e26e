"""A decoder that understands nothing and keeps the latest bytes: for a board nobody knows yet."""

import time
from dataclasses import dataclass

from core.samples.block import Channel
from drivers.events import Event
from drivers.teach.pace import clock_doubt

KEPT = 1 << 16
"""Bytes that are kept."""
_BACKLOG_S = 0.3
"""In the first moments comes what had waited in the system, faster than the board sends."""
_TELLS_S = 1.0
"""A shorter time tells no rate of boards that send in bursts."""


@dataclass(frozen=True, slots=True)
class Heard:
    """What has come.

    Parameters
    ----------
    tail : the latest bytes
    total : all bytes so far
    seconds : from the end of the first read, without what had waited before it, to that of the
        last; 0 while that is too short to tell a rate
    within : bytes that came in this time
    port : address that they came from; empty if unknown
    baud : its speed where it limits how fast they can have come; 0 if unknown
    """

    tail: bytes = b""
    total: int = 0
    seconds: float = 0.0
    within: int = 0
    port: str = ""
    baud: int = 0

    @property
    def bytes_per_s(self) -> float:
        """Mean rate of the bytes; 0 while it cannot be told."""
        return self.within / self.seconds if self.seconds > 0.2 else 0.0

    @property
    def doubt(self) -> str:
        """Why this is not how fast the board sends; empty if it is, or not known."""
        return clock_doubt(self.port, self.baud, self.bytes_per_s)


class Ear:
    """Keeps the latest bytes; the reader's thread feeds it, any thread may look at `heard`."""

    def __init__(self, kept: int = KEPT, port: str = "") -> None:
        self._kept = kept
        self._port = port
        self._opened = 0.0
        self._begun = 0.0
        self._first = 0
        self.heard = Heard(port=port)
        """Replaced whole at each feeding."""

    @property
    def channels(self) -> tuple[Channel, ...]:
        """None: nothing is understood."""
        return ()

    @property
    def rate(self) -> float:
        """Unknown."""
        return 0.0

    def feed(self, data: bytes) -> list[Event]:
        """Keep some bytes."""
        now = time.monotonic()
        tail = (self.heard.tail + data)[-self._kept :]
        total = self.heard.total + len(data)
        if not self.heard.total:
            self._opened = now
        if now - self._opened < _BACKLOG_S:
            self._begun, self._first = now, total
        seconds = now - self._begun
        self.heard = Heard(
            tail, total, seconds if seconds > _TELLS_S else 0.0, total - self._first, self._port
        )
        return []

    def flush(self) -> list[Event]:
        """Nothing is held back."""
        return []
