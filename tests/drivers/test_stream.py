"""The common way of decoders: layouts that change from frame to frame."""

import numpy as np

from core.samples.block import Channel, SampleBlock
from drivers.checksums import Checksum, ChecksumSpec
from drivers.counter import SampleCounter
from drivers.events import Event, Message
from drivers.shape import Batch, BoolArray, Shape
from drivers.stream import Layout, StreamDecoder
from tests.drivers.streams import bytewise, decode, outcome, same

SUM = Checksum(ChecksumSpec("sum8", 0, -1, -1, 1, "little"))
A, B, C = Channel("a", "V"), Channel("b", "V"), Channel("c", "V")
HELD = {1: (A, B), 2: (A, C), 3: (B,), 9: (), 10: ()}


class Several(StreamDecoder):
    """Frames of six bytes: AA, kind, two numbers, factor, sum; kind 7 sets the factor."""

    def __init__(self) -> None:
        shape = Shape(((0xAA,),), 6, 6, 6, SUM.intact)
        super().__init__(shape, SampleCounter(), 10.0, (C,))
        self.factor = 1.0
        self.made = 0
        self.layouts: dict[int, Layout] = {}

    def layout(self, frame: bytes) -> Layout:
        kind = frame[1]
        if kind not in self.layouts:
            self.made += 1
            channels = HELD[kind]
            same = (np.array([1]), np.array([kind], dtype=np.uint8))
            message = None if channels else (lambda raw: Message("nothing", raw, {}))
            self.layouts[kind] = Layout(
                channels,
                lambda rows: rows[:, 2 : 2 + len(channels)] * self.factor,
                None,
                same,
                message,
            )
        return self.layouts[kind]

    def apart(self, batch: Batch) -> BoolArray:
        return batch.buffer[batch.starts + 1] == 7

    def apply(self, frame: bytes) -> Event:
        self.factor = float(frame[4])
        return Message("factor", frame, {})


def frame(kind: int, one: int = 0, two: int = 0, factor: int = 0) -> bytes:
    body = bytes((0xAA, kind, one, two, factor))
    return body + bytes((sum(body) % 256,))


def test_columns_are_expected_then_known_then_more():
    decoder = Several()
    assert decoder.channels == (C,)
    blocks = decoder.feed(frame(1, 5, 6) + frame(1, 7, 8) + frame(2, 9, 10) + frame(3, 11))
    assert all(isinstance(block, SampleBlock) for block in blocks)
    assert [block.channels for block in blocks if isinstance(block, SampleBlock)] == [
        (A, B),
        (A, B, C),
    ]
    got = outcome(blocks)
    nan = np.nan
    np.testing.assert_array_equal(
        got.data, [[5, 6, nan], [7, 8, nan], [9, nan, 10], [nan, 11, nan]]
    )
    assert got.index.tolist() == [0, 1, 2, 3]
    assert decoder.made == 3


def test_frames_that_change_the_reading_do_so_in_their_place():
    stream = frame(1, 1, 1) + frame(7, factor=3) + frame(1, 1, 1) + frame(7, factor=5) + frame(3, 1)
    whole = decode(Several(), [stream])
    assert whole.data[:, 0].tolist()[:2] == [1.0, 3.0]
    assert whole.row(2)["b"] == 5.0
    assert [kind for kind, _, _ in whole.messages] == ["factor", "factor"]
    same(decode(Several(), bytewise(stream)), whole)


def test_frames_without_samples_are_messages_and_no_rows():
    stream = frame(9) + frame(1, 1, 2) + frame(9, 4) + frame(9, 5) + frame(1, 3, 4)
    got = decode(Several(), [stream])
    assert got.index.tolist() == [0, 1]
    assert got.data.tolist() == [[1, 2], [3, 4]]
    assert [payload[2] for _, payload, _ in got.messages] == [0, 4, 5]
    same(decode(Several(), bytewise(stream)), got)


def test_messages_of_several_layouts_keep_their_order():
    kinds = [9, 10, 9, 9, 10]
    got = decode(Several(), [b"".join(map(frame, kinds))])
    assert [payload[1] for _, payload, _ in got.messages] == kinds


def test_long_inputs_are_taken_in_pieces_without_a_seam():
    stream = frame(1, 1, 2) * 100_000
    got = decode(Several(), [stream])
    assert np.array_equal(got.index, np.arange(100_000))
    assert got.garbage == 0


def test_garbage_comes_with_a_sample_of_it():
    (event,) = Several().feed(b"hello, this is no frame at all")
    assert event.count == 30  # type: ignore[union-attr]
    assert event.sample == b"hello, this is n"  # type: ignore[union-attr]
