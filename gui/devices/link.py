"""One device at one port: its reader, its raw log, and how it does."""

import math
from datetime import datetime
from pathlib import Path

from core.errors import LinkError, StorageError
from core.records.names import safe_name
from core.samples.block import SampleBlock
from core.version import SOFTWARE
from drivers.decoders import make_decoder
from drivers.events import Event
from drivers.ports import reopener
from drivers.profile import Profile
from drivers.rawlog import RawLog
from drivers.reader import Counters, LinkState, Reader, Tap
from drivers.transport import opener
from gui.devices.setup import DeviceSetup
from gui.widgets.states import LinkMark

RAW_SUFFIX = ".calrec"
_OPENING_S = 1.5
_MARKS = {
    LinkState.OPENING: LinkMark.OPENING,
    LinkState.STREAMING: LinkMark.STREAMING,
    LinkState.NO_DATA: LinkMark.SILENT,
    LinkState.RECONNECTING: LinkMark.LOST,
}


class Link:
    """A running reader with what the operator is told about it.

    Parameters
    ----------
    setup : where the device is
    profile : what it speaks
    raw_folder : where the bytes go as they come, from the opening of the port on
    """

    def __init__(self, setup: DeviceSetup, profile: Profile, raw_folder: Path) -> None:
        self.setup = setup
        self.profile = profile
        self.temperature_c: float | None = None
        self.error: LinkError | None = None
        """Why the link has ended; None while it lives."""
        self.raw_doubt: StorageError | None = None
        """Why nothing is recorded; None while it is."""
        self._ended = False
        self._raw_before = self._raw_now = 0
        self._log = self._open_log(raw_folder)
        self._reader = Reader(
            opener(setup.url, profile.port, setup.baud),
            make_decoder(profile),
            self._log,
            reopener(setup.url, profile.port, setup.baud),
        )
        self._reader.start()

    def _open_log(self, folder: Path) -> RawLog | None:
        stem = f"{datetime.now():%Y%m%d-%H%M%S}_{safe_name(self.setup.name)}"
        try:
            folder.mkdir(parents=True, exist_ok=True)
            path = folder / f"{stem}{RAW_SUFFIX}"
            for count in range(2, 1000):
                if not path.exists():
                    break
                path = folder / f"{stem}_{count}{RAW_SUFFIX}"
            return RawLog(path, self.header)
        except OSError as error:
            self.raw_doubt = StorageError(f"{folder}: cannot be made ({error.strerror})")
        except StorageError as error:
            self.raw_doubt = error
        return None

    @property
    def header(self) -> dict[str, object]:
        """What a record of this device begins with."""
        return {
            "device": self.setup.name,
            "port": self.setup.url,
            "baud": self.setup.baud,
            "profile": self.profile.id,
            "profile_text": self.profile.text,
            "software": SOFTWARE,
        }

    @property
    def raw_path(self) -> Path | None:
        """File of the raw bytes; None if none could be made."""
        return None if self._log is None else self._log.path

    @property
    def raw_size(self) -> int:
        """Bytes of the raw log that surely stand before what the next `drain` brings."""
        return self._raw_before

    def drain(self) -> list[Event]:
        """What has come since the last call."""
        events = self._reader.drain()
        if self._log is not None and events:
            # Bytes are stored before they are parsed, so these events lie after the older size.
            try:
                size = self._log.path.stat().st_size
            except OSError:
                # The folder went away: the events are samples all the same, and `sync` tells.
                size = self._raw_now
            self._raw_before, self._raw_now = self._raw_now, size
        return events

    def took(self, block: SampleBlock) -> None:
        """Note what a block says about the device itself."""
        column = block.column("temp")
        if column is not None and len(column):
            self.temperature_c = float(column[-1])

    def ended(self, error: LinkError | None) -> None:
        """Note that nothing more will come."""
        self._ended = True
        self.error = error

    def tap(self, tap: Tap | None) -> None:
        """Let something hear all that is read from now on, in the reader's thread; or no more."""
        self._reader.tap = tap

    def send(self, data: bytes) -> None:
        """Have bytes sent to the device within some 50 ms."""
        self._reader.write(data)

    def sync(self) -> None:
        """Wait until the raw bytes are on the disk; raises `StorageError`."""
        self._reader.sync()

    def close(self) -> None:
        """Let go of the port; raises `LinkError` if the driver does not."""
        self._reader.close()

    @property
    def counters(self) -> Counters:
        """What has come so far."""
        return self._reader.counters

    @property
    def storage_error(self) -> StorageError | None:
        """Why the raw bytes are not stored; None while they are."""
        return self.raw_doubt or self._reader.storage_error

    @property
    def rate_hz(self) -> float:
        """Samples per second: declared, else measured; 0 while neither is known."""
        if self.profile.nominal_hz > 0:
            return self.profile.nominal_hz
        measured = self._reader.counters.measured_hz
        return 0.0 if math.isnan(measured) else measured

    @property
    def mark(self) -> LinkMark:
        """State for the device strip."""
        if self._ended:
            return LinkMark.LOST if self.error is not None else LinkMark.OFFLINE
        state = self._reader.state
        if state is LinkState.WAITING:
            waited = self._reader.counters.silent_s
            return LinkMark.OPENING if waited < _OPENING_S else LinkMark.SILENT
        return _MARKS.get(state, LinkMark.OFFLINE)
