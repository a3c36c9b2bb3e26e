"""A description as the text of a device file, which `drivers.profile` reads back as it was."""

import json
import math
from collections.abc import Iterable, Sequence

from drivers.checksums import CRC_PRESETS, ChecksumSpec
from drivers.profile_types import (
    CounterSpec,
    DeviceSection,
    FieldSpec,
    FrameSpec,
    LengthSpec,
    LineSpec,
    PortSettings,
)


def profile_text(
    device: DeviceSection, port: PortSettings, stream: FrameSpec | LineSpec, nominal_hz: float = 0.0
) -> str:
    """Return the text of a device file.

    Parameters
    ----------
    device, port, stream : what the sections say
    nominal_hz : samples per second; 0 leaves it out
    """
    lines = ["schema = 1", "", "[device]", _pair("name", device.name), _pair("kind", device.kind)]
    lines += [_pair("layout", device.layout)] if device.layout else []
    lines += [_pair("notes", device.notes)] if device.notes else []
    lines += ["", "[port]", f"baud = [{', '.join(map(str, port.bauds))}]"]
    lines.append(_pair("format", f"{port.data_bits}{port.parity}{port.stop_bits}"))
    lines += [f"settle_ms = {port.settle_ms}"] if port.settle_ms else []
    lines += [f"{name} = true" for name in ("dtr", "rts") if getattr(port, name)]
    rate = [f"nominal_hz = {_number(nominal_hz)}"] if nominal_hz > 0 else []
    if isinstance(stream, FrameSpec):
        lines += ["", "[frame]", *_frame(stream), *rate]
        for field in stream.fields:
            lines += ["", "[[field]]", *_field(field, stream.endian)]
    else:
        lines += ["", "[line]", *_line(stream), *rate]
    return "\n".join(lines) + "\n"


def _frame(spec: FrameSpec) -> Iterable[str]:
    words = (".." if byte is None else f"{byte:02X}" for byte in spec.sync)
    yield _pair("sync", " ".join(words))
    yield f"length = {_length(spec.length)}"
    yield _pair("endian", spec.endian)
    yield f"checksum = {_checksum(spec.checksum)}"
    if spec.counter is not None:
        yield _counter(spec.counter)
    if math.isfinite(spec.reject_abs):
        yield f"reject_abs = {_number(spec.reject_abs)}"
    if spec.tail:
        yield _pair("tail", spec.tail.hex(" ").upper())


def _length(length: int | LengthSpec) -> str:
    if isinstance(length, int):
        return str(length)
    kind = json.dumps(f"u{8 * length.size}")
    return (
        f'{{ at = {length.at}, type = {kind}, endian = "{length.endian}", add = {length.add},'
        f" mul = {length.mul}, min = {length.low}, max = {length.high} }}"
    )


def _checksum(spec: ChecksumSpec | None) -> str:
    if spec is None:
        return '{ alg = "none" }'
    parts = [
        f"alg = {json.dumps(spec.algorithm)}",
        f"from = {spec.start}",
        f"to = {spec.stop}",
        f"at = {spec.at}",
        f'type = "u{8 * spec.size}"',
        f'endian = "{spec.endian}"',
    ]
    parts += ["negate = true"] if spec.negate else []
    parts += [f"pad_to = {spec.pad_to}"] if spec.pad_to else []
    if spec.crc is not None and spec.algorithm not in CRC_PRESETS:
        crc, digits = spec.crc, spec.crc.width // 4
        parts += [f"{name} = 0x{getattr(crc, name):0{digits}X}" for name in ("poly", "init")]
        parts += [f"{name} = true" for name in ("refin", "refout") if getattr(crc, name)]
        parts += [f"xorout = 0x{crc.xorout:0{digits}X}"] if crc.xorout else []
    return f"{{ {', '.join(parts)} }}"


def _counter(spec: CounterSpec) -> str:
    step = '"auto"' if spec.step is None else str(spec.step)
    return (
        f"counter = {{ field = {json.dumps(spec.field, ensure_ascii=False)},"
        f" bits = {spec.bits}, step = {step} }}"
    )


def _field(spec: FieldSpec, endian: str) -> Iterable[str]:
    yield f"names = {_texts(channel.name for channel in spec.channels)}"
    yield _pair("type", spec.type)
    yield f"at = {spec.at}"
    if spec.endian != endian:
        yield _pair("endian", spec.endian)
    if spec.scale != 1.0:
        yield f"scale = {_number(spec.scale)}"
    if spec.offset != 0.0:
        yield f"offset = {_number(spec.offset)}"
    if spec.channels[0].unit != "code":
        yield _pair("unit", spec.channels[0].unit)
    if any(channel.role for channel in spec.channels):
        yield f"roles = {_texts(channel.role for channel in spec.channels)}"
    if spec.bits is not None:
        yield f"bits = [{spec.bits[0]}, {spec.bits[1]}]"
    if spec.hide:
        yield "hide = true"


def _line(spec: LineSpec) -> Iterable[str]:
    names = [channel.name for channel in spec.channels]
    if names:
        yield f"columns = {_texts(names)}"
    for key, value in (("prefix", spec.prefix), ("suffix", spec.suffix)):
        if value:
            yield _pair(key, value)
    yield _pair("delimiter", spec.delimiter)
    yield _pair("decimal", spec.decimal)
    yield _pair("style", spec.style)
    if spec.end != "\n":
        yield _pair("end", spec.end)
    if names:
        yield f"units = {_texts(channel.unit for channel in spec.channels)}"
    if any(channel.role for channel in spec.channels):
        yield f"roles = {_texts(channel.role for channel in spec.channels)}"
    yield from _factors("scale", spec.scales, 1.0)
    yield from _factors("offset", spec.offsets, 0.0)
    yield f"digits = {spec.digits}"
    if spec.checksum:
        yield _pair("checksum", "nmea")
    if spec.counter is not None:
        yield _counter(spec.counter)


def _factors(key: str, values: Sequence[float], usual: float) -> Iterable[str]:
    if any(value != usual for value in values):
        yield f"{key} = [{', '.join(map(_number, values))}]"


def _pair(key: str, text: str) -> str:
    return f"{key} = {json.dumps(text, ensure_ascii=False)}"


def _texts(texts: Iterable[str]) -> str:
    return f"[{', '.join(json.dumps(text, ensure_ascii=False) for text in texts)}]"


def _number(value: float) -> str:
    return repr(int(value)) if value == int(value) and abs(value) < 1e15 else repr(float(value))
