"""Rows, live values and small charts of the latest bytes; no Qt."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.samples.block import SampleBlock
from drivers.fields import read_raw
from drivers.line import LineDecoder
from drivers.profile_types import FieldSpec, FrameSpec, LineSpec
from drivers.shape import ByteArray
from drivers.teach.guesses import hint_of
from drivers.teach.rows import PLAIN, Sheet, parts_of, sheet_of
from gui.frames.state import BytesState, FieldRow, Live, Named
from gui.frames.taught import Taught
from gui.frames.texts import hint_words, place_words
from gui.widgets.number_text import significant

_SHOWN = 1 << 13
_FRAMES = 80
_ROWS = 200
_COURSE = 60
_DIGITS = 5


@dataclass(frozen=True, slots=True, eq=False)
class Readings:
    """What the latest bytes are by a description.

    Parameters
    ----------
    bytes : the rows
    live : one for each number
    frames : (n, length) uint8, the whole frames
    per_byte : frames, or lines that were read, a byte of the stream
    """

    bytes: BytesState
    live: tuple[Live, ...]
    frames: ByteArray
    per_byte: float


def read_latest(tail: bytes, taught: Taught) -> Readings:
    """Lay the latest bytes out and read their numbers; some milliseconds."""
    stream = taught.stream
    if isinstance(stream, FrameSpec):
        data = tail[-max(_SHOWN, _FRAMES * stream.shortest) :]
        sheet = sheet_of(data, stream, _ROWS)
        live = tuple(_field(sheet.frames, field) for field in stream.fields)
        return Readings(_rows(sheet, taught), live, sheet.frames, sheet.share / stream.shortest)
    data = tail[-_SHOWN:]
    sheet = sheet_of(data, stream, _ROWS)
    numbers = _numbers(data, stream) if isinstance(stream, LineSpec) else np.empty((0, 0))
    live = (
        tuple(_live(one, whole=bool(np.all(one == np.rint(one)))) for one in numbers.T)
        if len(numbers)
        else ()
    )
    return Readings(
        _rows(sheet, taught), live, sheet.frames, len(numbers) / len(data) if data else 0.0
    )


def field_rows(taught: Taught, frames: ByteArray) -> tuple[FieldRow, ...]:
    """The numbers of a description, with what they look like in some frames."""
    stream = taught.stream
    if isinstance(stream, LineSpec):
        return tuple(
            FieldRow(
                one.name, one.unit, one.role, str(n + 1), "", "", stream.scales[n],
                stream.offsets[n], hide=False,
            )
            for n, one in enumerate(stream.channels)
        )  # fmt: skip
    if not isinstance(stream, FrameSpec):
        return ()
    rows: list[FieldRow] = []
    for field in stream.fields:
        channel = field.channels[0]
        hint = hint_words(hint_of(frames, field)) if len(frames) > 1 else ""
        rows.append(
            FieldRow(
                channel.name, channel.unit, channel.role, place_words(field), field.type,
                field.endian, field.scale, field.offset, field.hide, hint,
            )
        )  # fmt: skip
    return tuple(rows)


def _rows(sheet: Sheet, taught: Taught) -> BytesState:
    widest = max((len(row.data) for row in sheet.rows), default=PLAIN)
    if not isinstance(taught.stream, FrameSpec):
        return BytesState(sheet.rows, (), widest, text=isinstance(taught.stream, LineSpec))
    named: list[Named] = []
    for part in parts_of(taught.stream):
        if part.kind == "field":
            name = taught.stream.fields[part.index].channels[0].name
            named.append(Named(part, name, part.index))
        else:
            named.append(Named(part, "header" if part.kind == "sync" else "check", -1))
    return BytesState(sheet.rows, tuple(named), max(widest, taught.stream.shortest))


def _numbers(data: bytes, stream: LineSpec) -> FloatArray:
    """Return what the lines of a stream say, (n, c)."""
    decoder = LineDecoder(stream, 0.0)
    blocks = [event.data for event in decoder.feed(data) if isinstance(event, SampleBlock)]
    return np.concatenate(blocks) if blocks else np.empty((0, len(stream.channels)))


def _field(frames: ByteArray, field: FieldSpec) -> Live:
    if not len(frames):
        return Live("", ())
    numbers = read_raw(frames, field)[:, 0]
    plain = field.type[0] != "f" and field.scale == 1.0 and field.offset == 0.0
    return _live(numbers * field.scale + field.offset, whole=plain)


def _live(values: FloatArray, *, whole: bool) -> Live:
    if not len(values):
        return Live("", ())
    course = np.asarray(values[-_COURSE:], dtype=np.float64)
    last = float(course[-1])
    text = f"{last:.0f}".replace("-", "\N{MINUS SIGN}") if whole else significant(last, _DIGITS)
    return Live(text, tuple(course[np.isfinite(course)].tolist()))
