"""Finding frames: the same frames whatever the pieces, every byte accounted for."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from drivers.checksums import Checksum, ChecksumSpec
from drivers.finder import FrameFinder
from drivers.shape import Batch, ByteArray, Shape

SUM = Checksum(ChecksumSpec("sum8", 1, -1, -1, 1, "little"))
CRLF = b"\r\n"


def told(heads: ByteArray) -> np.ndarray:
    """Length by the third byte: 5 to 40 bytes."""
    lengths = heads[:, 2].astype(np.int64) + 5
    return np.where(lengths <= 40, lengths, 0)


def bare(rows: ByteArray) -> np.ndarray:
    return (rows[:, -2] == 0xAA) & (rows[:, -1] == 0x55)


SHAPES = {
    "fixed": Shape(((0xAA,), (0x55,)), 2, 8, 8, SUM.intact),
    "fixed with tail": Shape(((0xAA,), (0x55,)), 2, 8, 8, SUM.intact, tail=CRLF),
    "told": Shape(((0xAA,), (0x55,)), 3, 40, told, SUM.intact),
    "told with tail": Shape(((0xAA,), (0x55,)), 3, 40, told, SUM.intact, tail=CRLF),
    "one of several": Shape(((0xAA, 0x55), None), 3, 40, told, SUM.intact),
    "no checksum": Shape(((0xAA,), (0x55,)), 2, 8, 8, bare, follow=2),
}


def frame(content: bytes, length: int) -> bytes:
    """AA 55 n content sum, filled up to the length."""
    body = bytes((0xAA, 0x55, length - 5)) + content[: length - 4].ljust(length - 4, b"\7")
    return body + bytes((sum(body[1:]) & 0xFF,))


def found(batch: Batch) -> list[bytes]:
    pairs = zip(batch.starts.tolist(), batch.lengths.tolist(), strict=True)
    return [batch.buffer[start : start + length].tobytes() for start, length in pairs]


def run(shape: Shape, pieces: list[bytes]) -> tuple[list[bytes], list[int], int, int]:
    """Return frames, gaps, garbage and bad places of a whole stream."""
    finder = FrameFinder(shape)
    frames: list[bytes] = []
    gaps: list[int] = []
    garbage = bad = 0
    fed = 0
    for piece in [*pieces, None]:
        batch = finder.finish() if piece is None else finder.push(piece)
        frames += found(batch)
        gaps += batch.gaps.tolist()
        garbage += batch.garbage
        bad += batch.bad
        assert len(batch.sample) == min(16, batch.garbage) or batch.garbage > len(batch.sample) > 0
        fed += len(piece or b"")
        accounted = sum(map(len, frames)) + garbage + finder.carried
        if not shape.tail:
            assert accounted == fed
        assert finder.carried <= shape.longest + shape.follow + len(shape.tail)
    assert finder.carried == 0
    return frames, gaps, garbage, bad


def cut(data: bytes, cuts: list[int]) -> list[bytes]:
    edges = [0, *sorted(c for c in cuts if c < len(data)), len(data)]
    return [data[begin:end] for begin, end in itertools.pairwise(edges)]


PIECES = st.lists(
    st.one_of(
        st.builds(frame, st.binary(max_size=36), st.sampled_from([8, 8, 8, 5, 20, 40])),
        st.binary(max_size=12),
        st.sampled_from([b"\xaa", b"\x55", b"\xaa\x55", CRLF, b"\r", b"\xaa\x55\xff"]),
    ),
    max_size=25,
).map(b"".join)


@pytest.mark.parametrize("name", SHAPES)
@given(data=PIECES, cuts=st.lists(st.integers(0, 600), max_size=12))
def test_the_pieces_do_not_matter(name: str, data: bytes, cuts: list[int]):
    whole = run(SHAPES[name], [data])
    assert run(SHAPES[name], cut(data, cuts)) == whole
    assert run(SHAPES[name], [data[n : n + 1] for n in range(len(data))]) == whole


@given(data=PIECES)
def test_frames_are_the_first_ones_that_fit_from_the_end_of_the_last(data: bytes):
    """The rule itself, written down naively."""
    frames: list[bytes] = []
    at = 0
    while at < len(data):
        piece = data[at : at + 8]
        if len(piece) == 8 and piece[:2] == b"\xaa\x55" and sum(piece[1:-1]) & 0xFF == piece[-1]:
            frames.append(piece)
            at += 8
        else:
            at += 1
    assert run(SHAPES["fixed"], [data])[0] == frames


def test_damage_costs_one_frame_and_noise_none():
    frames = [frame(bytes((n,)), 8) for n in range(50)]
    hurt = bytearray(b"".join(frames))
    hurt[20 * 8 + 5] ^= 1
    got, gaps, garbage, bad = run(SHAPES["fixed"], [bytes(hurt)])
    assert got == frames[:20] + frames[21:]
    assert (gaps[20], garbage, bad) == (8, 8, 1)
    noisy = b"".join(frames[:25]) + b"\xaa\x55noise" + b"".join(frames[25:])
    assert run(SHAPES["fixed"], [noisy])[0] == frames


def test_a_false_length_holds_back_only_what_it_covers():
    frames = [frame(bytes((n,)), 8) for n in range(12)]
    stream = b"\xaa\x55\x23" + b"".join(frames)  # announces 40 bytes
    finder = FrameFinder(SHAPES["told"])
    assert found(finder.push(stream[:39])) == []
    assert finder.carried == 39
    assert found(finder.push(stream[39:])) == frames


def test_a_tail_is_tolerated_and_neither_wanted_nor_garbage():
    frames = [frame(bytes((n,)), 8) for n in range(40)]
    shape = SHAPES["fixed with tail"]
    for stream in (CRLF.join(frames) + CRLF, b"".join(frames), b"".join(frames[:9]) + CRLF):
        got, _, garbage, bad = run(shape, [stream])
        assert got == frames[: len(got)]
        assert len(got) >= 9
        assert (garbage, bad) == (0, 0)
    assert run(shape, [frames[0] + CRLF + CRLF + frames[1]])[2] == 2


def test_a_damaged_tail_is_garbage_however_the_stream_is_cut():
    frames = [frame(bytes((n,)), 8) + CRLF for n in range(60)]
    frames[30] = frames[30][:8] + b"\r\0"
    data = b"".join(frames)
    for pieces in ([data], cut(data, [200, 310, 311]), [data[n : n + 1] for n in range(len(data))]):
        got, gaps, garbage, _ = run(SHAPES["fixed with tail"], pieces)
        assert len(got) == 60
        assert (garbage, gaps[31]) == (2, 2)


def test_bad_places_within_a_bad_frame_count_once():
    inner = b"\xaa\x55\x03\xaa\x55\x03"
    hurt = bytearray(frame(inner * 6, 40))
    hurt[-1] ^= 0xFF
    assert run(SHAPES["told"], [bytes(hurt) + frame(b"", 8)])[2:] == (40, 1)


def test_frames_of_other_lengths_at_the_same_distance_are_not_mixed_up():
    """Eight bytes with a tail or ten without: the same distance, not the same frames."""
    short = [frame(bytes((n % 256,)), 8) for n in range(300)]
    long = frame(b"\xa3\0\0\0\0\r", 10)
    assert long.endswith(CRLF)
    broken = b"\xaa\x55\x03damage!"
    pieces = [item + CRLF for item in short]
    pieces[120], pieces[121:130] = broken, [long] * 9
    data = b"".join(pieces)
    whole = run(SHAPES["told with tail"], [data])
    assert whole[0] == [*short[:120], *[long] * 9, *short[130:]]
    assert run(SHAPES["told with tail"], [data[n : n + 1] for n in range(len(data))]) == whole


def test_without_a_checksum_a_frame_needs_the_next_sync_or_a_frame_before_it():
    shape = SHAPES["no checksum"]
    frames = [bytes((0xAA, 0x55, n, 1, 2, 3, 4, 5)) for n in range(5)]
    assert run(shape, [b"".join(frames)])[0] == frames
    assert run(shape, [frames[0]])[0] == []
    assert run(shape, [b"\xaa\x55xx" + b"".join(frames[:3])])[0] == frames[:3]


def test_long_damaged_streams_are_found_again_alike_in_large_and_small_pieces():
    rng = np.random.default_rng(5)
    frames = [frame(rng.bytes(36), int(rng.choice([8, 8, 8, 8, 33]))) for _ in range(6000)]
    stream = bytearray(b"".join(frames))
    for at in rng.integers(0, len(stream), 150).tolist():
        stream[at] ^= 0x20
    data = bytes(stream)
    whole = run(SHAPES["told"], [data])
    assert run(SHAPES["told"], [data[n : n + 777] for n in range(0, len(data), 777)]) == whole
    assert len(whole[0]) > 5800
    assert sum(item in set(frames) for item in whole[0]) >= len(whole[0]) - 3
