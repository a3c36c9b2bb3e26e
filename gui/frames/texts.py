"""Words of the tab Teach a board."""

from drivers.profile_types import FieldSpec, FrameSpec, LineSpec
from drivers.teach.analysis import Proposal
from drivers.teach.checks import CheckFit
from drivers.teach.ear import Heard
from drivers.teach.frames import FrameProposal
from drivers.teach.guesses import Hint
from drivers.teach.lengths import LengthReading
from drivers.teach.pace import Pace
from gui.frames.state import Reading
from gui.widgets.number_text import grouped

NO_CHECK = "no checksum"
_FITS = 0.9


def heard_words(heard: Heard) -> str:
    """How much has come."""
    if not heard.total:
        return "no byte yet"
    text = f"{grouped(heard.total)} bytes"
    return f"{text}, {grouped(round(heard.bytes_per_s))} a second" if heard.bytes_per_s else text


def hint_words(hint: Hint) -> str:
    """What a number looks like."""
    if hint.kind == "counter":
        return f"counts by {hint.step}"
    words = {
        "constant": "never changes",
        "noise": "a noisy signal",
        "ramp": "rises or falls steadily",
        "flags": "a few values, seldom changing",
    }
    return words[hint.kind]


def check_words(fit: CheckFit, length: int) -> str:
    """A checksum with its range and the share of frames that hold it."""
    spec = fit.spec
    last = length + spec.stop - 1
    return f"{fit.text}, bytes {spec.start} to {last}: {share(fit.share)} fit"


def share(value: float) -> str:
    """A share in percent; 100 only where none is missing."""
    if value in (0.0, 1.0):
        return "100 %" if value else "0 %"
    return f"{min(99.9, 100.0 * value):.1f} %"


def reading_of(one: LengthReading) -> Reading:
    """One meaning of a length byte."""
    what = "the whole length" if one.meaning == "total" else f"the payload, {one.add} bytes less"
    text = (
        f"Byte {one.at} = {one.value}, {what}: frames of {one.length} bytes, {share(one.share)} fit"
    )
    return Reading(text, one.length, one.share > _FITS)


def verdict_words(proposal: Proposal) -> tuple[str, bool]:
    """What was found in a sentence, and whether it is beyond doubt."""
    found, stream = proposal.found, proposal.stream
    if found is None:
        return (
            "Neither frames nor lines were found. Is the baud rate right? Noise at every speed"
            " means another parity, or a signal that is no serial one.",
            False,
        )
    rate = f", {proposal.hz:g} a second" if proposal.hz else ""
    if isinstance(stream, LineSpec):
        text = f"Lines of {len(stream.channels)} numbers{rate}; {share(found.share)} of them read."
        return text + pace_words(proposal.pace), found.share > _FITS
    if not isinstance(found, FrameProposal) or not isinstance(stream, FrameSpec):
        raise TypeError(f"frames are described by {type(stream).__name__}")
    text = f"Frames of {stream.shortest} bytes behind {sync_words(stream.sync)}{rate};"
    if found.checks:
        text += f" {found.checks[0].text} fits {share(found.checks[0].share)} of them."
        return text + pace_words(proposal.pace), found.checks[0].share > _FITS
    text += (
        " none of the known checksums fits, so where a frame begins is a guess:"
        " the longest run of bytes that stay the same."
    )
    return text + pace_words(proposal.pace), False


def pace_words(pace: Pace) -> str:
    """Why the rate is not told, or where it is from if not from the clock."""
    if not pace.why:
        return ""
    return f" {pace.why}." if pace.hz else f" How many come in a second is not told: {pace.why}."


def sync_words(sync: tuple[int | None, ...]) -> str:
    """The first bytes of a frame."""
    return " ".join(".." if byte is None else f"{byte:02X}" for byte in sync)


def place_words(field: FieldSpec) -> str:
    """The bytes of a field."""
    last = field.end - 1
    return f"{field.at}" if last == field.at else f"{field.at}\N{EN DASH}{last}"


TYPE_WORDS = {
    "u8": "uint8", "i8": "int8", "u16": "uint16", "i16": "int16", "u24": "uint24",
    "i24": "int24", "u32": "uint32", "i32": "int32", "u64": "uint64", "f32": "float32",
    "f64": "float64",
}  # fmt: skip
"""Types as programmers of boards call them."""
