"""The samples on the screen: live, of the running record, or of one from the disk."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import FloatArray, IntArray
from core.samples.block import Channel, SampleBlock
from drivers.recording import Recording
from gui.widgets.history import History
from gui.widgets.strip_view import Interval, Mark

WATCH_S = 600.0
"""What is only watched is forgotten after so long."""
_KEPT_S = 60.0
_PIECE = 1 << 16


@dataclass(slots=True)
class Trace:
    """A history with what the operator put on it.

    Parameters
    ----------
    history : the samples
    name : of the record; empty for what is only watched
    marks : sample number and note
    intervals : chosen stretches, s
    """

    history: History
    name: str = ""
    marks: list[tuple[int, str]] = field(default_factory=list)
    intervals: list[Interval] = field(default_factory=list)

    @property
    def channels(self) -> tuple[Channel, ...]:
        """The columns."""
        return self.history.channels

    @property
    def seconds(self) -> float:
        """Length."""
        return self.history.seconds(self.history.end) if self.history.end else 0.0

    @property
    def newest(self) -> int:
        """Number of the last sample."""
        return self.history.end - 1

    def feed(self, block: SampleBlock, first: int | None = None, stop: int | None = None) -> None:
        """Take samples, those numbered first to stop where these are given."""
        history = self.history
        low = history.end if history.end else int(block.index[0]) if len(block.index) else 0
        chosen = block.index >= (low if first is None else max(low, first))
        if stop is not None:
            chosen &= block.index < stop
        history.append(block.index[chosen], block.data[chosen])

    def shorten(self) -> bool:
        """Forget all but the last minute of what has been watched too long; whether it did."""
        if self.name or self.seconds < WATCH_S:
            return False
        history, old = History(self.channels, self.history.rate), self.history
        history.append(*old.samples(old.end - round(_KEPT_S * old.rate), old.end))
        self.history = history
        self.intervals.clear()
        return True

    def shown_marks(self) -> tuple[Mark, ...]:
        """Marks by time, s."""
        return tuple(Mark(self.history.seconds(number), note) for number, note in self.marks)

    def chosen(self, a: float | None, b: float | None) -> list[tuple[float, float]]:
        """Stretches to average or export: selected intervals, else A to B, else everything."""
        picked = [(one.start, one.stop) for one in self.intervals if one.selected]
        if picked:
            return picked
        if a is not None and b is not None and a != b:
            return [(min(a, b), max(a, b))]
        return [(0.0, self.seconds)]

    def excerpt(self, stretches: list[tuple[float, float]]) -> "Excerpt":
        """Samples of stretches of time, s, as they are now."""
        history = self.history
        ranges = (
            (history.number(start), min(history.end, history.number(stop)))
            for start, stop in stretches
        )
        return Excerpt(history, tuple(ranges))

    def select_all(self, on: bool) -> None:
        """Select every interval, or none; without any, select everything as one."""
        if on and not self.intervals:
            self.intervals.append(Interval(0.0, self.seconds, "1", True))
        self.intervals[:] = [replace(one, selected=on) for one in self.intervals]

    def add_interval(self, start: float, stop: float) -> None:
        """Select one more stretch."""
        start, stop = max(0.0, start), min(self.seconds, stop)
        if stop > start:
            self.intervals.append(Interval(start, stop, f"{len(self.intervals) + 1}", True))


@dataclass(frozen=True, slots=True)
class Excerpt:
    """Stretches of a history that a worker may read while the history grows.

    Parameters
    ----------
    history : the samples; what has been appended never changes
    ranges : numbers of the first sample and after the last one of each stretch
    """

    history: History
    ranges: tuple[tuple[int, int], ...]

    @property
    def first(self) -> int:
        """Number of the first sample, from which times are counted."""
        return self.ranges[0][0] if self.ranges else 0

    @property
    def count(self) -> int:
        """Most samples that can be in it."""
        return sum(max(0, stop - start) for start, stop in self.ranges)

    def pieces(self) -> Iterator[tuple[IntArray, FloatArray]]:
        """Numbers (n,) and data (n, c), in pieces of bounded size."""
        for start, stop in self.ranges:
            for begin in range(start, stop, _PIECE):
                yield self.history.samples(begin, min(begin + _PIECE, stop))

    def samples(self) -> tuple[IntArray, FloatArray]:
        """All at once: numbers (n,), data (n, c)."""
        index = np.empty(self.count, dtype=np.int64)
        data = np.empty((self.count, len(self.history.channels)))
        place = 0
        for numbers, values in self.pieces():
            end = place + len(numbers)
            index[place:end], data[place:end] = numbers, values
            place = end
        return index[:place], data[:place]


def trace_of(record: Recording) -> Trace:
    """A record as a trace; takes seconds for hours of samples."""
    history = History(record.channels, record.rate)
    for block in record.chunks():
        history.append(block.index, block.data)
    marks = [
        (event.number, event.note or event.kind)
        for event in record.events
        if event.kind in ("mark", "link lost", "stopped")
    ]
    return Trace(history, record.path.name, marks)
