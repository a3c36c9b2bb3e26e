"""Real ptys: what opens, what refuses in which words, what happens when the other end goes."""

import os
import socket
import threading
import time
from collections.abc import Iterator
from dataclasses import replace

import pytest

from core.errors import LinkError
from drivers.transport import PLAIN, UnfitSettings, open_port

tty = pytest.importorskip("tty", reason="Windows has no pseudo-terminals")


@pytest.fixture
def pty_pair() -> Iterator[tuple[int, str]]:
    """Descriptor of the device's end, name of the computer's end."""
    master, slave = os.openpty()
    tty.setraw(slave)
    yield master, os.ttyname(slave)
    for fd in (master, slave):
        try:
            os.close(fd)
        except OSError:
            continue  # the test pulled the plug


def read_until(transport, wanted: int, seconds: float = 2.0) -> bytes:
    data, until = b"", time.monotonic() + seconds
    while len(data) < wanted and time.monotonic() < until:
        data += transport.read()
    return data


def test_bytes_go_both_ways(pty_pair):
    master, name = pty_pair
    transport = open_port(name)
    payload = bytes(range(256)) * 8
    threading.Thread(target=os.write, args=(master, payload)).start()
    assert read_until(transport, len(payload)) == payload
    transport.write(b"\x00\r\n\x11\x13\xff")
    assert os.read(master, 100) == b"\x00\r\n\x11\x13\xff"
    transport.close()
    transport.close()


def test_silence_returns_within_a_moment(pty_pair):
    transport = open_port(pty_pair[1])
    began = time.monotonic()
    assert transport.read() == b""
    assert time.monotonic() - began < 0.3
    transport.close()


def test_cancel_from_another_thread_ends_a_read(pty_pair):
    transport = open_port(pty_pair[1])
    transport._device.timeout = 10.0
    timer = threading.Timer(0.1, transport.cancel)
    timer.start()
    began = time.monotonic()
    assert transport.read() == b""
    assert time.monotonic() - began < 2.0
    timer.join()
    transport.close()
    transport.cancel()


def test_second_opening_is_refused_as_busy(pty_pair):
    first = open_port(pty_pair[1])
    with pytest.raises(LinkError, match="busy"):
        open_port(pty_pair[1])
    first.close()
    open_port(pty_pair[1]).close()


def test_unplugging_is_a_vanished_port(pty_pair):
    master, name = pty_pair
    transport = open_port(name)
    os.close(master)
    with pytest.raises(LinkError, match="vanished"):
        read_until(transport, 1)
    with pytest.raises(LinkError, match="vanished"):
        transport.write(b"x")
    transport.close()


def test_unknown_ports():
    with pytest.raises(LinkError, match="no such port"):
        open_port("/dev/tty_calrig_none")
    with pytest.raises(LinkError, match="nonsense:// is unknown"):
        open_port("nonsense://x")
    with pytest.raises(LinkError, match=r"no such port.*there are clbacc"):
        open_port("sim://toaster")


def test_what_is_no_serial_port():
    with pytest.raises(UnfitSettings, match="no serial port"):
        open_port(os.devnull)


def test_wrong_baud_rate(pty_pair):
    with pytest.raises(UnfitSettings, match="baud"):
        open_port(pty_pair[1], replace(PLAIN, bauds=(-5,)))


def test_forbidden_port_names_the_group(tmp_path, monkeypatch):
    # The superuser may open anything, so the refusal of the system is given by hand here.
    def refuse(*_args, **_kwargs):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "open", refuse)
    with pytest.raises(LinkError, match=r"permission denied.*dialout"):
        open_port("/dev/ttyS0")


def test_custom_speeds_are_set(pty_pair):
    for baud in (115200, 374400, 1843200):
        transport = open_port(pty_pair[1], PLAIN, baud)
        assert transport._device.baudrate == baud
        transport.close()


def test_control_lines_are_set_before_opening(pty_pair):
    low = open_port(pty_pair[1])
    assert (low._device.dtr, low._device.rts) == (False, False)
    low.close()
    high = open_port(pty_pair[1], replace(PLAIN, dtr=True, rts=True))
    assert (high._device.dtr, high._device.rts) == (True, True)
    high.close()


def test_socket_port():
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        transport = open_port(f"socket://127.0.0.1:{port}")
        peer, _ = server.accept()
        peer.sendall(b"hello" * 1000)
        assert read_until(transport, 5000) == b"hello" * 1000
        transport.write(b"back")
        assert peer.recv(10) == b"back"
        peer.close()
        with pytest.raises(LinkError, match="vanished"):
            read_until(transport, 1)
        transport.close()
    with pytest.raises(LinkError, match="nobody answers"):
        open_port(f"socket://127.0.0.1:{port}")
