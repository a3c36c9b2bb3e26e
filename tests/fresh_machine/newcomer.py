"""Be the newcomer of the README in a real window: mouse and keyboard, from start to certificate.

    .venv/bin/python tests/fresh_machine/newcomer.py [--folder FOLDER] [--program COMMAND]

A screen of its own is opened (Xvfb, with the window manager openbox), and on it the program as the
README says, in an empty home. What stands there is read as a screen reader reads it, so that each
widget must have its name; keys and clicks are those of an operator. A picture of each step stands
in the folder. The exit code is 1 if a step was missed, something was printed that should not be, or
something was left behind. It takes about six minutes, most of them spent measuring, and needs
Debian's packages xvfb xdotool openbox imagemagick dbus at-spi2-core python3-gi gir1.2-atspi-2.0.
"""

import argparse
import json
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

import numpy as np  # noqa: E402

from tests.drivers.teach.layouts import invented  # noqa: E402
from tests.fresh_machine.screen import NotSeenError, Screen, end, missing_packages  # noqa: E402
from tests.gui.frames.board import Board  # noqa: E402

PROGRAM = "python3 bootstrap.py run"
HARMLESS = (
    # Qt says so to every screen reader.
    "does not implement",
    "bootstrap: ",
)
_CYRILLIC = re.compile("[а-яіїєґ]{3}", re.IGNORECASE)
_LANGUAGE, _ENGLISH, _UKRAINIAN = 5, 1, 2
"""Places in the menu, and in the list of languages behind the one of the system."""
_BOARD = 3
"""Seed of the invented board: header, counter, numbers, CRC."""


@dataclass(frozen=True, slots=True)
class Done:
    """A step that was taken."""

    name: str
    seconds: float
    missed: str = ""

    def line(self) -> str:
        """As the table shows it."""
        return f"{self.name:<58} {self.seconds:6.1f} s  {self.missed or 'ok'}"


def complaints(log: str) -> list[str]:
    """Return the lines of a log that a program without faults would not have written."""
    lines = (line.strip() for line in log.splitlines())
    return [line for line in lines if line and not any(words in line for words in HARMLESS)]


def leftovers(home: Path) -> list[str]:
    """Return what no program may leave behind; a lock that nobody holds is empty and may stay."""
    names = ("*.tmp", "*.part", "*.db-wal", "core", "core.*", "*.lock")
    found = (path for name in names for path in home.rglob(name) if path.is_file())
    held = (path for path in found if path.suffix != ".lock" or path.stat().st_size)
    return sorted(str(path.relative_to(home)) for path in held)


