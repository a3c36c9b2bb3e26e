"""The rig's port through pyserial's own door."""

import threading
import time

import pytest
import serial

from core.errors import LinkError
from drivers.transport import open_port
from drivers.virtual.address import rig_of


def opened(query: str, device: str = "cvg25", **settings) -> serial.Serial:
    open_port("sim://clbacc?name=registers-the-handler").close()
    return serial.serial_for_url(f"sim://{device}?{query}", baudrate=115200, **settings)


def test_paced_in_real_time():
    port = opened("name=paced", timeout=0.05)
    began = time.monotonic()
    data = b""
    while time.monotonic() - began < 1.0:
        data += port.read(10_000)
    assert len(data) / 48 == pytest.approx(200.0 * (time.monotonic() - began), abs=12.0)
    port.close()


def test_time_stands_still_while_nobody_listens():
    port = opened("name=still", timeout=0.05)
    port.read(48 * 20)
    port.close()
    before = rig_of("sim://cvg25?name=still").state.time_s
    time.sleep(0.3)
    port.open()
    port.read(48)
    assert rig_of("sim://cvg25?name=still").state.time_s - before < 0.1
    port.close()


def test_accelerated():
    port = opened("name=fast&speed=50", timeout=0.2)
    assert len(port.read(48 * 1000)) == 48 * 1000
    port.close()


def test_read_returns_what_came_at_its_timeout_and_at_a_cancel():
    port = opened("name=timeout", timeout=0.1)
    began = time.monotonic()
    assert 0 < len(port.read(100_000)) < 48 * 60
    assert 0.08 < time.monotonic() - began < 0.3
    port.timeout = 10.0
    timer = threading.Timer(0.1, port.cancel_read)
    timer.start()
    began = time.monotonic()
    port.read(10_000_000)
    assert time.monotonic() - began < 1.0
    timer.join()
    port.close()


def test_input_can_be_thrown_away():
    port = opened("name=throw&speed=max", timeout=0.05)
    assert port.in_waiting > 0
    port.reset_input_buffer()
    first = port.read(2)
    assert first == b"\xaa\x55"
    port.close()
    with pytest.raises(serial.PortNotOpenError):
        port.read(1)
    with pytest.raises(serial.PortNotOpenError):
        port.write(b"x")


def test_busy_and_unplugged():
    url = "sim://clbacc?name=plug"
    first = open_port(url)
    with pytest.raises(LinkError, match="busy"):
        open_port(url)
    rig_of(url).unplug()
    with pytest.raises(LinkError, match="vanished"):
        first.read()
    first.close()
    with pytest.raises(LinkError, match="no such port"):
        open_port(url)
    rig_of(url).plug_in()
    open_port(url).close()


def test_wrong_baud_rate_is_garbage():
    port = opened("name=baud", timeout=0.2)
    assert port.read(480).count(b"\xaa\x55") >= 10
    port.baudrate = 57600
    port.reset_input_buffer()
    assert port.read(480).count(b"\xaa\x55") < 3
    port.close()


def test_unit_answers():
    port = opened("name=answer", "pointer", timeout=0.3)
    commands = rig_of("sim://pointer?name=answer").profile.commands
    port.write(commands["stop"].data)
    port.read(100_000)
    assert port.read(100_000) == b""
    port.write(commands["identify"].data)
    answer = port.read(174)
    assert answer[:6] == bytes.fromhex("AA550112AC00")
    assert answer[6:14] == b"PW09\0\0\0\0"
    assert answer[14:26] == b"MiniAhrs 2.1"
    assert int.from_bytes(answer[-2:], "little") == sum(answer[2:-2]) % 65536
    port.close()
