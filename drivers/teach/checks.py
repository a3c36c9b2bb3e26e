"""Checksums tried on frames: the sums, the named CRCs, and CRCs of any polynomial."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from drivers.checksums import CRC_PRESETS, Checksum, ChecksumSpec, Crc, CrcSpec
from drivers.shape import ByteArray
from drivers.teach.polynomials import codewords, generator

ACCEPTED = 0.5
"""Share of frames from which on a checksum is worth telling."""
_SAMPLE = 24
_ALL = 400
_SKIPPED = 3
_LONGEST_TAIL = 3
_WORD = 2
_RARE = 0.08
_FEWEST_VALUES = 4


@dataclass(frozen=True, slots=True)
class CheckFit:
    """A checksum, and the share of the frames that hold it, 0 to 1."""

    spec: ChecksumSpec
    share: float

    @property
    def text(self) -> str:
        """Name and parameters for a reader."""
        spec = self.spec
        crc = spec.crc
        words = [spec.algorithm]
        if crc is not None and spec.algorithm not in CRC_PRESETS:
            digits = crc.width // 4
            words += [f"poly 0x{crc.poly:0{digits}X}", f"init 0x{crc.init:0{digits}X}"]
            words += [name for name in ("refin", "refout") if getattr(crc, name)]
            if crc.xorout:
                words.append(f"xorout 0x{crc.xorout:0{digits}X}")
        if spec.negate:
            words.append("negated")
        if spec.size > 1:
            words.append(f"{spec.endian} endian")
        return " ".join(words)


def search_checks(rows: ByteArray, header: int) -> list[CheckFit]:
    """Return the checksums that frames hold, best first; empty if none of the known ones fits.

    Parameters
    ----------
    rows : (n, length) uint8, whole frames; damaged ones may be among them
    header : bytes at the beginning that stay the same
    """
    rows = rows[:_ALL]
    sample = _different(rows)
    if len(sample) < _FEWEST_VALUES:
        return []
    tails = _tails(rows)
    found = [fit for tail in tails for fit in _sums(rows, sample, header, tail)]
    if not found:
        found = [fit for tail in tails for fit in _crcs(rows, sample, header, tail)]
    return sorted(found, key=lambda fit: -fit.share)


def share_of(rows: ByteArray, spec: ChecksumSpec) -> float:
    """Return the share of whole frames that hold a checksum."""
    return float(np.mean(Checksum(spec).intact(rows))) if len(rows) else 0.0


def _different(rows: ByteArray) -> ByteArray:
    """Return some frames from all over, none like the one before it."""
    if len(rows) < 2:
        return rows
    fresh = np.flatnonzero(np.any(rows[1:] != rows[:-1], axis=1)) + 1
    chosen = fresh[np.linspace(0, len(fresh) - 1, min(_SAMPLE, len(fresh))).astype(int)]
    return rows[chosen]


def _tails(rows: ByteArray) -> range:
    """Return how many bytes may follow the checksum: as many as stay the same at the end."""
    still = np.mean(rows == np.median(rows, axis=0).astype(np.uint8), axis=0) > 0.9
    count = 0
    while count < min(_LONGEST_TAIL, len(still) - 1) and still[-1 - count]:
        count += 1
    return range(count + 1)


def _accept(rows: ByteArray, sample: ByteArray, spec: ChecksumSpec) -> CheckFit | None:
    """Return the fit of a checksum on all frames if it holds in a sample of them."""
    if share_of(sample, spec) < ACCEPTED:
        return None
    stored = rows[:, spec.at : spec.at + spec.size or None]
    if len(np.unique(stored, axis=0)) < _FEWEST_VALUES:
        return None
    share = share_of(rows, spec)
    return CheckFit(spec, share) if share >= ACCEPTED else None


def _sums(rows: ByteArray, sample: ByteArray, header: int, tail: int) -> Iterator[CheckFit]:
    length = rows.shape[1]
    for algorithm, size in (
        ("sum16", 2), ("sum16w", 2), ("fletcher16", 2), ("sum8", 1), ("xor8", 1),
    ):  # fmt: skip
        at = -size - tail
        for start in range(min(header + _SKIPPED, length + at - 2) + 1):
            if algorithm == "sum16w" and (length + at - start) % _WORD:
                continue
            for endian in ("little", "big")[:size]:
                for negate in (False, True)[: 1 if algorithm in ("xor8", "fletcher16") else 2]:
                    spec = ChecksumSpec(algorithm, start, at, at, size, endian, negate)
                    fit = _accept(rows, sample, spec)
                    if fit is not None:
                        yield fit


def _crcs(rows: ByteArray, sample: ByteArray, header: int, tail: int) -> Iterator[CheckFit]:
    """Yield CRCs whose generator shows in the differences of frames."""
    length = rows.shape[1]
    for width in (32, 16, 8):
        size = width // 8
        at = length - tail - size
        for skipped in range(_SKIPPED + 1):
            first = header + skipped
            if first > at - 2:
                break
            if not _random(sample[:, at : at + size]):
                break
            for endian in ("little", "big")[: min(size, 2)]:
                crc = _generated(sample[:, first:at], sample[:, at : at + size], endian)
                if crc is not None:
                    zeros = 4 if crc[1] else 0
                    spec = ChecksumSpec(
                        f"crc{width}", first, -size - tail, -size - tail, size, endian,
                        pad_to=zeros, crc=crc[0],
                    )  # fmt: skip
                    yield from _settled(rows, sample, spec, header, skipped)


def _random(checks: ByteArray) -> bool:
    """Return whether every bit is now set, now not, as in a CRC."""
    share = np.mean(np.unpackbits(np.ascontiguousarray(checks), axis=1), axis=0)
    return bool(np.all((share > _RARE) & (share < 1.0 - _RARE)))


def _generated(messages: ByteArray, checks: ByteArray, endian: str) -> tuple[CrcSpec, int] | None:
    """Return the CRC without its start value, and the unsent zero bytes; None if there is none."""
    width = 8 * checks.shape[1]
    bodies = [row.tobytes() for row in messages]
    stored = [row.tobytes() for row in checks]
    gaps = {0, -messages.shape[1] % 4} if width == 32 else {0}
    for zeros in sorted(gaps):
        padded = [body + bytes(zeros) for body in bodies]
        for refin, refout in ((False, False), (True, True), (True, False), (False, True)):
            words = codewords(padded, stored, refin=refin, refout=refout, little=endian == "little")
            poly = generator(words, width)
            if poly is not None:
                return CrcSpec(width, poly, refin=refin, refout=refout), zeros
    return None


def _settled(
    rows: ByteArray, sample: ByteArray, spec: ChecksumSpec, header: int, skipped: int
) -> Iterator[CheckFit]:
    """Yield the CRC with start value, final exclusive-or and beginning, the usual ones first."""
    starts = [spec.start] if skipped else range(header + 1)
    usual = False
    for name, crc in _spellings(spec.crc):
        for start in starts:
            padding = spec.pad_to
            if padding and (rows.shape[1] + spec.stop - start) % padding == 0:
                padding = 0
            tried = replace(spec, algorithm=name, start=start, crc=crc, pad_to=padding)
            fit = _accept(rows, sample, tried)
            if fit is not None:
                usual = True
                yield fit
    if not usual:
        solved = _solved(sample, spec)
        fit = _accept(rows, sample, solved)
        if fit is not None:
            yield fit


def _spellings(crc: CrcSpec | None) -> Iterator[tuple[str, CrcSpec]]:
    """Yield the named CRCs of a generator, then the common start and final values."""
    if crc is None:
        return
    top = (1 << crc.width) - 1
    named: list[CrcSpec] = []
    for name, preset in CRC_PRESETS.items():
        if replace(preset, init=0, xorout=0) == crc:
            named.append(preset)
            yield name, preset
    for init in (0, top):
        for xorout in (0, top):
            plain = replace(crc, init=init, xorout=xorout)
            if plain not in named:
                yield f"crc{crc.width}", plain


def _solved(sample: ByteArray, spec: ChecksumSpec) -> ChecksumSpec:
    """Return the CRC with the final exclusive-or that most frames ask for.

    For frames of one length a start value and a final exclusive-or say the same.
    """
    if spec.crc is None:
        return spec
    length = sample.shape[1]
    covered = np.ascontiguousarray(sample[:, spec.start : length + spec.stop])
    zeros = -covered.shape[1] % spec.pad_to if spec.pad_to else 0
    plain = Crc(spec.crc, zeros)(covered)
    raw = sample[:, length + spec.at : length + spec.at + spec.size].astype(np.int64)
    weights = 256 ** np.arange(spec.size, dtype=np.int64)
    stored = raw @ (weights if spec.endian == "little" else weights[::-1])
    values, counts = np.unique(stored ^ plain, return_counts=True)
    return replace(spec, crc=replace(spec.crc, xorout=int(values[counts.argmax()])))
