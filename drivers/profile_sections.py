"""The sections of a device file, read strictly into frozen dataclasses."""

import math
import re
from collections.abc import Mapping, Sequence

from core.samples.block import Channel
from drivers.checksums import CHECKSUM_NAMES, CRC_PRESETS, ChecksumSpec, CrcSpec
from drivers.expression import evaluate
from drivers.profile_types import (
    TYPES,
    CounterSpec,
    DeviceSection,
    FieldSpec,
    FrameSpec,
    LengthSpec,
    LineSpec,
    PortSettings,
    ProtocolSpec,
)
from drivers.protocols.options import PROTOCOL_OPTIONS, Option
from drivers.toml_table import Table

KINDS = ("gyro", "accel", "imu", "ahrs", "adc")
LAYOUTS = ("", "clbacc", "pointer", "clbdus", "cvgcom")
_ROLE = re.compile(
    r"(acc|rate|mag|angle|dangle|dvel)(\.[a-z][a-z0-9]*)?|adc\.\d+|incl\.[xyz]"
    r"|temp(\.[a-z][a-z0-9]*)*(\.\d+)?|counter|time|status|"
)
_UNITS = {
    "acc": ("m/s^2", "code", "V"),
    "rate": ("deg/s", "code", "V"),
    "angle": ("deg",),
    "temp": ("degC", "code", "V"),
}
"""Units that the rest of the program understands, by the first word of a role."""
ENDIANS = ("little", "big")
LONGEST_FRAME = 4096


def read_device(table: Table) -> DeviceSection:
    """Read [device]."""
    name = table.text("name")
    if not name.strip():
        table.fail("name", "must not be empty")
    kind = table.choice("kind", KINDS)
    layout = table.choice("layout", LAYOUTS, "")
    notes = table.text("notes", "")
    table.done()
    return DeviceSection(name, kind, layout, notes)


def read_port(table: Table) -> PortSettings:
    """Read [port]."""
    bauds = table.integers("baud")
    if not bauds or min(bauds) < 50 or max(bauds) > 20_000_000:
        table.fail("baud", "must list at least one baud rate between 50 and 20000000")
    form = table.text("format", "8N1")
    if not re.fullmatch(r"[5-8][NEO][12]", form):
        table.fail("format", f'must be like "8N1" (data bits, N/E/O, stop bits), not "{form}"')
    settle = table.integer("settle_ms", 0, high=60_000)
    dtr, rts = table.flag("dtr", False), table.flag("rts", False)
    table.done()
    return PortSettings(bauds, int(form[0]), form[1], int(form[2]), settle, dtr, rts)


def read_params(table: Table, replaced: Mapping[str, float]) -> dict[str, float]:
    """Read [params]; `replaced` overrides values that the file has."""
    params = {name: table.number(name) for name in table.keys()}  # noqa: SIM118
    for name, value in replaced.items():
        if name not in params:
            table.fail("", f'has no "{name}", which this unit replaces')
        params[name] = float(value)
    return params


def read_hex(table: Table, key: str, text: str) -> bytes:
    """Read a row of hexadecimal bytes."""
    try:
        return bytes.fromhex(text)
    except ValueError:
        table.fail(key, f'"{text}" is no row of hexadecimal bytes')


def _sync(table: Table) -> tuple[int | None, ...]:
    words = re.findall(r"\.\.|[0-9A-Fa-f]{2}|\S", table.text("sync"))
    if not 1 <= len(words) <= 8 or any(len(word) != 2 for word in words):
        table.fail("sync", 'must be 1 to 8 bytes like "AA 55"; ".." stands for any byte')
    sync = tuple(None if word == ".." else int(word, 16) for word in words)
    if sync[0] is None:
        table.fail("sync", "must not begin with any byte")
    return sync


def _number(table: Table, key: str, default: str, params: Mapping[str, float]) -> float:
    """Read a number or an expression."""
    if not table.has(key):
        return evaluate(default, params)
    value = table.raw(key)
    return _evaluate(table, key, value, params)


def _evaluate(table: Table, key: str, value: object, params: Mapping[str, float]) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        table.fail(key, f"must be a number or an expression, not {value!r}")
    try:
        return evaluate(str(value), params)
    except ValueError as error:
        table.fail(key, str(error))


