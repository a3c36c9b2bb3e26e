"""The one thread of a port: it opens, reads, logs, decodes and closes.

Everything that the port says comes out of `Reader.drain` in order; `Ended` is the last of it. An
interruption that heals comes as `Message` of kind ``"link lost"``, then ``"reconnected"``, and the
sample numbers leave a gap as long as it was by the clock, with a `Lost` of that many. One of kind
``"paused"`` tells that the program itself stood still: what the port could not hold meanwhile is
lost, and only a device's counter tells how much.
"""

import math
import sys
import threading
import time
from dataclasses import dataclass, replace
from enum import Enum
from queue import SimpleQueue
from typing import Protocol

from core.arrays import frozen_int
from core.errors import LinkError, StorageError
from core.samples.block import SampleBlock
from drivers.decoders import Decoder
from drivers.events import (
    BadChecksum,
    BadValues,
    Ended,
    Event,
    Garbage,
    Lost,
    Message,
)
from drivers.linkrate import LinkRate
from drivers.pauses import Pauses
from drivers.rawlog import RawLog
from drivers.transport import EndOfStream, Opener, Transport

_RETRY_S = 1.0
_JOIN_S = 5.0
_MOST_PENDING = 8
_PATIENCE_S = 0.001
_NO_DATA_S = 1.0
_NO_DATA_PERIODS = 20


class LinkState(Enum):
    """What a link is doing."""

    OPENING = "opening"
    WAITING = "waiting"
    """Open, and no valid frame came yet."""
    STREAMING = "streaming"
    NO_DATA = "no data"
    """Frames came and stopped coming."""
    RECONNECTING = "reconnecting"
    ENDED = "ended"


@dataclass(frozen=True, slots=True)
class Counters:
    """What a link has brought since it was opened.

    Parameters
    ----------
    bytes, frames : all bytes, all valid frames
    bad_checksum, bad_values, lost, garbage : frames refused, samples missing, bytes of no frame
    reconnections : how often the port came back
    measured_hz : rate of the samples by the arrival times; NaN until it can be told
    silent_s : seconds since the last valid frame, or since the start
    """

    bytes: int = 0
    frames: int = 0
    bad_checksum: int = 0
    bad_values: int = 0
    lost: int = 0
    garbage: int = 0
    reconnections: int = 0
    measured_hz: float = math.nan
    silent_s: float = 0.0


class Tap(Protocol):
    """Hears all that a reader reads and says, in the reader's thread; must not wait or raise."""

    def take(self, data: bytes, arrival: float) -> None:
        """Bytes of one read, before they are parsed; `arrival` on the monotonic clock."""
        ...

    def say(self, event: Event) -> None:
        """An event, as `Reader.drain` will bring it."""
        ...


