"""A proposed description of binary frames of one length."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import IntArray
from core.samples.block import Channel
from drivers.profile_types import TYPES, CounterSpec, FieldSpec, FrameSpec
from drivers.shape import ByteArray, gather
from drivers.teach.checks import CheckFit, search_checks
from drivers.teach.guesses import bits_of, field_of, guess_fields, hint_of
from drivers.teach.lengths import LengthReading, length_readings
from drivers.teach.period import Alignment, alignments, boundary_evidence, constant_runs
from drivers.teach.rows import frames_in

_RUNS = 12
_PHASES = 3
_SURE = 0.9
_PLENTY = 0.5
_LEAST = 0.4
_LONGEST_SYNC = 4
_EVIDENT = 0.02
_FOOTERS = {b"\r\n": 4.0, b"\n": 2.0, b"\x03": 2.0}
_WEIGHED = 6
_DULL = (0x00, 0xFF)


@dataclass(frozen=True, slots=True)
class FrameProposal:
    """Frames as they were found.

    Parameters
    ----------
    spec : the description
    checks : the checksums that fit, the one of `spec` first
    readings : of bytes that may tell the length
    share : of the bytes of the stream that are in whole frames, 0 to 1
    frames : how many
    """

    spec: FrameSpec
    checks: tuple[CheckFit, ...]
    readings: tuple[LengthReading, ...]
    share: float
    frames: int


@dataclass(frozen=True, slots=True)
class _Cut:
    """A place where frames may begin: bytes behind an anchor (negative: before it)."""

    length: int
    offset: int
    still: int
    checks: tuple[CheckFit, ...]
    worth: float


def propose_frames(data: bytes) -> FrameProposal | None:
    """Return the likeliest frames of a stream, or None if it does not repeat itself."""
    stream = np.frombuffer(data, dtype=np.uint8)
    best: FrameProposal | None = None
    lengths: set[tuple[int, int]] = set()
    for found in alignments(stream):
        anchor = int(stream[found.places[0]])
        if (found.length, anchor) in lengths:
            continue
        lengths.add((found.length, anchor))
        proposal = _proposed(data, stream, found)
        if proposal is None:
            continue
        if best is None or _rank(proposal) > _rank(best):
            best = proposal
        if _rank(proposal) > (True, _PLENTY):
            break
    # A header that no checksum proves is nothing if most of the stream is not explained.
    return best if best is not None and _rank(best) > (False, _LEAST) else None


def describe(
    data: bytes, sync: tuple[int | None, ...], length: int, check: CheckFit | None
) -> FrameProposal | None:
    """Return frames of a given header, length and checksum, with guessed fields.

    None if the stream holds too few of them.
    """
    bare = FrameSpec(
        sync,
        length,
        "little",
        check.spec if check else None,
        None,
        np.inf,
        b"",
        (field_of("x", "u8", min(len(sync), length - 1), "little"),),
    )
    rows, starts, lengths = frames_in(data, bare)
    if len(rows) < 2:
        return None
    first, stop = len(sync), length + check.spec.at if check else length
    endian, fields = guess_fields(rows, first, stop)
    if not fields and first < length:
        fields = [field_of("x", "u8", first, "little")]
    named, counter = _named(rows, fields)
    spec = replace(bare, endian=endian, fields=tuple(named), counter=counter)
    stream = np.frombuffer(data, dtype=np.uint8)
    behind = length - stop
    return FrameProposal(
        spec,
        (check,) if check else (),
        tuple(length_readings(stream, starts, length, behind)),
        float(np.sum(lengths)) / len(data),
        len(rows),
    )


def checks_of(data: bytes, sync: tuple[int | None, ...], length: int) -> list[CheckFit]:
    """Return the checksums that fit frames of a given header and length, best first."""
    stream = np.frombuffer(data, dtype=np.uint8)
    usable = len(stream) - length
    if usable <= 0:
        return []
    good = np.ones(usable, dtype=np.bool_)
    for place, byte in enumerate(sync):
        if byte is not None:
            good &= stream[place : place + usable] == byte
    starts = np.flatnonzero(good)
    # Chance headers within the payload have no other header one length away.
    chained = np.isin(starts + length, starts) | np.isin(starts - length, starts)
    return search_checks(gather(stream, starts[chained], length), len(sync))


def _rank(proposal: FrameProposal) -> tuple[bool, float]:
    sure = bool(proposal.checks) and proposal.checks[0].share > _SURE
    return sure, proposal.share


def _proposed(data: bytes, stream: ByteArray, found: Alignment) -> FrameProposal | None:
    cuts = list(_cuts(stream, found))
    if not cuts:
        return None
    cuts.sort(key=lambda cut: -cut.worth)
    if not cuts[0].checks:
        cuts = [_weighed(stream, found, cut) for cut in cuts[:_WEIGHED]]
    best = max(cuts, key=lambda cut: cut.worth)
    head = _rows(stream, found, best)[:, : min(best.still, 8)]
    values = np.median(head, axis=0).astype(int).tolist()
    check = best.checks[0] if best.checks else None
    count = _sync_length(values, check)
    proposal = describe(data, tuple(values[:count]), best.length, check)
    return None if proposal is None else replace(proposal, checks=best.checks)


def _rows(stream: ByteArray, found: Alignment, cut: _Cut) -> ByteArray:
    starts = found.places + cut.offset
    starts = starts[(starts >= 0) & (starts + cut.length <= len(stream))]
    return gather(stream, starts, cut.length)


def _cuts(stream: ByteArray, found: Alignment) -> Iterator[_Cut]:
    """Yield where frames may begin, each with its worth; a checksum that fits outweighs all."""
    length = found.length
    for first, count in constant_runs(found.constant)[:_RUNS]:
        for phase in range(min(_PHASES, count)):
            start = (first + phase) % length
            offset = start - length if start else 0
            plain = _Cut(length, offset, count - phase, (), 0.0)
            rows = _whole(_rows(stream, found, plain), found.constant, start)
            fits = tuple(_preferred(search_checks(rows, count - phase)))
            evidence = boundary_evidence(found, start)
            worth = 10.0 * round(evidence / _EVIDENT) * _EVIDENT
            worth += _looks(found.constant, first, phase, count)
            worth += 100.0 * fits[0].share if fits else 0.0
            yield replace(plain, checks=fits, worth=worth)


def _weighed(stream: ByteArray, found: Alignment, cut: _Cut) -> _Cut:
    """Return a cut whose worth counts how briefly the numbers behind its header are written."""
    rows = _rows(stream, found, cut)
    header = _sync_length(rows[0, : min(cut.still, 8)].tolist(), None)
    return replace(cut, worth=cut.worth - bits_of(rows, header, cut.length))


def _whole(rows: ByteArray, constant: IntArray, start: int) -> ByteArray:
    """Return the rows in which every constant byte holds."""
    expected = np.roll(constant, -start)
    still = np.flatnonzero(expected >= 0)
    return rows[np.all(rows[:, still] == expected[still], axis=1)]


def _preferred(fits: list[CheckFit]) -> list[CheckFit]:
    """Return the fits with the likeliest spelling first.

    A sum that fits does so from one place on, or from any place among zeros; it then rather begins
    at the header's second half than in the middle of the zeros.
    """
    return sorted(fits, key=lambda fit: (-round(fit.share, 2), fit.spec.algorithm == "sum8"))


def _looks(constant: IntArray, first: int, phase: int, count: int) -> float:
    """Return how much the constant bytes look like a header from this place on."""
    values = [int(constant[(first + place) % len(constant)]) for place in range(count)]
    before, header = bytes(values[:phase]), values[phase : phase + _LONGEST_SYNC]
    worth = sum(0.2 if value in _DULL else 1.0 for value in header)
    if header[0] in _DULL:
        worth -= 1.0
    return worth + _FOOTERS.get(before, -0.5 * phase)


def _sync_length(values: list[int], check: CheckFit | None) -> int:
    """Return how many of the constant bytes are taken for the header.

    A checksum often begins just behind it. Constant bytes that look like the high part of a small
    number are left out: they may change one day.
    """
    most = min(len(values), _LONGEST_SYNC)
    if check is not None and 1 <= check.spec.start <= most:
        return check.spec.start
    while most > 2 and values[most - 1] in _DULL:
        most -= 1
    return most


def _named(rows: ByteArray, fields: list[FieldSpec]) -> tuple[list[FieldSpec], CounterSpec | None]:
    """Return the fields with names, and the counter among them; it is read, but no channel."""
    named: list[FieldSpec] = []
    counter: CounterSpec | None = None
    number = 0
    for field in fields:
        hint = hint_of(rows, field)
        bits = 8 * TYPES[field.type]
        if counter is None and hint.kind == "counter" and bits <= 32 and field.type[0] != "f":
            counter = CounterSpec("counter", bits, hint.step)
            type_ = f"u{bits}"
            channel = Channel("counter", "code", "counter")
            named.append(replace(field, channels=(channel,), type=type_, hide=len(fields) > 1))
        else:
            number += 1
            named.append(replace(field, channels=(Channel(f"ch{number}", "code"),)))
    return named, counter
