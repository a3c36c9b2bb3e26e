"""What decoders and links say. Every byte that comes in is accounted for by one of these."""

from collections.abc import Mapping
from dataclasses import dataclass

from core.errors import LinkError
from core.samples.block import SampleBlock


@dataclass(frozen=True, slots=True)
class Garbage:
    """Bytes between frames that belong to no frame."""

    count: int
    sample: bytes
    """The first few of them, for the log."""


@dataclass(frozen=True, slots=True)
class BadChecksum:
    """Frames of the right shape whose checksum is wrong."""

    count: int


@dataclass(frozen=True, slots=True)
class BadValues:
    """Frames with a right checksum and impossible numbers (CVGCom's "wrong values")."""

    count: int


@dataclass(frozen=True, slots=True)
class Lost:
    """Samples that the device sent, by its counter or by the missing bytes, and that never came."""

    count: int
    before: int
    """Index of the first sample after the gap."""


@dataclass(frozen=True, slots=True)
class Message:
    """Anything readable that is no sample: a text line, a reply, an unknown message skipped whole.

    `kind` is stable (``"text"``, ``"reply"``, ``"unknown 0x9D"``), `fields` what could be read.
    """

    kind: str
    payload: bytes
    fields: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Ended:
    """The last event of a link. `error` is None after an ordinary close."""

    error: LinkError | None


Event = SampleBlock | Garbage | BadChecksum | BadValues | Lost | Message | Ended
