"""Addresses of recordings."""

import time

import pytest

from core.errors import LinkError
from drivers.rawlog import RawLog
from drivers.transport import EndOfStream, open_port


def read_all(transport) -> bytes:
    data = b""
    try:
        while True:
            data += transport.read()
    except EndOfStream:
        return data


@pytest.fixture
def recording(tmp_path):
    path = tmp_path / "a run with blanks, Прилад.calrec"
    log = RawLog(path, {})
    for step in range(3):
        log.write(bytes([step]) * 4, time.monotonic() + step * 0.1)
    log.mark("link lost", why="test")
    log.close()
    return path


def test_all_bytes_and_then_the_end(recording):
    transport = open_port(f"replay://{recording}?speed=max")
    assert transport.patient
    assert read_all(transport) == b"\0\0\0\0\1\1\1\1\2\2\2\2"
    transport.write(b"nobody listens")
    transport.close()


def test_twice_as_fast(recording):
    transport = open_port(f"replay://{recording}?speed=2")
    assert not transport.patient
    began = time.monotonic()
    assert len(read_all(transport)) == 12
    assert time.monotonic() - began == pytest.approx(0.1, abs=0.08)
    transport.close()


@pytest.mark.parametrize("speed", ["0", "-1", "nan"])
def test_impossible_speed(recording, speed):
    with pytest.raises(LinkError, match="must be above zero"):
        open_port(f"replay://{recording}?speed={speed}")
