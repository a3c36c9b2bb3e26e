"""Xsens MTi messages (Xbus, MTData2).

Message: ``FA FF | id | length u8 | data | sum``, all bytes behind ``FA`` adding up to zero; length
FF announces two more bytes of length. A measurement (id 36) is a row of items, each with its own
identifier, size and precision, and which items are there differs from one packet to the next: some
come at a lower rate, the angles only once the filter has settled. Big-endian.

The 10 kHz sample time counts the samples, since packets without measurements (satellites) advance
the packet counter too; where it is switched off the packet counter counts.

Items and precisions: Low Level Communication Protocol documentation.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from struct import Struct

import numpy as np

from core.arrays import FloatArray, IntArray
from core.samples.block import Channel
from core.units import DEG_PER_RAD
from drivers.checksums import Checksum, ChecksumSpec
from drivers.counter import SampleCounter
from drivers.events import Message
from drivers.profile import Profile
from drivers.shape import ByteArray, Shape
from drivers.stream import Layout, StreamDecoder

CHECKSUM = ChecksumSpec("sum8", start=1, stop=-1, at=-1, size=1, endian="big", negate=True)
_DATA = 0x36
_LONGEST = 2048 + 7
_TICKS_HZ = 10_000.0
_COUNTER, _TIME = 0x1020, 0x1060
_PVT, _SATELLITES, _UTC = 0x7010, 0x7020, 0x1010


@dataclass(frozen=True, slots=True)
class _Item:
    """One kind of data: its channels and how a number becomes their value."""

    channels: tuple[Channel, ...]
    kind: str = "float"
    scale: float = 1.0
    sample: bool = True
    """Whether a packet that holds it is a sample."""


def _axes(name: str, unit: str, role: str, axes: str = "xyz") -> tuple[Channel, ...]:
    return tuple(Channel(f"{name}_{a}", unit, f"{role}.{a}" if role else "") for a in axes)


def _named(unit: str, *names: str) -> tuple[Channel, ...]:
    return tuple(Channel(name, unit) for name in names)


_EULER = tuple(Channel(name, "deg", f"angle.{name}") for name in ("roll", "pitch", "yaw"))
_MATRIX = _named("", *(f"matrix_{letter}" for letter in "abcdefghi"))

_ITEMS: Mapping[int, _Item] = {
    0x0810: _Item((Channel("temp", "degC", "temp"),)),
    _UTC: _Item((Channel("utc", "s"),), "utc", sample=False),
    _COUNTER: _Item((Channel("packet_counter", "code", "counter"),), ">u2", sample=False),
    _TIME: _Item((Channel("sample_time", "s", "time"),), ">u4", 1 / _TICKS_HZ, sample=False),
    0x1070: _Item((Channel("sample_time_coarse", "s"),), ">u4", sample=False),
    0x2010: _Item(_named("", "q0", "q1", "q2", "q3")),
    0x2020: _Item(_MATRIX),
    0x2030: _Item(_EULER),
    0x3010: _Item((Channel("pressure", "Pa"),), ">u4"),
    0x4010: _Item(_axes("delta_v", "m/s", "dvel")),
    0x4020: _Item(_axes("acc", "m/s^2", "acc")),
    0x4030: _Item(_axes("free_acc", "m/s^2", "")),
    0x4040: _Item(_axes("acc_hr", "m/s^2", "acc")),
    0x5020: _Item((Channel("altitude", "m"),)),
    0x5030: _Item(_axes("ecef", "m", "")),
    0x5040: _Item(_named("deg", "latitude", "longitude")),
    0x8020: _Item(_axes("gyro", "deg/s", "rate"), scale=DEG_PER_RAD),
    0x8030: _Item(_named("", "dq0", "dq1", "dq2", "dq3")),
    0x8040: _Item(_axes("gyro_hr", "deg/s", "rate"), scale=DEG_PER_RAD),
    0xC020: _Item(_axes("mag", "a.u.", "mag")),
    0xD010: _Item(_axes("velocity", "m/s", "")),
    0xE010: _Item((Channel("status", "code", "status"),), ">u1", sample=False),
    0xE020: _Item((Channel("status", "code", "status"),), ">u4", sample=False),
}
_FLOATS = (">f4", "fp1220", "fp1632", ">f8")
"""Meaning of the two lowest bits of an identifier."""
_SIZES = {">f4": 4, "fp1220": 4, "fp1632": 6, ">f8": 8, ">u1": 1, ">u2": 2, ">u4": 4, "utc": 12}

_PVT_FORM = Struct(">IH5BBIi4BiiiiIIiiiiiIIi7H")
_PVT_NAMES = (
    "itow", "year", "month", "day", "hour", "min", "sec", "valid", "t_acc", "nano", "fix_type",
    "flags", "num_sv", "reserved1", "lon", "lat", "height", "h_msl", "h_acc", "v_acc", "vel_n",
    "vel_e", "vel_d", "g_speed", "head_mot", "s_acc", "head_acc", "head_veh", "gdop", "pdop",
    "tdop", "vdop", "hdop", "ndop", "edop",
)  # fmt: skip
_SATELLITES_FORM = Struct(">I4B")
_SATELLITES_NAMES = ("itow", "num_svs", "res1", "res2", "res3")


@dataclass(frozen=True, slots=True)
class _Place:
    """Where one item stands in a packet."""

    item: _Item
    kind: str
    at: int


def _read_utc(raw: ByteArray) -> FloatArray:
    """Return seconds since 1970; (n, 12) uint8 -> (n, 1)."""
    wide = raw.astype(np.int64)
    year, month, day = (wide[:, 4] << 8) | wide[:, 5], wide[:, 6], wide[:, 7]
    before = year - (month <= 2)  # years and months counted from March put the leap day last
    shifted = (month + 9) % 12
    days = 365 * before + before // 4 - before // 100 + before // 400
    days += (153 * shifted + 2) // 5 + day - 1 - 719468
    seconds = (days * 24 + wide[:, 8]) * 3600 + wide[:, 9] * 60 + wide[:, 10]
    nanoseconds = raw[:, :4].view(">u4")[:, 0].astype(np.float64)
    return (seconds + nanoseconds * 1e-9).reshape(-1, 1)


def _read(rows: ByteArray, place: _Place) -> FloatArray:
    """Return the numbers of one item; (n, length) uint8 -> (n, k) float64."""
    count = len(place.item.channels)
    raw = rows[:, place.at : place.at + count * _SIZES[place.kind]]
    if place.kind == "utc":
        return _read_utc(raw)
    if place.kind == "fp1220":
        return raw.view(">i4").astype(np.float64) * 2.0**-20
    if place.kind == "fp1632":
        parts = raw.reshape(len(rows), count, 6)
        fraction = np.ascontiguousarray(parts[:, :, :4]).view(">u4")[:, :, 0].astype(np.float64)
        whole = np.ascontiguousarray(parts[:, :, 4:]).view(">i2")[:, :, 0]
        return whole + fraction * 2.0**-32
    return raw.view(place.kind).astype(np.float64)


def _values(rows: ByteArray, places: tuple[_Place, ...], columns: int) -> FloatArray:
    data = np.empty((len(rows), columns))
    begin = 0
    with np.errstate(invalid="ignore"):  # a signalling NaN where the unit has no value yet
        for place in places:
            end = begin + len(place.item.channels)
            data[:, begin:end] = _read(rows, place)
            if place.item.scale != 1.0:
                data[:, begin:end] *= place.item.scale
            begin = end
    return data


def _counts(rows: ByteArray, place: _Place) -> IntArray:
    size = _SIZES[place.kind]
    return rows[:, place.at : place.at + size].view(place.kind)[:, 0].astype(np.int64)


def _told(heads: ByteArray) -> IntArray:
    """Return whole lengths; an extended one whose bytes are missing yet counts as long as they."""
    short = heads[:, 3].astype(np.int64)
    extended = (heads[:, 4].astype(np.int64) << 8) | heads[:, 5]
    whole = np.where(short == 0xFF, extended + 7, short + 5)
    return np.where(whole <= _LONGEST, whole, 0)


def _data_start(frame: bytes) -> int:
    return 6 if frame[3] == 0xFF else 4


def _items(frame: bytes) -> list[tuple[int, int, int]]:
    """Return identifier, place of the data and size of each item of a measurement."""
    at, end = _data_start(frame), len(frame) - 1
    items: list[tuple[int, int, int]] = []
    while at + 3 <= end:
        size = frame[at + 2]
        if at + 3 + size > end:
            break
        items.append((int.from_bytes(frame[at : at + 2], "big"), at + 3, size))
        at += 3 + size
    return items


def _place(identifier: int, at: int, size: int) -> _Place | None:
    """Return how an item is read; None if it is unknown or not of its proper size."""
    item = _ITEMS.get(identifier & 0xFFF0)
    if item is None:
        return None
    kind = _FLOATS[identifier & 3] if item.kind == "float" else item.kind
    return _Place(item, kind, at) if size == _SIZES[kind] * len(item.channels) else None


def _report(frame: bytes) -> Message:
    """Return a measurement without a sample: satellites, or nothing but times."""
    fields: dict[str, str] = {}
    for identifier, at, size in _items(frame):
        data = frame[at : at + size]
        for known, form, names in (
            (_PVT, _PVT_FORM, _PVT_NAMES),
            (_SATELLITES, _SATELLITES_FORM, _SATELLITES_NAMES),
        ):
            if identifier & 0xFFF0 == known and size >= form.size:
                fields.update(zip(names, map(str, form.unpack_from(data)), strict=True))
    return Message("satellites" if fields else "packet", frame, fields)


def _reply(frame: bytes) -> Message:
    """Return any other message of the unit."""
    message, data = frame[2], frame[_data_start(frame) : -1]
    fields: dict[str, str] = {}
    if message == 0x01:
        fields["serial"] = data.hex().upper()
    elif message == 0x13 and len(data) >= 3:
        fields["firmware"] = f"{data[0]}.{data[1]}.{data[2]}"
    elif message == 0x1D:
        fields["model"] = data.decode("ascii", errors="replace").strip("\0 ")
    elif message == 0xC1:
        pairs = (data[n : n + 4].hex().upper() for n in range(0, len(data) - 3, 4))
        fields["outputs"] = " ".join(f"{pair[:4]}@{int(pair[4:], 16)}" for pair in pairs)
    elif message == 0x42:
        fields["error"] = data.hex()
    elif message not in (0x11, 0x31):
        return Message(f"unknown 0x{message:02X}", frame, {})
    return Message("reply", frame, fields | {"message": f"0x{message:02X}"})


class XsensDecoder(StreamDecoder):
    """Bytes of an Xsens MTi to events."""

    def __init__(self, profile: Profile) -> None:
        self._layouts: dict[bytes, Layout] = {}
        self._counted = 0
        starts = ((0xFA,), (0xFF,))
        shape = Shape(starts, 6, _LONGEST, _told, Checksum(CHECKSUM).intact, least=4)
        super().__init__(shape, SampleCounter(), profile.nominal_hz)

    @property
    def rate(self) -> float:
        """Rate by the step of the sample time once it is known, else as declared."""
        if self._counted == _TIME and self._counter.step:
            return _TICKS_HZ / self._counter.step
        return self._nominal_hz

    def layout(self, frame: bytes) -> Layout:
        """Return the layout by the identifiers and sizes of all items."""
        items = _items(frame) if frame[2] == _DATA else []
        places = [2, *(at - 3 + n for _, at, _ in items for n in range(3))]
        head = bytes(frame[place] for place in places)
        key = head + len(frame).to_bytes(2, "big")
        found = self._layouts.get(key)
        if found is None:
            same = (np.array(places), np.frombuffer(head, dtype=np.uint8))
            found = self._layouts[key] = self._make(frame, items, same)
        return found

    def _make(
        self, frame: bytes, items: list[tuple[int, int, int]], same: tuple[IntArray, ByteArray]
    ) -> Layout:
        known = [place for item in items if (place := _place(*item)) is not None]
        names: set[str] = set()
        places: list[_Place] = []
        for place in known:
            own = {channel.name for channel in place.item.channels}
            if not own & names:
                places.append(place)
                names |= own
        channels = tuple(channel for place in places for channel in place.item.channels)
        values = partial(_values, places=tuple(places), columns=len(channels))
        if not any(place.item.sample for place in places):
            message = _report if frame[2] == _DATA else _reply
            return Layout((), values, None, same, message)
        return Layout(channels, values, self._counting(places), same)

    def _counting(self, places: list[_Place]) -> "partial[IntArray] | None":
        """Return what reads the counter; the first sample settles which item that is."""
        found = {kind: place for place in places for kind in (_TIME, _COUNTER)
                 if place.item is _ITEMS[kind]}  # fmt: skip
        if not self._counted and found:
            self._counted = _TIME if _TIME in found else _COUNTER
            self._counter = SampleCounter(bits=32 if self._counted == _TIME else 16)
        place = found.get(self._counted)
        return None if place is None else partial(_counts, place=place)
