"""Curves of a plot and their names."""

from dataclasses import dataclass

from core.arrays import FloatArray
from gui.widgets.legend import DASHES, LINE, LegendEntry


@dataclass(frozen=True, slots=True, eq=False)
class LineState:
    """One curve; `colour` numbers the colours of the look."""

    x: FloatArray
    y: FloatArray
    colour: int
    name: str = ""
    dashed: bool = False

    @property
    def legend(self) -> LegendEntry:
        """How it is named above the plot."""
        return LegendEntry(self.name, self.colour, DASHES if self.dashed else LINE)
