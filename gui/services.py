"""What every tab is given."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from drivers.profile import Profile
from gui.devices.connection import Connection
from gui.jobs import Jobs
from gui.messages import Messages
from gui.settings import Settings


@dataclass(frozen=True, slots=True)
class Services:
    """What all tabs share.

    Parameters
    ----------
    connection : the devices
    jobs : worker threads
    messages : banner and log
    settings : what is remembered
    profiles : returns the device files by id
    root : returns the folder of all sessions
    play : the loudspeaker: ``"start"``, ``"done"`` or ``"error"``
    """

    connection: Connection
    jobs: Jobs
    messages: Messages
    settings: Settings
    profiles: Callable[[], Mapping[str, Profile]]
    root: Callable[[], Path]
    play: Callable[[str], None]
