"""Text messages of VectorNav units: ``$VNYMR,+100.949,...*69``.

The checksum is the exclusive-or of the characters in two digits or CRC-16 in four. Which values a
line holds follows from its header; status and count may be appended. Answers to commands are
messages of kind ``"reply"``.
"""

import math
import re
from collections.abc import Mapping

import numpy as np

from core.samples.block import Channel, SampleBlock
from core.units import DEG_PER_RAD
from drivers.columns import Columns
from drivers.counter import SampleCounter
from drivers.events import BadChecksum, Event, Message
from drivers.line import text_message
from drivers.lines import LineSplitter, checked
from drivers.profile import Profile

_APPENDED = (("S", Channel("status", "code", "status"), 16), ("T", Channel("count", "code"), 10))
_NUMBER = re.compile(r"[+-]?\d+(?:\.\d*)?(?:[eE][+-]?\d+)?", re.ASCII)
_REGISTERS = {"01": "model", "02": "hardware", "03": "serial", "04": "firmware"}
_ERRORS = {
    "01": "hard fault", "02": "serial buffer overflow", "03": "invalid checksum",
    "04": "invalid command", "05": "not enough parameters", "06": "too many parameters",
    "07": "invalid parameter", "08": "invalid register", "09": "unauthorized access",
    "0A": "watchdog reset", "0B": "output buffer overflow", "0C": "insufficient baud rate",
}  # fmt: skip


def _xyz(name: str, unit: str, role: str) -> tuple[Channel, ...]:
    return tuple(Channel(f"{name}_{axis}", unit, f"{role}.{axis}") for axis in "xyz")


_YPR = tuple(
    Channel(name, "deg", f"angle.{role}")
    for name, role in (("yaw", "heading"), ("pitch", "pitch"), ("roll", "roll"))
)
_QTN = tuple(Channel(name, "") for name in ("qx", "qy", "qz", "qw"))
_MAG, _ACC = _xyz("mag", "gauss", "mag"), _xyz("acc", "m/s^2", "acc")
_GYR = _xyz("gyro", "deg/s", "rate")
_HOUSE = (Channel("temp", "degC", "temp"), Channel("pressure", "kPa"))
_HEADERS: Mapping[str, tuple[Channel, ...]] = {
    "YPR": _YPR, "QTN": _QTN, "MAG": _MAG, "ACC": _ACC, "GYR": _GYR,
    "QMR": _QTN + _MAG + _ACC + _GYR, "MAR": _MAG + _ACC + _GYR,
    "YMR": _YPR + _MAG + _ACC + _GYR, "IMU": _MAG + _ACC + _GYR + _HOUSE,
    "YBA": _YPR + tuple(Channel(f"body_acc_{a}", "m/s^2") for a in "xyz") + _GYR,
    "YIA": _YPR + tuple(Channel(f"inertial_acc_{a}", "m/s^2") for a in "xyz") + _GYR,
    "DTV": (
        Channel("delta_time", "s"), *_xyz("delta_theta", "deg", "dangle"),
        *_xyz("delta_v", "m/s", "dvel"),
    ),
}  # fmt: skip

Reading = tuple[tuple[Channel, ...], list[float]]


def _reading(words: list[str]) -> Reading | None:
    """Return what a measurement line holds; None if it cannot be read whole."""
    channels = _HEADERS[words[0][3:]]
    values = words[1 : 1 + len(channels)]
    if len(values) < len(channels) or not all(map(_NUMBER.fullmatch, values)):
        return None
    numbers = [
        float(word) * (DEG_PER_RAD if channel.role.startswith("rate") else 1.0)
        for channel, word in zip(channels, values, strict=True)
    ]
    for word in words[1 + len(channels) :]:
        known = next((one for one in _APPENDED if word[:1] == one[0]), None)
        if known is None or not word[1:].isalnum():
            return None
        try:
            numbers.append(float(int(word[1:], known[2])))
        except ValueError:
            return None
        channels = (*channels, known[1])
    return (channels, numbers) if all(map(math.isfinite, numbers)) else None


def _reply(raw: bytes, words: list[str]) -> Message:
    if words[0] == "$VNERR" and len(words) > 1:
        code = words[1].upper().rjust(2, "0")
        return Message("reply", raw, {"error": _ERRORS.get(code, f"code {code}")})
    if words[0] in ("$VNRRG", "$VNWRG") and len(words) > 2:
        value = ",".join(words[2:])
        name = _REGISTERS.get(words[1].rjust(2, "0"))
        return Message("reply", raw, {name: value} if name else {f"register {words[1]}": value})
    return text_message(raw)


class VectorNavAsciiDecoder:
    """Text lines of a VectorNav unit to events.

    Parameters
    ----------
    profile : gives the declared rate
    """

    def __init__(self, profile: Profile) -> None:
        self._rate = profile.nominal_hz
        self._splitter = LineSplitter("\n", keep_first=True)
        self._columns = Columns(_HEADERS["YMR"])
        self._counter = SampleCounter()
        self._lost = 0

    @property
    def channels(self) -> tuple[Channel, ...]:
        """The columns of the next block; may grow with each new header."""
        return self._columns.channels

    @property
    def rate(self) -> float:
        """Declared samples per second."""
        return self._rate

    @property
    def carried(self) -> int:
        """Bytes that wait for more."""
        return self._splitter.carried

    def feed(self, data: bytes) -> list[Event]:
        """Return what these bytes complete; any bytes are allowed."""
        return self._convert(self._splitter.split(data))

    def flush(self) -> list[Event]:
        """Return what is left when nothing more will come."""
        return self._convert(self._splitter.rest())

    def _convert(self, lines: list[bytes]) -> list[Event]:
        events = self._splitter.wasted()
        waiting: list[tuple[Reading, int]] = []
        for raw in lines:
            reading = self._line(raw, events)
            if reading is None:
                continue
            if waiting and self._columns.lack(reading[0]):
                self._emit(waiting, events)
                waiting = []
            self._columns.take(reading[0])
            waiting.append((reading, self._lost))
            self._lost = 0
        if waiting:
            self._emit(waiting, events)
        return events

    def _line(self, raw: bytes, events: list[Event]) -> Reading | None:
        line = raw.decode("latin-1").strip()
        if not line:
            return None
        body = checked(line)
        words = (line if body is None else body).split(",")
        measured = words[0].startswith("$VN") and words[0][3:] in _HEADERS
        if body is None:
            self._lost += measured
            events.append(BadChecksum(1) if words[0].startswith("$VN") else text_message(raw))
            return None
        reading = _reading(words) if measured else None
        if reading is None:
            self._lost += measured
            events.append(_reply(raw, words))
        return reading

    def _emit(self, readings: list[tuple[Reading, int]], events: list[Event]) -> None:
        channels = self._columns.channels
        data = np.full((len(readings), len(channels)), np.nan)
        for row, ((held, numbers), _) in enumerate(readings):
            data[row, self._columns.places(held)] = numbers
        losses = np.array([lost for _, lost in readings], dtype=np.int64)
        index, said = self._counter.number(None, losses)
        events.extend(event for _, event in said)
        data.flags.writeable = index.flags.writeable = False
        events.append(SampleBlock(channels, index, data, self._rate))
