"""Victims started, killed, stopped and waited for by the tests."""

import atexit
import functools
import json
import os
import random
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from tests.reliability.victims import promised

ROOT = Path(__file__).resolve().parents[2]
_PATIENCE_S = 30.0


@dataclass(frozen=True, slots=True)
class Victim:
    """A process that measures.

    Parameters
    ----------
    nursery : whose child it is
    pid : its number
    promises : file of what it has been promised
    """

    nursery: "Nursery"
    pid: int
    promises: Path

    def told(self) -> list[str]:
        """What it has been promised so far."""
        return promised(self.promises)

    def wait_for(self, count: int) -> None:
        """Wait until so much has been promised."""
        until = time.monotonic() + _PATIENCE_S
        while len(self.told()) < count:
            assert time.monotonic() < until, f"only {self.told()} was promised"
            time.sleep(0.002)

    def signal(self, number: int) -> None:
        """Send a signal to it."""
        os.kill(self.pid, number)

    def kill(self, rng: random.Random, most_s: float) -> list[str]:
        """Kill it at a random moment; return what it had been promised by then."""
        time.sleep(rng.uniform(0.0, most_s))
        self.signal(signal.SIGKILL)
        self.wait()
        return self.told()

    def wait(self) -> None:
        """Wait until it has ended."""
        self.nursery.ask({"wait": self.pid})


class Nursery:
    """The process whose children the victims are."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.reliability.victims"],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._orders, self._answers = self._process.stdin, self._process.stdout
        assert self._answers.readline() == "ready\n"
        self._count = 0

    def ask(self, order: dict[str, object]) -> int:
        """Give an order; return the answer."""
        self._orders.write(json.dumps(order) + "\n")
        self._orders.flush()
        return int(self._answers.readline())

    def start(self, victim: str, folder: Path, promises: Path) -> Victim:
        """Begin a victim in a folder."""
        order: dict[str, object] = {"victim": victim, "folder": str(folder)}
        return Victim(self, self.ask({**order, "promises": str(promises)}), promises)

    def close(self) -> None:
        """End it, and its children with it."""
        self._orders.close()
        self._process.wait()
        self._answers.close()


@functools.cache
def nursery() -> Nursery:
    """The one that serves until the end of the program: it takes seconds to load everything."""
    made = Nursery()
    atexit.register(made.close)
    return made
