"""Datagrams of the Sensonor STIM300 family.

A datagram has no length field: its first byte says what is in it. Ranges, units and the rate stand
in the configuration datagram, which the unit sends after power-on and in answer to ``C``; until it
has been seen the profile's range and the default units hold. All big-endian; CRC-32/MPEG-2 over the
datagram and dummy zero bytes up to a multiple of four. The counter counts the unit's internal
2000 Hz samples. A reply takes the place of a measurement, which is then counted as lost.

Layout, scales and codes: datasheet TS1524.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np

from core.arrays import IntArray
from core.samples.block import Channel
from core.units import STANDARD_GRAVITY
from drivers.checksums import CRC_PRESETS, Checksum, ChecksumSpec
from drivers.counter import SampleCounter
from drivers.events import Event, Message
from drivers.fields import FieldTable
from drivers.profile import Profile
from drivers.profile_types import FieldSpec
from drivers.shape import Batch, BoolArray, ByteArray, Shape
from drivers.stream import Layout, StreamDecoder

CHECKSUM = ChecksumSpec(
    "crc-32/mpeg-2", start=0, stop=-4, at=-4, size=4, endian="big",
    pad_to=4, crc=CRC_PRESETS["crc-32/mpeg-2"],
)  # fmt: skip
_INTERNAL_HZ = 2000.0
_CONFIGURATION = (0xBC, 0xBD)
_SERIAL = (0xB5, 0xB7)
_PART = (0xB1, 0xB3)
_REPLIES = dict.fromkeys((*_PART, *_SERIAL), 20) | {
    0xBC: 26, 0xBD: 26, 0xBE: 21, 0xBF: 21, 0xD1: 40, 0xD2: 40,
}  # fmt: skip
_RATES = {0: 125.0, 1: 250.0, 2: 500.0, 3: 1000.0, 4: 2000.0}
_RANGES_G = {0: 10, 3: 5, 4: 30, 6: 80}
_ACC_BITS = {5: 20, 10: 19, 30: 18, 80: 16}
"""Bits behind the point of an acceleration in g; of a velocity in m/s three more."""


@dataclass(frozen=True, slots=True)
class _Content:
    """What a datagram holds besides the three gyros."""

    acc: bool
    incl: bool
    temp: bool
    last: str
    """``"pps"``, ``"aux"`` or empty."""


def _contents() -> dict[int, _Content]:
    plain = (0x90, 0x91, 0x92, 0x93, 0x94, 0xA5, 0xA6, 0xA7)
    pps = range(0xF0, 0xF8)
    aux = (0x98, 0x99, 0x9A, 0x9B, 0x9C, 0xAD, 0xAE, 0xAF)
    return {
        datagram: _Content(bool(n & 1), bool(n & 2), bool(n & 4), last)
        for last, ids in (("", plain), ("pps", pps), ("aux", aux))
        for n, datagram in enumerate(ids)
    }


_CONTENTS = _contents()


@dataclass(frozen=True, slots=True)
class _Settings:
    """What the configuration datagram says about scales; codes as in the datasheet."""

    ranges_g: tuple[int, int, int]
    gyro: int = 0
    acc: int = 0
    incl: int = 0
    pps: int = 0


class _Places:
    """Fields one behind the other."""

    def __init__(self) -> None:
        self.fields: list[FieldSpec] = []
        self.end = 1

    def add(self, kind: str, scale: float, *channels: Channel) -> None:
        spec = FieldSpec(channels, kind, self.end, scale, endian="big")
        self.fields.append(spec)
        self.end = spec.end

    def status(self, name: str) -> None:
        self.add("u8", 1.0, Channel(f"{name}_status", "code", "status"))


def _axes(name: str, unit: str, role: str) -> tuple[Channel, ...]:
    return tuple(Channel(f"{name}_{axis}", unit, f"{role}.{axis}") for axis in "xyz")


def _inertial(places: _Places, content: _Content, settings: _Settings) -> None:
    turned = settings.gyro & 1
    unit, role = ("deg", "dangle") if turned else ("deg/s", "rate")
    places.add("i24", 2.0 ** -(21 if turned else 14), *_axes("gyro", unit, role))
    places.status("gyro")
    if content.acc:
        moved = settings.acc not in (0, 2)
        unit, role = ("m/s", "dvel") if moved else ("m/s^2", "acc")
        size = 1.0 if moved else STANDARD_GRAVITY
        for channel, range_g in zip(_axes("acc", unit, role), settings.ranges_g, strict=True):
            places.add("i24", size * 2.0 ** -(_ACC_BITS[range_g] + (3 if moved else 0)), channel)
        places.status("acc")
    if content.incl:
        moved = settings.incl not in (0, 2)
        scale = 2.0**-25 if moved else STANDARD_GRAVITY * 2.0**-22
        places.add("i24", scale, *_axes("incl", "m/s" if moved else "m/s^2", "incl"))
        places.status("incl")


def datagram_fields(datagram: int, settings: _Settings) -> tuple[FieldSpec, ...]:
    """Return the fields of a measurement by its first byte."""
    content, places = _CONTENTS[datagram], _Places()
    _inertial(places, content, settings)
    if content.temp:
        held = (("gyro", "rate", True), ("acc", "acc", content.acc), ("incl", "incl", content.incl))
        for name, role, present in held:
            if present:
                places.add("i16", 2.0**-8, *_axes(f"{name}_temp", "degC", f"temp.{role}"))
                places.status(f"{name}_temp")
    if content.last == "pps" and settings.pps in (0, 1):
        places.add("u24", 2.0**-22, Channel("pps", ""))
    elif content.last:
        places.add("i24", 1.0, Channel(content.last, "us" if content.last == "pps" else "code"))
    if content.last:
        places.status(content.last)
    places.add("u8", 1.0, Channel("counter", "code", "counter"))
    places.add("u16", 1.0, Channel("latency", "us"))
    return tuple(places.fields)


def _lengths() -> dict[int, int]:
    settings = _Settings((10, 10, 10))
    sizes = {id_: datagram_fields(id_, settings)[-1].end + 4 for id_ in _CONTENTS}
    return sizes | _REPLIES


_LENGTHS = _lengths()
_LENGTH_TABLE = np.array([_LENGTHS.get(first, 0) for first in range(256)], dtype=np.int64)


def _told(heads: ByteArray) -> IntArray:
    return _LENGTH_TABLE[heads[:, 0]]


def _digits(raw: bytes) -> str:
    return raw.hex().upper()


class Stim300Decoder(StreamDecoder):
    """Bytes of a STIM300 to events.

    Parameters
    ----------
    profile : its options give the datagram to expect and the accelerometers' range
    """

    def __init__(self, profile: Profile) -> None:
        range_g = profile.option("acc_range_g")
        self._settings = _Settings((range_g, range_g, range_g))
        self._layouts: dict[int, Layout] = {}
        self._configured_hz = 0.0
        expected = FieldTable(datagram_fields(profile.option("datagram"), self._settings))
        shape = Shape(
            (tuple(_LENGTHS),), 1, max(_LENGTHS.values()), _told, Checksum(CHECKSUM).intact, b"\r\n"
        )
        super().__init__(shape, SampleCounter(bits=8), profile.nominal_hz, expected.channels)

    @property
    def rate(self) -> float:
        """Rate of the configuration datagram, else by the counter's step, else as declared."""
        if self._configured_hz:
            return self._configured_hz
        return _INTERNAL_HZ / self._counter.step if self._counter.step else self._nominal_hz

    def layout(self, frame: bytes) -> Layout:
        """Return the layout of a measurement by its first byte."""
        first = frame[0]
        if first not in self._layouts:
            table = FieldTable(datagram_fields(first, self._settings))
            same = (np.zeros(1, dtype=np.int64), np.array([first], dtype=np.uint8))
            counts = partial(table.counts, name="counter")
            self._layouts[first] = Layout(table.channels, table.values, counts, same)
        return self._layouts[first]

    def apart(self, batch: Batch) -> BoolArray | None:
        """Return which datagrams are replies."""
        replies = np.zeros(256, dtype=np.bool_)
        replies[list(_REPLIES)] = True
        return replies[batch.buffer[batch.starts]]

    def apply(self, frame: bytes) -> Event:
        """Return a reply as a message; a configuration changes how measurements are read."""
        first, payload = frame[0], frame[1:-4]
        fields: Mapping[str, str]
        if first in _CONFIGURATION:
            fields = self._configure(payload)
        elif first in _SERIAL:
            fields = {"serial": _digits(payload[1:8])}
        elif first in _PART:
            whole = f"{_digits(payload[:3])[1:]}-{_digits(payload[4:7])}"
            fields = {"model": whole, "revision": chr(payload[14])}
        else:
            fields = {"datagram": f"0x{first:02X}", "content": _digits(payload)}
        return Message("reply", frame, fields)

    def _configure(self, payload: bytes) -> dict[str, str]:
        codes = (payload[16] >> 4, payload[16] & 15, payload[17] >> 4)
        x, y, z = (_RANGES_G.get(code, 10) for code in codes)
        self._settings = _Settings(
            (x, y, z), payload[4] & 15, payload[7] & 15, payload[10] & 15, payload[12] & 15
        )
        self._layouts.clear()
        self._configured_hz = _RATES.get(payload[2] >> 5, 0.0)
        if self._configured_hz:
            self._counter.settle(round(_INTERNAL_HZ / self._configured_hz))
        return {
            "revision": chr(payload[0]),
            "firmware": str(payload[1]),
            "rate_hz": f"{self._configured_hz:g}" if self._configured_hz else "external trigger",
            "acc_range_g": f"{x} {y} {z}",
            "crlf": "yes" if payload[2] & 1 else "no",
        }