def _length(table: Table, sync: tuple[int | None, ...], endian: str) -> int | LengthSpec:
    if not isinstance(table.raw("length"), dict):
        return table.integer("length", low=len(sync) + 1, high=LONGEST_FRAME)
    inner = table.table("length")
    size = TYPES[inner.choice("type", ("u8", "u16"))]
    spec = LengthSpec(
        at=inner.integer("at", high=64),
        size=size,
        endian=inner.choice("endian", ENDIANS, endian),
        add=inner.integer("add", 0, low=-64, high=LONGEST_FRAME),
        mul=inner.integer("mul", 1, low=1, high=64),
        low=inner.integer("min", low=len(sync) + 1, high=LONGEST_FRAME),
        high=inner.integer("max", low=len(sync) + 1, high=LONGEST_FRAME),
    )
    inner.done()
    if spec.high < spec.low or spec.low < spec.at + size:
        table.fail("length", "min must hold the length field, and max must not be below min")
    return spec


def _crc(table: Table, algorithm: str) -> CrcSpec | None:
    if algorithm in CRC_PRESETS:
        return CRC_PRESETS[algorithm]
    if not algorithm.startswith("crc"):
        return None
    width = int(algorithm[3:])
    top = 2**width - 1
    return CrcSpec(
        width,
        poly=table.integer("poly", low=1, high=top),
        init=table.integer("init", 0, high=top),
        refin=table.flag("refin", False),
        refout=table.flag("refout", False),
        xorout=table.integer("xorout", 0, high=top),
    )


def _checksum(outer: Table, shortest: int, endian: str) -> ChecksumSpec | None:
    table = outer.table("checksum")
    algorithm = table.choice("alg", CHECKSUM_NAMES)
    if algorithm == "none":
        table.done()
        return None
    crc = _crc(table, algorithm)
    natural = crc.width // 8 if crc else 1 if algorithm in ("sum8", "xor8") else 2
    size = TYPES[table.choice("type", ("u8", "u16", "u32"), f"u{8 * natural}")]
    spec = ChecksumSpec(
        algorithm,
        start=table.integer("from", low=-shortest, high=shortest),
        stop=table.integer("to", low=-shortest, high=shortest),
        at=table.integer("at", low=-shortest, high=shortest - size),
        size=size,
        endian=table.choice("endian", ENDIANS, endian),
        negate=table.flag("negate", False),
        pad_to=table.integer("pad_to", 0, high=64),
        crc=crc,
    )
    table.done()
    doubt = doubtful(spec, shortest)
    if doubt:
        outer.fail("checksum", doubt)
    return spec


def doubtful(spec: ChecksumSpec, length: int) -> str:
    """Return what is wrong with a checksum in a frame of this length; empty if nothing."""
    covered = range(*slice(spec.start, spec.stop).indices(length))
    at = spec.at if spec.at >= 0 else length + spec.at
    if not covered:
        return "from and to cover no byte"
    if not 0 <= at <= length - spec.size:
        return f"at {spec.at} leaves no room for {spec.size} bytes"
    if at < covered.stop and at + spec.size > covered.start:
        return "from and to cover the checksum itself"
    if spec.algorithm == "sum16w" and len(covered) % 2:
        return f"sum16w needs an even number of bytes, from and to give {len(covered)}"
    return ""


def _channels(
    table: Table, names: tuple[str, ...], units: tuple[str, ...], roles: tuple[str, ...]
) -> tuple[Channel, ...]:
    for key, given in (("units", units), ("roles", roles)):
        if len(given) != len(names):
            table.fail(key, f"has {len(given)} entries for {len(names)} names")
    for role, unit in zip(roles, units, strict=True):
        if not _ROLE.fullmatch(role):
            table.fail("roles", f'"{role}" is no role')
        allowed = _UNITS.get(role.split(".")[0], (unit,))
        if unit not in allowed:
            table.fail("roles", f'"{role}" needs the unit {" or ".join(allowed)}, not "{unit}"')
    if any(not name.strip() for name in names):
        table.fail("names", "a name must not be empty")
    return tuple(map(Channel, names, units, roles))


def _field(table: Table, at: int, endian: str, params: Mapping[str, float]) -> FieldSpec:
    names = table.texts("names")
    if not names:
        table.fail("names", "must name at least one value")
    kind = table.choice("type", TYPES)
    roles = table.texts("roles", ("",) * len(names))
    channels = _channels(table, names, (table.text("unit", "code"),) * len(names), roles)
    bits = table.integers("bits", ())
    if bits and (len(bits) != 2 or not 0 <= bits[0] <= bits[1] < 8 * TYPES[kind]):
        table.fail("bits", f"must be [lowest, highest] within {kind}")
    if bits and kind[0] != "u":
        table.fail("bits", "can only be taken from an unsigned type")
    spec = FieldSpec(
        channels,
        kind,
        at=table.integer("at", at, high=LONGEST_FRAME),
        scale=_number(table, "scale", "1", params),
        offset=_number(table, "offset", "0", params),
        endian=table.choice("endian", ENDIANS, endian),
        bits=(bits[0], bits[1]) if bits else None,
        hide=table.flag("hide", False),
    )
    if spec.scale == 0:
        table.fail("scale", "must not be zero")
    table.done()
    return spec


