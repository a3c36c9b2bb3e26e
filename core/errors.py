"""The errors that a user can cause or meet, and the notes of doubt in a result."""

from dataclasses import dataclass
from enum import Enum
from pathlib import Path


class LabError(Exception):
    """Base of everything that is told to the operator; never raised itself."""


class FormatError(LabError):
    """A file, profile or plan cannot be read.

    Parameters
    ----------
    path : path of the file, or a name for text that came from elsewhere
    why : what is wrong and what was expected
    line, column : 1-based place, 0 where the whole file or line is meant
    """

    def __init__(self, path: Path | str, why: str, *, line: int = 0, column: int = 0) -> None:
        self.path = str(path)
        self.line = line
        self.column = column
        self.why = why
        place = "".join(
            f", {word} {number}" for word, number in (("line", line), ("column", column)) if number
        )
        super().__init__(f"{self.path}{place}: {why}")


class FitError(LabError):
    """The data cannot give the parameters that were asked for."""


class RankDeficient(FitError):
    """The design leaves parameters free.

    Parameters
    ----------
    free : names of the parameters that the data do not determine
    why : what would determine them
    """

    def __init__(self, free: tuple[str, ...], why: str) -> None:
        self.free = free
        super().__init__(f"not determined: {', '.join(free)}; {why}")


class LinkError(LabError):
    """A port cannot be opened, or a link broke.

    Parameters
    ----------
    port : the port as the user typed it
    why : what happened
    remedy : what to do about it
    """

    def __init__(self, port: str, why: str, remedy: str = "") -> None:
        self.port = port
        self.why = why
        self.remedy = remedy
        super().__init__(f"{port}: {why}" + (f" ({remedy})" if remedy else ""))


class StorageError(LabError):
    """Something measured could not be put on disk; what was written before stays readable."""


class Severity(Enum):
    """How much a note matters."""

    INFO = "info"
    WARNING = "warning"
    ERROR = "error"


@dataclass(frozen=True, slots=True)
class Note:
    """One doubt about a result, in words an operator understands.

    Parameters
    ----------
    severity : how much it matters
    subject : short stable identifier, e.g. ``"lack_of_fit"``; tests and translations use it
    text : the full sentence, with numbers and units
    """

    severity: Severity
    subject: str
    text: str
