"""Twelve-byte packets of InnaLabs CVG gyros behind a switch.

``AA | b1 | b2 | float | float | CRC-8``: b1 holds the numbers of controller (high half) and gyro
(low half), b2 says which parameters the two numbers are, second in the high half. The first is the
gyro's output in every packet, the second walks through the slow parameters; between its turns a
slow parameter keeps its last value, and one that never came is not a number. Little-endian. The
layout is that of CVGCom's published sources, not yet confirmed with bytes of a real unit.
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
    Channel("GyroOut_RAW", "V"), Channel("N_Excitation", "code"),
)  # fmt: skip
"""By their numbers on the wire."""


def _foreign(frame: bytes) -> Message:
    return Message(f"gyro {frame[1] & 15} of controller {frame[1] >> 4}", frame, {})


class Cvg12Decoder(StreamDecoder):
    """Packets of one gyro to events; those of other gyros become messages.

    Parameters
    ----------
    profile : its options ``controller`` and ``gyro`` are the numbers of the gyro
    """

    def __init__(self, profile: Profile) -> None:
        self._sender = profile.option("controller") << 4 | profile.option("gyro")
        self._layouts: dict[int, Layout] = {}
        self._held = np.full(len(_PARAMETERS), np.nan)
        shape = Shape(((0xAA,),), LENGTH, LENGTH, LENGTH, Checksum(CHECKSUM).intact)
        super().__init__(shape, SampleCounter(), profile.nominal_hz, _PARAMETERS)

    def layout(self, frame: bytes) -> Layout:
        """Return the layout by the number of the gyro."""
        sender = frame[1]
        if sender not in self._layouts:
            same = (np.array([1]), np.array([sender], dtype=np.uint8))
            channels, message = (_PARAMETERS, None) if sender == self._sender else ((), _foreign)
            self._layouts[sender] = Layout(channels, self._parameters, None, same, message)
        return self._layouts[sender]

    def _parameters(self, rows: ByteArray) -> FloatArray:
        """Return a column a parameter, each with its last value until it comes again."""
        with np.errstate(invalid="ignore"):  # a signalling NaN
            numbers = rows[:, 3:11].view("<f4").astype(np.float64)
        first, second = rows[:, 2] & 15, rows[:, 2] >> 4
        data = np.empty((len(rows), len(_PARAMETERS)))
        for parameter in range(len(_PARAMETERS)):
            came = np.flatnonzero((first == parameter) | (second == parameter))
            steps = np.empty(len(came) + 1)
            steps[0] = self._held[parameter]
            steps[1:] = np.where(first[came] == parameter, numbers[came, 0], numbers[came, 1])
            edges = np.concatenate(([0], came, [len(rows)]))
            data[:, parameter] = steps.repeat(edges[1:] - edges[:-1])
        self._held = data[-1].copy()
        return data
