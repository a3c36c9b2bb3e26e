"""A pyserial port that the program itself feeds."""

import math
import threading
import time
from abc import abstractmethod

import serial

_LONGEST_WAIT_S = 0.05
_STEP_S = 0.01
_FULL = 1 << 16


class FedPort(serial.SerialBase):
    """The common half of ``sim://`` and ``replay://``.

    Bytes are asked for when somebody reads, so none are lost while nobody does, and no thread is
    needed.
    """

    patient = False

    def __init__(self, *args: object, **settings: object) -> None:
        self._pending = bytearray()
        self._cancelled = threading.Event()
        super().__init__(*args, **settings)  # pyright: ignore[reportArgumentType]

    @abstractmethod
    def attach(self, url: str) -> None:
        """Connect to the source; raises what pyserial would."""

    @abstractmethod
    def detach(self) -> None:
        """Let go of the source."""

    @abstractmethod
    def due(self) -> bytes:
        """Return the bytes that have come by now."""

    def accept(self, data: bytes) -> None:
        """Take bytes from the computer; a source that cannot answer lets them go."""

    def open(self) -> None:
        """Connect."""
        self.attach(str(self.portstr))
        self._pending.clear()
        self._cancelled.clear()
        self._asked = -math.inf
        self.is_open = True

    def close(self) -> None:
        """Disconnect; may be called again."""
        if self.is_open:
            self.is_open = False
            self.detach()

    @property
    def in_waiting(self) -> int:
        """Bytes that can be read at once."""
        self._fill()
        return len(self._pending)

    def read(self, size: int = 1, /) -> bytes:
        """Return up to `size` bytes, fewer after the timeout or a cancel."""
        timeout = self.timeout
        until = time.monotonic() + (_LONGEST_WAIT_S if timeout is None else timeout)
        self._fill()
        while len(self._pending) < size and not (self.patient and self._pending):
            left = until - time.monotonic()
            if left <= 0 or self._cancelled.wait(min(left, _STEP_S)):
                break
            self._fill()
        self._cancelled.clear()
        data = bytes(self._pending[:size])
        del self._pending[:size]
        return data

    def write(self, data: bytes, /) -> int:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Send bytes to the source."""
        if not self.is_open:
            raise serial.PortNotOpenError
        self.accept(bytes(data))
        return len(data)

    def cancel_read(self) -> None:
        """Make a waiting `read` return."""
        self._cancelled.set()

    def reset_input_buffer(self) -> None:
        """Forget what was not read."""
        self._fill()
        self._pending.clear()

    def reset_output_buffer(self) -> None:
        """Nothing waits to be sent."""

    def _fill(self) -> None:
        """Ask the source; not in steps of single frames, which would cost more than they bring."""
        if not self.is_open:
            raise serial.PortNotOpenError
        now = time.monotonic()
        if len(self._pending) < _FULL and (self.patient or now - self._asked >= _STEP_S):
            self._asked = now
            self._pending += self.due()

    def _reconfigure_port(self) -> None:
        """Speed and format are looked at when bytes are sent."""

    def _update_dtr_state(self) -> None:
        """There is no such line."""

    _update_rts_state = _update_break_state = _update_dtr_state
