"""A decoder that understands nothing and keeps the latest bytes: for a board nobody knows yet."""

import time
from dataclasses import dataclass

from core.samples.block import Channel
from drivers.events import Event

KEPT = 1 << 16
"""Bytes that are kept."""


@dataclass(frozen=True, slots=True)
class Heard:
    """What has come.

    Parameters
    ----------
    tail : the latest bytes
    total : all bytes so far
    seconds : from the end of the first read to that of the last
    within : bytes that came in this time
    """

    tail: bytes = b""
    total: int = 0
    seconds: float = 0.0
    within: int = 0

    @property
    def bytes_per_s(self) -> float:
        """Mean rate of the bytes; 0 while it cannot be told."""
        return self.within / self.seconds if self.seconds > 0.2 else 0.0


class Ear:
    """Keeps the latest bytes; the reader's thread feeds it, any thread may look at `heard`."""

    def __init__(self, kept: int = KEPT) -> None:
        self._kept = kept
        self._begun = 0.0
        self._first = 0
        self.heard = Heard()
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
        if not self.heard.total:
            self._begun, self._first = now, len(data)
        tail = (self.heard.tail + data)[-self._kept :]
        total = self.heard.total + len(data)
        self.heard = Heard(tail, total, now - self._begun, total - self._first)
        return []

    def flush(self) -> list[Event]:
        """Nothing is held back."""
        return []
