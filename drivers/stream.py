"""The common way from found frames to events; what differs between decoders is a few methods."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from operator import itemgetter

import numpy as np

from core.arrays import FloatArray, IntArray
from core.samples.block import Channel, SampleBlock
from drivers.columns import Columns
from drivers.counter import SampleCounter
from drivers.events import BadChecksum, BadValues, Event, Garbage, Message
from drivers.finder import FrameFinder
from drivers.shape import Batch, BoolArray, ByteArray, Shape

_PIECE = 1 << 18


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """How the frames of one kind hold their values.

    Parameters
    ----------
    channels : (c,) what the columns are; empty for frames that hold no sample
    values : (n, length) uint8 -> (n, c) float64
    counts : (n, length) uint8 -> (n,) counter, -1 for none; None where these frames have none
    same : bytes of the header by which a frame is known to have this layout; (m,) places and
        (m,) values
    message : event of a frame that holds no sample
    """

    channels: tuple[Channel, ...]
    values: Callable[[ByteArray], FloatArray]
    counts: Callable[[ByteArray], IntArray] | None
    same: tuple[IntArray, ByteArray]
    message: Callable[[bytes], Message] | None = None


class StreamDecoder(ABC):
    """Bytes to events, for streams whose frames a `Shape` can describe.

    The columns of the samples are the channels of all layouts met so far, in the order in which
    they came; a sample whose frame does not hold a channel has NaN there.

    Parameters
    ----------
    shape : what the frames look like
    counter : numbers the samples
    nominal_hz : declared samples per second, 0 if unknown
    expected : columns until the first frame tells
    """

    def __init__(
        self,
        shape: Shape,
        counter: SampleCounter,
        nominal_hz: float,
        expected: tuple[Channel, ...] = (),
    ) -> None:
        self._finder = FrameFinder(shape)
        self._counter = counter
        self._nominal_hz = nominal_hz
        self._columns = Columns(expected)

    @property
    def channels(self) -> tuple[Channel, ...]:
        """The columns of the next block; may grow while the device is being heard."""
        return self._columns.channels

    @property
    def rate(self) -> float:
        """Samples per second of one step of the index; 0 while unknown."""
        return self._nominal_hz

    @property
    def carried(self) -> int:
        """Bytes that wait for more."""
        return self._finder.carried

    def feed(self, data: bytes) -> list[Event]:
        """Return what these bytes complete; any bytes are allowed."""
        events: list[Event] = []
        for begin in range(0, len(data), _PIECE):
            self._convert(self._finder.push(data[begin : begin + _PIECE]), events)
        return events

    def flush(self) -> list[Event]:
        """Return what is left when nothing more will come."""
        events: list[Event] = []
        self._convert(self._finder.finish(), events)
        return events

    @abstractmethod
    def layout(self, frame: bytes) -> Layout:
        """Return the layout of a frame, always the same object for the same layout."""

    def apart(self, batch: Batch) -> BoolArray | None:
        """Return which frames change how the later ones are read; None where there are none."""
        del batch

    def apply(self, frame: bytes) -> Event:
        """Take over what such a frame says."""
        raise NotImplementedError(frame)

    def accept(self, data: FloatArray) -> BoolArray | None:
        """Return which samples are possible; None for all."""
        del data

    def _convert(self, batch: Batch, events: list[Event]) -> None:
        if batch.garbage:
            events.append(Garbage(batch.garbage, batch.sample))
        if batch.bad:
            events.append(BadChecksum(batch.bad))
        total = len(batch.starts)
        if not total:
            return
        apart = self.apart(batch)
        begin = 0
        for single in np.flatnonzero(apart).tolist() if apart is not None else ():
            self._samples(batch, begin, single, events)
            events.append(self.apply(self._frame(batch, single)))
            begin = single + 1
        self._samples(batch, begin, total, events)

    @staticmethod
    def _frame(batch: Batch, position: int) -> bytes:
        start = int(batch.starts[position])
        return batch.buffer[start : start + int(batch.lengths[position])].tobytes()

    def _samples(self, batch: Batch, begin: int, end: int, events: list[Event]) -> None:
        """Convert frames `begin` to `end`; a block ends where a new channel appears."""
        while begin < end:
            begin = self._block(batch, begin, end, events)

    def _block(self, batch: Batch, begin: int, end: int, events: list[Event]) -> int:
        first = self.layout(self._frame(batch, begin))
        self._columns.take(first.channels)
        groups: list[tuple[Layout, IntArray]] = []
        left = np.arange(begin, end)
        layout = first
        while True:
            mine = self._alike(batch, left, layout)
            groups.append((layout, left[mine]))
            left = left[~mine]
            if not len(left):
                break
            layout = self.layout(self._frame(batch, int(left[0])))
            if self._columns.lack(layout.channels):
                end = int(left[0])
                groups = [(known, where[where < end]) for known, where in groups]
                break
        self._emit(batch, begin, end, groups, events)
        return end

    def _alike(self, batch: Batch, frames: IntArray, layout: Layout) -> BoolArray:
        """Return which frames have this layout; the first one does."""
        places, values = layout.same
        if not len(places):
            return np.ones(len(frames), dtype=np.bool_)
        lengths = batch.lengths[frames]
        alike = lengths == lengths[0]
        found = batch.buffer[batch.starts[frames[alike], None] + places]
        alike[alike] = (found == values).all(axis=1)
        return alike

    def _emit(
        self, batch: Batch, begin: int, end: int, groups: list[tuple[Layout, IntArray]],
        events: list[Event],
    ) -> None:  # fmt: skip
        """Turn frames into messages and one block; only the block's place among them is lost."""
        said: list[tuple[int, Event]] = [
            (position, layout.message(self._frame(batch, position)))
            for layout, where in groups
            if layout.message is not None
            for position in where.tolist()
        ]
        holds = [(layout, where) for layout, where in groups if layout.channels and len(where)]
        block: SampleBlock | None = None
        if holds:
            frames = np.arange(begin, end)
            if len(holds) < len(groups):
                frames = np.sort(np.concatenate([where for _, where in holds]))
            data, counts = self._values(batch, frames, holds)
            index, counted = self._counter.number(counts, self._losses(batch, frames))
            said.extend((int(frames[row]), event) for row, event in counted)
            block = self._possible(data, index, events)
        events.extend(event for _, event in sorted(said, key=itemgetter(0)))
        if block is not None:
            events.append(block)

    def _possible(
        self, data: FloatArray, index: IntArray, events: list[Event]
    ) -> SampleBlock | None:
        """Return the block of the samples that are possible, and count the others."""
        possible = self.accept(data)
        if possible is not None and not possible.all():
            events.append(BadValues(int(np.count_nonzero(~possible))))
            data, index = data[possible], index[possible]
        data.flags.writeable = index.flags.writeable = False
        return SampleBlock(self.channels, index, data, self.rate) if len(data) else None

    def _values(
        self, batch: Batch, frames: IntArray, groups: list[tuple[Layout, IntArray]]
    ) -> tuple[FloatArray, IntArray | None]:
        if len(groups) == 1 and groups[0][0].channels == self.channels:
            layout = groups[0][0]
            rows = batch.rows(frames, int(batch.lengths[frames].min()))
            return layout.values(rows), None if layout.counts is None else layout.counts(rows)
        data = np.full((len(frames), len(self.channels)), np.nan)
        counts = np.full(len(frames), -1)
        for layout, where in groups:
            rows = batch.rows(where, int(batch.lengths[where].min()))
            at = np.searchsorted(frames, where)
            data[at[:, None], self._columns.places(layout.channels)] = layout.values(rows)
            if layout.counts is not None:
                counts[at] = layout.counts(rows)
        return data, counts

    def _losses(self, batch: Batch, frames: IntArray) -> IntArray:
        """Return how many samples the garbage before each frame may have been."""
        gaps, lengths = batch.gaps[frames], batch.lengths[frames]
        return (gaps + lengths // 2) // lengths
