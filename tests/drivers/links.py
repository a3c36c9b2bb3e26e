"""Sources, decoders and waiting for the tests of links."""

import threading
import time
from collections.abc import Callable, Sequence

import numpy as np

from core.arrays import frozen, frozen_int
from core.samples.block import Channel, SampleBlock
from drivers.decoders import make_decoder
from drivers.events import Ended, Event, Garbage
from drivers.profile import load_profiles
from drivers.reader import Reader
from drivers.transport import opener
from drivers.virtual.address import rig_of

CVG = load_profiles()["cvgx48"]


class Script:
    """A transport that does what a list says: bytes, a pause, or an error to raise."""

    def __init__(self, steps: Sequence[bytes | float | Exception]) -> None:
        self.port = "script"
        self.patient = False
        self.written = b""
        self.closed = 0
        self._steps = list(steps)
        self._cancelled = threading.Event()

    def read(self) -> bytes:
        if not self._steps:
            self._cancelled.wait(0.05)
            return b""
        step = self._steps.pop(0)
        if isinstance(step, Exception):
            raise step
        if isinstance(step, bytes):
            return step
        self._cancelled.wait(step)
        return b""

    def write(self, data: bytes) -> None:
        self.written += data

    def cancel(self) -> None:
        self._cancelled.set()

    def close(self) -> None:
        self.closed += 1


class Letters:
    """A decoder: one sample a letter, anything else is garbage, `!` breaks it."""

    def __init__(self, rate: float = 0.0) -> None:
        self.channels = (Channel("letter"),)
        self.rate = rate
        self._next = 0

    def feed(self, data: bytes) -> list[Event]:
        if b"!" in data:
            raise ZeroDivisionError("a bug")
        values = [byte for byte in data if chr(byte).isalpha()]
        if not values:
            return [Garbage(len(data), data[:8])]
        index = frozen_int(range(self._next, self._next + len(values)))
        self._next += len(values)
        return [SampleBlock(self.channels, index, frozen([[v] for v in values]), self.rate)]

    def flush(self) -> list[Event]:
        return []


def wait_for(condition: Callable[[], bool], seconds: float = 10.0) -> None:
    until = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < until, "it never happened"
        time.sleep(0.005)


def finish(reader: Reader) -> list[Event]:
    """All events of a reader that ends by itself."""
    reader.start()
    events: list[Event] = []
    wait_for(
        lambda: bool(events.extend(reader.drain()) or events) and isinstance(events[-1], Ended)
    )
    reader.close()
    return events


def samples(events: Sequence[Event]) -> tuple[np.ndarray, np.ndarray]:
    blocks = [event for event in events if isinstance(event, SampleBlock)]
    return (
        np.concatenate([block.index for block in blocks]),
        np.concatenate([block.data for block in blocks]),
    )


def sim_reader(query: str, device: str = "cvg25", **options) -> Reader:
    url = f"sim://{device}?{query}"
    profile = rig_of(url).profile
    return Reader(opener(url, profile.port), make_decoder(profile), **options)
