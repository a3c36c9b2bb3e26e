"""Opening a record: samples by their numbers, gaps, marks; hours in seconds.

The samples stay in the file and are mapped, not read, until they are asked for. A raw log without
samples is decoded again by the profile in its header.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import cast

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FormatError, Note, Severity
from core.samples.block import Channel, SampleBlock
from drivers.decoders import make_decoder
from drivers.framing import Block, Damage, read_blocks
from drivers.profile import parse_profile
from drivers.rawlog import EVENT, Chunk, Mark, event_of, rawlog_header, read_rawlog
from drivers.recorder import DOUBLE, HEAD, SAMPLES, SINGLE
from drivers.spells import Spell, numbered, rate_of

SUFFIX = ".calrec"
_BLOCK_HEAD = 12
_CHUNK_ROWS = 1 << 16
_LAST_NUMBER = 1 << 53
_INTERRUPTIONS = ("link lost", "reconnected", "stopped", "resumed")

Values = NDArray[np.float32] | FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Stretch:
    """Samples without a gap between them.

    Parameters
    ----------
    first : number of the first
    data : (n, c) as they are stored
    """

    first: int
    data: Values

    @property
    def end(self) -> int:
        """Number after the last."""
        return self.first + len(self.data)


@dataclass(frozen=True, slots=True)
class Gap:
    """`count` samples that never came, numbered from `first` on."""

    first: int
    count: int


@dataclass(frozen=True, slots=True)
class RecordEvent:
    """Something that happened while recording.

    Parameters
    ----------
    number : of the sample that came next, or of the marked one
    kind : ``"mark"``, ``"lost"``, ``"link lost"``, ``"reconnected"``, ``"stopped"``, ...
    note : its words
    """

    number: int
    kind: str
    note: str


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """A record as it stands in its file.

    Parameters
    ----------
    path : the file
    header : what the writer said: device, port, profile, settings, start
    channels : (c,) columns
    rate : samples per second of one step of the numbers
    stretches : the samples, in the order of their numbers
    events : marks and interruptions
    ended : whether the record was ended in order, not by a crash or a power cut
    notes : doubts that arose on opening
    """

    path: Path
    header: Mapping[str, object]
    channels: tuple[Channel, ...]
    rate: float
    stretches: tuple[Stretch, ...]
    events: tuple[RecordEvent, ...] = ()
    ended: bool = True
    notes: tuple[Note, ...] = field(default=())

    def __len__(self) -> int:
        return sum(len(stretch.data) for stretch in self.stretches)

    @property
    def device(self) -> str:
        """Name of the device."""
        return str(self.header.get("device", ""))

    @property
    def settings(self) -> Mapping[str, object]:
        """What the operator had set; empty if nothing was stored."""
        found = self.header.get("settings")
        return cast(Mapping[str, object], found) if isinstance(found, dict) else {}

    @property
    def first(self) -> int:
        """Number of the first sample."""
        return self.stretches[0].first if self.stretches else 0

    @property
    def end(self) -> int:
        """Number after the last sample."""
        return self.stretches[-1].end if self.stretches else 0

    @property
    def seconds(self) -> float:
        """Time from the first sample to the end of the last."""
        return (self.end - self.first) / self.rate

    @property
    def marks(self) -> tuple[RecordEvent, ...]:
        """What the operator marked."""
        return tuple(event for event in self.events if event.kind == "mark")

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Where samples are missing."""
        return tuple(
            Gap(before.end, after.first - before.end)
            for before, after in zip(self.stretches, self.stretches[1:], strict=False)
            if after.first > before.end
        )

    def index(self) -> IntArray:
        """Numbers of all samples, (n,)."""
        parts = [np.arange(stretch.first, stretch.end) for stretch in self.stretches]
        return frozen_int(np.concatenate(parts) if parts else [])

    def column(self, channel: int) -> FloatArray:
        """All samples of one channel, (n,)."""
        out = np.empty(len(self))
        place = 0
        for stretch in self.stretches:
            with np.errstate(invalid="ignore"):  # a signalling NaN is a value like any other
                out[place : place + len(stretch.data)] = stretch.data[:, channel]
            place += len(stretch.data)
        out.flags.writeable = False
        return out

    def chunks(self, start: int | None = None, stop: int | None = None) -> Iterator[SampleBlock]:
        """Yield the samples numbered start to stop, without stop, in pieces of bounded size."""
        low = self.first if start is None else start
        high = self.end if stop is None else stop
        wanted: list[Stretch] = []
        rows = 0
        for stretch in self.stretches:
            begin, end = max(low, stretch.first), min(high, stretch.end)
            if begin >= end:
                continue
            data = stretch.data[begin - stretch.first : end - stretch.first]
            for at in range(0, len(data), _CHUNK_ROWS):
                part = Stretch(begin + at, data[at : at + _CHUNK_ROWS])
                wanted.append(part)
                rows += len(part.data)
                if rows >= _CHUNK_ROWS:
                    yield self._block(wanted)
                    wanted, rows = [], 0
        if wanted:
            yield self._block(wanted)

    def samples(
        self, start: int | None = None, stop: int | None = None
    ) -> tuple[IntArray, FloatArray]:
        """The samples numbered start to stop, without stop: numbers (n,), data (n, c)."""
        blocks = list(self.chunks(start, stop))
        if not blocks:
            return frozen_int([]), frozen(np.empty((0, len(self.channels))))
        return (
            frozen_int(np.concatenate([block.index for block in blocks])),
            frozen(np.concatenate([block.data for block in blocks])),
        )

    def _block(self, parts: list[Stretch]) -> SampleBlock:
        index = np.concatenate([np.arange(part.first, part.end) for part in parts])
        data = np.concatenate([part.data for part in parts])
        with np.errstate(invalid="ignore"):
            return SampleBlock(self.channels, frozen_int(index), frozen(data), self.rate)


