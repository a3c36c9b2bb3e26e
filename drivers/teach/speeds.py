"""At which speed a port makes sense: each is listened to, and what came is looked at."""

import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from drivers.teach.analysis import Proposal, analyse
from drivers.teach.frames import FrameProposal
from drivers.transport import EndOfStream, Transport, UnfitSettings

SPEEDS = (115200, 921600, 460800, 230400, 57600, 38400, 19200, 9600, 1843200)
"""Speeds of boards, the commonest first."""
_SURE = 0.9
_NEVER = threading.Event()


@dataclass(frozen=True, slots=True)
class Trial:
    """What was heard at one speed: so many bytes, and what they seem to be."""

    baud: int
    count: int
    proposal: Proposal

    @property
    def rank(self) -> tuple[bool, float]:
        """The larger the better: proven by a checksum or read as text, then the share explained."""
        found = self.proposal.found
        if found is None:
            return False, 0.0
        if isinstance(found, FrameProposal):
            return bool(found.checks) and found.checks[0].share > _SURE, found.share
        return found.share > _SURE, found.share


def try_speeds(
    open_at: Callable[[int], Transport],
    speeds: Sequence[int] = SPEEDS,
    *,
    listen_s: float = 1.0,
    cancel: threading.Event = _NEVER,
    progress: Callable[[int], None] | None = None,
) -> list[Trial]:
    """Listen at each speed, nothing is sent; for a worker thread.

    Ends at the first speed that is beyond doubt.

    Parameters
    ----------
    open_at : opens the port at a speed
    speeds : which, in their order
    listen_s : time for each
    cancel : set from another thread, ends the search
    progress : called in this thread with each speed before it is tried

    Returns
    -------
    list of Trial
        The best first.

    Raises
    ------
    LinkError
        The port cannot be opened.
    """
    trials: list[Trial] = []
    for baud in speeds:
        if cancel.is_set():
            break
        if progress is not None:
            progress(baud)
        try:
            data = _heard(open_at(baud), listen_s, cancel)
        except UnfitSettings:
            continue
        trials.append(Trial(baud, len(data), analyse(data, len(data) / listen_s)))
        if trials[-1].rank > (True, 0.5):
            break
    return sorted(trials, key=lambda trial: trial.rank, reverse=True)


def _heard(port: Transport, listen_s: float, cancel: threading.Event) -> bytes:
    pieces: list[bytes] = []
    end = time.monotonic() + listen_s
    try:
        while time.monotonic() < end and not cancel.is_set():
            pieces.append(port.read())
    except EndOfStream:
        pass
    finally:
        port.close()
    return b"".join(pieces)
