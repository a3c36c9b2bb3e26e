"""A stream laid out for the eye: one frame a row, what is no frame in rows of its own."""

from dataclasses import dataclass

import numpy as np

from core.arrays import IntArray
from drivers.finder import FrameFinder
from drivers.frame import frame_shape
from drivers.profile_types import FrameSpec, LineSpec
from drivers.shape import ByteArray, gather

PLAIN = 16
"""Bytes a row where no frame is known."""


@dataclass(frozen=True, slots=True)
class Part:
    """Bytes of a frame that belong together.

    Parameters
    ----------
    kind : ``"sync"``, ``"field"`` or ``"check"``
    first, stop : place of the first byte, and the one after the last
    index : which field; 0 for the others
    """

    kind: str
    first: int
    stop: int
    index: int = 0


@dataclass(frozen=True, slots=True)
class SheetRow:
    """Bytes in one row, and whether they are a whole frame."""

    data: bytes
    whole: bool


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
    """A stream in rows.

    Parameters
    ----------
    rows : in the order of the stream
    frames : (n, length) uint8, the whole frames; (0, 0) where the stream is text
    share : of the bytes that are in whole frames or lines, 0 to 1
    """

    rows: tuple[SheetRow, ...]
    frames: ByteArray
    share: float


def parts_of(spec: FrameSpec) -> tuple[Part, ...]:
    """Return the known parts of frames of a description."""
    parts = [Part("sync", 0, len(spec.sync))]
    for index, field in enumerate(spec.fields):
        parts.append(Part("field", field.at, field.end, index))
    if spec.checksum is not None:
        at = spec.checksum.at if spec.checksum.at >= 0 else spec.shortest + spec.checksum.at
        parts.append(Part("check", at, at + spec.checksum.size))
    return tuple(parts)


def frames_in(data: bytes, spec: FrameSpec) -> tuple[ByteArray, IntArray, IntArray]:
    """Return the whole frames of a stream, where they begin, and their lengths.

    Returns
    -------
    frames : (n, shortest) uint8
    starts, lengths : (n,) int64, places in `data`
    """
    finder = FrameFinder(frame_shape(spec))
    batches = [finder.push(data), finder.finish()]
    # A finder tells places within its own buffer: the whole stream, then what it still carried.
    starts = [batch.starts + (len(data) - len(batch.buffer)) for batch in batches]
    lengths = [batch.lengths for batch in batches]
    all_starts, all_lengths = np.concatenate(starts), np.concatenate(lengths)
    bytes_ = np.frombuffer(data, dtype=np.uint8)
    return gather(bytes_, all_starts, spec.shortest), all_starts, all_lengths


def sheet_of(data: bytes, stream: FrameSpec | LineSpec | None, most: int = 200) -> Sheet:
    """Return the latest rows of a stream by a description; plain rows without one.

    Parameters
    ----------
    data : the latest bytes of the stream
    stream : the description
    most : rows at most
    """
    if isinstance(stream, FrameSpec):
        return _framed(data, stream, most)
    if isinstance(stream, LineSpec):
        lines = data.splitlines(keepends=True)[-most:]
        rows = tuple(SheetRow(line, line.endswith((b"\n", b"\r"))) for line in lines)
        return Sheet(rows, np.empty((0, 0), np.uint8), 1.0)
    cut = data[len(data) % PLAIN :] if len(data) > PLAIN else data
    plain = [cut[at : at + PLAIN] for at in range(0, len(cut), PLAIN)][-most:]
    return Sheet(tuple(SheetRow(row, False) for row in plain), np.empty((0, 0), np.uint8), 0.0)


def _framed(data: bytes, spec: FrameSpec, most: int) -> Sheet:
    frames, starts, lengths = frames_in(data, spec)
    rows: list[SheetRow] = []
    place = 0
    share = float(np.sum(lengths)) / len(data) if data else 0.0
    for start, length in zip(starts.tolist(), lengths.tolist(), strict=True):
        rows += _rest(data[place:start], spec.shortest)
        rows.append(SheetRow(data[start : start + length], True))
        place = start + length
    # The beginning of the next frame is no garbage yet.
    if len(data) - place > 2 * spec.shortest:
        rows += _rest(data[place:], spec.shortest)
    return Sheet(tuple(rows[-most:]), frames, share)


def _rest(data: bytes, width: int) -> list[SheetRow]:
    return [SheetRow(data[at : at + width], False) for at in range(0, len(data), width)]
