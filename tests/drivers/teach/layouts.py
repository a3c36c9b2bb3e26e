"""Boards that nobody has seen: random layouts, and the streams that they send."""

from dataclasses import dataclass

import numpy as np

from core.samples.block import Channel
from drivers.checksums import CRC_PRESETS, Checksum, ChecksumSpec, CrcSpec
from drivers.fields import write_raw
from drivers.profile_types import TYPES, FieldSpec

SUMS = {"sum8": 1, "xor8": 1, "sum16": 2, "sum16w": 2, "fletcher16": 2}


@dataclass(frozen=True)
class Layout:
    """One invented board.

    `garbage` is the share of frames behind which some bytes of nothing come.
    """

    sync: bytes
    length: int
    fields: tuple[FieldSpec, ...]
    counter: int | None
    check: ChecksumSpec | None
    footer: bytes
    garbage: float


def invented(rng: np.random.Generator, *, checked: bool | None = None) -> Layout:
    with_check = bool(rng.random() < 0.85) if checked is None else checked
    count = int(rng.integers(1 if with_check else 2, 5))
    sync = bytes(rng.choice(np.arange(1, 255), count, replace=False).astype(np.uint8))
    endian = str(rng.choice(["little", "big"]))
    fields: list[FieldSpec] = []
    at = count
    counter = None

    def add(type_: str) -> None:
        nonlocal at
        name = f"f{len(fields)}"
        fields.append(FieldSpec((Channel(name, "code"),), type_, at, endian=endian))
        at += TYPES[type_]

    if rng.random() < 0.7:
        counter = 0
        add(str(rng.choice(["u8", "u16", "u32"])))
    for _ in range(int(rng.integers(1, 4))):
        type_ = str(rng.choice(["i16", "i24", "i32", "f32"]))
        for _ in range(int(rng.choice([1, 3, 3, 6]))):
            add(type_)
    if rng.random() < 0.5:
        add("i16")
    footer = b"\r\n" if rng.random() < 0.15 else b""
    check = _check(rng, count, at, endian, len(footer)) if with_check else None
    length = at + (check.size if check else 0) + len(footer)
    return Layout(
        sync, length, tuple(fields), counter, check, footer, float(rng.choice([0.0, 0.05, 0.3]))
    )


def _check(
    rng: np.random.Generator, header: int, stop: int, endian: str, footer: int
) -> ChecksumSpec:
    start = int(rng.choice([0, header]))
    order = str(rng.choice([endian, "little", "big"]))
    kind = rng.random()
    if kind < 0.4:
        name = str(rng.choice(list(SUMS)))
        if name == "sum16w" and (stop - start) % 2:
            name = "sum16"
        size, crc = SUMS[name], None
    elif kind < 0.75:
        name = str(rng.choice(list(CRC_PRESETS)))
        crc = CRC_PRESETS[name]
        size = crc.width // 8
    else:
        width = int(rng.choice([8, 16, 32]))
        top = 1 << width
        turned = bool(rng.random() < 0.5)
        crc = CrcSpec(
            width, int(rng.integers(top // 4, top)) | 1, int(rng.integers(top)), turned, turned,
            int(rng.integers(top)),
        )  # fmt: skip
        name, size = f"crc{width}", width // 8
    at = -size - footer
    negate = name.startswith("sum") and bool(rng.random() < 0.3)
    return ChecksumSpec(name, start, at, at, size, order, negate, crc=crc)


def frames_of(layout: Layout, rng: np.random.Generator, first: int, count: int) -> np.ndarray:
    """Whole frames number `first` on; (count, length) uint8."""
    rows = np.zeros((count, layout.length), np.uint8)
    rows[:, : len(layout.sync)] = np.frombuffer(layout.sync, np.uint8)
    t = np.arange(first, first + count)
    for place, field in enumerate(layout.fields):
        seeded = np.random.default_rng(place)
        if place == layout.counter:
            numbers = t % (1 << (8 * TYPES[field.type]))
        elif field.type == "f32":
            level, noise = seeded.normal(0.0, 10.0), 10.0 ** seeded.uniform(-3, 0)
            numbers = level + noise * rng.standard_normal(count)
        else:
            top = 2.0 ** (8 * TYPES[field.type] - 1)
            noise = 2.0 ** seeded.uniform(4, 8 * TYPES[field.type] - 6)
            level = seeded.choice([-1.0, 1.0]) * min(noise * 2.0 ** seeded.uniform(0, 8), top / 2)
            numbers = np.rint(level + noise * rng.standard_normal(count)).astype(np.int64)
        write_raw(rows, field, np.asarray(numbers).reshape(-1, 1))
    if layout.footer:
        rows[:, -len(layout.footer) :] = np.frombuffer(layout.footer, np.uint8)
    if layout.check is not None:
        Checksum(layout.check).stamp(rows)
    return rows


def stream_of(layout: Layout, rng: np.random.Generator, first: int, count: int) -> bytes:
    """The frames with garbage between some of them, from the middle of a frame on."""
    rows = frames_of(layout, rng, first, count)
    pieces: list[bytes] = []
    for row in rows:
        pieces.append(row.tobytes())
        if rng.random() < layout.garbage:
            pieces.append(rng.integers(0, 256, int(rng.integers(1, 12)), np.uint8).tobytes())
    return b"".join(pieces)[layout.length // 3 :]
