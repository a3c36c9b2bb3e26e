"""The simulated rig in a process of its own, behind a real pseudo-terminal.

``python -m drivers.virtual.pty_rig sim://clbacc?seed=3 --control /tmp/rig.sock`` prints the name
of the port as ``{"port": "/dev/pts/5"}``, sends frames at the speed of the address, and takes
orders (`drivers.virtual.orders`) as lines of JSON from standard input, or from a control socket.
It ends with the order ``{"quit": true}`` and at the end of standard input. Linux and macOS only;
elsewhere use ``sim://``.
"""

import argparse
import json
import math
import os
import selectors
import socket
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from drivers.virtual.address import Stand, stand_of
from drivers.virtual.orders import obey_line
from drivers.virtual.rig import Unplugged

if sys.platform != "win32":
    import termios
    import tty

_STEP_S = 0.005
_MOST_WAITING = 1 << 16


class PtyLine:
    """A pseudo-terminal: the rig's end, and a name for the other.

    Parameters
    ----------
    link : symbolic link that names the port, kept over unplugging; None for none
    """

    def __init__(self, link: Path | None) -> None:
        self._link = link
        self._waiting = b""
        self.overrun = 0
        self.master, self._slave = os.openpty()
        tty.setraw(self._slave)
        os.set_blocking(self.master, False)
        self.name = os.ttyname(self._slave)
        if link is not None:
            beside = link.with_name(link.name + ".new")
            beside.symlink_to(self.name)
            beside.replace(link)

    def send(self, data: bytes) -> None:
        """Write what the terminal takes; beyond 64 kB of backlog bytes are lost, as on a UART."""
        self._waiting += data
        try:
            sent = os.write(self.master, self._waiting)
        except BlockingIOError:
            sent = 0
        self._waiting = self._waiting[sent:]
        if len(self._waiting) > _MOST_WAITING:
            self.overrun += len(self._waiting)
            self._waiting = b""

    def receive(self) -> bytes:
        """Return what the computer sent."""
        try:
            return os.read(self.master, 4096)
        except BlockingIOError:
            return b""

    def heard_at(self, baud: int) -> bool:
        """Whether the computer has set this baud rate."""
        return termios.tcgetattr(self._slave)[5] == getattr(termios, f"B{baud}", None)

    def close(self) -> None:
        """Hang up, as an unplugged adapter does."""
        os.close(self.master)
        os.close(self._slave)
        if self._link is not None:
            self._link.unlink(missing_ok=True)


class Control:
    """Where the orders come from: standard input, or all who connect to a socket.

    Parameters
    ----------
    path : the socket to make; None for standard input
    """

    def __init__(self, path: Path | None) -> None:
        self.ended = False
        self._selector = selectors.DefaultSelector()
        self._pieces: dict[int, bytes] = {}
        self._clients: dict[int, socket.socket] = {}
        self._path = path
        self._server: socket.socket | None = None
        if path is None:
            self._watch(sys.stdin.fileno())
        else:
            path.unlink(missing_ok=True)
            self._server = socket.socket(socket.AF_UNIX)
            self._server.bind(str(path))
            self._server.listen()
            self._selector.register(self._server.fileno(), selectors.EVENT_READ)

    def lines(self, wait_s: float) -> list[tuple[int, bytes]]:
        """Return what was ordered, with whom to answer; waits so long for the first."""
        lines: list[tuple[int, bytes]] = []
        for key, _ in self._selector.select(wait_s):
            if self._server is not None and key.fd == self._server.fileno():
                client, _ = self._server.accept()
                self._clients[client.fileno()] = client
                self._watch(client.fileno())
            else:
                lines += self._read(key.fd)
        return lines

    def answer(self, to: int, line: bytes) -> None:
        """Send an answer back."""
        os.write(sys.stdout.fileno() if to == sys.stdin.fileno() else to, line + b"\n")

    def close(self) -> None:
        """Let go of all."""
        self._selector.close()
        for client in self._clients.values():
            client.close()
        if self._server is not None and self._path is not None:
            self._server.close()
            self._path.unlink(missing_ok=True)

    def _watch(self, fd: int) -> None:
        self._selector.register(fd, selectors.EVENT_READ)
        self._pieces[fd] = b""

    def _read(self, fd: int) -> list[tuple[int, bytes]]:
        data = os.read(fd, 65536)
        if not data:
            self._selector.unregister(fd)
            if fd in self._clients:
                self._clients.pop(fd).close()
            else:
                self.ended = True
            return []
        *whole, self._pieces[fd] = (self._pieces[fd] + data).split(b"\n")
        return [(fd, line) for line in whole if line.strip()]


class PtyRig:
    """Brings a rig, a line and the orders together.

    Parameters
    ----------
    stand : the rig and its speed
    control : the orders
    link : lasting name of the port; None for none
    """

    def __init__(self, stand: Stand, control: Control, link: Path | None) -> None:
        self._rig = stand.rig
        self._speed = stand.speed
        self._control = control
        self._link = link
        self._line: PtyLine | None = PtyLine(link)
        self._began = time.monotonic()
        self._made = 0

    @property
    def port(self) -> str:
        """Name of the port now; empty while unplugged."""
        return "" if self._line is None else self._line.name

    def run(self) -> None:
        """Send and obey until told to end."""
        while not self._control.ended:
            for to, line in self._control.lines(_STEP_S):
                if b'"quit"' in line:
                    return
                answer = obey_line(self._rig, line)
                self._plug()
                self._control.answer(to, answer[:-1] + self._where())
            self._send()

    def close(self) -> None:
        """Hang up."""
        if self._line is not None:
            self._line.close()

    def _where(self) -> bytes:
        """End of an answer: the port, and what a computer that does not listen has lost."""
        overrun = 0 if self._line is None else self._line.overrun
        return f', "port": {json.dumps(self.port)}, "overrun": {overrun}}}'.encode()

    def _plug(self) -> None:
        plugged = self._rig.state.plugged
        if not plugged and self._line is not None:
            self._line.close()
            self._line = None
        elif plugged and self._line is None:
            self._line = PtyLine(self._link)

    def _send(self) -> None:
        passed = (time.monotonic() - self._began) * self._speed
        count = math.floor(passed * self._rig.rate_hz) - self._made
        self._made += count
        if self._line is None:
            return
        self._rig.receive(self._line.receive())
        try:
            data = self._rig.produce(count)
        except Unplugged:
            return
        if data and not self._line.heard_at(self._rig.profile.port.bauds[0]):
            data = self._rig.garble(len(data))
        self._line.send(data)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run from the command line."""
    parser = argparse.ArgumentParser(prog="python -m drivers.virtual.pty_rig")
    parser.add_argument("url", help="the rig, e.g. sim://clbacc?seed=3")
    parser.add_argument("--control", type=Path, help="socket for orders; standard input without")
    parser.add_argument("--link", type=Path, help="lasting name of the port")
    options = parser.parse_args(arguments)
    if sys.platform == "win32":
        parser.error("a pseudo-terminal needs Linux or macOS; open the sim:// address instead")
    try:
        stand = stand_of(options.url)
    except ValueError as error:
        parser.error(str(error))
    if math.isinf(stand.speed):
        parser.error("a pseudo-terminal has a speed; speed=max is for sim:// alone")
    control = Control(options.control)
    rig = PtyRig(stand, control, options.link)
    sys.stdout.write(json.dumps({"port": rig.port}) + "\n")
    sys.stdout.flush()
    try:
        rig.run()
    finally:
        rig.close()
        control.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
