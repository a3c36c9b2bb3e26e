"""Everything that the Allan tab shows."""

from dataclasses import dataclass

from core.arrays import FloatArray
from core.records.noise_study import StudyRequest
from gui.widgets.states import ActionBarState, FindingsState


@dataclass(frozen=True, slots=True)
class RecordRow:
    """One record of the list.

    Parameters
    ----------
    key : by which it is meant
    title, detail : two lines
    colour : number of its curve colour
    shown : whether its curve is drawn
    trouble : why there is no result; empty if there is one or it is being worked at
    """

    key: int
    title: str
    detail: str
    colour: int
    shown: bool
    trouble: str = ""


@dataclass(frozen=True, slots=True)
class ChoiceState:
    """What the operator can decide about the chosen record.

    Parameters
    ----------
    request : as decided
    channels : names of the channels
    channel : the one that is analysed
    rate : of the file, Hz; 0 while unknown
    unit : of the samples as they are analysed
    factor : scale factor by which they are divided
    live : the record is the running device, which tells its own rate and is not regressed
    """

    request: StudyRequest
    channels: tuple[str, ...]
    channel: str
    rate: float
    unit: str
    factor: float
    live: bool


@dataclass(frozen=True, slots=True, eq=False)
class CurveState:
    """One curve of the plot; one `aside`, such as that before a regression, is drawn dashed."""

    name: str
    colour: int
    taus: FloatArray
    deviation: FloatArray
    lower: FloatArray
    upper: FloatArray
    edf: FloatArray
    aside: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class LineState:
    """A fitted term, or the whole model, with the words at its end."""

    words: str
    taus: FloatArray
    values: FloatArray
    whole: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class PictureState:
    """The plot.

    Parameters
    ----------
    unit : of the chosen curve, as it is printed
    curves : those of the records that are shown; the chosen record's stands last
    lines : fitted terms of the chosen record
    mixed : other units that stand in the same plot
    """

    unit: str
    curves: tuple[CurveState, ...]
    lines: tuple[LineState, ...]
    mixed: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class AllanState:
    """The tab.

    Parameters
    ----------
    rows : the list
    current : key of the chosen record; 0 for none
    choices : about the chosen record; None without one
    picture : the plot; None while there is nothing to draw
    findings : None while nothing was found
    actions : the row of buttons
    hint : what to do while the plot is empty
    band, terms : whether confidence bands and fitted terms are drawn
    """

    rows: tuple[RecordRow, ...]
    current: int
    choices: ChoiceState | None
    picture: PictureState | None
    findings: FindingsState | None
    actions: ActionBarState
    hint: str
    band: bool
    terms: bool
