"""The right speed is known by what it lets be read."""

import numpy as np
import pytest

from core.errors import LinkError
from drivers.teach.speeds import try_speeds
from drivers.transport import UnfitSettings
from tests.drivers.links import Script
from tests.drivers.teach.layouts import frames_of, invented


class Wire:
    """A board at 57600; any other speed hears noise, and one is refused by the adapter."""

    def __init__(self) -> None:
        rng = np.random.default_rng(9)
        self._noise = rng.integers(0, 256, 4000, np.uint8).tobytes()
        self._frames = frames_of(invented(rng, checked=True), rng, 0, 200).tobytes()
        self.opened: list[Script] = []

    def __call__(self, baud: int) -> Script:
        if baud == 1843200:
            raise UnfitSettings("port", "no such speed")
        port = Script([self._frames if baud == 57600 else self._noise])
        self.opened.append(port)
        return port


def test_the_first_speed_beyond_doubt_ends_the_search():
    wire, tried = Wire(), []
    speeds = (115200, 1843200, 57600, 9600)
    trials = try_speeds(wire, speeds, listen_s=0.05, progress=tried.append)
    assert trials[0].baud == 57600
    assert trials[0].rank[0]
    assert tried == [115200, 1843200, 57600]
    assert [port.closed for port in wire.opened] == [1, 1]
    assert all(port.written == b"" for port in wire.opened)


def test_noise_at_every_speed_proves_none():
    trials = try_speeds(Wire(), (115200, 9600), listen_s=0.05)
    assert [trial.rank for trial in trials] == [(False, 0.0)] * 2
    assert all(trial.count == 4000 for trial in trials)


def test_a_port_that_does_not_open_is_told():
    def refuse(_: int) -> Script:
        raise LinkError("port", "in use")

    with pytest.raises(LinkError, match="in use"):
        try_speeds(refuse, (9600,), listen_s=0.05)
