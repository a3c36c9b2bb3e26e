"""Twelve-byte packets of InnaLabs CVG gyros behind a switch.

``AA | b1 | b2 | float | float | CRC-8``: b1 holds the numbers of controller (high half) and gyro
(low half), b2 says which parameters the two numbers are, second in the high half. The first is the
gyro's output in every packet, the second walks through the slow parameters; between its turns a
slow parameter keeps its last value. Little-endian; the layout is that of CVGCom's published
sources, not yet confirmed with bytes of a real unit.
"""

import numpy as np

from core.arrays import FloatArray
from core.samples.block import Channel
from drivers.checksums import CRC_PRESETS, Checksum, ChecksumSpec
from drivers.counter import SampleCounter
from drivers.events import Message
from drivers.profile import Profile
from drivers.shape import ByteArray, Shape
from drivers.stream import Layout, StreamDecoder

LENGTH = 12
CHECKSUM = ChecksumSpec(
    "crc-8/maxim", start=1, stop=-1, at=-1, size=1, endian="little", crc=CRC_PRESETS["crc-8/maxim"]
)
_PARAMETERS = (
    Channel("GyroOut", "V", "rate.z"), Channel("Temperature", "degC", "temp"),
    Channel("AntinodePeriod", "us"), Channel("ExcitationAmpl", "V"), Channel("QuadratureAmpl", "V"),
    Channel("QuadratureError", "V"), Channel("CoriolisError", "V"), Channel("XAmplitude", "V"),
    Channel("YAmplitude", "V"), Channel("XMean", "V"), Channel("YMean", "V"),
    Channel("GyroOut_RAW", "V"), Channel("N_Excitation", "code"), *(
        Channel(f"Parameter{number}", "code") for number in (13, 14, 15)
    ),
)  # fmt: skip


def _both(rows: ByteArray) -> FloatArray:
    with np.errstate(invalid="ignore"):  # a signalling NaN
        return rows[:, 3:11].view("<f4").astype(np.float64)


def _first(rows: ByteArray) -> FloatArray:
    return _both(rows)[:, :1]


def _foreign(frame: bytes) -> Message:
    return Message(f"gyro {frame[1] & 15} of controller {frame[1] >> 4}", frame, {})


class Cvg12Decoder(StreamDecoder):
    """Packets of one gyro to events; those of other gyros on the switch become messages.

    Parameters
    ----------
    profile : its option ``gyro`` is the number of the gyro
    """

    def __init__(self, profile: Profile) -> None:
        self._gyro = profile.option("gyro")
        self._layouts: dict[bytes, Layout] = {}
        self._held: dict[str, float] = {}
        shape = Shape(((0xAA,),), LENGTH, LENGTH, LENGTH, Checksum(CHECKSUM).intact)
        super().__init__(shape, SampleCounter(), profile.nominal_hz, _PARAMETERS[:1])

    def layout(self, frame: bytes) -> Layout:
        """Return the layout by gyro and parameters."""
        key = frame[1:3]
        if key not in self._layouts:
            same = (np.array([1, 2]), np.frombuffer(key, dtype=np.uint8))
            first, second = _PARAMETERS[key[1] & 15], _PARAMETERS[key[1] >> 4]
            if key[0] & 15 != self._gyro:
                self._layouts[key] = Layout((), _both, None, same, _foreign)
            elif first == second:
                self._layouts[key] = Layout((first,), _first, None, same)
            else:
                self._layouts[key] = Layout((first, second), _both, None, same)
        return self._layouts[key]

    def fill(self, data: FloatArray) -> None:
        """Let each parameter keep its last value until it comes again."""
        for column, channel in enumerate(self.channels):
            values = data[:, column]
            known = np.isfinite(values)
            last = np.maximum.accumulate(np.where(known, np.arange(len(values)), -1))
            held = self._held.get(channel.name, np.nan)
            values[:] = np.where(last >= 0, values[last], held)
            self._held[channel.name] = float(values[-1])
