"""Samples to bytes, by the same profile that decodes them: what the simulated rig sends."""

from collections.abc import Callable, Mapping

import numpy as np

from core.arrays import FloatArray, IntArray
from drivers.checksums import Checksum, ChecksumSpec
from drivers.fields import FieldTable
from drivers.profile import Profile
from drivers.profile_types import CounterSpec, FieldSpec, FrameSpec, LengthSpec, LineSpec
from drivers.protocols.inertial import CHECKSUM, HEADER, message_fields
from drivers.shape import ByteArray


def encode(profile: Profile, index: IntArray, data: FloatArray) -> bytes:
    """Return the frames or lines of these samples.

    Integer fields are rounded and held at the ends of their range, as an ADC does. Counters run
    with `index`; a column that is the counter is not read. Hidden fields are sent as zero.

    Parameters
    ----------
    profile : the device
    index : (n,) sample numbers
    data : (n, c) values in the order of ``make_decoder(profile).channels``

    Raises
    ------
    ValueError
        `data` does not fit the channels or holds a value that is not finite, or the profile's
        protocol has no encoder.
    """
    if not np.isfinite(data).all():
        raise ValueError("only finite values can be sent")
    stream = profile.stream
    if isinstance(stream, FrameSpec):
        return _frames(stream, index, data)
    if isinstance(stream, LineSpec):
        return _lines(stream, index, data)
    if stream.name not in ENCODERS:
        raise ValueError(f'there is no encoder for "{stream.name}"')
    return ENCODERS[stream.name](profile, data)


def _check(data: FloatArray, columns: int) -> None:
    if data.ndim != 2 or data.shape[1] != columns:
        raise ValueError(f"data of shape {data.shape} for {columns} channels")


def _counted(counter: CounterSpec, index: IntArray) -> IntArray:
    return index * (counter.step or 1) % (1 << counter.bits)


def _finish(rows: ByteArray, checksum: ChecksumSpec | None) -> bytes:
    if checksum is not None:
        Checksum(checksum).stamp(rows)
    return rows.tobytes()


def _frames(spec: FrameSpec, index: IntArray, data: FloatArray) -> bytes:
    table = FieldTable(spec.fields)
    _check(data, len(table.channels))
    rows = np.zeros((len(data), spec.shortest), dtype=np.uint8)
    counted = spec.counter.field if spec.counter else ""
    table.write(rows, data, skip=counted)
    for position, byte in enumerate(spec.sync):
        if byte is not None:
            rows[:, position] = byte
    if spec.counter is not None:
        table.write_counts(rows, counted, _counted(spec.counter, index))
    if isinstance(spec.length, LengthSpec):
        field = spec.length
        order = "little" if field.endian == "little" else "big"
        told = ((spec.shortest - field.add) // field.mul).to_bytes(field.size, order)
        rows[:, field.at : field.at + field.size] = np.frombuffer(told, dtype=np.uint8)
    if not spec.tail:
        return _finish(rows, spec.checksum)
    body = np.frombuffer(_finish(rows, spec.checksum), dtype=np.uint8).reshape(rows.shape)
    tails = np.tile(np.frombuffer(spec.tail, dtype=np.uint8), (len(rows), 1))
    return np.hstack((body, tails)).tobytes()


def _lines(spec: LineSpec, index: IntArray, data: FloatArray) -> bytes:
    _check(data, len(spec.channels))
    numbers = (data - np.array(spec.offsets)) / np.array(spec.scales)
    lines = [_line(spec, row) for row in _with_counter(spec, index, numbers).tolist()]
    return "".join(lines).encode("ascii", errors="replace")


def _with_counter(spec: LineSpec, index: IntArray, numbers: FloatArray) -> FloatArray:
    if spec.counter is None:
        return numbers
    names = [channel.name for channel in spec.channels]
    numbers[:, names.index(spec.counter.field)] = _counted(spec.counter, index)
    return numbers


def _line(spec: LineSpec, row: list[float]) -> str:
    words = [f"{value:.{spec.digits}f}" for value in row]
    names = [channel.name for channel in spec.channels]
    if spec.style == "json":
        pairs = (f'"{name}":{word}' for name, word in zip(names, words, strict=True))
        return f"{{{','.join(pairs)}}}{spec.end}"
    words = [word.replace(".", spec.decimal) for word in words]
    if spec.style == "labels":
        words = [f"{name}:{word}" for name, word in zip(names, words, strict=True)]
    between = {"tab": "\t", "ws": "\t", "auto": ","}.get(spec.delimiter, spec.delimiter)
    body = spec.prefix + between.join(words) + spec.suffix
    if spec.checksum:
        body += f"*{_xor(body):02X}"
    return body + spec.end


def _xor(body: str) -> int:
    return int(np.bitwise_xor.reduce(np.frombuffer(body.lstrip("$").encode("ascii"), np.uint8)))


def _inertial(profile: Profile, data: FloatArray) -> bytes:
    message = profile.option("message")
    fields: tuple[FieldSpec, ...] = message_fields(
        message, profile.params["KG"], profile.params["KA"]
    )
    table = FieldTable(fields)
    _check(data, len(table.channels))
    length = max(spec.end for spec in fields) + CHECKSUM.size
    rows = np.zeros((len(data), length), dtype=np.uint8)
    head = bytes((0xAA, 0x55, 1, message)) + (length - 2).to_bytes(2, "little")
    rows[:, :HEADER] = np.frombuffer(head, dtype=np.uint8)
    table.write(rows, data)
    return _finish(rows, CHECKSUM)


ENCODERS: Mapping[str, Callable[[Profile, FloatArray], bytes]] = {"inertial_labs": _inertial}
"""Encoders of [protocol] sections by their name."""
