"""The results page of any test, as plain data."""

from dataclasses import dataclass, field

from core.errors import Note
from gui.widgets.states import MatrixState, ResidualState, TableState


@dataclass(frozen=True, slots=True, eq=False)
class CurveState:
    """Points with error bars over a quantity that was set.

    Parameters
    ----------
    title : over the plot
    x_label, y_label : with units
    series : name, x, y, half width of the 95 % interval (empty for none) of each
    joined : whether the points are joined by lines
    """

    title: str
    x_label: str
    y_label: str
    series: tuple[
        tuple[str, tuple[float, ...], tuple[float, ...], tuple[float, ...]],
        ...,
    ]
    joined: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class LogCurveState:
    """Points with their limits over a quantity, both axes logarithmic, and lines of a model.

    Parameters
    ----------
    title : over the plot
    x_label, y_label : with units
    x, y, low, high : points and the limits of their intervals
    lines : name, x, y of each
    """

    title: str
    x_label: str
    y_label: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    lines: tuple[tuple[str, tuple[float, ...], tuple[float, ...]], ...] = ()


Part = TableState | tuple[MatrixState, ...] | ResidualState | CurveState | LogCurveState | Note
"""What can stand on the page: a table, matrices in one row, a plot, a doubt."""


@dataclass(frozen=True, slots=True, eq=False)
class ResultsPage:
    """The results page.

    Parameters
    ----------
    title : device and number of rows
    source : session or file
    parts : in the order of reading
    effects : names of what was added to the plain model, each with its output
    """

    title: str
    source: str
    parts: tuple[Part, ...]
    effects: tuple[str, ...] = field(default=(), kw_only=True)

    @property
    def notes(self) -> tuple[Note, ...]:
        """Every doubt."""
        return tuple(part for part in self.parts if isinstance(part, Note))

    @property
    def tables(self) -> tuple[TableState, ...]:
        """Every table."""
        return tuple(part for part in self.parts if isinstance(part, TableState))
