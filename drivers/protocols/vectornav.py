"""Binary messages of VectorNav units.

``FA | groups u8 | mask u16 of each group | fields | CRC-16``: each bit of a mask stands for one
field, in the order of the bits. Fields are little-endian, the checksum is big-endian. Messages with
extension words, satellite lists or raw satellite data are not taken (garbage), since their length
is not told by the masks.

Where a message holds both, the uncompensated sensors are the ones to calibrate: they get the roles.
Fields and sizes: the vendor's public SDK.
"""

from collections.abc import Mapping
from functools import cache, partial

import numpy as np

from core.arrays import IntArray
from core.samples.block import Channel
from core.units import DEG_PER_RAD
from drivers.checksums import CRC_PRESETS, Checksum, ChecksumSpec
from drivers.counter import SampleCounter
from drivers.fields import FieldTable
from drivers.profile import Profile
from drivers.profile_types import FieldSpec
from drivers.shape import ByteArray, Shape
from drivers.stream import Layout, StreamDecoder

CHECKSUM = ChecksumSpec(
    "crc-16/xmodem", start=1, stop=-2, at=-2, size=2, endian="big", crc=CRC_PRESETS["crc-16/xmodem"]
)
_GROUPS = 7
_HEADER = 2 + 2 * _GROUPS
_MICROSECONDS = 1e6
_UNCOMPENSATED = "uncomp_"

Piece = tuple[str, float, tuple[Channel, ...]]
"""Type, scale and channels of neighbouring values."""


def _xyz(name: str, unit: str, role: str = "", axes: str = "xyz") -> tuple[Channel, ...]:
    return tuple(Channel(f"{name}_{a}", unit, f"{role}.{a}" if role else "") for a in axes)


def _one(kind: str, name: str, unit: str, role: str = "", scale: float = 1.0) -> tuple[Piece, ...]:
    return ((kind, scale, (Channel(name, unit, role),)),)


def _floats(channels: tuple[Channel, ...], scale: float = 1.0) -> tuple[Piece, ...]:
    return (("f32", scale, channels),)


def _names(unit: str, *names: str) -> tuple[Channel, ...]:
    return tuple(Channel(name, unit) for name in names)


def _time(name: str, role: str = "") -> tuple[Piece, ...]:
    return _one("u64", name, "s", role, 1e-9)


def _position(name: str) -> tuple[Piece, ...]:
    degrees = _names("deg", f"{name}latitude", f"{name}longitude")
    return (("f64", 1.0, degrees), ("f64", 1.0, _names("m", f"{name}altitude")))


def _utc(name: str) -> tuple[Piece, ...]:
    parts = _names("", *(f"{name}utc_{part}" for part in ("month", "day", "hour", "min", "sec")))
    year, fraction = _names("", f"{name}utc_year", f"{name}utc_ms")
    return (("i8", 1.0, (year,)), ("u8", 1.0, parts), ("u16", 1.0, (fraction,)))


_YPR = tuple(
    Channel(name, "deg", f"angle.{role}")
    for name, role in (("yaw", "heading"), ("pitch", "pitch"), ("roll", "roll"))
)
_QUATERNION = _names("", "qx", "qy", "qz", "qw")
_RATE = _floats(_xyz("gyro", "deg/s", "rate"), DEG_PER_RAD)
_ACC = _floats(_xyz("acc", "m/s^2", "acc"))
_MAG = _floats(_xyz("mag", "gauss", "mag"))
_RAW_RATE = _floats(_xyz("uncomp_gyro", "deg/s", "rate"), DEG_PER_RAD)
_RAW_ACC = _floats(_xyz("uncomp_acc", "m/s^2", "acc"))
_RAW_MAG = _floats(_xyz("uncomp_mag", "gauss", "mag"))
_TEMP, _PRESSURE = _one("f32", "temp", "degC", "temp"), _one("f32", "pressure", "kPa")
_TURN = (*_one("f32", "delta_time", "s"), *_floats(_xyz("delta_theta", "deg", "dangle")))
_PUSH = _floats(_xyz("delta_v", "m/s", "dvel"))
_VELOCITY = _floats(_xyz("velocity", "m/s", "", "ned"))
_START = _time("time_startup", "time")
_SYNC = _one("u32", "sync_in_count", "code")
_INS = _one("u16", "ins_status", "code", "status")


