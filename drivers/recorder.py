"""Records a link: bytes and samples into one file, in a thread of its own.

The file is a raw log (`drivers.rawlog`) whose header also tells channels, rate and settings, with
one more tag:

``BLK0``
    i64 number of the first sample, u32 samples n, u16 channels c, u16 bytes of a value (4 or 8),
    then n * c values row by row: float32 where the device sends float32, else float64.

Within a block no sample is missing; a gap is a step between blocks, and is told by an event
``"lost"``. Bytes of about a quarter of a second make one ``RAW0`` with the arrival of the first.
Further events: ``"mark"`` with ``number`` and ``note``, ``"stopped"`` and ``"resumed"`` by the
operator, ``"ended"`` with the counts of the whole record.
"""

import contextlib
import struct
import sys
import threading
import time
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from queue import Empty, SimpleQueue

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import StorageError
from core.records.cvgcom_writer import CvgcomWriter
from core.samples.block import Channel, SampleBlock
from drivers.events import BadChecksum, BadValues, Ended, Event, Garbage, Lost, Message
from drivers.framing import Header
from drivers.profile import Profile
from drivers.profile_types import FrameSpec
from drivers.rawlog import WITH_SAMPLES, RawLog

SAMPLES = b"BLK0"
HEAD = struct.Struct("<qIHH")
SINGLE, DOUBLE = 4, 8

_FLUSH_S = 0.2
_FLUSH_BYTES = 4 << 20
_JOIN_S = 10.0


@dataclass(frozen=True, slots=True)
class RecordLayout:
    """What the samples of a record are.

    Parameters
    ----------
    channels : (c,) columns
    rate : samples per second
    item : bytes of a stored value, `SINGLE` or `DOUBLE`
    """

    channels: tuple[Channel, ...]
    rate: float
    item: int = DOUBLE


@dataclass(frozen=True, slots=True)
class _Bytes:
    data: bytes
    arrival: float


@dataclass(frozen=True, slots=True)
class _Note:
    kind: str
    fields: Mapping[str, str | float]


class _Turn:
    """Puts what has come on the disk; the last one ends the thread."""

    def __init__(self, *, last: bool = False) -> None:
        self.last = last
        self.done = threading.Event()


def wire_item(profile: Profile) -> int:
    """Bytes that a value needs to be stored without loss."""
    stream = profile.stream
    if not isinstance(stream, FrameSpec):
        return DOUBLE
    plain = all(
        field.type == "f32" and field.scale == 1.0 and field.offset == 0.0
        for field in stream.fields
        if not field.hide
    )
    return SINGLE if plain else DOUBLE