def read_recording(path: Path, *, from_bytes: bool = False) -> Recording:
    """Open a record.

    Parameters
    ----------
    path : a record, or a raw log that was written without samples
    from_bytes : whether to decode the bytes again even if samples are there

    Raises
    ------
    FormatError
        It is no record, or holds no samples.
    """
    header = rawlog_header(path)
    scan = _Scan(path)
    scan.run()
    if scan.stretches and not from_bytes:
        channels = _channels(header, path)
        stated = header.get("rate_hz")
        rate = float(stated) if isinstance(stated, int | float) else 0.0
        stretches = tuple(scan.stretches)
    else:
        channels, rate, stretches = _decoded(path, header)
    if any(stretch.data.shape[1] != len(channels) for stretch in stretches):
        raise FormatError(path, f"its samples have not the {len(channels)} channels of its header")
    if not 0.0 < rate < math.inf:
        raise FormatError(path, "the rate of its samples is not known")
    return Recording(
        path,
        header,
        channels,
        rate,
        stretches,
        tuple(scan.events),
        scan.ended,
        scan.notes(),
    )


class _Scan:
    """One pass over the blocks of a file."""

    def __init__(self, path: Path) -> None:
        self.stretches: list[Stretch] = []
        self.events: list[RecordEvent] = []
        self.ended = False
        self._path = path
        self._mapped: NDArray[np.uint8] = np.memmap(path, dtype=np.uint8, mode="r").view(np.ndarray)
        self._damaged: list[Damage] = []
        self._refused = 0

    def run(self) -> None:
        """Look at every block."""
        for block in read_blocks(self._path):
            if isinstance(block, Damage):
                self._damaged.append(block)
            elif block.tag == SAMPLES:
                self._take(block)
            elif block.tag == EVENT:
                self._note(block)

    def notes(self) -> tuple[Note, ...]:
        """Doubts."""
        notes: list[Note] = []
        size = self._mapped.size
        inside = [one for one in self._damaged if one.offset + one.count < size]
        if inside:
            count = sum(one.count for one in inside)
            text = f"{count} bytes inside the file are damaged; what they held is a gap."
            notes.append(Note(Severity.WARNING, "damaged", text))
        if len(inside) < len(self._damaged):
            text = "The file ends within a block, as after a power cut; all before it is whole."
            notes.append(Note(Severity.INFO, "torn_tail", text))
        if self._refused:
            text = f"{self._refused} bytes found no room on the disk while recording."
            notes.append(Note(Severity.WARNING, "not_stored", text))
        return tuple(notes)

    def _take(self, block: Block) -> None:
        if len(block.payload) < HEAD.size:
            self._damaged.append(block.as_damage())
            return
        first, rows, columns, item = cast(
            tuple[int, int, int, int], HEAD.unpack_from(block.payload)
        )
        size = rows * columns * item
        end = self.stretches[-1].end if self.stretches else first
        fits = size == len(block.payload) - HEAD.size and item in (SINGLE, DOUBLE)
        if not fits or not rows or not end <= first <= _LAST_NUMBER - rows:
            self._damaged.append(block.as_damage())
            return
        begin = block.offset + _BLOCK_HEAD + HEAD.size
        values = self._mapped[begin : begin + size]
        data = values.view("<f4" if item == SINGLE else "<f8").reshape(rows, columns)
        self.stretches.append(Stretch(first, data))

    def _note(self, block: Block) -> None:
        mark = event_of(block.payload)
        if mark is None:
            self._damaged.append(block.as_damage())
            return
        end = self.stretches[-1].end if self.stretches else 0
        fields = mark.fields
        if mark.kind == "not stored":
            self._refused += _whole(fields.get("count"), 0)
        self.ended = mark.kind == "ended"
        number = _whole(fields.get("number", fields.get("before")), end)
        note = str(fields.get("note", fields.get("why", "")))
        self.events.append(RecordEvent(number, mark.kind, note))


