"""Which ports there are, likeliest first, and how to find an adapter again."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from serial.tools import list_ports as pyserial_ports
from serial.tools.list_ports_common import ListPortInfo

from core.errors import LinkError
from drivers.profile_types import PortSettings
from drivers.transport import PLAIN, Opener, SerialTransport, open_port

# Makers of USB to serial bridges and of boards with one built in.
_BRIDGES = frozenset({0x0403, 0x067B, 0x10C4, 0x1A86, 0x04D8, 0x0483, 0x2341, 0x2639, 0x1FC9})

SIMULATED = (
    ("sim://clbacc", "Simulated rig: assembly of nine accelerometers (ClbAcc)"),
    ("sim://pointer", "Simulated rig: attitude unit PW09 (Pointer)"),
    ("sim://clbdus", "Simulated rig: assembly of MEMS gyros (ClbDUS)"),
    ("sim://cvg25", "Simulated rig: vibratory gyro CVG25 (CVGCom)"),
)
"""The simulated rig's ports with what they are."""


@dataclass(frozen=True, slots=True)
class UsbIdentity:
    """What stays the same when a USB adapter is plugged in again and gets another port name."""

    vid: int
    pid: int
    serial: str
    location: str


@dataclass(frozen=True, slots=True)
class PortInfo:
    """One port.

    Parameters
    ----------
    url : what to open
    text : what the system or we call it
    kind : ``"usb"``, ``"built-in"``, ``"bluetooth"`` or ``"simulated"``
    usb : identity of the USB adapter; None for other ports
    """

    url: str
    text: str
    kind: str
    usb: UsbIdentity | None = None


def list_ports() -> tuple[PortInfo, ...]:
    """Return the ports of this machine and the simulated ones, likeliest first.

    Call it in a worker thread: on Windows each Bluetooth port takes seconds.
    """
    found = sorted(_machine_ports(), key=lambda port: (_rank(port), port.url))
    return (*found, *(PortInfo(url, text, "simulated") for url, text in SIMULATED))


def reopener(
    url: str,
    settings: PortSettings = PLAIN,
    baud: int = 0,
    known: Sequence[PortInfo] | None = None,
) -> Opener:
    """Return a function that opens this port, wherever its USB adapter is by then.

    An adapter is known again by maker, product and serial number; one without a serial number,
    by the socket that it is plugged into. Ports without a USB identity keep their names.

    Parameters
    ----------
    url, settings, baud : as for `open_port`
    known : ports as `list_ports` gave them, among which to look the adapter up; without them the
        ports are listed now, which a window must not wait for
    """
    ports = _machine_ports() if known is None else known
    found = next((port for port in ports if port.url == url), None)
    if found is None or found.usb is None:
        return lambda: open_port(url, settings, baud)
    usb = found.usb

    def reopen() -> SerialTransport:
        for port in _machine_ports():
            if port.usb is not None and _same(port.usb, usb):
                return open_port(port.url, settings, baud)
        raise LinkError(url, "the adapter is not plugged in", "plug it in again")

    return reopen


def _same(one: UsbIdentity, other: UsbIdentity) -> bool:
    if (one.vid, one.pid, one.serial) != (other.vid, other.pid, other.serial):
        return False
    if not one.serial:
        return one.location == other.location
    # The ports of an adapter that has several differ after the colon, e.g. 1-2:1.0 and 1-2:1.1.
    return one.location.partition(":")[2] == other.location.partition(":")[2]


def _machine_ports() -> list[PortInfo]:
    return [_info(port) for port in _steady(lambda: list(pyserial_ports.comports()))]


def _steady(lister: Callable[[], list[ListPortInfo]]) -> list[ListPortInfo]:
    """List once more if an adapter was pulled while its attributes were being read."""
    try:
        return lister()
    except (OSError, TypeError, ValueError):
        time.sleep(0.1)
        return lister()


def _info(port: ListPortInfo) -> PortInfo:
    text = port.description if port.description not in ("", "n/a") else port.name
    if port.vid is not None and port.pid is not None:
        usb = UsbIdentity(port.vid, port.pid, port.serial_number or "", port.location or "")
        return PortInfo(port.device, text, "usb", usb)
    bluetooth = "BTHENUM" in port.hwid or "rfcomm" in port.device or "luetooth" in text
    return PortInfo(port.device, text, "bluetooth" if bluetooth else "built-in")


def _rank(port: PortInfo) -> int:
    if port.usb is not None:
        return 0 if port.usb.vid in _BRIDGES else 1
    return 3 if port.kind == "bluetooth" else 2