class Newcomer:
    """Walks through the README.

    Parameters
    ----------
    screen : with nothing on it
    program : command that starts the program, with ROOT as its folder
    """

    def __init__(self, screen: Screen, program: list[str]) -> None:
        self.screen = screen
        self.data = screen.home / "CalRig"
        self._program = program
        self._log = screen.folder / "program.log"
        self._read = 0
        self.process: subprocess.Popen[bytes] | None = None
        self.done: list[Done] = []

    @property
    def missed(self) -> bool:
        """Whether a step went wrong."""
        return any(step.missed for step in self.done)

    def walk(self) -> None:
        """Take all steps; one that cannot be taken ends the walk."""
        for step in (
            self.start,
            self.take_the_tour,
            self.measure_one_position,
            self.refuse_a_wrong_position,
            self.measure_hands_free,
            self.look_from_three_metres,
            self.process_and_export,
            self.find_it_in_the_archive,
            self.issue_a_certificate,
            self.teach_a_board,
            self.speak_ukrainian,
            self.close,
            self.start_again,
            self.lose_power,
            self.go_on_after_it,
            self.close,
        ):
            if not self._take(step):
                break
        if self.process is not None and self.process.poll() is None:
            end(self.process, signal.SIGKILL, 10)
        self.done.append(Done("nothing is left behind", 0.0, ", ".join(leftovers(self.data))))

    def _take(self, step: Callable[[], None]) -> bool:
        name = (step.__doc__ or "").splitlines()[0].rstrip(".")
        began = time.monotonic()
        missed = ""
        try:
            step()
        except (NotSeenError, subprocess.SubprocessError) as error:
            missed = f"MISSED: {error}"
        self.screen.picture(step.__name__)
        new = self._log.read_text("utf-8", errors="replace")[self._read :]
        self._read += len(new)
        said = complaints(new)
        if said:
            missed = f"{missed} PRINTED: {said[-1]} ({len(said)} lines)".strip()
        self.done.append(Done(name, time.monotonic() - began, missed))
        print(self.done[-1].line(), flush=True)
        return not missed.startswith("MISSED")

    def _hold(self, held: Callable[[], bool], what: str, within_s: float = 20.0) -> None:
        until = time.monotonic() + within_s
        while not held():
            if time.monotonic() > until:
                raise NotSeenError(what)
            time.sleep(0.2)

    def _sessions(self) -> list[Path]:
        return sorted(path.parent for path in self.data.rglob("positions.jsonl"))

    def _accepted(self, session: Path) -> int:
        lines = (session / "positions.jsonl").read_text("utf-8").splitlines()
        kinds = [json.loads(line) for line in lines if line.endswith("}")]
        return sum("mean" in json.dumps(kind) for kind in kinds)

    # --- the steps, each named by its first line --------------------------------------------------

    def start(self) -> None:
        """The window opens on the simulated rig."""
        with self._log.open("ab") as log:
            self.process = self.screen.start(self._program, log, ROOT)
        self.screen.see("*streaming*", within_s=90)

    def take_the_tour(self) -> None:
        """The tour is offered, and walked by Enter."""
        screen = self.screen
        screen.click("Start the tour")
        for number in range(1, 9):
            screen.see(f"{number} of 8", "label")
            screen.key("Return")
        screen.gone("8 of 8", "label")

    def measure_one_position(self) -> None:
        """Space measures the first position."""
        self.screen.key("space")
        self.screen.see("*Rotation Around X axis, X from ODH, 1 * done*", "list item")

    def refuse_a_wrong_position(self) -> None:
        """The head stands where it stood: the program says so and records nothing."""
        self.screen.key("space")
        self.screen.see("*looks like position 1 *", "label")
        self.screen.picture("wrong_position")
        self.screen.click("Close this message")

    def measure_hands_free(self) -> None:
        """Hands-free and the rig's own operator measure the rest."""
        screen = self.screen
        screen.click("Operator turns it for me")
        screen.click("Hands-free")
        screen.see("All positions done", within_s=400)

    def look_from_three_metres(self) -> None:
        """F11 gives the screen to the step, Esc takes it back."""
        screen = self.screen
        screen.key("F11")
        self._hold(self._is_large, "the verdict over the whole screen")
        screen.picture("distance")
        screen.key("Escape")
        self._hold(lambda: not self._is_large(), "the window behind it")

    def _is_large(self) -> bool:
        width = int(self.screen.size.partition("x")[0])
        seen = self.screen.look()
        return any(one.name == "All positions done" and one.width == width for one in seen)

    def process_and_export(self) -> None:
        """Process Data shows results, Export writes them."""
        screen = self.screen
        screen.key("F5")
        screen.see("Certificate", "push button")
        screen.key("ctrl+e")
        screen.see("Exported", "label")
        self._hold(lambda: bool(list(self.data.rglob("*.cal.json"))), "no calibration on the disk")

    def find_it_in_the_archive(self) -> None:
        """The archive finds it by its serial number."""
        screen = self.screen
        screen.key("ctrl+0")
        screen.see("Search the archive")
        screen.key("ctrl+f")
        screen.type("pw09")
        screen.click("calibration", "table cell")
        screen.see("Parameters, U for 95 %", "label")

    def issue_a_certificate(self) -> None:
        """Its certificate is filled in and issued as PDF."""
        screen = self.screen
        screen.click("Certificate", "push button")
        screen.see("*Draft No. *")
        screen.put("Customer", "Newcomer Ltd, 1 First Street", "text")
        screen.put("Item", "attitude unit", "text")
        screen.picture("draft")
        screen.key("ctrl+Return")
        screen.click("Issue all the same")
        screen.see("*is issued*", "label")
        papers = list(self.data.rglob("certificate_*.pdf"))
        if len(papers) != 1 or not papers[0].read_bytes().startswith(b"%PDF"):
            raise NotSeenError(f"one certificate as PDF, but {papers}")

    def teach_a_board(self) -> None:
        """A board that nobody has seen is taught and streams."""
        screen = self.screen
        board = Board(invented(np.random.default_rng(_BOARD), checked=True))
        try:
            screen.click("Teach a board", "page tab")
            label = screen.see("Port", "label")
            screen.click_at(label.x + label.width + 60, label.middle[1])
            screen.key("ctrl+a")
            screen.type(board.port)
            screen.key("Tab")
            screen.click("Listen", "push button")
            screen.see("Stop listening", "push button")
            screen.gone("Nothing is described yet", "label", within_s=30)
            screen.picture("found")
            screen.put("Device name", "Invented board", "text")
            screen.click("Save and connect", "push button")
            screen.see("*Invented board*streaming*", within_s=20)
            if not list((self.data / "devices").glob("*.toml")):
                raise NotSeenError("no device file")
            screen.click("Live", "page tab")
            time.sleep(2)
            screen.picture("live")
        finally:
            board.close()

    def speak_ukrainian(self) -> None:
        """The menu switches to Ukrainian at once."""
        self.screen.key("ctrl+1")
        self._choose_language(_UKRAINIAN)
        self._hold(lambda: self._cyrillic(10), "tabs in Ukrainian")

    def _choose_language(self, place: int) -> None:
        """Walk through the menu by keys: screen readers see menus by their focus alone."""
        self.screen.key("F10", *["Down"] * _LANGUAGE, "Right", *["Down"] * place, "Return")

    def _cyrillic(self, tabs: int) -> bool:
        names = [one.name for one in self.screen.look() if one.role == "page tab"]
        return sum(bool(_CYRILLIC.search(name)) for name in names) >= tabs

    def close(self) -> None:
        """The window is closed, and nothing runs on."""
        self.screen.key("alt+F4")
        assert self.process is not None
        try:
            code = self.process.wait(20)
        except subprocess.TimeoutExpired as error:
            raise NotSeenError("the program did not end") from error
        if code:
            raise NotSeenError(f"it ended with code {code}")
        running = subprocess.run(
            ["ps", "-o", "args=", "--sid", str(self.process.pid)],
            capture_output=True,
            text=True,
            check=False,
        ).stdout.strip()
        if running:
            raise NotSeenError(f"nothing running, but {running}")

    def start_again(self) -> None:
        """It starts again in Ukrainian, and switches back."""
        self.start_quietly()
        self._hold(lambda: self._cyrillic(10), "tabs in Ukrainian", 60)
        self.screen.picture("ukrainian_start")
        self._choose_language(_ENGLISH)
        self.screen.see("Dividing head", "page tab")

    def start_quietly(self) -> None:
        """Start the program without waiting for words."""
        with self._log.open("ab") as log:
            self.process = self.screen.start(self._program, log, ROOT)

    def lose_power(self) -> None:
        """kill -9 in the middle of the second position."""
        screen, before = self.screen, self._sessions()
        screen.click("Operator turns it for me")
        screen.click("Hands-free")
        self._hold(lambda: self._sessions() != before, "a new session", 60)
        session = next(one for one in self._sessions() if one not in before)
        self._hold(lambda: self._accepted(session) >= 1, "a position on the disk", 60)
        screen.see("Measuring", within_s=60)
        assert self.process is not None
        end(self.process, signal.SIGKILL, 10)

    def go_on_after_it(self) -> None:
        """The next start offers to continue, and continues at the next position."""
        self.start()
        self.screen.click("*Continue it*")
        self.screen.see("*Rotation Around X axis, X from ODH, 1 * done*", "list item")


def main() -> int:
    """Walk; return the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--folder", type=Path, help="for pictures and logs, which are then kept")
    parser.add_argument("--program", default=PROGRAM, help="command that opens the window")
    parser.add_argument("--size", default="1280x800", help="of the screen")
    options = parser.parse_args()
    missing = missing_packages()
    if missing:
        sys.exit(f"apt-get install --no-install-recommends {' '.join(missing)}")
    with tempfile.TemporaryDirectory() as temporary:
        folder = (options.folder or Path(temporary)).resolve()
        home = folder / "home"
        home.mkdir(parents=True)
        with Screen(folder, home, options.size) as screen:
            newcomer = Newcomer(screen, shlex.split(options.program))
            newcomer.walk()
    print(newcomer.done[-1].line())
    print(f"{sum(not step.missed for step in newcomer.done)} of {len(newcomer.done)} steps")
    return int(newcomer.missed)


if __name__ == "__main__":
    raise SystemExit(main())
