"""The list of ports and the way back to an adapter that moved."""

import pytest
from serial.tools import list_ports as pyserial_ports
from serial.tools.list_ports_common import ListPortInfo

from core.errors import LinkError
from drivers.ports import SIMULATED, UsbIdentity, list_ports, reopener


def adapter(device: str, vid: int, serial: str | None, location: str) -> ListPortInfo:
    port = ListPortInfo(device, skip_link_detection=True)
    port.vid, port.pid, port.serial_number, port.location = vid, 0x6001, serial, location
    port.product = "USB Serial"
    port.apply_usb_info()
    return port


def plain(device: str, hwid: str = "n/a") -> ListPortInfo:
    port = ListPortInfo(device, skip_link_detection=True)
    port.hwid = hwid
    return port


@pytest.fixture
def machine(monkeypatch):
    """The ports that the system reports; a list to be changed."""
    ports: list[ListPortInfo] = []
    monkeypatch.setattr(pyserial_ports, "comports", lambda: ports)
    return ports


def test_likeliest_first(machine):
    machine += [
        plain("COM7", r"BTHENUM\{00001101}"),
        plain("/dev/ttyS0", "PNP0501"),
        adapter("/dev/ttyACM0", 0x9999, "a", "1-1"),
        adapter("/dev/ttyUSB1", 0x0403, "b", "1-2"),
    ]
    listed = list_ports()
    assert [port.url for port in listed] == [
        "/dev/ttyUSB1",
        "/dev/ttyACM0",
        "/dev/ttyS0",
        "COM7",
        *(url for url, _ in SIMULATED),
    ]
    assert [port.kind for port in listed[:4]] == ["usb", "usb", "built-in", "bluetooth"]
    assert listed[0].usb == UsbIdentity(0x0403, 0x6001, "b", "1-2")
    assert listed[0].text == "USB Serial"
    assert listed[2].text == "ttyS0"


def test_adapter_pulled_while_it_is_being_listed(monkeypatch):
    calls = []

    def shaky():
        calls.append(1)
        if len(calls) == 1:
            raise TypeError("int() argument must be a string, not 'NoneType'")
        return [plain("/dev/ttyS0")]

    monkeypatch.setattr(pyserial_ports, "comports", shaky)
    assert list_ports()[0].url == "/dev/ttyS0"


@pytest.mark.parametrize(
    ("before", "after", "same"),
    [
        (("A5", "1-1"), ("A5", "1-4"), True),
        (("A5", "1-1"), ("B6", "1-1"), False),
        ((None, "1-1"), (None, "1-1"), True),
        ((None, "1-1"), (None, "1-2"), False),
        (("A5", "1-1:1.0"), ("A5", "1-3:1.0"), True),
        (("A5", "1-1:1.0"), ("A5", "1-1:1.1"), False),
    ],
)
def test_adapter_is_known_again_under_another_name(machine, monkeypatch, before, after, same):
    opened = []
    monkeypatch.setattr("drivers.ports.open_port", lambda url, *_: opened.append(url))
    machine.append(adapter("/dev/ttyUSB0", 0x0403, *before))
    reopen = reopener("/dev/ttyUSB0")
    machine[:] = [adapter("/dev/ttyUSB3", 0x0403, *after)]
    if same:
        reopen()
        assert opened == ["/dev/ttyUSB3"]
    else:
        with pytest.raises(LinkError, match="not plugged in"):
            reopen()


def test_other_ports_keep_their_names(machine, monkeypatch):
    opened = []
    monkeypatch.setattr("drivers.ports.open_port", lambda url, *_: opened.append(url))
    reopener("/dev/pts/3")()
    assert opened == ["/dev/pts/3"]


def test_a_list_that_is_at_hand_is_not_made_again(machine, monkeypatch):
    opened = []
    monkeypatch.setattr("drivers.ports.open_port", lambda url, *_: opened.append(url))
    machine.append(adapter("/dev/ttyUSB0", 0x0403, "A5", "1-1"))
    known = list_ports()
    machine.clear()
    reopen = reopener("/dev/ttyUSB0", known=known)
    machine.append(adapter("/dev/ttyUSB1", 0x0403, "A5", "1-1"))
    reopen()
    assert opened == ["/dev/ttyUSB1"]