def _gnss(name: str) -> Mapping[int, tuple[Piece, ...]]:
    return {
        0: _utc(name), 1: _time(f"{name}tow"), 2: _one("u16", f"{name}week", "week"),
        3: _one("u8", f"{name}satellites", "code"), 4: _one("u8", f"{name}fix", "code"),
        5: _position(name), 6: (("f64", 1.0, _xyz(f"{name}ecef", "m")),),
        7: _floats(_xyz(f"{name}velocity", "m/s", "", "ned")),
        8: _floats(_xyz(f"{name}velocity_ecef", "m/s")),
        9: _floats(_xyz(f"{name}position_sd", "m", "", "ned")),
        10: _one("f32", f"{name}velocity_sd", "m/s"), 11: _one("f32", f"{name}time_sd", "s"),
        12: _one("u16", f"{name}time_info", "code"),
        13: _floats(_names("", *(f"{name}dop{n}" for n in range(7)))),
    }  # fmt: skip


_FIELDS: tuple[Mapping[int, tuple[Piece, ...]], ...] = (
    {
        0: _START, 1: _time("time_gps"), 2: _time("time_sync_in"), 3: _floats(_YPR),
        4: _floats(_QUATERNION), 5: _RATE, 6: _position(""), 7: _VELOCITY, 8: _ACC,
        9: (*_RAW_ACC, *_RAW_RATE), 10: (*_MAG, *_TEMP, *_PRESSURE), 11: (*_TURN, *_PUSH),
        12: _INS, 13: _SYNC, 14: _time("time_gps_pps"),
    },
    {
        0: _START, 1: _time("time_gps"), 2: _time("gps_tow"), 3: _one("u16", "gps_week", "week"),
        4: _time("time_sync_in"), 5: _time("time_gps_pps"), 6: _utc(""), 7: _SYNC,
        8: _one("u32", "sync_out_count", "code"), 9: _one("u8", "time_status", "code"),
    },
    {
        0: _one("u16", "imu_status", "code", "status"), 1: _RAW_MAG, 2: _RAW_ACC, 3: _RAW_RATE,
        4: _TEMP, 5: _PRESSURE, 6: _TURN, 7: _PUSH, 8: _MAG, 9: _ACC, 10: _RATE,
        11: _one("u16", "saturation", "code", "status"),
    },
    _gnss("gnss1_"),
    {
        1: _floats(_YPR), 2: _floats(_QUATERNION),
        3: _floats(_names("", *(f"dcm_{n}" for n in range(9)))),
        4: _floats(_xyz("mag_ned", "gauss")),
        5: _floats(_xyz("acc_ned", "m/s^2")), 6: _floats(_xyz("linear_acc", "m/s^2")),
        7: _floats(_xyz("linear_acc_ned", "m/s^2")),
        8: _floats(_names("deg", "yaw_sd", "pitch_sd", "roll_sd")),
    },
    {
        0: _INS, 1: _position(""), 2: (("f64", 1.0, _xyz("ecef", "m")),),
        3: _floats(_xyz("velocity_body", "m/s")), 4: _VELOCITY,
        5: _floats(_xyz("velocity_ecef", "m/s")), 6: _floats(_xyz("mag_ecef", "gauss")),
        7: _floats(_xyz("acc_ecef", "m/s^2")), 8: _floats(_xyz("linear_acc_ecef", "m/s^2")),
        9: _one("f32", "position_sd", "m"), 10: _one("f32", "velocity_sd", "m/s"),
    },
    _gnss("gnss2_"),
)  # fmt: skip
"""Fields of each group by the bit of its mask."""

_BYTES = {"u8": 1, "i8": 1, "u16": 2, "u32": 4, "f32": 4, "u64": 8, "f64": 8}
_UNKNOWN = 1 << 20


def _size(pieces: tuple[Piece, ...]) -> int:
    return sum(_BYTES[kind] * len(channels) for kind, _, channels in pieces)


