"""What the Live tab shows."""

from dataclasses import dataclass
from enum import Enum

from gui.live.settings import LiveSettings
from gui.widgets.states import ActionBarState, TableState, Tone
from gui.widgets.strip_view import Interval, Mark


class Phase(Enum):
    """What the tab does."""

    OFFLINE = "offline"
    """No device, nothing loaded."""
    WATCHING = "watching"
    """Samples are shown and not recorded."""
    RECORDING = "recording"
    STOPPED = "stopped"
    """The record is on the screen, and can be resumed while its device is there."""
    LOADED = "loaded"
    """A record from the disk is on the screen."""


@dataclass(frozen=True, slots=True)
class ChannelRow:
    """One line of the channel list."""

    name: str
    unit: str
    shown: bool


@dataclass(frozen=True, slots=True)
class LiveState:
    """The tab, but for the samples.

    Parameters
    ----------
    phase : what it does
    headline, tone : the same in words
    settings : the panel
    port : port, device file and rate of the device; empty without one
    file : name of the record that would be or is written, without suffix
    folder : where it stands
    locked : why settings of the record cannot be changed now; empty if they can
    channels : of the device or of the record
    actions : the row of buttons
    intervals, marks : of the record on the screen, s
    statistics : table of cursors and intervals
    overlays : names of the records drawn beneath
    """

    phase: Phase
    headline: str
    tone: Tone
    settings: LiveSettings
    port: str
    file: str
    folder: str
    locked: str
    channels: tuple[ChannelRow, ...]
    actions: ActionBarState
    intervals: tuple[Interval, ...]
    marks: tuple[Mark, ...]
    statistics: TableState
    overlays: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class LiveStatus:
    """The status line.

    Parameters
    ----------
    port : with its speed
    packed : frames of the record, or since the port was opened
    seconds : length of what is on the screen
    rate_hz : measured; None while unknown
    cep, cwv : frames with a bad checksum, with impossible values
    lost : samples that never came
    stored : bytes of the record on the disk
    lasting : how long the disk lasts, in words; empty where nothing is recorded
    """

    port: str = ""
    packed: int = 0
    seconds: float = 0.0
    rate_hz: float | None = None
    cep: int = 0
    cwv: int = 0
    lost: int = 0
    stored: int = 0
    lasting: str = ""
