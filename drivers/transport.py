"""Opening a port and moving its bytes: pyserial behind four methods.

Every port is opened by URL text, so ``COM4``, ``/dev/ttyUSB0``, ``/dev/pts/3``,
``socket://host:port``, ``sim://clbacc`` and ``replay://PATH`` are ports alike.
"""

import errno
import os
import sys
from collections.abc import Callable
from typing import Protocol

import serial

from core.errors import LinkError
from drivers.profile_types import PortSettings

LIMIT = 65536
"""Most bytes of one read."""

_GATHER_S = 0.02
_WINDOWS_BUFFER = 1 << 20
_WRITE_TIMEOUT_S = 2.0
_HANDLERS = "drivers.virtual"

# What pyserial lets through when a port dies: termios.error is no OSError, and a port that was
# closed under a read gives TypeError (pyserial #713).
if sys.platform == "win32":
    _PORT_ERRORS: tuple[type[Exception], ...] = (OSError, TypeError)
else:
    import termios

    _PORT_ERRORS = (OSError, TypeError, termios.error)


class EndOfStream(Exception):
    """A source of finite length, such as a replay, has given everything it had."""


PLAIN = PortSettings(
    bauds=(115200,), data_bits=8, parity="N", stop_bits=1, settle_ms=0, dtr=False, rts=False
)
"""115200 8N1, for a port of which nothing is known."""


class UnfitSettings(LinkError):
    """The port is there and does not take this speed or format."""


class Transport(Protocol):
    """A source of bytes that a `Reader` reads and closes in its own thread.

    Attributes
    ----------
    port : the port as the user knows it
    patient : the source waits for its reader and loses nothing meanwhile
    """

    port: str
    patient: bool

    def read(self) -> bytes:
        """Return what has come in; waits some 50 ms at most, and returns ``b""`` after a cancel.

        Raises
        ------
        LinkError
            The port is gone.
        EndOfStream
            There will never be more.
        """
        ...

    def write(self, data: bytes) -> None:
        """Send bytes; raises `LinkError` if the port does not take them."""
        ...

    def cancel(self) -> None:
        """Make a waiting `read` return; the only method for other threads."""
        ...

    def close(self) -> None:
        """Let go of the port; may be called again."""
        ...


Opener = Callable[[], Transport]
"""Opens a transport when its time comes; raises `LinkError`."""


class SerialTransport:
    """A pyserial port of any kind as a `Transport`."""

    def __init__(self, port: str, device: serial.Serial) -> None:
        self.port = port
        self.patient = bool(getattr(device, "patient", False))
        self._device = device

    def read(self) -> bytes:
        """Return what came in some 20 ms, so that blocks are worth decoding.

        One call of pyserial each time: every further one, such as `in_waiting`, has to wait for
        the interpreter once more while the window computes, and the kernel gives 4 kB at a time.
        """
        try:
            return self._device.read(LIMIT)
        except _PORT_ERRORS as error:
            raise self._lost(error) from error

    def write(self, data: bytes) -> None:
        """Send bytes."""
        try:
            self._device.write(data)
        except serial.SerialTimeoutException as error:
            raise LinkError(
                self.port, "the device takes no data", "check the cable and the flow control"
            ) from error
        except _PORT_ERRORS as error:
            raise self._lost(error) from error

    def cancel(self) -> None:
        """Make a waiting `read` return."""
        cancel = getattr(self._device, "cancel_read", None)
        if cancel is not None:
            try:
                cancel()
            except _PORT_ERRORS:
                return  # the reader closed the port first, so nothing waits

    def close(self) -> None:
        """Let go of the port."""
        try:
            self._device.close()
        except _PORT_ERRORS:
            return  # an unplugged adapter cannot be closed in order; its descriptor is gone

    def _lost(self, error: Exception) -> LinkError:
        return LinkError(
            self.port,
            f"the port vanished: {error}",
            "the adapter was unplugged or lost power; plug it in again",
        )


