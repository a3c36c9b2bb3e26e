"""What a stream is: the one question asked of bytes that nobody knows."""

from dataclasses import dataclass

from drivers.profile_types import DeviceSection, FrameSpec, LineSpec, PortSettings
from drivers.teach.frames import FrameProposal, propose_frames
from drivers.teach.text import LineProposal, looks_like_text, propose_lines
from drivers.teach.written import profile_text

LATEST = 1 << 15
"""Bytes that are looked at, the latest ones."""
FEWEST = 128
"""Bytes below which nothing is said."""
_USUAL_HZ = (
    1, 2, 5, 10, 20, 25, 40, 50, 60, 80, 100, 120, 125, 200, 240, 250, 256, 300, 400, 500, 512,
    600, 800, 1000, 1024, 1600, 2000, 4000,
)  # fmt: skip
_NEAR = 0.015


@dataclass(frozen=True, slots=True)
class Proposal:
    """What a stream seems to be.

    Parameters
    ----------
    found : frames, lines, or None where neither was found
    hz : frames or lines a second; 0 where no time is known
    """

    found: FrameProposal | LineProposal | None
    hz: float = 0.0

    @property
    def stream(self) -> FrameSpec | LineSpec | None:
        """The description."""
        return None if self.found is None else self.found.spec


def analyse(data: bytes, bytes_per_s: float = 0.0) -> Proposal:
    """Find out how a stream is laid out; up to some seconds, for a worker thread.

    Parameters
    ----------
    data : the bytes; only the latest `LATEST` are looked at
    bytes_per_s : how fast they came; 0 if that is not known
    """
    latest = data[-LATEST:]
    if len(latest) < FEWEST:
        return Proposal(None)
    found = propose_lines(latest) if looks_like_text(latest) else None
    if found is not None:
        return Proposal(found, _rate(bytes_per_s, found.lines, len(latest)))
    frames = propose_frames(latest)
    if frames is None:
        return Proposal(None)
    return Proposal(frames, _rate(bytes_per_s, frames.frames, len(latest)))


def usual_rate(hz: float) -> float:
    """Return the round rate that a measured one stands for, or the measured one in three digits."""
    near = min(_USUAL_HZ, key=lambda usual: abs(usual - hz))
    return float(near) if abs(near - hz) <= _NEAR * hz else float(f"{hz:.3g}")


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
    device = DeviceSection(name, kind, "", notes)
    return profile_text(device, port, stream, proposal.hz)


def _rate(bytes_per_s: float, count: int, size: int) -> float:
    hz = bytes_per_s * count / size
    return usual_rate(hz) if hz > 0 else 0.0
