"""What the page of the comparison shows."""

from dataclasses import dataclass

from gui.widgets.states import FindingsState


@dataclass(frozen=True, slots=True)
class SourceRow:
    """One gyro of one file.

    Parameters
    ----------
    key : by which it is meant
    name : heading of its column; rows of the same name share one
    source : file
    tells : what it tells, in words
    """

    key: int
    name: str
    source: str
    tells: str


@dataclass(frozen=True, slots=True)
class ComparisonState:
    """The page.

    Parameters
    ----------
    rows : the sources
    findings : the table; None while there is none
    hint : what to do while there is none
    busy : whether files are being read
    """

    rows: tuple[SourceRow, ...]
    findings: FindingsState | None
    hint: str
    busy: bool
