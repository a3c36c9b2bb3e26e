"""Messages of Inertial Labs / InnaLabs AHRS, IMU and INS units (the family of the PW09).

Frame: ``AA 55 | type | id | length u16 | payload | sum16``; the length counts everything but the
two sync bytes. All little-endian. The ranges behind KG (counts per deg/s) and KA (counts per g) are
those of the single unit, so they are [params] of its device file. Axes: right, forward, up.

Offsets and scales: the vendor's public SDK. The tail of 0x80 and 0x83 behind the temperature is
not verified on hardware.
"""

from collections.abc import Mapping
from functools import partial

import numpy as np

from core.arrays import IntArray
from core.samples.block import Channel
from core.units import STANDARD_GRAVITY
from drivers.checksums import Checksum, ChecksumSpec
from drivers.counter import SampleCounter
from drivers.events import Message
from drivers.fields import FieldTable
from drivers.frame import told_lengths
from drivers.profile import Profile
from drivers.profile_types import TYPES, FieldSpec, LengthSpec
from drivers.shape import ByteArray, Shape
from drivers.stream import Layout, StreamDecoder

HEADER = 6
CHECKSUM = ChecksumSpec("sum16", start=2, stop=-2, at=-2, size=2, endian="little")
_LENGTH = LengthSpec(at=4, size=2, endian="little", add=2, mul=1, low=9, high=1024)
_ALIGNMENT = (50, 128)
"""Payloads of the report that comes once the initial alignment is done."""
_UDD = 0x95
_MICRO_G = 1e-6 * STANDARD_GRAVITY
_ACC_BIAS = tuple(Channel(f"acc_bias_{axis}", "m/s^2") for axis in "xyz")
_DEVICE_INFO = 0x12
_FIRMWARE = 0x1F


def _three(name: str, kind: str, at: int, scale: float, unit: str, role: str) -> FieldSpec:
    channels = tuple(Channel(f"{name}_{axis}", unit, f"{role}.{axis}") for axis in "xyz")
    return FieldSpec(channels, kind, at, scale)


def _one(name: str, kind: str, at: int, scale: float, unit: str, role: str = "") -> FieldSpec:
    return FieldSpec((Channel(name, unit, role),), kind, at, scale)


def _angles(kinds: tuple[str, str, str], at: int, scale: float) -> tuple[FieldSpec, ...]:
    fields: list[FieldSpec] = []
    for name, kind in zip(("heading", "pitch", "roll"), kinds, strict=True):
        fields.append(_one(name, kind, at, scale, "deg", f"angle.{name}"))
        at += TYPES[kind]
    return tuple(fields)


def _triads(at: int, kg: float, ka: float) -> tuple[FieldSpec, ...]:
    return (
        _three("gyro", "i16", at, 1 / kg, "deg/s", "rate"),
        _three("acc", "i16", at + 6, STANDARD_GRAVITY / ka, "m/s^2", "acc"),
        _three("mag", "i16", at + 12, 10.0, "nT", "mag"),
    )


def _supply(vsup: int, temp: int) -> tuple[FieldSpec, ...]:
    return (
        _one("vsup", "u16", vsup, 0.01, "V"),
        _one("temp", "i16", temp, 0.1, "degC", "temp"),
    )


def message_fields(message: int, kg: float, ka: float) -> tuple[FieldSpec, ...]:
    """Return the fields of a message by its id, at their places in the frame; () if unknown."""
    short = ("u16", "i16", "i16")
    match message:
        case 0x33:
            status = (_one("usw", "u16", 34, 1.0, "code", "status"),)
            return _angles(short, 6, 0.01) + _triads(12, kg, ka) + status + _supply(36, 38)
        case 0x80 | 0x83:
            return _angles(short, 6, 0.01) + _triads(12, kg, ka) + _supply(36, 38)
        case 0x8D:
            return _triads(6, kg, ka) + _supply(32, 34)
        case 0x8F:
            gyro = _three("gyro", "i32", 6, 1e-5, "deg/s", "rate")
            return (gyro, _three("acc", "i32", 18, _MICRO_G, "m/s^2", "acc"), *_supply(34, 36))
        case _:
            return ()


