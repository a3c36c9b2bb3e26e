"""What ``calrig fit`` has read and found so far."""

from dataclasses import dataclass, field
from pathlib import Path

from core.errors import Note
from core.fit.estimate import Estimate
from core.procedures.calibration import Calibration
from core.procedures.rate_table import RateTable
from core.samples.run import Conditions, Run


@dataclass(slots=True)
class Fitted:
    """The state of one call of the command.

    Parameters
    ----------
    full_scale_dps, same_unit : choices of the user
    path, run, conditions : the file at hand
    calibration : of accelerometers, by the last file of positions
    rates : the last table run with what was found from it
    data, lines : the answer so far
    """

    full_scale_dps: float | None
    same_unit: bool
    path: Path = Path()
    measured: Run | None = None
    conditions: Conditions = field(default_factory=Conditions)
    calibration: Calibration | None = None
    rates: tuple[Run, RateTable] | None = None
    data: list[dict[str, object]] = field(default_factory=list[dict[str, object]])
    lines: list[str] = field(default_factory=list[str])

    def take(self, path: Path, measured: Run, conditions: Conditions) -> None:
        """Turn to the next file."""
        self.path, self.measured, self.conditions = path, measured, conditions

    @property
    def run(self) -> Run:
        """The run at hand."""
        if self.measured is None:
            raise RuntimeError("no file was taken")
        return self.measured

    def say(self, *lines: str) -> None:
        """Add lines to the answer."""
        self.lines.extend(lines)

    def give(self, **data: object) -> None:
        """Add the result of the file at hand."""
        self.data.append({"file": self.path, **data})


def estimate_text(symbol: str, found: Estimate) -> str:
    """One number with its expanded uncertainty."""
    return f"{symbol:<8} {found.value:>14.8g} +- {found.expanded():.2g} {found.unit}  (95 %)"


def note_lines(notes: tuple[Note, ...], indent: str) -> list[str]:
    """Notes as lines."""
    return [f"{indent}{note.severity.value}: {note.text}" for note in notes]
