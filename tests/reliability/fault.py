"""What a fault did."""

import random
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, slots=True)
class Found:
    """Outcome of trials of a fault.

    Parameters
    ----------
    trials : how often it happened
    lost : positions, samples, files or numbers that were promised and are not there, that are
        there twice, or that nobody ever sent
    message : what the program said of it
    """

    trials: int = 0
    lost: int = 0
    message: str = ""

    def __add__(self, other: "Found") -> "Found":
        longer = max(self.message, other.message, key=len)
        return Found(self.trials + other.trials, self.lost + other.lost, longer)


Run = Callable[[Path, random.Random, int], Found]
"""Does a fault so many times in an empty folder."""


@dataclass(frozen=True, slots=True)
class Fault:
    """A row of the table.

    Parameters
    ----------
    title : what happens, in words
    run : does it
    few, many : trials in the tests, and in the long run
    """

    title: str
    run: Run
    few: int
    many: int