def _whole(found: object, otherwise: int) -> int:
    """A whole number that an event tells."""
    if isinstance(found, int) and abs(found) <= _LAST_NUMBER:
        return int(found)
    return otherwise


def _channels(header: Mapping[str, object], path: Path) -> tuple[Channel, ...]:
    found = header.get("channels")
    rows = cast(list[object], found) if isinstance(found, list) else []
    if not rows or not all(isinstance(row, dict) for row in rows):
        raise FormatError(path, "the header names no channels")
    return tuple(
        Channel(str(row.get("name", "")), str(row.get("unit", "")), str(row.get("role", "")))
        for row in cast(list[Mapping[str, object]], rows)
    )


def _decoded(
    path: Path, header: Mapping[str, object]
) -> tuple[tuple[Channel, ...], float, tuple[Stretch, ...]]:
    """Decode the bytes of a log: channels, rate, samples."""
    text = header.get("profile_text")
    if not isinstance(text, str) or not text:
        raise FormatError(path, "holds no samples, and no profile that its bytes could be read by")
    decoder = make_decoder(parse_profile(text, f"{path}: profile"))
    spells = [Spell()]
    for part in read_rawlog(path):
        if isinstance(part, Chunk):
            spells[-1].take(decoder.feed(part.data), part.t)
        elif isinstance(part, Mark) and part.kind in _INTERRUPTIONS and spells[-1].blocks:
            spells[-1].take(decoder.flush(), spells[-1].last_t)
            spells.append(Spell())
    spells[-1].take(decoder.flush(), spells[-1].last_t)
    spells = [spell for spell in spells if spell.blocks]
    if not spells:
        raise FormatError(path, "its bytes hold no samples")
    rate = decoder.rate or rate_of(spells)
    if len(spells) > 1 and not rate > 0.0:
        raise FormatError(path, "was interrupted, and too little came to tell how long by")
    blocks = numbered(spells, rate)
    channels = blocks[-1].channels
    blocks = [block for block in blocks if block.channels == channels]
    stretches: list[Stretch] = []
    for block in blocks:
        breaks = (np.flatnonzero(np.diff(block.index) > 1) + 1).tolist()
        for start, stop in zip([0, *breaks], [*breaks, len(block.index)], strict=True):
            stretches.append(Stretch(int(block.index[start]), block.data[start:stop]))
    return channels, rate, tuple(stretches)
