"""What a stream is: the one question asked of bytes that nobody knows."""

from dataclasses import dataclass, field

from drivers.profile_types import DeviceSection, FrameSpec, LineSpec, PortSettings
from drivers.teach.frames import FrameProposal, propose_frames
from drivers.teach.pace import Pace, pace_of
from drivers.teach.text import LineProposal, looks_like_text, propose_lines
from drivers.teach.written import profile_text

LATEST = 1 << 15
"""Bytes that are looked at, the latest ones."""
FEWEST = 128
"""Bytes below which nothing is said."""


@dataclass(frozen=True, slots=True)
class Proposal:
    """What a stream seems to be.

    Parameters
    ----------
    found : frames, lines, or None where neither was found
    pace : frames or lines a second
    """

    found: FrameProposal | LineProposal | None
    pace: Pace = field(default_factory=Pace)

    @property
    def hz(self) -> float:
        """Frames or lines a second; 0 where that cannot be told."""
        return self.pace.hz

    @property
    def stream(self) -> FrameSpec | LineSpec | None:
        """The description."""
        return None if self.found is None else self.found.spec


def analyse(data: bytes, bytes_per_s: float = 0.0, doubt: str = "") -> Proposal:
    """Find out how a stream is laid out; up to some seconds, for a worker thread.

    Parameters
    ----------
    data : the bytes; only the latest `LATEST` are looked at
    bytes_per_s : how fast they came; 0 if that is not known
    doubt : why they did not come as fast as the board sends; empty if they did
    """
    latest = data[-LATEST:]
    if len(latest) < FEWEST:
        return Proposal(None)
    found = propose_lines(latest) if looks_like_text(latest) else None
    if found is not None:
        hz = bytes_per_s * found.lines / len(latest)
        return Proposal(found, pace_of(latest, found.spec, hz, doubt))
    frames = propose_frames(latest)
    if frames is None:
        return Proposal(None)
    hz = bytes_per_s * frames.frames / len(latest)
    return Proposal(frames, pace_of(latest, frames.spec, hz, doubt))


def device_file(
    proposal: Proposal, name: str, kind: str = "imu", baud: int = 115200, notes: str = ""
) -> str:
    """Return the text of the device file that a proposal stands for.

    Raises
    ------
    ValueError
        Nothing was found.
    """
    stream = proposal.stream
    if stream is None:
        raise ValueError("nothing was found that a device file could say")
    port = PortSettings((baud,), 8, "N", 1, 0, dtr=False, rts=False)
    notes = "; ".join(filter(None, (notes, proposal.pace.why)))
    device = DeviceSection(name, kind, "", notes)
    return profile_text(device, port, stream, proposal.hz)
