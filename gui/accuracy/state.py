"""The graph and the verdicts of an accuracy check, as plain data."""

from dataclasses import dataclass

from gui.widgets.states import Tone

PAGES = ("error", "cross", "heading", "current", "temperature")
"""Pages of the graph, in the order of the tabs over it."""


@dataclass(frozen=True, slots=True)
class Series:
    """One trace of the graph.

    Parameters
    ----------
    name : in the legend
    colour : number of its curve colour
    x, y : (n,) set angle and value; NaN where there is none
    u95 : (n,) half width of the 95 % interval of each value; empty where unknown
    """

    name: str
    colour: int
    x: tuple[float, ...]
    y: tuple[float, ...]
    u95: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class GraphState:
    """One page of the graph.

    Parameters
    ----------
    title : of the values, with their unit
    unit : of the values
    series : the traces that are shown
    low, high : range of set angles, deg
    limit : largest allowed value, drawn on both sides; 0 for none
    level : value now, drawn as a line; NaN for none
    hint : what to say while there is nothing to draw
    """

    title: str = ""
    unit: str = ""
    series: tuple[Series, ...] = ()
    low: float = 0.0
    high: float = 360.0
    limit: float = 0.0
    level: float = float("nan")
    hint: str = ""


@dataclass(frozen=True, slots=True)
class Chip:
    """The verdict on one trace, or that there is none.

    Parameters
    ----------
    name : of the trace
    verdict : "PASS", "FAIL", "UNDECIDED"; empty without a limit
    tone : colour and sign
    why : the row that decides
    """

    name: str
    verdict: str
    tone: Tone
    why: str


@dataclass(frozen=True, slots=True)
class TraceToggle:
    """A trace that can be shown or hidden."""

    key: str
    name: str
    colour: int
    shown: bool
