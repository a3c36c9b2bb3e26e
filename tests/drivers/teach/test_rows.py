"""A stream is laid out one frame a row."""

import numpy as np

from drivers.profile_types import FrameSpec
from drivers.teach.frames import describe
from drivers.teach.rows import PLAIN, Part, frames_in, parts_of, sheet_of
from drivers.teach.text import propose_lines


def numbered(count: int) -> list[bytes]:
    return [bytes((0xAA, 0x55, n % 256, 0, 7 * n % 256, 1)) for n in range(count)]


def spec_of(data: bytes) -> FrameSpec:
    return describe(data, (0xAA, 0x55), 6, None).spec


def test_frames_and_garbage_stand_in_rows_of_their_own():
    frames = numbered(20)
    data = b"\x01\x02" + b"".join(frames[:10]) + b"\x09" * 8 + b"".join(frames[10:])
    sheet = sheet_of(data, spec_of(b"".join(frames)))
    assert sheet.rows[0].data == b"\x01\x02"
    assert b"".join(row.data for row in sheet.rows) == data
    # The frame before garbage has no header behind it, and nothing else proves it whole.
    assert sum(row.whole for row in sheet.rows) == 19
    assert sheet.frames.shape == (19, 6)


def test_the_latest_rows_are_kept():
    frames = numbered(100)
    sheet = sheet_of(b"".join(frames), spec_of(b"".join(frames)), most=5)
    assert [row.data for row in sheet.rows] == frames[-5:]


def test_without_a_description_rows_are_plain():
    sheet = sheet_of(bytes(range(100)), None)
    assert [len(row.data) for row in sheet.rows] == [PLAIN] * 6
    assert sheet.rows[-1].data[-1] == 99


def test_lines_are_rows():
    data = b"".join(b"%d,2.5\n" % n for n in range(9))
    spec = propose_lines(data * 2).spec
    assert sheet_of(data, spec).rows[0].data == b"0,2.5\n"


def test_the_parts_are_those_of_the_description():
    frames = b"".join(numbered(40))
    spec = spec_of(frames)
    parts = parts_of(spec)
    assert parts[0] == Part("sync", 0, 2)
    assert [(part.first, part.stop) for part in parts[1:]] == [
        (field.at, field.end) for field in spec.fields
    ]


def test_places_are_those_of_the_stream():
    data = b"\x00" * 5 + b"".join(numbered(12))
    rows, starts, lengths = frames_in(data, spec_of(b"".join(numbered(40))))
    assert starts.tolist() == [5 + 6 * n for n in range(len(rows))]
    assert set(lengths.tolist()) == {6}
    assert np.all(rows[:, 0] == 0xAA)
