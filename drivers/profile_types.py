"""What the sections of a device file hold, as frozen dataclasses."""

from collections.abc import Mapping
from dataclasses import dataclass

from core.samples.block import Channel
from drivers.checksums import ChecksumSpec

TYPES: Mapping[str, int] = {
    "u8": 1, "i8": 1, "u16": 2, "i16": 2, "u24": 3, "i24": 3,
    "u32": 4, "i32": 4, "u64": 8, "f32": 4, "f64": 8,
}  # fmt: skip
"""Field types and their bytes."""


@dataclass(frozen=True, slots=True)
class DeviceSection:
    """Name, kind, notes, and the old program whose dividing-head session the device takes."""

    name: str
    kind: str
    layout: str
    notes: str


@dataclass(frozen=True, slots=True)
class PortSettings:
    """How to open the port.

    Parameters
    ----------
    bauds : the default first, the rest in the order of scanning
    data_bits, parity, stop_bits : from ``"8N1"``; parity ``"N"``, ``"E"`` or ``"O"``
    settle_ms : silence to expect after opening
    dtr, rts : levels of the two lines
    """

    bauds: tuple[int, ...]
    data_bits: int
    parity: str
    stop_bits: int
    settle_ms: int
    dtr: bool
    rts: bool


@dataclass(frozen=True, slots=True)
class FieldSpec:
    """Neighbouring values of one type in a frame: ``value = raw * scale + offset``.

    Parameters
    ----------
    channels : one channel a value
    type : one of `TYPES`
    at : byte of the first value in the frame
    scale, offset, endian : how the raw number becomes the value
    bits : lowest and highest bit where the value is only a part of the number; else None
    hide : whether it stays out of the samples
    """

    channels: tuple[Channel, ...]
    type: str
    at: int
    scale: float = 1.0
    offset: float = 0.0
    endian: str = "little"
    bits: tuple[int, int] | None = None
    hide: bool = False

    @property
    def end(self) -> int:
        """First byte after the values."""
        return self.at + TYPES[self.type] * len(self.channels)


@dataclass(frozen=True, slots=True)
class LengthSpec:
    """A length field: whole length = value * `mul` + `add`, between `low` and `high`."""

    at: int
    size: int
    endian: str
    add: int
    mul: int
    low: int
    high: int


@dataclass(frozen=True, slots=True)
class CounterSpec:
    """The device's counter: `bits` wide, `step` a sample; None means that the step is learned."""

    field: str
    bits: int
    step: int | None


@dataclass(frozen=True, slots=True)
class FrameSpec:
    """Binary frames of one kind.

    Parameters
    ----------
    sync : the first bytes; None for any byte
    length : whole length, or the field that tells it
    endian : byte order where a field does not say
    checksum : None where the frame has none
    counter : None where the frame has none
    reject_abs : frames with a value at or above it are refused; infinite for none
    tail : bytes that may stand between frames and belong to neither
    fields : in the order of the file
    """

    sync: tuple[int | None, ...]
    length: int | LengthSpec
    endian: str
    checksum: ChecksumSpec | None
    counter: CounterSpec | None
    reject_abs: float
    tail: bytes
    fields: tuple[FieldSpec, ...]

    @property
    def shortest(self) -> int:
        """Bytes of the shortest frame."""
        return self.length if isinstance(self.length, int) else self.length.low


@dataclass(frozen=True, slots=True)
class LineSpec:
    """Text lines of one kind.

    Parameters
    ----------
    prefix, suffix : text that every sample line begins and ends with
    delimiter : ``","``, ``";"``, ``"tab"``, ``"ws"`` (blanks and tabs) or ``"auto"``
    decimal : ``"."`` or ``","``
    end : bytes that end a line; a carriage return before a line feed is always dropped
    style : ``"values"``, ``"labels"`` (name:value) or ``"json"`` (one object a line)
    channels : the columns; empty where the device decides
    scales, offsets : ``value = number * scale + offset``
    digits : decimal places that the device prints
    checksum : whether lines carry NMEA's ``*HH``
    counter : None where no column counts samples
    """

    prefix: str
    suffix: str
    delimiter: str
    decimal: str
    end: str
    style: str
    channels: tuple[Channel, ...]
    scales: tuple[float, ...]
    offsets: tuple[float, ...]
    digits: int
    checksum: bool
    counter: CounterSpec | None


@dataclass(frozen=True, slots=True)
class ProtocolSpec:
    """A decoder class and what it is told."""

    name: str
    options: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class Capture:
    """A piece of a binary reply: `size` bytes from `at`, as ``"ascii"``, ``"hex"`` or a number."""

    at: int
    type: str
    size: int
    endian: str


@dataclass(frozen=True, slots=True)
class Command:
    """Something to send.

    Parameters
    ----------
    data : the bytes, with their checksum
    repeat, gap_ms : how often, and the pause between
    wait_ms : how long to wait for the answer
    expect : regular expression of a text answer with named groups ``serial``, ``model``,
        ``firmware``; empty for none
    expect_bytes : first bytes of a binary answer; empty for none
    capture : pieces of the binary answer by name
    """

    name: str
    data: bytes
    repeat: int
    gap_ms: int
    wait_ms: int
    expect: str
    expect_bytes: bytes
    capture: Mapping[str, Capture]
