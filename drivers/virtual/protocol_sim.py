"""pyserial's handler of ``sim://`` addresses: the simulated rig within this process."""

import errno
import math
import time

import serial

from drivers.virtual.address import Stand, stand_of
from drivers.virtual.fed_port import FedPort
from drivers.virtual.rig import Unplugged


class Serial(FedPort):
    """The port of a rig; its baud rate must be the device's, as on a real line."""

    _stand: Stand

    def attach(self, url: str) -> None:
        """Connect to the rig, which may have been standing there for long."""
        self._stand = stand_of(url)
        rig = self._stand.rig
        if not rig.state.plugged:
            raise serial.SerialException(errno.ENOENT, f"{url} is unplugged")
        if not rig.acquire():
            raise serial.SerialException(errno.EBUSY, f"{url} is open")
        self.patient = math.isinf(self._stand.speed)
        self._began = time.monotonic()
        self._made = 0

    def detach(self) -> None:
        """Give the rig back."""
        self._stand.rig.release()

    def due(self) -> bytes:
        """Let the rig's time go on to now."""
        rig = self._stand.rig
        if self.patient:
            count = max(1, round(rig.rate_hz * self._stand.block_s))
        else:
            passed = (time.monotonic() - self._began) * self._stand.speed
            count = max(0, math.floor(passed * rig.rate_hz) - self._made)
        self._made += count
        try:
            data = rig.produce(count)
        except Unplugged as error:
            raise serial.SerialException("the simulated cable was pulled") from error
        if data and self.baudrate not in rig.profile.port.bauds[:1]:
            return rig.garble(max(1, round(len(data) * self.baudrate / rig.profile.port.bauds[0])))
        return data

    def accept(self, data: bytes) -> None:
        """Pass bytes on to the unit."""
        self._stand.rig.receive(data)