def _counter(table: Table, names: Sequence[str]) -> CounterSpec | None:
    if not table.has("counter"):
        return None
    inner = table.table("counter")
    field = inner.choice("field", names)
    bits = inner.integer("bits", low=1, high=32)
    step = inner.raw("step") if inner.has("step") else "auto"
    if step != "auto":
        step = inner.integer("step", low=1)
    inner.done()
    return CounterSpec(field, bits, step if isinstance(step, int) else None)


def read_frame(table: Table, sections: Sequence[Table], params: Mapping[str, float]) -> FrameSpec:
    """Read [frame] and its [[field]] sections."""
    sync = _sync(table)
    endian = table.choice("endian", ENDIANS)
    length = _length(table, sync, endian)
    shortest = length if isinstance(length, int) else length.low
    checksum = _checksum(table, shortest, endian)
    tail = read_hex(table, "tail", table.text("tail", ""))
    if len(tail) > 4 or any(byte == sync[0] for byte in tail):
        table.fail("tail", "must be at most 4 bytes, none of them the first of sync")
    if tail and checksum is None:
        table.fail("tail", "needs a checksum; without one let length include these bytes")
    fields: list[FieldSpec] = []
    at = len(sync)
    for section in sections:
        spec = _field(section, at, endian, params)
        if spec.end > shortest:
            section.fail("names", f"end at byte {spec.end}, the frame has {shortest}")
        at = spec.end
        fields.append(spec)
    names = [channel.name for spec in fields for channel in spec.channels]
    if not any(not spec.hide for spec in fields):
        table.fail("", "needs at least one [[field]] that is not hidden")
    double = next((name for name in names if names.count(name) > 1), "")
    if double:
        table.fail("", f'the fields name "{double}" twice')
    counter = _counter(table, names)
    reject = table.number("reject_abs") if table.has("reject_abs") else math.inf
    table.done()
    return FrameSpec(sync, length, endian, checksum, counter, reject, tail, tuple(fields))


def _factors(
    table: Table, key: str, default: str, count: int, params: Mapping[str, float]
) -> tuple[float, ...]:
    if not table.has(key):
        return (evaluate(default, params),) * count
    values = table.listed(key)
    if len(values) != count:
        table.fail(key, f"must hold {count} numbers or expressions, one a column")
    return tuple(_evaluate(table, key, value, params) for value in values)


def read_line(table: Table, params: Mapping[str, float]) -> LineSpec:
    """Read [line]."""
    names = table.texts("columns", ())
    units = table.texts("units", ("code",) * len(names))
    roles = table.texts("roles", ("",) * len(names))
    channels = _channels(table, names, units, roles)
    if len(set(names)) != len(names):
        table.fail("columns", "names a column twice")
    delimiter = table.choice("delimiter", (",", ";", "tab", "ws", "auto"), "auto")
    decimal = table.choice("decimal", (".", ","), ".")
    if delimiter == decimal:
        table.fail("delimiter", "must differ from the decimal mark")
    style = table.choice("style", ("values", "labels", "json"), "values")
    if style != "values" and not names:
        table.fail("columns", f'must be given for style "{style}"')
    spec = LineSpec(
        prefix=table.text("prefix", ""),
        suffix=table.text("suffix", ""),
        delimiter=delimiter,
        decimal=decimal,
        end=table.choice("end", ("\n", "\r\n", "\r"), "\n"),
        style=style,
        channels=channels,
        scales=_factors(table, "scale", "1", len(names), params),
        offsets=_factors(table, "offset", "0", len(names), params),
        digits=table.integer("digits", 6, high=12),
        checksum=table.choice("checksum", ("none", "nmea"), "none") == "nmea",
        counter=_counter(table, names),
    )
    if 0 in spec.scales:
        table.fail("scale", "must not be zero")
    table.done()
    return spec


def _option(table: Table, key: str, known: Option) -> int:
    value = table.integer(key, known.usual)
    if value not in known.allowed:
        allowed = ", ".join(f"{one} (0x{one:02X})" for one in sorted(known.allowed))
        table.fail(key, f"{value} is not one of {allowed}")
    return value


def read_protocol(table: Table) -> ProtocolSpec:
    """Read [protocol]: the decoder's name and its own options."""
    name = table.choice("name", PROTOCOL_OPTIONS)
    options = {key: _option(table, key, known) for key, known in PROTOCOL_OPTIONS[name].items()}
    table.done()
    return ProtocolSpec(name, options)
