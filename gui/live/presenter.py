"""The Live tab: clicks in, `LiveState` out; samples go straight to the trace."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import LabError
from core.records.names import NO_NAME
from core.samples.block import SampleBlock
from drivers.reader import Counters
from gui.devices.connection import Connection
from gui.devices.link import Link
from gui.live.keeper import Keeper
from gui.live.loading import Loaded, Loading
from gui.live.measures import Measures
from gui.live.scene import DISCARD, RESUME, actions, headline, stopped_banner
from gui.live.settings import LiveSettings, settings_of
from gui.live.state import ChannelRow, LiveState, LiveStatus, Phase
from gui.live.trace import Trace
from gui.messages import Messages
from gui.settings import Settings
from gui.widgets.history import History

SECTION = SOURCE = "live"


def _port(link: Link) -> str:
    """Port and speed, as the operator knows them."""
    port = link.setup.url.partition("?")[0]
    return port if link.setup.simulated else f"{port} {link.setup.baud}"


class LivePresenter(QObject):
    """Everything the view asks for.

    Parameters
    ----------
    connection : the devices
    keeper : the record on the disk
    loading : records from the disk
    measures : cursors, intervals, means and exports
    messages : where troubles are told
    settings : where the operator's choices are remembered
    """

    changed = Signal(object)
    """A new `LiveState`."""
    trace_changed = Signal()
    """Another history is on the screen: read `trace`."""

    def __init__(
        self,
        connection: Connection,
        keeper: Keeper,
        loading: Loading,
        measures: Measures,
        messages: Messages,
        settings: Settings,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._connection = connection
        self._keeper = keeper
        self._loading = loading
        self.measures = measures
        self._messages = messages
        self._stored = settings
        self.settings = settings_of(settings.section(SECTION))
        self.trace: Trace | None = None
        self.overlays: list[Trace] = []
        self._phase = Phase.OFFLINE
        self._stem = ""
        self._latest: SampleBlock | None = None
        self._before = Counters()
        self._acts = {
            "start": self.start,
            "stop": self.stop,
            RESUME: self.resume,
            DISCARD: self.discard,
            "watch": self.watch,
        }
        connection.blocks.connect(self._on_block)
        connection.changed.connect(self._on_device)
        messages.action.connect(self._on_banner)
        keeper.discarded.connect(self._tell)
        loading.loaded.connect(self._on_loaded)
        measures.changed.connect(self._tell)

    # --- what is shown ----------------------------------------------------------------------------

    @property
    def phase(self) -> Phase:
        """What the tab does."""
        return self._phase

    @property
    def serial(self) -> str:
        """Device #: what the operator typed, else the device's own name."""
        link = self._connection.link
        return self.settings.serial or (NO_NAME if link is None else link.setup.name)

    @property
    def file(self) -> str:
        """Name of the next or the running record, without suffix."""
        recorder = self._keeper.recorder
        if recorder is not None and self._phase is Phase.RECORDING:
            return recorder.path.stem
        return self._stem or self._keeper.propose(self.serial, self.settings)

    @property
    def state(self) -> LiveState:
        """The tab as it is now."""
        trace, phase = self.trace, self._phase
        link = self._connection.link
        words, tone = headline(phase, "" if trace is None else trace.name)
        busy = phase is Phase.RECORDING
        return LiveState(
            phase,
            words,
            tone,
            self.settings,
            "" if link is None else f"{_port(link)}, {link.profile.name}, {link.rate_hz:g} Hz",
            self.file,
            str(self._keeper.folder(self.serial)),
            "A record is running" if busy else "",
            self._rows(),
            actions(
                phase,
                linked=link is not None and link.rate_hz > 0 and link.error is None,
                resumable=self._keeper.recorder is not None and self._keeper.link is link,
                samples=trace is not None and trace.history.end > 0,
            ),
            () if trace is None else tuple(trace.intervals),
            () if trace is None else trace.shown_marks(),
            self.measures.table,
            tuple(one.name for one in self.overlays),
        )

    def shown(self) -> list[int]:
        """Numbers of the channels that are shown."""
        if self.trace is None:
            return []
        hidden = self.settings.hidden
        return [i for i, c in enumerate(self.trace.channels) if c.name not in hidden]

    def status(self) -> LiveStatus:
        """The status line as it is now."""
        self._keeper.watch()
        trace, link = self.trace, self._connection.link
        seconds = 0.0 if trace is None else trace.seconds
        if link is None or self._phase is Phase.LOADED:
            return LiveStatus(seconds=seconds)
        now, before = link.counters, self._before
        recorder = self._keeper.recorder
        stored = 0
        if recorder is not None and recorder.path.exists():
            stored = recorder.path.stat().st_size
        return LiveStatus(
            _port(link),
            now.frames - before.frames if recorder is None else recorder.count,
            seconds,
            now.measured_hz if now.measured_hz == now.measured_hz else None,
            now.bad_checksum - before.bad_checksum,
            now.bad_values - before.bad_values,
            now.lost - before.lost,
            stored,
            self._keeper.lasting,
        )

    def _rows(self) -> tuple[ChannelRow, ...]:
        if self.trace is None:
            return ()
        hidden = self.settings.hidden
        return tuple(ChannelRow(c.name, c.unit, c.name not in hidden) for c in self.trace.channels)

    # --- what the operator does -------------------------------------------------------------------

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        self._acts[key]()

    def start(self) -> None:
        """START sampling process."""
        link, trace = self._connection.link, self.trace
        block = self._latest
        if link is None or block is None or not link.rate_hz > 0.0:
            return
        stem = self.file
        try:
            self._keeper.start(link, block.channels, self.serial, stem, self.settings)
        except LabError as error:
            self._messages.tell_error(SOURCE, "The record cannot begin", error)
            return
        self._messages.clear(SOURCE)
        self._stem = ""
        self._before = link.counters
        same = trace is not None and trace.channels == block.channels
        self._show(Trace(History(block.channels, link.rate_hz), stem), Phase.RECORDING, keep=same)

    def stop(self) -> None:
        """STOP sampling process: at once; the banner offers to resume or to discard."""
        recorder = self._keeper.recorder
        if recorder is None or self._phase is not Phase.RECORDING:
            return
        self._keeper.stop()
        self._phase = Phase.STOPPED
        seconds = 0.0 if self.trace is None else self.trace.seconds
        self._messages.show(SOURCE, stopped_banner(recorder.path.name, recorder.count, seconds))
        self._tell()

    def resume(self) -> None:
        """Go on with the stopped record."""
        if self._phase is Phase.STOPPED and self._keeper.recorder is not None:
            self._messages.clear(SOURCE)
            self._keeper.resume()
            self._phase = Phase.RECORDING
            self._tell()

    def discard(self) -> None:
        """Put the stopped record aside and watch on."""
        if self._phase is Phase.STOPPED:
            self._messages.clear(SOURCE)
            self._keeper.discard()
            self.watch()

    def watch(self) -> None:
        """Back to the live samples; a stopped record is ended."""
        if self._phase is Phase.RECORDING:
            return
        self._keeper.end()
        self._messages.clear(SOURCE)
        self._phase = Phase.OFFLINE
        self.trace = None
        self.measures.take(None, [], self.serial)
        if self._latest is not None:
            self._on_block(self._latest)
        self.trace_changed.emit()
        self._tell()

    def mark(self, note: str) -> None:
        """Note an event: now while samples come, else at cursor A."""
        trace = self.trace
        if trace is None or not trace.history.end or self._phase is Phase.LOADED:
            return
        at = self.measures.cursors[0]
        moving = self._phase is not Phase.STOPPED or at is None
        number = trace.newest if moving or at is None else trace.history.number(at)
        text = note.strip() or f"{len(trace.marks) + 1}"
        trace.marks.append((number, text))
        self._keeper.mark(number, text)
        self._tell()

    def load(self, path: Path, *, beneath: bool = False) -> None:
        """Open a record, or draw it beneath."""
        if beneath or self._phase is not Phase.RECORDING:
            self._loading.load(path, beneath=beneath)

    def clear_overlays(self) -> None:
        """Draw nothing beneath."""
        self.overlays.clear()
        self._tell()

    def set_settings(self, settings: LiveSettings) -> None:
        """Take the fields of the panel."""
        if settings != self.settings:
            self.settings = settings
            self._stored.store(SECTION, settings.to_section())
            self.measures.show(self.shown(), self.serial)
            self._tell()

    def set_file(self, name: str) -> None:
        """Name the next record; an empty name gives back the proposed one."""
        self._stem = name.strip()
        self._tell()

    def show_channel(self, name: str, shown: bool) -> None:
        """Show or hide a channel."""
        hidden = [one for one in self.settings.hidden if one != name]
        self.set_settings(replace(self.settings, hidden=(*hidden, *([] if shown else [name]))))

    # --- what comes from elsewhere ----------------------------------------------------------------

    def _on_block(self, block: SampleBlock) -> None:
        self._latest = block
        link, trace = self._connection.link, self.trace
        if self._phase is Phase.LOADED or link is None or not link.rate_hz > 0.0:
            return
        recorder = self._keeper.recorder
        if self._phase in (Phase.RECORDING, Phase.STOPPED):
            same = trace is not None and block.channels == trace.channels
            first = None if recorder is None else recorder.first
            if recorder is not None and trace is not None and same and first is not None:
                trace.feed(block, first, recorder.next)
            return
        if trace is None or trace.channels != block.channels:
            self._show(Trace(History(block.channels, link.rate_hz)), Phase.WATCHING)
            trace = self.trace
        if trace is not None:
            trace.feed(block)
            if trace.shorten():
                self.trace_changed.emit()

    def _on_device(self) -> None:
        """Another device, or none: a record of the old one is over."""
        link = self._connection.link
        self._latest = None
        self._before = Counters()
        if self._phase in (Phase.RECORDING, Phase.STOPPED) and self._keeper.link is not link:
            self._keeper.end()
            self._phase = Phase.STOPPED
        elif self._phase in (Phase.WATCHING, Phase.OFFLINE):
            self.trace, self._phase = None, Phase.OFFLINE
            self.measures.take(None, [], self.serial)
            self.trace_changed.emit()
        self._tell()

    def _on_loaded(self, found: object) -> None:
        if not isinstance(found, Loaded):
            raise TypeError(f"{type(found).__name__} is no record")
        if found.beneath:
            self.overlays.append(found.trace)
            self._tell()
        elif self._phase is not Phase.RECORDING:
            self._keeper.end()
            self._show(found.trace, Phase.LOADED)

    def _on_banner(self, source: str, key: str) -> None:
        if source == SOURCE and key in self._acts:
            self.act(key)

    def _show(self, trace: Trace, phase: Phase, *, keep: bool = False) -> None:
        self.trace, self._phase = trace, phase
        if not keep:
            self.overlays.clear()
        self.measures.take(trace, self.shown(), self.serial)
        self.trace_changed.emit()
        self._tell()

    def _tell(self) -> None:
        self.changed.emit(self.state)
