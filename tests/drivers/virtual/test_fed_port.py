"""A port that the program feeds behaves as pyserial's own do."""

import threading
import time

import pytest
import serial

from drivers.virtual.fed_port import FedPort


class Source(FedPort):
    """Gives ten bytes at each asking until it has given all."""

    attached = 0

    def attach(self, url: str) -> None:
        self.attached += 1
        self.left = 30
        self.heard = b""

    def detach(self) -> None:
        self.attached -= 1

    def due(self) -> bytes:
        count = min(self.left, 10)
        self.left -= count
        return b"x" * count

    def accept(self, data: bytes) -> None:
        self.heard += data


@pytest.fixture
def port() -> Source:
    source = Source(timeout=0.2)
    source.portstr = "fed://x"
    source.open()
    return source


def test_bytes_come_when_they_are_asked_for(port: Source) -> None:
    assert port.read(30) == b"x" * 30
    began = time.monotonic()
    assert port.read(1) == b""
    assert time.monotonic() - began > 0.15


def test_close_may_be_called_again_and_lets_go_once(port: Source) -> None:
    port.close()
    port.close()
    assert port.attached == 0
    with pytest.raises(serial.SerialException):
        port.read(1)


def test_what_is_written_reaches_the_source(port: Source) -> None:
    assert port.write(b"stop") == 4
    assert port.heard == b"stop"


def test_a_waiting_read_can_be_cancelled(port: Source) -> None:
    port.timeout = 10.0
    port.read(30)
    timer = threading.Timer(0.1, port.cancel_read)
    timer.start()
    began = time.monotonic()
    assert port.read(1) == b""
    assert time.monotonic() - began < 5.0
    timer.join()
