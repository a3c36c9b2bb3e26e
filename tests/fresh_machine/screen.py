"""A screen of its own with a window manager: a program on it, read and driven as a person would.

What stands there is read from the accessibility bus, so a widget is found by the words that a
screen reader says; keys and clicks are sent by xdotool to the X server.
"""

import json
import os
import select
import shutil
import signal
import subprocess
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path
from typing import IO

NEEDED = {
    "Xvfb": "xvfb",
    "xdotool": "xdotool",
    "openbox": "openbox",
    "import": "imagemagick",
    "dbus-daemon": "dbus",
    "/usr/libexec/at-spi-bus-launcher": "at-spi2-core",
    "/usr/lib/python3/dist-packages/gi": "python3-gi",
    "/usr/lib/x86_64-linux-gnu/girepository-1.0/Atspi-2.0.typelib": "gir1.2-atspi-2.0",
}
"""What is needed beside the program: a command or a path, and the Debian package that has it."""
EYES = Path(__file__).with_name("eyes.py")
_LOOKS, _LOOK_S = 3, 60.0
DEBIANS_PYTHON = "/usr/bin/python3"


class NotSeenError(Exception):
    """What a step waited for never stood on the screen."""


@dataclass(frozen=True, slots=True)
class Seen:
    """Something on the screen.

    Parameters
    ----------
    role, name : as a screen reader says them
    x, y, width, height : in pixels of the screen
    states : of FOCUSED, CHECKED, ENABLED, SELECTED
    text : what a field holds
    """

    role: str
    name: str
    x: int
    y: int
    width: int
    height: int
    states: frozenset[str] = frozenset()
    text: str = ""

    @property
    def middle(self) -> tuple[int, int]:
        """Where one clicks."""
        return self.x + self.width // 2, self.y + self.height // 2


def missing_packages(exists: Callable[[str], bool] | None = None) -> list[str]:
    """Debian packages that are not here."""
    here = exists or (lambda name: Path(name).exists() or shutil.which(name) is not None)
    return [package for name, package in NEEDED.items() if not here(name)]