def _udd_item(item: int, at: int, kg: float, ka: float) -> tuple[FieldSpec, ...]:
    """Return the fields of one item of a user-defined data message; () if unknown."""
    position = (("latitude", 1e-7, "deg"), ("longitude", 1e-7, "deg"), ("altitude", 1e-2, "m"))
    items: Mapping[int, tuple[FieldSpec, ...]] = {
        0x01: (_one("ms_gps", "u32", at, 1.0, "ms", "time"),),
        0x07: _angles(("u16", "i16", "i16"), at, 0.01),
        0x08: _angles(("i32", "i32", "i32"), at, 0.001),
        0x09: (FieldSpec(tuple(Channel(f"q{n}", "") for n in range(4)), "i16", at, 1e-4),),
        0x10: tuple(_one(n, "i32", at + 4 * k, s, u) for k, (n, s, u) in enumerate(position)),
        0x12: (FieldSpec(tuple(Channel(f"vel_{n}", "m/s") for n in "enu"), "i32", at, 0.01),),
        0x20: (_three("gyro", "i16", at, 1 / kg, "deg/s", "rate"),),
        0x21: (_three("gyro", "i32", at, 1e-5, "deg/s", "rate"),),
        0x22: (_three("acc", "i16", at, STANDARD_GRAVITY / ka, "m/s^2", "acc"),),
        0x23: (_three("acc", "i32", at, _MICRO_G, "m/s^2", "acc"),),
        0x24: (_three("mag", "i16", at, 10.0, "nT", "mag"),),
        0x25: (_one("p_bar", "u16", at, 2.0, "Pa"), _one("h_bar", "i32", at + 2, 0.01, "m")),
        0x26: (
            FieldSpec(tuple(Channel(f"gyro_bias_{a}", "deg/s") for a in "xyz"), "i8", at, 2e-4),
            FieldSpec(_ACC_BIAS, "i8", at + 3, 2e-5 * STANDARD_GRAVITY),
            _one("bias_reserved", "u8", at + 6, 1.0, "code"),
        ),
        0x3C: (_one("gps_week", "u16", at, 1.0, "week"),),
        0x41: (_one("new_gps", "u8", at, 1.0, "code"),),
        0x50: (_one("vsup", "u16", at, 0.01, "V"),),
        0x51: (_one("vstab", "u16", at, 0.001, "V"),),
        0x52: (_one("temp", "i16", at, 0.1, "degC", "temp"),),
        0x53: (_one("usw", "u16", at, 1.0, "code", "status"),),
    }
    return items.get(item, ())


def _text(raw: bytes) -> str:
    return raw.split(b"\0", 1)[0].decode("ascii", errors="replace").strip()


def _reply(frame: bytes) -> Message:
    """Return what a frame without samples says."""
    kind, message, payload = frame[2], frame[3], frame[HEADER:-2]
    if kind == 0:
        command = payload[0] if payload else message
        return Message(f"command 0x{command:02X}", frame, {})
    if message == _DEVICE_INFO and len(payload) >= 48:
        fields = {"serial": _text(payload[:8]), "firmware": _text(payload[8:48])}
        return Message("reply", frame, fields)
    if message == _FIRMWARE:
        return Message("reply", frame, {"firmware": _text(payload)})
    if len(payload) <= 2:
        return Message("reply", frame, {"ack": f"0x{message:02X}"})
    if len(payload) in _ALIGNMENT:
        return Message("alignment report", frame, {})
    return Message(f"unknown 0x{message:02X}", frame, {})


class InertialDecoder(StreamDecoder):
    """Bytes of an Inertial Labs unit to events.

    Parameters
    ----------
    profile : its [params] hold KG and KA
    """

    def __init__(self, profile: Profile) -> None:
        message = profile.option("message")
        self._kg, self._ka = profile.params["KG"], profile.params["KA"]
        expected = FieldTable(message_fields(message, self._kg, self._ka))
        self._layouts: dict[bytes, Layout] = {}
        starts = ((0xAA,), (0x55,), (0, 1))
        lengths = partial(told_lengths, field=_LENGTH)
        shape = Shape(starts, HEADER, _LENGTH.high, lengths, Checksum(CHECKSUM).intact)
        super().__init__(shape, SampleCounter(bits=32), profile.nominal_hz, expected.channels)

    def layout(self, frame: bytes) -> Layout:
        """Return the layout by type, id and, for user-defined data, the list of items."""
        listed = 1 + frame[HEADER] if frame[2:4] == bytes((1, _UDD)) else 0
        head = frame[2:4] + frame[HEADER : HEADER + listed]
        key = head + len(frame).to_bytes(2, "little")
        found = self._layouts.get(key)
        if found is None:
            places = np.array([2, 3, *range(HEADER, HEADER + listed)])
            same = (places, np.frombuffer(head, dtype=np.uint8))
            found = self._layouts[key] = self._make(frame, same)
        return found

    def _make(self, frame: bytes, same: tuple[IntArray, ByteArray]) -> Layout:
        fields: tuple[FieldSpec, ...] = ()
        if frame[2] == 1:
            fields = self._udd(frame) if frame[3] == _UDD else self._known(frame)
        table = FieldTable(fields)
        if not fields:
            return Layout((), table.values, None, same, _reply)
        timed = any(channel.role == "time" for channel in table.channels)
        counts = partial(table.counts, name="ms_gps") if timed else None
        return Layout(table.channels, table.values, counts, same)

    def _known(self, frame: bytes) -> tuple[FieldSpec, ...]:
        fields = message_fields(frame[3], self._kg, self._ka)
        payload = len(frame) - HEADER - 2
        fits = bool(fields) and fields[-1].end <= len(frame) - 2 and payload not in _ALIGNMENT
        return fields if fits else ()

    def _udd(self, frame: bytes) -> tuple[FieldSpec, ...]:
        end = len(frame) - 2
        at = HEADER + 1 + frame[HEADER]
        fields: list[FieldSpec] = []
        for item in frame[HEADER + 1 : at]:
            new = _udd_item(item, at, self._kg, self._ka)
            if not new or new[-1].end > end:
                return ()
            fields.extend(new)
            at = new[-1].end
        names = [channel.name for spec in fields for channel in spec.channels]
        return tuple(fields) if len(set(names)) == len(names) else ()
