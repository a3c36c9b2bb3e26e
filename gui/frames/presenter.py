"""Teach a board: from the bytes to a device file."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import LabError, Severity
from core.samples.block import Channel
from drivers.expression import evaluate
from drivers.profile import Profile
from drivers.profile_types import FrameSpec
from drivers.teach.analysis import FEWEST, Proposal, analyse
from drivers.teach.ear import Heard
from drivers.teach.frames import FrameProposal, checks_of, describe
from drivers.teach.pace import pace_of, usual_rate
from gui.devices.connection import Connection
from gui.devices.setup import DeviceSetup
from gui.frames.readings import Readings, field_rows, read_latest
from gui.frames.saving import file_of, save, why_not
from gui.frames.source import SOURCE, Source
from gui.frames.state import FramesState
from gui.frames.taught import (
    Taught,
    add_fields,
    change_channel,
    change_field,
    change_scale,
    found,
    remove_fields,
    with_check,
)
from gui.frames.texts import (
    NO_CHECK,
    check_words,
    reading_of,
    sync_words,
    verdict_words,
)
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.states import BannerState

_ENOUGH = 2000
_HINTS_EVERY = 10


class FramesPresenter(QObject):
    """Finds what the bytes are, and lets the operator change what was found.

    Parameters
    ----------
    source : the bytes
    connection : the devices, to which the taught one is added
    jobs : runs what is slow
    messages : where troubles are told
    profiles : returns the device files by id
    root : returns the folder of all sessions
    may_let_go : tells why the ports cannot be let go of now; empty if they can
    """

    changed = Signal(object)
    """A new `FramesState`."""
    ticked = Signal(object)
    """New `Readings` of the latest bytes."""

    def __init__(
        self,
        source: Source,
        connection: Connection,
        jobs: Jobs,
        messages: Messages,
        profiles: Callable[[], Mapping[str, Profile]],
        root: Callable[[], Path],
        may_let_go: Callable[[], str],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.source = source
        self._connection = connection
        self._jobs = jobs
        self._messages = messages
        self._profiles = profiles
        self._root = root
        self._may_let_go = may_let_go
        self._ticks = 0
        self._searching = False
        self._looked = True
        self.taught = Taught()
        self.readings: Readings = read_latest(b"", self.taught)
        self.state = FramesState()
        source.ticked.connect(self._on_tick)
        source.fresh.connect(self._on_fresh)
        source.read.connect(self.find)

    # --- what they are ----------------------------------------------------------------------------

    def find(self) -> None:
        """Find out what the stream is, in a worker; replaces the description."""
        tail, heard = self.source.tail, self.source.heard
        if self._searching or len(tail) < FEWEST:
            return
        self._searching = self._looked = True
        self.source.show(busy="Looking for frames, checksum and numbers")
        self._jobs.start(
            "teach",
            lambda: analyse(tail, heard.bytes_per_s, heard.doubt),
            self._on_found,
            self._on_search_failed,
        )

    def set_frame(self, sync: str, length: int) -> None:
        """Take a header and a length given by hand; checksum and numbers are found again."""
        if self._searching:
            return
        try:
            header = tuple(bytes.fromhex(sync))
        except ValueError:
            self._set(verdict=f'"{sync}" is no row of bytes like "AA 55"', sure=False)
            return
        if not 1 <= len(header) <= 8 or length <= len(header):
            self._set(verdict="A header has 1 to 8 bytes, and a frame more than it", sure=False)
            return
        tail, heard = self.source.tail, self.source.heard
        self._searching = True
        self.source.show(busy="Looking for the checksum")
        self._jobs.start(
            "teach",
            lambda: _by_hand(tail, header, length, heard),
            self._on_found,
            self._on_search_failed,
        )

    def choose_reading(self, index: int) -> None:
        """Take the length that one meaning of a length byte gives."""
        readings = self.state.readings
        if 0 <= index < len(readings) and readings[index].length != self.state.length:
            self.set_frame(self.state.sync, readings[index].length)

    def choose_check(self, index: int) -> None:
        """Take one of the checksums that fit, or none."""
        checks = self.taught.checks
        self._teach(with_check(self.taught, checks[index] if 0 <= index < len(checks) else None))

    def select(self, first: int, stop: int) -> None:
        """Point at columns of the frames."""
        self._set(selection=(first, stop) if stop > first else None)

    def add_selected(self) -> None:
        """Make fields of the bytes pointed at."""
        if self.state.selection is None:
            return
        first, stop = self.state.selection
        self._teach(add_fields(self.taught, first, stop, self.readings.frames))
        places = (
            [n for n, one in enumerate(self.taught.stream.fields) if first <= one.at < stop]
            if isinstance(self.taught.stream, FrameSpec)
            else []
        )
        self.edit(places[0] if places else -1)

    def remove_selected(self) -> None:
        """Take the fields away that stand on the bytes pointed at."""
        if self.state.selection is not None:
            self._teach(remove_fields(self.taught, *self.state.selection))

    def edit(self, index: int) -> None:
        """Choose the number to change."""
        spec = self.taught.stream
        if isinstance(spec, FrameSpec) and 0 <= index < len(spec.fields):
            field = spec.fields[index]
            self._set(field=index, selection=(field.at, field.end))
        else:
            self._set(field=index)

    def rename(self, index: int, name: str, unit: str, role: str) -> None:
        """Change what a number is called and what it measures."""
        channel = Channel(name.strip(), unit.strip() or "code", role.strip())
        self._teach(change_channel(self.taught, index, channel))

    def retype(self, index: int, type_: str, endian: str) -> None:
        """Change how the bytes of a number are read."""
        self._teach(change_field(self.taught, index, type=type_, endian=endian))

    def hide(self, index: int, hidden: bool) -> None:
        """Keep a number out of the channels, or put it in."""
        self._teach(change_field(self.taught, index, hide=hidden))

    def rescale(self, index: int, scale: str, offset: str) -> None:
        """Change value = number * scale + offset; both may be expressions."""
        try:
            numbers = evaluate(scale, {}), evaluate(offset, {})
        except ValueError as error:
            self._set(doubt=str(error))
            return
        self._teach(change_scale(self.taught, index, *numbers))

    # --- what becomes of it -----------------------------------------------------------------------

    def describe(self, name: str, kind: str) -> None:
        """Name the board."""
        self._teach(replace(self.taught, name=name.strip(), kind=kind))

    def save(self) -> Path | None:
        """Write the device file; return where it stands."""
        if self.state.doubt:
            return None
        source = self.source.state
        heard = source.file or source.url
        self._time()
        told = (f"taught from {heard}" if heard else "", self.taught.why_hz)
        taught = replace(self.taught, notes="; ".join(filter(None, told)))
        try:
            path = save(self._root(), taught, source.baud)
        except LabError as error:
            self._messages.tell_error(SOURCE, "The device file is not saved", error)
            return None
        self._messages.log(Severity.INFO, f"device file {path}", SOURCE)
        self._set(saved=str(path))
        return path

    def use(self) -> None:
        """Save, let go of the port here, and open it as a device like any other."""
        source = self.source.state
        why = self._may_let_go()
        if why:
            remedy = "End what is being measured there, then press Save and connect again."
            banner = BannerState(Severity.WARNING, "Not connected yet", why, remedy)
            self._messages.show(SOURCE, banner)
            return
        if not source.url or self.save() is None:
            return
        self.source.stop()
        name = self.taught.name
        profile = file_of(self._root(), name).stem
        self._connection.open([DeviceSetup(source.url, source.baud, profile, name)])
        self._messages.show(
            SOURCE,
            BannerState(
                Severity.INFO,
                f"{name} is connected",
                "Its numbers are drawn in the tab Live; every tab knows it by its roles.",
            ),
        )

    # --- within -----------------------------------------------------------------------------------

    def _on_fresh(self) -> None:
        self._looked = False

    def _on_tick(self) -> None:
        """Show the latest bytes; look once by itself what they are."""
        self._look()
        self._ticks += 1
        if self.source.state.listening:
            if not self._looked and self.source.heard.total >= _ENOUGH:
                self.find()
            elif self._ticks % _HINTS_EVERY == 0:
                self._time()
                self._tell()

    def _time(self) -> None:
        """Count the samples a second once the stream has been heard for long enough."""
        heard = self.source.heard
        hz = heard.bytes_per_s * self.readings.per_byte
        if hz > 0.0 and not heard.doubt:
            self.taught = replace(self.taught, hz=usual_rate(hz), why_hz="")

    def _look(self) -> None:
        self.readings = read_latest(self.source.tail, self.taught)
        self.ticked.emit(self.readings)

    def _teach(self, taught: Taught) -> None:
        self.taught = taught
        self._look()
        self._tell(saved="")

    def _tell(self, *, field: int | None = None, **values: object) -> None:
        """Show the description as it is now; `field` is edited, or the one that was."""
        field = self.state.field if field is None else field
        taught = self.taught
        spec = taught.stream if isinstance(taught.stream, FrameSpec) else None
        length = spec.shortest if spec else 0
        taken = next(
            (n for n, fit in enumerate(taught.checks) if spec and fit.spec == spec.checksum),
            len(taught.checks),
        )
        doubt = taught.doubt(self.source.state.baud)
        if not doubt:
            packaged = [one.id for one in self._profiles().values()] if taught.name else []
            doubt = why_not(self._root(), taught.name, packaged)
        fields = field_rows(taught, self.readings.frames)
        self._set(
            binary=taught.stream is None or spec is not None,
            sync=sync_words(spec.sync) if spec else "",
            length=length,
            checks=(*(check_words(fit, length) for fit in taught.checks), NO_CHECK) if spec else (),
            check=taken if spec else -1,
            readings=tuple(map(reading_of, taught.readings)),
            fields=fields,
            field=min(field, len(fields) - 1),
            name=taught.name,
            kind=taught.kind,
            hz=taught.hz,
            doubt=doubt,
            **values,
        )

    def _on_found(self, proposal: object) -> None:
        if not isinstance(proposal, Proposal):
            raise TypeError(f"a search brought {type(proposal).__name__}")
        self._searching = False
        self.source.show(busy="")
        if self.source.state.listening and not self.source.heard.doubt:
            # The clock tells it in a moment.
            proposal = replace(proposal, pace=replace(proposal.pace, why=""))
        verdict, sure = verdict_words(proposal)
        if proposal.found is None:
            self._set(verdict=verdict, sure=False)
            return
        self.taught = found(self.taught, proposal)
        self._look()
        self._tell(verdict=verdict, sure=sure, selection=None, field=-1, saved="")

    def _on_search_failed(self, error: LabError) -> None:
        self._searching = False
        self._on_failed(error)

    def _on_failed(self, error: LabError) -> None:
        self.source.show(busy="")
        self._messages.tell_error(SOURCE, "The bytes cannot be had", error)

    def _set(self, **values: object) -> None:
        state = replace(self.state, **values)  # pyright: ignore[reportArgumentType]
        if state != self.state:
            self.state = state
            self.changed.emit(state)


def _by_hand(tail: bytes, header: tuple[int, ...], length: int, heard: Heard) -> Proposal:
    """Describe frames of a given header and length."""
    fits = checks_of(tail, header, length)
    proposal: FrameProposal | None = describe(tail, header, length, fits[0] if fits else None)
    if proposal is None:
        return Proposal(None)
    hz = heard.bytes_per_s * proposal.frames / len(tail)
    pace = pace_of(tail, proposal.spec, hz, heard.doubt)
    return Proposal(replace(proposal, checks=tuple(fits)), pace)
