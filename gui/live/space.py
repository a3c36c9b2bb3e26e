"""Room on the disk: how long it lasts at the rate at which a record grows."""

import math
import shutil
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.errors import Severity, StorageError
from core.samples.block import Channel
from drivers.recorder import wire_item
from gui.devices.link import Link
from gui.live.settings import LiveSettings
from gui.widgets.states import BannerState

REFUSE_S, WARN_S = 60.0, 3600.0
"""A disk that lasts shorter is refused, or told of."""
_TEXT_CELL = 14
"""Bytes of a value in CVGCom's file."""


def _say(text: str) -> str:
    return QCoreApplication.translate("LiveSpace", text)


@dataclass(frozen=True, slots=True)
class Room:
    """What is left on a disk.

    Parameters
    ----------
    folder : where is written
    free : bytes
    per_s : bytes a second that are written
    """

    folder: Path
    free: int
    per_s: float

    @property
    def seconds(self) -> float:
        """How long it lasts."""
        return self.free / self.per_s if self.per_s > 0.0 else math.inf


def growth(link: Link, channels: tuple[Channel, ...], settings: LiveSettings) -> float:
    """Bytes a second of a record: bytes twice, as the log of the port and in it, samples, text."""
    counters = link.counters
    frame = counters.bytes / counters.frames if counters.frames else 0.0
    values = link.rate_hz * len(channels)
    text = settings.sampling_hz * len(channels) * _TEXT_CELL if settings.text else 0
    return 2.0 * frame * link.rate_hz + values * wire_item(link.profile) + text


def room(folder: Path, per_s: float) -> Room:
    """Look at the disk of a folder, which need not exist yet.

    Raises
    ------
    StorageError
        The disk does not answer.
    """
    there = folder
    while not there.exists() and there != there.parent:
        there = there.parent
    try:
        return Room(folder, shutil.disk_usage(there).free, per_s)
    except OSError as error:
        raise StorageError(f"{there}: cannot be looked at: {error.strerror}") from error


def enough(found: Room) -> None:
    """Let a record begin.

    Raises
    ------
    StorageError
        The disk lasts less than a minute.
    """
    if found.seconds < REFUSE_S:
        raise StorageError(
            f"{found.folder}: the disk has {megabytes(found.free)} left, which last"
            f" {lasting(found.seconds)} at {found.per_s / 1e3:.1f} kB/s; free some space first"
        )


def warning(found: Room) -> BannerState | None:
    """What is told of a disk that is running out; None of one that is not."""
    if found.seconds >= WARN_S:
        return None
    return BannerState(
        Severity.WARNING,
        _say("The disk lasts {time} more").format(time=_coarse(found.seconds)),
        _say("{folder} has little room left for the record.").format(folder=found.folder),
        _say("Free some space; what is written stays readable when it runs out."),
    )


def megabytes(count: float) -> str:
    """Bytes in words."""
    return f"{count / 1e9:.1f} GB" if count >= 1e9 else f"{count / 1e6:.0f} MB"


def lasting(seconds: float) -> str:
    """A time in words: ``40 s``, ``12 min``, ``5 h``, ``80 d``."""
    for unit, size in (("d", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2.0 * size:
            return f"{seconds / size:.0f} {unit}"
    return f"{seconds:.0f} s"


def _coarse(seconds: float) -> str:
    """The same in steps, so that a banner is not renewed each second."""
    steps = (60, 120, 300, 600, 1200, 1800, 2700, 3600)
    return lasting(max((step for step in steps if step <= seconds), default=60.0))
