"""Stop Device and Start Device: by the commands of the device file, else by its port."""

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QObject, QTimer

from core.errors import Severity
from drivers.profile_types import Command
from gui.devices.connection import Connection
from gui.devices.link import Link
from gui.devices.setup import DeviceSetup
from gui.messages import Messages
from gui.widgets.states import BannerAction, BannerState, LinkMark

_SOURCE = "stop"
_START = "start"
_OBEYED_MS = 2500


class Stopping(QObject):
    """Stops the device that is measured, and starts it again.

    Parameters
    ----------
    connection : the devices
    messages : where it is told
    why_busy : why nothing can be stopped now; empty if it can
    """

    def __init__(
        self,
        connection: Connection,
        messages: Messages,
        why_busy: Callable[[], str],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._connection = connection
        self._messages = messages
        self._why_busy = why_busy
        self._closed: tuple[DeviceSetup, ...] = ()
        self._look = QTimer(self, singleShot=True, interval=_OBEYED_MS)
        self._look.timeout.connect(self._on_look)
        messages.action.connect(self._on_action)
        connection.changed.connect(self._on_changed)

    def stop(self) -> None:
        """Have the device stop sending; let go of the ports where it knows no such command."""
        busy = self._why_busy()
        if busy:
            self._tell(Severity.WARNING, _say("The device is not stopped"), busy, start=False)
            return
        link = self._connection.link
        if link is None:
            return
        command = link.profile.commands.get("stop")
        if command is None:
            setups = self._connection.setups
            self._connection.close()
            self._closed = setups
            self._tell(
                Severity.INFO,
                _say("The port is closed"),
                _say("The device file of {name} knows no stop command; the device goes on"
                     " sending.").format(name=link.setup.name),
            )  # fmt: skip
            return
        self._send(link, command)
        self._connection.stopped = True
        self._look.start()
        can_start = "start" in link.profile.commands
        self._tell(
            Severity.INFO,
            _say("{name} was told to stop").format(name=link.setup.name),
            ""
            if can_start
            else _say("Its device file knows no start command: switch it off and on to have it"
                      " send again."),
            start=can_start,
        )  # fmt: skip

    def start(self) -> None:
        """Have it send again."""
        self._messages.clear(_SOURCE)
        self._connection.stopped = False
        link = self._connection.link
        if link is None:
            setups, self._closed = self._closed, ()
            if setups:
                self._connection.open(setups)
            return
        command = link.profile.commands.get("start")
        if command is not None:
            self._send(link, command)

    def _send(self, link: Link, command: Command) -> None:
        """As often and with the pauses that the device file asks for."""
        for turn in range(command.repeat):
            QTimer.singleShot(turn * command.gap_ms, self, _Sending(link, command.data))

    def _on_look(self) -> None:
        """Whether the device obeyed."""
        link = self._connection.link
        if link is not None and self._connection.stopped and link.mark is LinkMark.STREAMING:
            self._connection.stopped = False
            self._tell(
                Severity.WARNING,
                _say("{name} goes on sending").format(name=link.setup.name),
                _say("It did not obey the stop command of its device file."),
                start=False,
            )

    def _on_action(self, source: str, key: str) -> None:
        if source == _SOURCE and key == _START:
            self.start()

    def _on_changed(self) -> None:
        if self._connection.link is not None:
            self._closed = ()
            self._messages.clear(_SOURCE)

    def _tell(self, severity: Severity, what: str, meaning: str, *, start: bool = True) -> None:
        actions = (BannerAction(_START, _say("Start Device")),) if start else ()
        self._messages.show(_SOURCE, BannerState(severity, what, meaning, "", actions))


class _Sending:
    """One sending of a command, later."""

    def __init__(self, link: Link, data: bytes) -> None:
        self._link = link
        self._data = data

    def __call__(self) -> None:
        self._link.send(self._data)


def _say(text: str) -> str:
    return QCoreApplication.translate("Stopping", text)