class Screen:
    """An X server without a monitor, a window manager, a session bus; a context manager.

    Parameters
    ----------
    folder : for logs and pictures
    home : of the program that is started
    size : of the screen, px
    """

    def __init__(self, folder: Path, home: Path, size: str = "1280x800") -> None:
        self.folder, self.home, self.size = folder, home, size
        self._started: list[subprocess.Popen[bytes]] = []
        self.pictures = 0
        self.patience_s = 30.0

    def __enter__(self) -> "Screen":
        read, write = os.pipe()
        self._begin(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{self.size}x24"], pass_fds=(write,)
        )
        os.close(write)
        with os.fdopen(read) as pipe:
            self.display = f":{pipe.readline().strip()}"
        self._begin(["openbox"])
        bus = self._begin(["dbus-daemon", "--session", "--nofork", "--print-address=1"], piped=True)
        address = bus.stdout.readline().decode().strip() if bus.stdout is not None else ""
        self._bus = {"DBUS_SESSION_BUS_ADDRESS": address}
        self._eyes = self._begin([DEBIANS_PYTHON, str(EYES)], piped=True)
        return self

    def __exit__(self, *_: object) -> None:
        for process in reversed(self._started):
            if process.poll() is None:
                process.terminate()
                try:
                    process.wait(5)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
            for pipe in (process.stdin, process.stdout):
                if pipe is not None:
                    pipe.close()

    def environ(self) -> dict[str, str]:
        """The variables of somebody who has just logged in at this screen."""
        kept = ("PATH", "LD_LIBRARY_PATH", "PYENV_ROOT")
        return {
            **{name: os.environ[name] for name in kept if name in os.environ},
            "HOME": str(self.home),
            "LANG": "C.UTF-8",
            "DISPLAY": getattr(self, "display", ""),
            "QT_QPA_PLATFORM": "xcb",
            "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1",
            "PYTHONFAULTHANDLER": "1",
            **getattr(self, "_bus", {}),
        }

    def _begin(
        self, command: Sequence[str], *, piped: bool = False, pass_fds: Sequence[int] = ()
    ) -> "subprocess.Popen[bytes]":
        with (self.folder / f"{Path(command[0]).name}.log").open("ab") as log:
            process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE if piped else subprocess.DEVNULL,
                stdout=subprocess.PIPE if piped else log,
                stderr=log,
                env=self.environ(),
                pass_fds=pass_fds,
            )
        self._started.append(process)
        return process

    def start(
        self, command: Sequence[str], log: IO[bytes], where: Path
    ) -> "subprocess.Popen[bytes]":
        """Start a program of a session of its own on this screen."""
        return subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            cwd=where,
            env=self.environ(),
            start_new_session=True,
        )

    # --- eyes -------------------------------------------------------------------------------------

    def look(self) -> list[Seen]:
        """Return everything that the program shows now."""
        for _ in range(_LOOKS):
            inward, outward = self._eyes.stdin, self._eyes.stdout
            assert inward is not None
            assert outward is not None
            inward.write(b"CalRig\n")
            inward.flush()
            if select.select([outward], [], [], _LOOK_S)[0]:
                found = json.loads(outward.readline())
                return [Seen(*one[:6], frozenset(one[6]), one[7]) for one in found]
            # The bus has lost an answer, and libatspi waits for it for ever.
            self._eyes.kill()
            self._eyes = self._begin([DEBIANS_PYTHON, str(EYES)], piped=True)
        raise NotSeenError("answers on the accessibility bus")

    def find(self, name: str, role: str = "") -> Seen | None:
        """Return what has this name; of a pattern such as ``*part*`` the shortest that fits."""
        matching = [
            one
            for one in self.look()
            if one.width > 0 and (not role or one.role == role) and _fits(name, one.name)
        ]
        return min(matching, key=lambda one: len(one.name), default=None)

    def see(self, name: str, role: str = "", within_s: float | None = None) -> Seen:
        """Wait until something of this name stands on the screen."""
        until = time.monotonic() + (self.patience_s if within_s is None else within_s)
        while True:
            found = self.find(name, role)
            if found is not None:
                return found
            if time.monotonic() > until:
                raise NotSeenError(f"{role or 'nothing'} {name!r} on the screen")
            time.sleep(0.2)

    def gone(self, name: str, role: str = "", within_s: float = 10.0) -> None:
        """Wait until nothing of this name stands there."""
        until = time.monotonic() + within_s
        while self.find(name, role) is not None:
            if time.monotonic() > until:
                raise NotSeenError(f"{name!r} is still on the screen")
            time.sleep(0.2)

    def picture(self, name: str) -> Path:
        """Keep what the screen shows."""
        self.pictures += 1
        path = self.folder / f"{self.pictures:02d}-{name}.png"
        self._do("import", "-window", "root", str(path))
        return path

    # --- hands ------------------------------------------------------------------------------------

    def key(self, *keys: str) -> None:
        """Press keys, e.g. ``"ctrl+0"``."""
        for key in keys:
            self._do("xdotool", "key", "--clearmodifiers", key)

    def type(self, text: str) -> None:
        """Type a text."""
        self._do("xdotool", "type", "--delay", "15", text)

    def click(self, name: str, role: str = "") -> Seen:
        """Wait for something and click at its middle."""
        found = self.see(name, role)
        self.click_at(*found.middle)
        return found

    def click_at(self, x: int, y: int) -> None:
        """Click at a place of the screen."""
        self._do("xdotool", "mousemove", "--sync", str(x), str(y), "click", "1")

    def drag(self, begin: tuple[int, int], end: tuple[int, int]) -> None:
        """Drag with the left button, by a way a hand would take."""
        self._do("xdotool", "mousemove", str(begin[0]), str(begin[1]), "mousedown", "1")
        for share in range(1, 9):
            x = begin[0] + (end[0] - begin[0]) * share // 8
            y = begin[1] + (end[1] - begin[1]) * share // 8
            self._do("xdotool", "mousemove", str(x), str(y), "sleep", "0.03")
        self._do("xdotool", "mouseup", "1")

    def put(self, name: str, text: str, role: str = "") -> None:
        """Click into a field and write another text into it."""
        self.click(name, role)
        self.key("ctrl+a")
        self.type(text)
        self.key("Tab")

    def _do(self, *command: str) -> None:
        subprocess.run(
            command, env=self.environ(), check=True, timeout=30, stdout=subprocess.DEVNULL
        )


def _fits(wanted: str, name: str) -> bool:
    return fnmatchcase(name, wanted) if "*" in wanted else wanted == name


def end(process: "subprocess.Popen[bytes]", how: signal.Signals, within_s: float) -> int:
    """Send a signal to a program and its children; return its exit code."""
    os.killpg(process.pid, how)
    return process.wait(within_s)