class Recorder:
    """Writes what a reader hears; give it to `Reader.tap`.

    Parameters
    ----------
    path : must not exist yet
    header : device, port, profile text, settings
    layout : channels, rate and size of values
    text : CVGCom's file that is written beside it, or None

    Raises
    ------
    StorageError
        The file cannot be made.
    """

    def __init__(
        self, path: Path, header: Header, layout: RecordLayout, text: CvgcomWriter | None = None
    ) -> None:
        self.path = path
        self.text_error: StorageError | None = None
        """Why CVGCom's file ends early; None while it does not."""
        self._layout = layout
        self._type = np.dtype("<f4" if layout.item == SINGLE else "<f8")
        columns = [{"name": c.name, "unit": c.unit, "role": c.role} for c in layout.channels]
        whole = {**header, "channels": columns, "rate_hz": layout.rate, "item": layout.item}
        self._log = RawLog(path, whole, WITH_SAMPLES)
        self._text = text
        self._queue: SimpleQueue[_Bytes | _Note | _Turn | Event] = SimpleQueue()
        self._held = False
        self.first: int | None = None
        """Number of the first sample taken since the start or the last `go_on`."""
        self.next = 0
        """Number after the last sample taken."""
        self._bytes: list[_Bytes] = []
        self._blocks: list[SampleBlock] = []
        self._counts: Counter[str] = Counter()
        self._flushed, self._gathered = time.monotonic(), 0
        self._end: _Turn | None = None
        self._fault: StorageError | None = None
        self._thread = threading.Thread(target=self._run, name="calrig recorder", daemon=True)
        self._thread.start()

    # For the reader's thread.

    def take(self, data: bytes, arrival: float) -> None:
        """Bytes of one read."""
        if not self._held:
            self._queue.put(_Bytes(data, arrival))

    def say(self, event: Event) -> None:
        """An event; samples, losses and interruptions are kept."""
        if self._held:
            return
        if isinstance(event, SampleBlock) and len(event.index):
            if self.first is None:
                self.first = int(event.index[0])
            self.next = int(event.index[-1]) + 1
        self._queue.put(event)

    # For any thread.

    @property
    def error(self) -> StorageError | None:
        """Why the latest samples are not stored; None while all are."""
        return self._fault or self._log.error

    @property
    def closed(self) -> bool:
        """Whether the file has been closed: nothing more comes to it, and `error` is final."""
        return not self._thread.is_alive()

    @property
    def count(self) -> int:
        """Samples taken so far."""
        return self._counts["samples"]

    @property
    def held(self) -> bool:
        """Whether the record is stopped and waits."""
        return self._held

    def mark(self, number: int, note: str) -> None:
        """Note an event at a sample number."""
        self._queue.put(_Note("mark", {"number": number, "note": note}))

    def hold(self) -> None:
        """Stop; the file stays open for `go_on`."""
        if not self._held:
            self._held = True
            self._queue.put(_Note("stopped", {}))
            self._queue.put(_Turn())

    def go_on(self) -> None:
        """Go on after `hold`; what came meanwhile is a gap."""
        if self._held:
            self._queue.put(_Note("resumed", {}))
            self.first = None
            self._held = False

    def flush(self, seconds: float = _JOIN_S) -> bool:
        """Wait until what has come so far is on the disk; return whether it is."""
        turn = _Turn()
        self._queue.put(turn)
        return turn.done.wait(seconds) and self.error is None

    def end(self) -> None:
        """Have the file ended and closed without waiting for it; may be called again."""
        if self._end is None:
            self._held = True
            self._end = _Turn(last=True)
            self._queue.put(self._end)

    def close(self) -> None:
        """End the file and wait for it; may be called again."""
        self.end()
        self._thread.join(_JOIN_S)
        if self._thread.is_alive():
            self._fault = StorageError(
                f"{self.path}: the disk has not taken the end of the record for {_JOIN_S:g} s"
            )

    # For the recorder's own thread.

    def _run(self) -> None:
        try:
            self._work()
        finally:
            fault = sys.exception()
            if fault is not None:
                self._held = True
                self._fault = StorageError(
                    f"{self.path}: the recorder was stopped by an error inside the program"
                    f" ({fault!r}); what it had stored before is whole: start a new record"
                )
                self._log.close()

    def _work(self) -> None:
        while True:
            try:
                item = self._queue.get(timeout=_FLUSH_S)
            except Empty:
                self._flush()
                continue
            if isinstance(item, _Turn):
                self._turn(item)
                if item.last:
                    return
            else:
                self._accept(item)
                due = time.monotonic() - self._flushed >= _FLUSH_S
                if due or self._gathered >= _FLUSH_BYTES:
                    self._flush()

    def _turn(self, turn: _Turn) -> None:
        self._flush()
        if turn.last:
            self._log.mark("ended", **self._counts)
            self._log.close()
            self._write_text(None)
        else:
            # The log keeps the error until its bytes are stored.
            with contextlib.suppress(StorageError):
                self._log.sync()
        turn.done.set()

    def _accept(self, item: "_Bytes | _Note | Event") -> None:
        match item:
            case _Bytes():
                self._bytes.append(item)
                self._gathered += len(item.data)
            case SampleBlock():
                self._samples(item)
            case _Note():
                self._flush()
                self._log.mark(item.kind, **item.fields)
            case Lost():
                self._counts["lost"] += item.count
                self._flush()
                self._log.mark("lost", count=item.count, before=item.before)
            case Message(kind="link lost" | "reconnected" | "paused"):
                self._flush()
                self._log.mark(item.kind, **item.fields)
            case Ended():
                self._flush()
                self._log.mark("link ended", why=str(item.error or ""))
            case BadChecksum() | BadValues() | Garbage():
                self._counts[type(item).__name__] += item.count
            case Message():
                self._counts["messages"] += 1

    def _samples(self, block: SampleBlock) -> None:
        if block.channels == self._layout.channels:
            self._blocks.append(block)
            self._gathered += block.data.nbytes
            self._counts["samples"] += len(block.index)
            return
        if not self._counts["other channels"]:
            names = ", ".join(channel.name for channel in block.channels)
            self._log.mark("other channels", names=names)
        self._counts["other channels"] += len(block.index)

    def _flush(self) -> None:
        self._flushed, self._gathered = time.monotonic(), 0
        if self._bytes:
            data = b"".join(part.data for part in self._bytes)
            self._log.write(data, self._bytes[0].arrival)
            self._bytes.clear()
        if self._blocks:
            index = np.concatenate([block.index for block in self._blocks])
            data = np.concatenate([block.data for block in self._blocks])
            self._blocks.clear()
            self._store(index, data)
            self._write_text((index, data))

    def _store(self, index: IntArray, data: FloatArray) -> None:
        """One block for each stretch without a gap."""
        breaks = (np.flatnonzero(np.diff(index) > 1) + 1).tolist()
        channels, item = len(self._layout.channels), self._layout.item
        for start, stop in zip([0, *breaks], [*breaks, len(index)], strict=True):
            head = HEAD.pack(int(index[start]), stop - start, channels, item)
            self._log.append(SAMPLES, head + data[start:stop].astype(self._type).tobytes())

    def _write_text(self, samples: tuple[IntArray, FloatArray] | None) -> None:
        """Samples into CVGCom's file, or its end; a fault of it never harms the record."""
        if self._text is None:
            return
        try:
            if samples is None:
                self._text.close()
            else:
                self._text.feed(*samples)
        except StorageError as error:
            self.text_error = error
            self._text = None
