"""Everything that the Archive tab shows."""

from dataclasses import dataclass

from core.arrays import FloatArray, IntArray
from gui.widgets.states import ActionBarState, FindingsState, Tone


@dataclass(frozen=True, slots=True)
class ListRow:
    """One entry of the list.

    Parameters
    ----------
    id : its number
    cells : serial number, kind, moment, verdict, temperature, operator, plan or procedure
    tone : of its verdict
    """

    id: int
    cells: tuple[str, ...]
    tone: Tone = Tone.IDLE


@dataclass(frozen=True, slots=True, eq=False)
class HistoryState:
    """A parameter over time.

    Parameters
    ----------
    title, unit : of the parameter
    seconds : (n,) moments since the epoch
    values, expanded : (n,) values and half widths of their 95 % intervals; NaN where unknown
    counted : (n,) 1 where the value is in the statistics
    chosen : (m,) places of the values of the entries that are chosen in the list
    mean, spread : of those that count; NaN where there is none
    low, high : limits; infinite where there is none
    """

    title: str
    unit: str
    seconds: FloatArray
    values: FloatArray
    expanded: FloatArray
    counted: IntArray
    chosen: IntArray
    mean: float
    spread: float
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class ArchiveState:
    """The tab.

    Parameters
    ----------
    text, kind : what is looked for; kind empty for all
    rows : what was found
    status : how much was found, or what is being done
    chosen : numbers of the chosen entries
    parameters : names of those that can be followed
    parameter : place of the one that is followed; -1 for none
    temperatures : in words, at which it can be followed; the first stands for all
    temperature : place of the one that is chosen
    history : its picture; None while there is none
    findings : the right-hand side; None while nothing is chosen
    actions : the row below
    hint : in place of the picture
    """

    text: str
    kind: str
    rows: tuple[ListRow, ...]
    status: str
    chosen: tuple[int, ...]
    parameters: tuple[str, ...]
    parameter: int
    temperatures: tuple[str, ...]
    temperature: int
    history: HistoryState | None
    findings: FindingsState | None
    actions: ActionBarState
    hint: str
