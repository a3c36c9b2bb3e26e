"""The links to all devices: opened, drained by one timer, told to whoever measures."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from core.errors import LabError, LinkError, Severity
from core.records.names import NO_NAME
from core.samples.block import SampleBlock
from drivers.events import Ended, Message
from drivers.profile import Profile
from gui.devices.link import Link
from gui.devices.setup import DeviceSetup
from gui.devices.words import PROPERTIES, RETRY, lost_banner, paused_words, silent_banner
from gui.messages import Messages
from gui.widgets.states import DeviceStripState, LinkMark

PERIOD_MS = 33
_STATE_EVERY = 8
_SILENT_S = 3.0
_SOURCE = "link"


class Connection(QObject):
    """Owns the readers; one device is the current one, which the tabs measure and the strip shows.

    Parameters
    ----------
    profiles : returns the profiles by id
    raw_folder : returns the folder of the raw bytes at the time of opening
    messages : where troubles are told
    """

    blocks = Signal(object)
    """`SampleBlock` of the current device."""
    changed = Signal()
    """The devices, or which one is current, have changed: `link` is another one."""
    interrupted = Signal()
    """The link of the current device broke: what was being accumulated is incomplete."""
    resumed = Signal()
    """Its samples come again."""
    strip = Signal(object)
    """`DeviceStripState`, some times a second."""
    properties_wanted = Signal()

    def __init__(
        self,
        profiles: Callable[[], Mapping[str, Profile]],
        raw_folder: Callable[[], Path],
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._profiles = profiles
        self._raw_folder = raw_folder
        self._messages = messages
        self._links: list[Link] = []
        self._current = 0
        self._ticks = 0
        self._told_silent = False
        self.stopped = False
        """The operator has stopped the current device: its silence is no trouble."""
        self._timer = QTimer(self)
        self._timer.setInterval(PERIOD_MS)
        self._timer.timeout.connect(self.drain)
        messages.action.connect(self._on_action)

    @property
    def link(self) -> Link | None:
        """The link of the current device."""
        return self._links[self._current] if self._links else None

    @property
    def setups(self) -> tuple[DeviceSetup, ...]:
        """All devices."""
        return tuple(link.setup for link in self._links)

    def open(self, setups: Sequence[DeviceSetup]) -> None:
        """Let go of all ports and open these."""
        self.close()
        profiles = self._profiles()
        self._links = [
            Link(setup, profiles[setup.profile_id], self._raw_folder()) for setup in setups
        ]
        self._current = 0
        self._timer.start()
        for link in self._links:
            if link.raw_doubt is not None:
                self._messages.tell_error("raw log", "Bytes are not recorded", link.raw_doubt)
        self.changed.emit()
        self._tell()

    def select(self, current: int) -> None:
        """Make another device the current one."""
        if current != self._current and 0 <= current < len(self._links):
            self._current = current
            self._told_silent = self.stopped = False
            self.changed.emit()
            self._tell()

    def close(self) -> None:
        """Let go of all ports; may be called again."""
        self._timer.stop()
        had = bool(self._links)
        for link in self._links:
            try:
                link.close()
            except LinkError as error:
                self._messages.tell_error(_SOURCE, "The port stays busy", error)
            if link.storage_error is not None:
                what = "The last bytes are not recorded"
                self._messages.tell_error("raw log", what, link.storage_error)
        self._links = []
        self._told_silent = self.stopped = False
        self._messages.clear(_SOURCE)
        if had:
            self.changed.emit()
            self._tell()

    def drain(self) -> None:
        """Pass on what has come; the timer calls it."""
        for link in tuple(self._links):
            for event in link.drain():
                self._on_event(link, event)
        self._ticks += 1
        if self._ticks % _STATE_EVERY == 0:
            self._watch()
            self._tell()

    def _on_event(self, link: Link, event: object) -> None:
        current = link is self.link
        match event:
            case SampleBlock():
                link.took(event)
                if current:
                    self.blocks.emit(event)
            case Message(kind="link lost"):
                self._messages.show(_SOURCE, lost_banner(link.setup, event.fields["why"]))
                if current:
                    self.interrupted.emit()
                self._tell()
            case Message(kind="reconnected"):
                self._messages.clear(_SOURCE)
                if current:
                    self.resumed.emit()
                self._tell()
            case Message(kind="paused"):
                self._messages.log(Severity.WARNING, paused_words(event.fields["gap_s"]), _SOURCE)
            case Ended():
                self._on_ended(link, event.error)
            case _:
                pass

    def _on_ended(self, link: Link, error: LinkError | None) -> None:
        link.ended(error)
        if error is not None:
            self._messages.tell_error(_SOURCE, "No link", error, RETRY, PROPERTIES)
        if link is self.link:
            self.interrupted.emit()
        self._tell()

    def _watch(self) -> None:
        """Tell of a silent link and of a disk that refuses."""
        link = self.link
        if link is None:
            return
        trouble: LabError | None = link.storage_error
        if trouble is not None:
            self._messages.tell_error("raw log", "Bytes are not recorded", trouble)
        silent = link.mark is LinkMark.SILENT and link.counters.silent_s > _SILENT_S
        if self.stopped:
            return
        if silent and not self._told_silent:
            self._messages.show(_SOURCE, silent_banner(link.setup, link.counters))
        elif self._told_silent and link.mark is LinkMark.STREAMING:
            self._messages.clear(_SOURCE)
        self._told_silent = silent

    def _tell(self) -> None:
        link = self.link
        if link is None:
            self.strip.emit(DeviceStripState(devices=(NO_NAME,)))
            return
        counters = link.counters
        measured = counters.measured_hz
        self.strip.emit(
            DeviceStripState(
                devices=tuple(one.setup.name for one in self._links),
                current=self._current,
                port=link.setup.url.partition("?")[0],
                baud=0 if link.setup.simulated else link.setup.baud,
                link=link.mark,
                rate_hz=measured if measured == measured else None,
                frames=counters.frames,
                received_bytes=counters.bytes,
                bad_checksum=counters.bad_checksum,
                lost=counters.lost,
                garbage=counters.garbage,
                temperature_c=link.temperature_c,
            )
        )

    def _on_action(self, source: str, key: str) -> None:
        if source != _SOURCE:
            return
        if key == RETRY.key:
            self.open(self.setups)
        elif key == PROPERTIES.key:
            self.properties_wanted.emit()