class Reader:
    """Reads one port in one plain thread.

    Attributes
    ----------
    tap : hears everything from the next read on; any thread may set it or take it away

    Parameters
    ----------
    opener : opens the port, in the thread
    decoder : turns the bytes into events
    raw_log : stores the bytes before they are parsed; the reader closes it
    reopener : opens the port again, tried each second after it vanished; without it a vanished
        port ends the link
    """

    def __init__(
        self,
        opener: Opener,
        decoder: Decoder,
        raw_log: RawLog | None = None,
        reopener: Opener | None = None,
    ) -> None:
        self._opener = opener
        self._reopener = reopener
        self._decoder = decoder
        self._log = raw_log
        self._events: SimpleQueue[Event] = SimpleQueue()
        self._outgoing: SimpleQueue[bytes] = SimpleQueue()
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="calrig reader", daemon=True)
        self._transport: Transport | None = None
        self._state = LinkState.OPENING
        self._counters = Counters()
        self._last_frame = time.monotonic()
        self._rate = LinkRate()
        self._pauses = Pauses()
        self._next_index = 0
        self._shift = 0
        self._resuming = False
        self.tap: Tap | None = None

    def start(self) -> None:
        """Begin; a port that does not open says so as `Ended`."""
        self._last_frame = time.monotonic()
        self._thread.start()

    def drain(self) -> list[Event]:
        """Return the events since the last call; never waits. For one thread alone."""
        return [self._events.get() for _ in range(self._events.qsize())]

    def write(self, data: bytes) -> None:
        """Have bytes sent within some 50 ms."""
        self._outgoing.put(data)

    @property
    def counters(self) -> Counters:
        """What has come so far."""
        return replace(self._counters, silent_s=time.monotonic() - self._last_frame)

    @property
    def state(self) -> LinkState:
        """What the link is doing now."""
        state = self._state
        if state is LinkState.STREAMING:
            rate = self._decoder.rate
            periods = _NO_DATA_PERIODS / rate if rate > 0 else 0.0
            if time.monotonic() - self._last_frame > max(_NO_DATA_S, periods):
                return LinkState.NO_DATA
        return state

    @property
    def storage_error(self) -> StorageError | None:
        """Why the raw log does not hold the latest bytes; None while it does or there is none."""
        return self._log.error if self._log is not None else None

    def sync(self) -> None:
        """Wait until all bytes read so far are on the disk itself.

        Raises
        ------
        StorageError
            Some are not.
        """
        if self._log is not None:
            self._log.sync()

    def close(self) -> None:
        """Let go of the port and wait until the thread has ended; may be called again.

        Raises
        ------
        LinkError
            The driver does not let go of the port within 5 s.
        """
        self._stop.set()
        transport = self._transport
        if transport is not None:
            transport.cancel()
        if self._thread.ident is None or self._thread is threading.current_thread():
            return
        self._thread.join(_JOIN_S)
        if self._thread.is_alive():
            port = transport.port if transport is not None else "port"
            raise LinkError(port, "the driver does not let go of the port", "unplug the adapter")

    def _run(self) -> None:
        error: LinkError | None = None
        try:
            error = self._link()
        finally:
            fault = sys.exception()
            if fault is not None:
                error = LinkError("reader", f"stopped by an error inside the program: {fault!r}")
            if self._log is not None:
                self._log.close()
            self._state = LinkState.ENDED
            self._say(Ended(error))

    def _link(self) -> LinkError | None:
        """Read until the end, over as many openings as it takes; return why it ended."""
        opening = self._opener
        while True:
            try:
                self._session(opening())
            except LinkError as error:
                if self._state is LinkState.OPENING or self._reopener is None:
                    return error
                self._interrupted(error)
                opening = self._reopener
                if self._stop.wait(_RETRY_S):
                    return None
            else:
                return None

    def _session(self, transport: Transport) -> None:
        self._transport = transport
        try:
            if self._state is LinkState.RECONNECTING:
                self._reconnected()
            self._state = LinkState.WAITING
            self._pauses.begin()
            while not self._stop.is_set():
                self._send(transport)
                data = transport.read()
                self._look_at_clock(transport)
                self._take(data)
                while transport.patient and self._events.qsize() > _MOST_PENDING:
                    if self._stop.wait(_PATIENCE_S):
                        break
        except EndOfStream:
            pass
        finally:
            self._transport = None
            transport.close()
            self._pass_on(self._decoder.flush(), time.monotonic())

    def _look_at_clock(self, transport: Transport) -> None:
        """Tell of a pause of the program; a source that waits for its reader loses nothing."""
        pause = self._pauses.seconds()
        if not pause or transport.patient:
            return
        if self._log is not None:
            self._log.mark("paused", gap_s=pause)
        self._say(Message("paused", b"", {"gap_s": f"{pause:.3f}"}))

    def _send(self, transport: Transport) -> None:
        while not self._outgoing.empty():
            transport.write(self._outgoing.get())

    def _take(self, data: bytes) -> None:
        if not data:
            return
        arrival = time.monotonic()
        if self._log is not None:
            self._log.write(data, arrival)
        if (tap := self.tap) is not None:
            tap.take(data, arrival)
        self._counters = replace(self._counters, bytes=self._counters.bytes + len(data))
        self._pass_on(self._decoder.feed(data), arrival)

    def _pass_on(self, events: list[Event], arrival: float) -> None:
        if self._resuming:
            self._leave_gap(events, arrival)
        for event in events:
            shifted = _shifted(event, self._shift)
            if isinstance(shifted, SampleBlock):
                self._next_index = int(shifted.index[-1]) + 1
                self._last_frame = arrival
                self._state = LinkState.STREAMING
                self._rate.add(arrival, self._next_index)
            self._say(shifted)
        if self._rate.due(arrival):
            self._counters = replace(self._counters, measured_hz=self._rate.hz())

    def _say(self, event: Event) -> None:
        self._counters = _counted(self._counters, event)
        if (tap := self.tap) is not None:
            tap.say(event)
        self._events.put(event)

    def _interrupted(self, error: LinkError) -> None:
        if self._state is LinkState.RECONNECTING:
            return
        self._state = LinkState.RECONNECTING
        if self._log is not None:
            self._log.mark("link lost", why=error.why)
        self._say(Message("link lost", b"", {"why": error.why}))

    def _reconnected(self) -> None:
        gap = time.monotonic() - self._last_frame
        if self._log is not None:
            self._log.mark("reconnected", gap_s=gap)
        self._resuming = True
        self._counters = replace(self._counters, reconnections=self._counters.reconnections + 1)
        self._say(Message("reconnected", b"", {"gap_s": f"{gap:.3f}"}))

    def _leave_gap(self, events: list[Event], arrival: float) -> None:
        """Leave a gap in the sample numbers as long as the interruption was by the clock."""
        block = next((event for event in events if isinstance(event, SampleBlock)), None)
        if block is None:
            return
        self._resuming = False
        measured = self._counters.measured_hz
        rate = self._decoder.rate or (0.0 if math.isnan(measured) else measured)
        self._rate = LinkRate()
        expected = self._next_index - 1 + round((arrival - self._last_frame) * rate)
        missing = expected - (int(block.index[-1]) + self._shift)
        if missing > 0 and self._next_index:
            self._shift += missing
            self._say(Lost(missing, self._next_index + missing))


def _shifted(event: Event, shift: int) -> Event:
    """The same event with later sample numbers."""
    if shift and isinstance(event, SampleBlock):
        return replace(event, index=frozen_int(event.index + shift))
    if shift and isinstance(event, Lost):
        return replace(event, before=event.before + shift)
    return event


def _counted(now: Counters, event: Event) -> Counters:
    """The counters after one more event."""
    match event:
        case SampleBlock():
            return replace(now, frames=now.frames + len(event.index))
        case BadChecksum():
            return replace(now, bad_checksum=now.bad_checksum + event.count)
        case BadValues():
            return replace(now, bad_values=now.bad_values + event.count)
        case Lost():
            return replace(now, lost=now.lost + event.count)
        case Garbage():
            return replace(now, garbage=now.garbage + event.count)
        case Message() | Ended():
            return now