@cache
def _sizes(group: int) -> IntArray:
    """Return the bytes of all fields of a group by its mask; huge where one is unknown."""
    masks = np.arange(1 << 16)
    total = np.zeros(1 << 16, dtype=np.int64)
    for bit in range(16):
        pieces = _FIELDS[group].get(bit)
        total += ((masks >> bit) & 1) * (_UNKNOWN if pieces is None else _size(pieces))
    return total


_LONGEST = _HEADER + 2 + sum(_size(pieces) for group in _FIELDS for pieces in group.values())


def _told(heads: ByteArray) -> IntArray:
    """Return whole lengths; a mask that has not come counts as empty."""
    groups = heads[:, 1]
    words = np.ascontiguousarray(heads[:, 2:_HEADER]).view("<u2")
    place = np.zeros(len(heads), dtype=np.int64)
    payload = np.zeros(len(heads), dtype=np.int64)
    present = int(np.bitwise_or.reduce(groups, initial=0))
    for group in range(_GROUPS):
        if present >> group & 1:
            held = (groups >> group & 1).astype(np.int64)
            mask = words[np.arange(len(heads)), np.minimum(place, _GROUPS - 1)]
            payload += held * _sizes(group)[mask]
            place += held
    return np.where(payload < _UNKNOWN, 2 + 2 * place + payload + 2, 0)


def _header(frame: bytes) -> int:
    return 2 + 2 * frame[1].bit_count()


def _fields(frame: bytes) -> list[FieldSpec]:
    """Return the fields of a message; of two of the same name only the first."""
    at, word = _header(frame), 2
    names: set[str] = set()
    fields: list[FieldSpec] = []
    for group in range(_GROUPS):
        if not frame[1] >> group & 1:
            continue
        mask = int.from_bytes(frame[word : word + 2], "little")
        word += 2
        for bit, pieces in sorted(_FIELDS[group].items()):
            for kind, scale, channels in pieces if mask >> bit & 1 else ():
                spec = FieldSpec(channels, kind, at, scale)
                at = spec.end
                if channels[0].name not in names:
                    names.update(channel.name for channel in channels)
                    fields.append(spec)
    return fields


def _with_roles(fields: list[FieldSpec]) -> list[FieldSpec]:
    """Return the fields with each role given once, to uncompensated sensors first."""
    channels = [channel for spec in fields for channel in spec.channels]
    raw = {channel.role for channel in channels if channel.name.startswith(_UNCOMPENSATED)}
    return [
        FieldSpec(
            tuple(
                Channel(channel.name, channel.unit)
                if channel.role in raw and not channel.name.startswith(_UNCOMPENSATED)
                else channel
                for channel in spec.channels
            ),
            spec.type,
            spec.at,
            spec.scale,
        )
        for spec in fields
    ]


def _start_counts(rows: ByteArray, at: int) -> IntArray:
    """Return the time since start in microseconds, mod 2^32."""
    nanoseconds = rows[:, at : at + 8].view("<u8")[:, 0]
    return (nanoseconds // 1000 % 2**32).astype(np.int64)


class VectorNavDecoder(StreamDecoder):
    """Binary messages of a VectorNav unit to events."""

    def __init__(self, profile: Profile) -> None:
        self._layouts: dict[bytes, Layout] = {}
        starts = ((0xFA,), tuple(range(1, 1 << _GROUPS)))
        shape = Shape(starts, _HEADER, _LONGEST, _told, Checksum(CHECKSUM).intact, least=2)
        super().__init__(shape, SampleCounter(bits=32), profile.nominal_hz)

    @property
    def rate(self) -> float:
        """Declared rate, else by the step of the time since start."""
        if self._nominal_hz or not self._counter.step:
            return self._nominal_hz
        return _MICROSECONDS / self._counter.step

    def layout(self, frame: bytes) -> Layout:
        """Return the layout by groups and masks."""
        head = frame[1 : _header(frame)]
        if head not in self._layouts:
            fields = _with_roles(_fields(frame))
            table = FieldTable(fields)
            same = (np.arange(1, 1 + len(head)), np.frombuffer(head, dtype=np.uint8))
            started = [spec.at for spec in fields if spec.channels[0].name == "time_startup"]
            counts = partial(_start_counts, at=started[0]) if started else None
            self._layouts[head] = Layout(table.channels, table.values, counts, same)
        return self._layouts[head]
