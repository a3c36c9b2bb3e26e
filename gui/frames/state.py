"""What the tab Teach a board shows."""

from dataclasses import dataclass

from drivers.ports import PortInfo
from drivers.teach.rows import Part, SheetRow


@dataclass(frozen=True, slots=True)
class FieldRow:
    """One number of the board.

    Parameters
    ----------
    name, unit, role : of its channel
    place : its bytes, or its column, in words
    type, endian : of a binary number; empty for a column of text
    scale, offset : value = number * scale + offset
    hide : read, but no channel
    hint : what it looks like, in words
    """

    name: str
    unit: str
    role: str
    place: str
    type: str
    endian: str
    scale: float
    offset: float
    hide: bool
    hint: str = ""


@dataclass(frozen=True, slots=True)
class Reading:
    """A meaning of a length byte: its words, and the whole length that follows."""

    text: str
    length: int
    fits: bool


@dataclass(frozen=True, slots=True)
class SourceState:
    """Where the bytes come from.

    Parameters
    ----------
    ports : what can be chosen
    url, baud : port and speed
    listening : whether the port is open
    file : name of the file instead; empty for none
    heard : how much has come, in words
    busy : what a worker does; empty for nothing
    held : whether the picture stands still
    """

    ports: tuple[PortInfo, ...] = ()
    url: str = ""
    baud: int = 115200
    listening: bool = False
    file: str = ""
    heard: str = ""
    busy: str = ""
    held: bool = False


@dataclass(frozen=True, slots=True)
class FramesState:
    """All but where the bytes come from, the bytes, and the live values.

    Parameters
    ----------
    verdict : what was found, in a sentence
    sure : whether that is beyond doubt
    binary : whether header, length and checksum mean anything
    sync, length : of the frames; empty and 0 while unknown
    checks : the checksums that fit, in words; the last one is none
    check : which of them is taken
    readings : of bytes that may tell the length
    fields : the numbers
    field : which one is being edited; -1 for none
    selection : first byte, and the one after the last, of the columns pointed at
    name, kind, hz : of the device file
    doubt : why it cannot be saved; empty if it can
    saved : the file, once it stands there; empty else
    """

    verdict: str = ""
    sure: bool = False
    binary: bool = True
    sync: str = ""
    length: int = 0
    checks: tuple[str, ...] = ()
    check: int = -1
    readings: tuple[Reading, ...] = ()
    fields: tuple[FieldRow, ...] = ()
    field: int = -1
    selection: tuple[int, int] | None = None
    name: str = ""
    kind: str = "imu"
    hz: float = 0.0
    doubt: str = "Nothing is described yet"
    saved: str = ""


@dataclass(frozen=True, slots=True)
class Named:
    """A part of a frame with its name, and the number of its colour; -1 for none of its own."""

    part: Part
    name: str
    colour: int


@dataclass(frozen=True, slots=True)
class BytesState:
    """The bytes in rows.

    Parameters
    ----------
    rows : the latest ones
    parts : of a whole frame
    width : bytes of the widest row
    text : whether the bytes are letters
    """

    rows: tuple[SheetRow, ...] = ()
    parts: tuple[Named, ...] = ()
    width: int = 16
    text: bool = False


@dataclass(frozen=True, slots=True)
class Live:
    """The latest value of a number as text, and its course for a small chart."""

    value: str
    course: tuple[float, ...]
