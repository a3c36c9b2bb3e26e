"""The description under way, and what an operator changes in it; no Qt."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from core.errors import FormatError
from core.samples.block import Channel
from drivers.profile import parse_profile
from drivers.profile_types import (
    TYPES,
    CounterSpec,
    DeviceSection,
    FieldSpec,
    FrameSpec,
    LineSpec,
    PortSettings,
)
from drivers.shape import ByteArray
from drivers.teach.analysis import Proposal
from drivers.teach.checks import CheckFit
from drivers.teach.frames import FrameProposal
from drivers.teach.guesses import field_of, guess_fields
from drivers.teach.lengths import LengthReading
from drivers.teach.written import profile_text

_WHOLE = {1: "u8", 2: "u16", 3: "u24", 4: "u32"}
_COUNTED_BITS = 32


@dataclass(frozen=True, slots=True)
class Taught:
    """What is known of a board.

    Parameters
    ----------
    name, kind : as the device file has them
    stream : the description; None until something is found
    hz : samples per second; 0 if unknown
    why_hz : how that was found if not by the clock, or why it is unknown
    checks : checksums that fit the stream
    readings : of bytes that may tell the length
    notes : where it is from
    """

    name: str = ""
    kind: str = "imu"
    stream: FrameSpec | LineSpec | None = None
    hz: float = 0.0
    why_hz: str = ""
    checks: tuple[CheckFit, ...] = ()
    readings: tuple[LengthReading, ...] = ()
    notes: str = ""

    @property
    def columns(self) -> tuple[Channel, ...]:
        """Names, units and roles of all numbers, hidden ones too."""
        match self.stream:
            case FrameSpec():
                return tuple(field.channels[0] for field in self.stream.fields)
            case LineSpec():
                return self.stream.channels
            case None:
                return ()

    def text(self, baud: int) -> str:
        """Return the device file; empty while nothing is found."""
        if self.stream is None:
            return ""
        port = PortSettings((baud,), 8, "N", 1, 0, dtr=False, rts=False)
        device = DeviceSection(self.name, self.kind, "", self.notes)
        return profile_text(device, port, self.stream, self.hz)

    def doubt(self, baud: int) -> str:
        """Return why the description is no device file yet; empty if it is one."""
        if self.stream is None:
            return "Nothing is described yet"
        if not self.name.strip():
            return "Give the board a name"
        try:
            parse_profile(self.text(baud), "the description")
        except FormatError as error:
            return error.why
        return ""


def found(taught: Taught, proposal: Proposal) -> Taught:
    """Return the description with what was found in a stream."""
    frames = proposal.found if isinstance(proposal.found, FrameProposal) else None
    return replace(
        taught,
        stream=proposal.stream,
        hz=proposal.hz or (0.0 if proposal.pace.why else taught.hz),
        why_hz=proposal.pace.why,
        checks=frames.checks if frames else (),
        readings=frames.readings if frames else (),
    )


def add_fields(taught: Taught, first: int, stop: int, rows: ByteArray) -> Taught:
    """Return the description with fields on some bytes, as their numbers look.

    Fields that were there before are replaced.
    """
    spec = taught.stream
    if not isinstance(spec, FrameSpec) or stop <= first:
        return taught
    endian, new = guess_fields(rows, first, stop)
    covered = sum(field.end - field.at for field in new)
    if covered < stop - first:
        whole = _WHOLE.get(stop - first)
        if whole is not None:
            new, endian = [field_of("", whole, first, spec.endian)], spec.endian
    kept = [field for field in spec.fields if field.end <= first or field.at >= stop]
    named = list(kept)
    for field in new:
        name = _free_name(named)
        channel = Channel(name, "code")
        named.append(replace(field, channels=(channel,), endian=endian))
    return _with_fields(taught, spec, named)


def remove_fields(taught: Taught, first: int, stop: int) -> Taught:
    """Return the description without the fields on some bytes."""
    spec = taught.stream
    if not isinstance(spec, FrameSpec):
        return taught
    kept = [field for field in spec.fields if field.end <= first or field.at >= stop]
    return _with_fields(taught, spec, kept)


def change_channel(taught: Taught, index: int, channel: Channel) -> Taught:
    """Return the description with another name, unit or role of one number."""
    spec = taught.stream
    if isinstance(spec, FrameSpec):
        old = spec.fields[index].channels[0].name
        fields = list(spec.fields)
        fields[index] = replace(fields[index], channels=(channel,))
        counter = _counter(spec.counter, old, channel, 8 * TYPES[fields[index].type])
        return replace(taught, stream=replace(spec, fields=tuple(fields), counter=counter))
    if isinstance(spec, LineSpec):
        old = spec.channels[index].name
        channels = [*spec.channels[:index], channel, *spec.channels[index + 1 :]]
        counter = _counter(spec.counter, old, channel, _COUNTED_BITS)
        return replace(taught, stream=replace(spec, channels=tuple(channels), counter=counter))
    return taught


def change_field(taught: Taught, index: int, **values: object) -> Taught:
    """Return the description with another type, byte order, or ``hide`` of one field."""
    spec = taught.stream
    if not isinstance(spec, FrameSpec):
        return taught
    fields = list(spec.fields)
    fields[index] = replace(fields[index], **values)  # pyright: ignore[reportArgumentType]
    changed = fields[index]
    if changed.end > spec.shortest:
        return taught
    others = [
        field
        for place, field in enumerate(fields)
        if place == index or field.end <= changed.at or field.at >= changed.end
    ]
    return _with_fields(taught, spec, others)


def change_scale(taught: Taught, index: int, scale: float, offset: float) -> Taught:
    """Return the description with another scale and offset of one number."""
    spec = taught.stream
    if isinstance(spec, FrameSpec):
        return change_field(taught, index, scale=scale, offset=offset)
    if isinstance(spec, LineSpec):
        scales, offsets = list(spec.scales), list(spec.offsets)
        scales[index], offsets[index] = scale, offset
        stream = replace(spec, scales=tuple(scales), offsets=tuple(offsets))
        return replace(taught, stream=stream)
    return taught


def with_check(taught: Taught, check: CheckFit | None) -> Taught:
    """Return the description with another checksum, or none."""
    spec = taught.stream
    if not isinstance(spec, FrameSpec):
        return taught
    changed = replace(spec, checksum=check.spec if check else None)
    if check is None:
        return replace(taught, stream=changed)
    at = spec.shortest + check.spec.at
    kept = [field for field in spec.fields if field.end <= at]
    return _with_fields(taught, changed, kept)


def _with_fields(taught: Taught, spec: FrameSpec, fields: Sequence[FieldSpec]) -> Taught:
    ordered = tuple(sorted(fields, key=lambda field: field.at))
    names = [field.channels[0].name for field in ordered]
    counter = spec.counter if spec.counter and spec.counter.field in names else None
    return replace(taught, stream=replace(spec, fields=ordered, counter=counter))


def _counter(old: CounterSpec | None, name: str, channel: Channel, bits: int) -> CounterSpec | None:
    """Return the counter after a number called `name` has become `channel`."""
    if channel.role == "counter":
        step = old.step if old is not None and old.field == name else None
        return CounterSpec(channel.name, min(bits, _COUNTED_BITS), step)
    return None if old is not None and old.field == name else old


def _free_name(fields: Sequence[FieldSpec]) -> str:
    used = {field.channels[0].name for field in fields}
    return next(name for n in range(1, 1000) if (name := f"ch{n}") not in used)
