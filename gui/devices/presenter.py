"""Device Properties: which devices are at which ports."""

import threading
from collections.abc import Callable, Mapping
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from core.errors import LabError, Severity
from core.records.names import NO_NAME
from drivers.ports import list_ports
from drivers.profile import Profile
from drivers.scan import Found, ScanReport, ScanStep, scan
from gui.devices.connection import Connection
from gui.devices.scan_words import asked_banner, heard_words, question_words
from gui.devices.setup import DeviceSetup
from gui.devices.state import PropertiesState, found_at, why_not_ok
from gui.jobs import Jobs
from gui.messages import Messages

MOST = 16
_SOURCE = "devices"
_LISTEN_S = 1.0


class DevicesPresenter(QObject):
    """Fills the rows by hand or by scanning, and opens the connection.

    Parameters
    ----------
    connection : opened by `ok`
    profiles : returns the device files by id
    jobs : runs the listing and the scan
    messages : where troubles are told
    may_let_go : tells why the ports cannot be let go of now; empty if they can
    """

    changed = Signal(object)
    """A new `PropertiesState`."""
    accepted = Signal()
    """The connection was opened: the panel has done its work."""
    _stepped = Signal(object)

    def __init__(
        self,
        connection: Connection,
        profiles: Callable[[], Mapping[str, Profile]],
        jobs: Jobs,
        messages: Messages,
        may_let_go: Callable[[], str],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._connection = connection
        self._profiles = profiles
        self._jobs = jobs
        self._messages = messages
        self._may_let_go = may_let_go
        self._cancel = threading.Event()
        self._active = False
        self._open_after = False
        self.state = PropertiesState()
        self._stepped.connect(self._on_step)

    def show_setups(self, setups: tuple[DeviceSetup, ...]) -> None:
        """Begin with these rows."""
        self._set(rows=setups or (DeviceSetup(),), report="", question="")

    def refresh(self) -> None:
        """List the ports anew, in a worker; and the device files."""
        try:
            known = tuple((p.id, p.name) for p in self._profiles().values())
        except LabError as error:
            self._messages.tell_error(_SOURCE, "A device file is wrong", error)
            known = self.state.profiles
        self._set(profiles=known)
        self._jobs.start("port list", list_ports, self._on_ports, self._on_failed)

    def set_count(self, count: int) -> None:
        """Number of Devices."""
        count = max(1, min(count, MOST))
        rows = self.state.rows[:count]
        self._set(rows=(*rows, *(DeviceSetup() for _ in range(count - len(rows)))))

    def set_port(self, row: int, url: str) -> None:
        """Choose or type the port of a device; who is there is then unknown."""
        if url != self.state.rows[row].url:
            self._change(row, url=url.strip(), name=NO_NAME)

    def set_baud(self, row: int, baud: int) -> None:
        """Choose or type the speed of a device."""
        self._change(row, baud=baud)

    def set_profile(self, row: int, profile_id: str) -> None:
        """Choose what a device speaks; empty leaves it to the scan."""
        profile = self._profiles().get(profile_id)
        same = profile_id == self.state.rows[row].profile_id
        if profile is None or same:
            self._change(row, profile_id=profile_id)
        else:
            self._change(row, profile_id=profile_id, baud=profile.port.bauds[0])

    def scan(self) -> None:
        """Listen at the ports of all rows; nothing is sent."""
        self._begin(active=False)

    def ask(self) -> None:
        """Ask the devices for their names, since the operator agreed that something is sent."""
        self._begin(active=True)

    def decline(self) -> None:
        """Leave the devices unasked."""
        self._set(question="")

    def cancel(self) -> None:
        """End the scan with what it has found."""
        self._cancel.set()

    def ok(self) -> None:
        """Open the ports of all rows; rows whose profile is unknown are scanned first."""
        if self.state.why_not_ok or self.state.busy:
            return
        if any(not row.profile_id for row in self.state.rows):
            self._open_after = True
            self._begin(active=False)
            return
        if self._refused():
            return
        self._set(question="", report="")
        self._messages.clear(_SOURCE)
        self._connection.open(self.state.rows)
        self.accepted.emit()

    def _refused(self) -> bool:
        why = self._may_let_go()
        if why:
            self._messages.show(_SOURCE, asked_banner(why))
        return bool(why)

    def _begin(self, *, active: bool) -> None:
        if self.state.busy or self._refused():
            self._open_after = False
            return
        urls = [row.url for row in self.state.rows if row.url]
        if not urls:
            self._open_after = False
            self._set(report="Choose a port first.")
            return
        self._connection.close()
        self._cancel.clear()
        self._active = active
        profiles = list(self._profiles().values())
        self._set(busy="Listening", progress=0.0, question="", report="")
        self._jobs.start(
            "scan",
            lambda: scan(
                urls,
                profiles,
                listen_s=_LISTEN_S,
                active=active,
                cancel=self._cancel,
                progress=self._stepped.emit,
            ),
            self._on_scanned,
            self._on_failed,
        )

    def _on_step(self, step: object) -> None:
        if isinstance(step, ScanStep) and self.state.busy:
            verb = "Asking at" if self._active else "Listening at"
            self._set(
                busy=f"{verb} {step.url}, {step.baud} baud",
                progress=step.done / max(step.total, 1),
            )

    def _on_scanned(self, result: object) -> None:
        if not isinstance(result, ScanReport):
            raise TypeError(f"a scan brought {type(result).__name__}")
        first: dict[str, Found] = {}
        for found in result.found:
            first.setdefault(found.url, found)
        rows = tuple(found_at(row, first.get(row.url)) for row in self.state.rows)
        question = "" if self._active else question_words(result)
        self._set(rows=rows, busy="", question=question, report=heard_words(result))
        if self._open_after:
            self._open_after = False
            if all(row.profile_id for row in rows):
                self.ok()

    def _on_ports(self, ports: object) -> None:
        if not isinstance(ports, tuple):
            raise TypeError(f"a port list is {type(ports).__name__}")
        rows = self.state.rows
        if len(rows) == 1 and not rows[0].url and ports:
            rows = (replace(rows[0], url=ports[0].url),)
        self._set(ports=ports, rows=rows)

    def _on_failed(self, error: LabError) -> None:
        self._open_after = False
        self._set(busy="")
        self._messages.tell_error(_SOURCE, "The ports cannot be looked at", error)
        self._messages.log(Severity.ERROR, str(error), _SOURCE)

    def _change(self, row: int, **values: object) -> None:
        rows = list(self.state.rows)
        rows[row] = replace(rows[row], **values)  # pyright: ignore[reportArgumentType]
        self._set(rows=tuple(rows))

    def _set(self, **values: object) -> None:
        state = replace(self.state, **values)  # pyright: ignore[reportArgumentType]
        self.state = replace(state, why_not_ok=why_not_ok(state))
        self.changed.emit(self.state)