def open_port(url: str, settings: PortSettings = PLAIN, baud: int = 0) -> SerialTransport:
    """Open a port for this program alone.

    Parameters
    ----------
    url : the port as the user typed it
    settings : speed, format and control lines
    baud : another speed than the default of the settings; 0 for none

    Raises
    ------
    LinkError
        Says which of these it was: no such port, busy, not permitted, wrong baud rate or format,
        no serial port at all.
    """
    baud = baud or settings.bauds[0]
    if _HANDLERS not in serial.protocol_handler_packages:
        serial.protocol_handler_packages.append(_HANDLERS)
    try:
        device = serial.serial_for_url(
            url,
            do_not_open=True,
            baudrate=baud,
            bytesize=settings.data_bits,
            parity=settings.parity,
            stopbits=settings.stop_bits,
            timeout=_GATHER_S,
            write_timeout=_WRITE_TIMEOUT_S,
            exclusive=True,
        )
        # Before open(): an asserted DTR resets an Arduino for two seconds.
        device.dtr = settings.dtr
        device.rts = settings.rts
        device.open()
    except (*_PORT_ERRORS, ValueError) as error:
        raise _refusal(url, baud, settings, error) from error
    _tune(device)
    return SerialTransport(url, device)


def opener(url: str, settings: PortSettings = PLAIN, baud: int = 0) -> Opener:
    """Return a function that opens this port."""
    return lambda: open_port(url, settings, baud)


def _tune(device: serial.Serial) -> None:
    """Enlarge the driver's buffer and shorten its latency, where there is such a thing."""
    enlarge = getattr(device, "set_buffer_size", None)
    if enlarge is not None:  # Windows; its 4096 bytes last 44 ms at 921600 baud
        enlarge(rx_size=_WINDOWS_BUFFER)
    low_latency = getattr(device, "set_low_latency_mode", None)
    if low_latency is not None:
        try:
            low_latency(True)
        except (OSError, ValueError, NotImplementedError):
            return  # a pty or a driver without the mode: streaming does not need it


_BUSY = (errno.EBUSY, errno.EAGAIN, errno.EWOULDBLOCK)
_FORBIDDEN = (errno.EACCES, errno.EPERM)
_ABSENT = (errno.ENOENT, errno.ENODEV, errno.ENXIO, errno.EIO)


def _refusal(url: str, baud: int, settings: PortSettings, error: Exception) -> LinkError:
    """Say in distinct words why a port did not open."""
    text = str(error)
    code = getattr(error, "errno", None)
    if isinstance(error, ValueError):
        return _misuse(url, baud, text)
    if code in _BUSY or (os.name == "nt" and "PermissionError" in text):
        return LinkError(
            url, "the port is busy: another program has it open", "close that program and try again"
        )
    if code in _FORBIDDEN:
        return LinkError(
            url,
            "permission denied: this user may not open the port",
            "sudo usermod -aG dialout $USER, then log in again",
        )
    if code in _ABSENT or "FileNotFoundError" in text:
        return LinkError(url, "there is no such port", "plug the adapter in and refresh the list")
    if "socket" in url.partition("://")[0]:
        return LinkError(url, f"nobody answers there: {text}", "check the address and the port")
    if "onfigure port" in text or not isinstance(error, OSError):
        form = f"{settings.data_bits}{settings.parity}{settings.stop_bits}"
        return UnfitSettings(
            url,
            f"the port does not take {baud} baud {form}, or is no serial port ({text})",
            "choose another baud rate or another port",
        )
    return LinkError(url, f"the port does not open: {text}")


def _misuse(url: str, baud: int, text: str) -> LinkError:
    if "baud" in text.lower():
        return UnfitSettings(
            url,
            f"the port does not take {baud} baud ({text})",
            "choose another baud rate",
        )
    if "protocol" in text:
        kind = url.partition("://")[0]
        return LinkError(
            url,
            f"there is no such port: {kind}:// is unknown",
            "expected a port name, socket://, sim:// or replay://",
        )
    return LinkError(url, f"there is no such port: {text}")
