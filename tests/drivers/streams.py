"""What the decoder tests share: stored frames, streams cut and damaged, outcomes compared."""

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from core.samples.block import SampleBlock
from drivers.decoders import Decoder
from drivers.events import BadChecksum, BadValues, Event, Garbage, Lost, Message

FRAMES = Path(__file__).parents[1] / "data" / "frames"


def stored(file: str) -> dict[str, dict[str, Any]]:
    """Return the stored frames of one protocol by their id, with their bytes as ``"bytes"``."""
    frames = json.loads((FRAMES / f"{file}.json").read_text("utf-8"))["frames"]
    return {frame["id"]: frame | {"bytes": bytes.fromhex(frame["hex"])} for frame in frames}


@dataclass(frozen=True)
class Outcome:
    """All that came out of a decoder."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    index: np.ndarray
    data: np.ndarray
    """(n, c): rows of blocks that had fewer columns hold not-a-number behind them."""
    garbage: int
    bad_checksum: int
    bad_values: int
    lost: list[tuple[int, int]]
    messages: list[tuple[str, bytes, dict[str, str]]]

    def column(self, name: str) -> np.ndarray:
        """Return one column."""
        return self.data[:, self.names.index(name)]

    def row(self, position: int = 0) -> dict[str, float]:
        """Return one sample by name."""
        return dict(zip(self.names, self.data[position].tolist(), strict=True))


def outcome(events: Iterable[Event]) -> Outcome:
    """Gather the events of a whole stream."""
    events = list(events)
    blocks = [event for event in events if isinstance(event, SampleBlock)]
    for block in blocks:
        assert block.data.dtype == np.float64
        assert block.data.shape == (len(block.index), len(block.channels))
        assert not block.data.flags.writeable
        assert not block.index.flags.writeable
    channels = blocks[-1].channels if blocks else ()
    data = np.full((sum(len(block.index) for block in blocks), len(channels)), np.nan)
    row = 0
    for block in blocks:
        data[row : row + len(block.index), : len(block.channels)] = block.data
        row += len(block.index)
    index = np.concatenate([block.index for block in blocks] or [np.empty(0, dtype=np.int64)])
    assert np.all(np.diff(index) > 0)
    return Outcome(
        tuple(channel.name for channel in channels),
        tuple(channel.unit for channel in channels),
        index,
        data,
        sum(event.count for event in events if isinstance(event, Garbage)),
        sum(event.count for event in events if isinstance(event, BadChecksum)),
        sum(event.count for event in events if isinstance(event, BadValues)),
        [(event.count, event.before) for event in events if isinstance(event, Lost)],
        [
            (event.kind, event.payload, dict(event.fields))
            for event in events
            if isinstance(event, Message)
        ],
    )


def decode(decoder: Decoder, pieces: Iterable[bytes]) -> Outcome:
    """Feed all pieces and flush."""
    events: list[Event] = []
    for piece in pieces:
        events.extend(decoder.feed(piece))
    return outcome([*events, *decoder.flush()])


def same(one: Outcome, other: Outcome) -> None:
    """Assert that two outcomes are the same."""
    assert one.names == other.names
    assert one.units == other.units
    np.testing.assert_array_equal(one.index, other.index)
    np.testing.assert_array_equal(one.data, other.data)
    assert one.garbage == other.garbage
    assert one.bad_checksum == other.bad_checksum
    assert one.bad_values == other.bad_values
    assert one.lost == other.lost
    assert one.messages == other.messages


def bytewise(data: bytes) -> Iterator[bytes]:
    """Cut into single bytes."""
    return (data[n : n + 1] for n in range(len(data)))


def randomly(data: bytes, rng: np.random.Generator, mean: float = 40.0) -> Iterator[bytes]:
    """Cut into pieces of random length, some of them empty."""
    at = 0
    while at < len(data):
        step = int(rng.geometric(1 / mean)) - 1
        yield data[at : at + step]
        at += step


def damaged(data: bytes, rng: np.random.Generator, places: int) -> bytes:
    """Flip bits, drop and insert bytes at random places."""
    whole = bytearray(data)
    for turn in range(places):
        at = int(rng.integers(len(whole)))
        if turn % 3 == 0:
            whole[at] ^= 1 << int(rng.integers(8))
        elif turn % 3 == 1:
            del whole[at : at + int(rng.integers(1, 80))]
        else:
            whole[at:at] = rng.integers(0, 256, int(rng.integers(1, 60)), dtype=np.uint8).tobytes()
    return bytes(whole)
