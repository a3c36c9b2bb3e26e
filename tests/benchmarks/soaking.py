"""Hours of frames with faults between, through reader and recorder, each frame known by its number.

The source ends after the last frame, so that nothing is left over in a port: every frame that was
sent whole has to be in the record once, and no other.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.errors import LinkError
from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.profile import load_profiles
from drivers.reader import Reader
from drivers.recorder import Recorder, RecordLayout, wire_item
from drivers.recording import Recording, read_recording
from drivers.transport import EndOfStream, Transport
from drivers.virtual.faults import Faults, Line

PROFILE = load_profiles()["cvgx48"]
FAULTS = Faults(bit_error=1e-6, drop=2e-4, half=2e-4, garbage=2e-4)
_PIECE = 4096
_SPLIT = 1 << 16
_LOW, _HIGH = 0, -1
"""Channels that hold the number of the frame: its remainder by `_SPLIT`, and the rest."""


class NumberedFrames:
    """A port that sends numbered frames, loses its cable now and then, and ends.

    Parameters
    ----------
    count : frames
    cuts : how often the cable is pulled, in the middle of a frame
    seed : of all chance
    """

    patient = True
    port = "soak"

    def __init__(self, count: int, cuts: int, seed: int) -> None:
        self._count = count
        self._pieces = -(-count // _PIECE)
        self._at = 0
        stream = np.random.default_rng(seed)
        self._rng = stream
        self._line = Line(stream)
        self._width = len(make_decoder(PROFILE).channels)
        self._cuts = set((np.arange(1, cuts + 1) * self._pieces // (cuts + 1)).tolist())
        self._torn: list[int] = []
        self._lost = False
        self._left = b""

    @property
    def damaged(self) -> np.ndarray:
        """Numbers of the frames that did not arrive whole."""
        return np.unique(np.concatenate([*self._line.damaged, np.array(self._torn, dtype=int)]))

    def open(self) -> Transport:
        """Plug the cable in."""
        return self

    def read(self) -> bytes:
        """Return a piece of random length, as a driver would."""
        if not self._left:
            if self._lost:
                self._lost = False
                raise LinkError(self.port, "the cable was pulled")
            if self._at == self._pieces:
                raise EndOfStream
            self._left = self._make()
        size = int(self._rng.integers(1, 1 << 17))
        data, self._left = self._left[:size], self._left[size:]
        return data

    def write(self, data: bytes) -> None:
        """Nothing is listened to."""

    def cancel(self) -> None:
        """Nothing waits."""

    def close(self) -> None:
        """Nothing is held."""

    def _make(self) -> bytes:
        first = self._at * _PIECE
        number = np.arange(first, min(first + _PIECE, self._count))
        values = self._rng.normal(size=(len(number), self._width))
        values[:, _LOW], values[:, _HIGH] = number % _SPLIT, number // _SPLIT
        data = self._line.carry(encode(PROFILE, number, values), first, len(number), FAULTS)
        self._at += 1
        if self._at in self._cuts:
            self._lost = True
            whole = encode(PROFILE, number[-1:], values[-1:])
            if data.endswith(whole):
                data = data[: -len(whole) // 2]
                self._torn.append(int(number[-1]))
        return data


@dataclass(frozen=True, slots=True, eq=False)
class Soaked:
    """What became of the frames.

    Parameters
    ----------
    sent, damaged : frames, and those of them that did not arrive whole
    missing, doubled, foreign : whole frames that are not in the record, that are in it more than
        once, frames in it that were never sent whole
    heard : frames by the reader's count
    reconnections : how often the cable came back
    spent_s : of our time
    record : the record
    """

    sent: int
    damaged: int
    missing: int
    doubled: int
    foreign: int
    heard: int
    reconnections: int
    spent_s: float
    record: Recording


def soak(hours: float, path: Path, *, cuts: int = 0, seed: int = 9) -> Soaked:
    """Record so many hours of the CVG's frames as fast as they can be read."""
    began = time.perf_counter()
    rate = PROFILE.nominal_hz
    source = NumberedFrames(round(hours * 3600 * rate), cuts, seed)
    decoder = make_decoder(PROFILE)
    layout = RecordLayout(decoder.channels, rate, wire_item(PROFILE))
    writer = Recorder(path, {"profile_text": PROFILE.text}, layout)
    opening: Callable[[], Transport] = source.open
    reader = Reader(opening, decoder, None, opening)
    reader.tap = writer
    reader.start()
    while reader.state.value != "ended":
        reader.drain()
        time.sleep(0.002)
    reader.close()
    writer.close()
    record = read_recording(path)
    spent = time.perf_counter() - began
    found = np.concatenate(
        [
            (part.data[:, _HIGH] * _SPLIT + part.data[:, _LOW]).astype(np.int64)
            for part in record.chunks()
        ]
    )
    sent = round(hours * 3600 * rate)
    good = np.ones(sent, dtype=bool)
    good[source.damaged] = False
    inside = found[(found >= 0) & (found < sent)]
    times = np.bincount(inside, minlength=sent)
    return Soaked(
        sent,
        int(np.count_nonzero(~good)),
        int(np.count_nonzero(good & (times == 0))),
        int(np.count_nonzero(times > 1)),
        int(np.count_nonzero(~good & (times > 0))) + len(found) - len(inside),
        reader.counters.frames,
        reader.counters.reconnections,
        spent,
        record,
    )
