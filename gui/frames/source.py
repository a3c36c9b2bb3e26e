"""Where the bytes come from: a port that is listened to, or a file."""

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from core.errors import LabError, LinkError, Severity
from drivers.ports import list_ports
from drivers.profile_types import PortSettings
from drivers.teach.ear import Heard
from drivers.teach.speeds import Trial, try_speeds
from drivers.transport import open_port
from gui.devices.connection import Connection
from gui.frames.listening import Listening, heard_in
from gui.frames.state import SourceState
from gui.frames.texts import heard_words
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.states import BannerState

PERIOD_MS = 200
SOURCE = "teach"


class Source(QObject):
    """Listens at a port of its own; nothing is ever sent.

    Parameters
    ----------
    connection : the devices; lets go of a port that is wanted here
    jobs : lists the ports and reads files
    messages : where troubles are told
    root : returns the folder of all sessions
    may_let_go : tells why the ports cannot be let go of now; empty if they can
    """

    changed = Signal(object)
    """A new `SourceState`."""
    ticked = Signal()
    """The latest bytes may be others."""
    fresh = Signal()
    """Other bytes than before begin to come."""
    read = Signal()
    """A file is here."""
    _stepped = Signal(int)

    def __init__(
        self,
        connection: Connection,
        jobs: Jobs,
        messages: Messages,
        root: Callable[[], Path],
        may_let_go: Callable[[], str],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._connection = connection
        self._jobs = jobs
        self._messages = messages
        self._root = root
        self._may_let_go = may_let_go
        self._listening: Listening | None = None
        self._frozen: bytes | None = None
        self.heard = Heard()
        self.state = SourceState()
        self._timer = QTimer(self)
        self._timer.setInterval(PERIOD_MS)
        self._timer.timeout.connect(self.tick)
        self._cancel = threading.Event()
        self._stepped.connect(self._on_speed)

    @property
    def tail(self) -> bytes:
        """The latest bytes, or those of the moment when the picture was held."""
        return self.heard.tail if self._frozen is None else self._frozen

    @property
    def raw_folder(self) -> Path:
        """Where the bytes are kept."""
        return self._root() / "raw"

    def refresh(self) -> None:
        """List the ports anew, in a worker."""
        self._jobs.start("port list", list_ports, self._on_ports, self._on_failed)

    def set_port(self, url: str) -> None:
        """Choose or type the port."""
        self.show(url=url.strip())

    def set_baud(self, baud: int) -> None:
        """Choose or type the speed; a port that is open is opened anew."""
        again = self.state.listening and baud != self.state.baud
        self.show(baud=baud)
        if again:
            self.listen()

    def listen(self) -> None:
        """Open the port and listen."""
        url = self.state.url
        if self.state.busy or not self._is_free(url):
            return
        self.stop()
        self.heard, self._frozen = Heard(), None
        self._listening = Listening(url, self.state.baud, self.raw_folder)
        if self._listening.raw_doubt is not None:
            self._messages.tell_error(SOURCE, "Bytes are not recorded", self._listening.raw_doubt)
        self.show(listening=True, file="", held=False, heard=heard_words(self.heard))
        self.fresh.emit()
        self._timer.start()

    def find_speed(self) -> None:
        """Listen at each speed until one makes sense, then go on at that one."""
        url = self.state.url
        if self.state.busy or not self._is_free(url):
            return
        self.stop()
        self._cancel.clear()
        self.show(busy="Listening at every speed")
        self._jobs.start(
            "speeds",
            lambda: try_speeds(
                lambda baud: open_port(url, _port(baud), baud),
                cancel=self._cancel,
                progress=self._stepped.emit,
            ),
            self._on_speeds,
            self._on_failed,
        )

    def stop(self) -> None:
        """Let go of the port; what was heard stays. May be called again."""
        self._cancel.set()
        self._timer.stop()
        listening, self._listening = self._listening, None
        if listening is None:
            return
        self.heard = listening.heard
        try:
            listening.close()
        except LinkError as error:
            self._messages.tell_error(SOURCE, "The port stays busy", error)
        self.show(listening=False)

    def load(self, path: Path) -> None:
        """Take the bytes of a file."""
        self.stop()
        self.show(busy=f"Reading {path.name}", file=path.name)
        self._jobs.start("raw bytes", lambda: heard_in(path), self._on_read, self._on_failed)

    def hold(self, held: bool) -> None:
        """Let the picture stand still, or follow the stream again."""
        self._frozen = self.heard.tail if held else None
        self.show(held=held)
        self.ticked.emit()

    def tick(self) -> None:
        """Look what has come; the timer calls it."""
        listening = self._listening
        if listening is None:
            return
        self.heard = listening.heard
        self.show(heard=heard_words(self.heard))
        if listening.ended:
            self.stop()
            if listening.error is not None:
                self._messages.tell_error(SOURCE, "No bytes from this port", listening.error)
        self.ticked.emit()

    def show(self, **values: object) -> None:
        """Take over values of the state."""
        state = replace(self.state, **values)  # pyright: ignore[reportArgumentType]
        if state != self.state:
            self.state = state
            self.changed.emit(state)

    def _is_free(self, url: str) -> bool:
        """Whether there is a port, and no device that measures stands at it."""
        if not url:
            self.show(heard="Choose a port first")
            return False
        if any(setup.url == url for setup in self._connection.setups):
            why = self._may_let_go()
            if why:
                remedy = "End what is being measured there, or choose another port."
                self._messages.show(
                    SOURCE, BannerState(Severity.WARNING, "The port is in use", why, remedy)
                )
                return False
            self._connection.close()
        return True

    def _on_speed(self, baud: int) -> None:
        if self.state.busy:
            self.show(busy=f"Listening at {baud} baud")

    def _on_speeds(self, trials: object) -> None:
        if not isinstance(trials, list):
            raise TypeError(f"a search of speeds brought {type(trials).__name__}")
        self.show(busy="")
        heard = [trial for trial in trials if isinstance(trial, Trial)]
        if heard and heard[0].proposal.found is not None:
            self.show(baud=heard[0].baud)
            self.listen()
        elif any(trial.count for trial in heard):
            self.show(
                heard="Bytes come, but at no speed do they repeat themselves: choose the BaudRate"
                " of the board's manual and Listen, then type Header and Length"
            )
        elif heard:
            self.show(heard="Silent at every speed; is the board switched on?")

    def _on_ports(self, ports: object) -> None:
        if not isinstance(ports, tuple):
            raise TypeError(f"a port list is {type(ports).__name__}")
        used = {setup.url for setup in self._connection.setups}
        free = [port.url for port in ports if port.url not in used and port.kind != "simulated"]
        self.show(ports=ports, url=self.state.url or (free[0] if free else ""))

    def _on_read(self, heard: object) -> None:
        if not isinstance(heard, Heard):
            raise TypeError(f"a file brought {type(heard).__name__}")
        self.heard, self._frozen = heard, None
        self.show(busy="", heard=heard_words(heard), held=False)
        self.fresh.emit()
        self.ticked.emit()
        self.read.emit()

    def _on_failed(self, error: LabError) -> None:
        self.show(busy="")
        self._messages.tell_error(SOURCE, "The bytes cannot be had", error)


def _port(baud: int) -> PortSettings:
    return PortSettings((baud,), 8, "N", 1, 0, dtr=False, rts=False)
