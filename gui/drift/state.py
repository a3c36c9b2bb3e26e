"""Everything that the Drift tab shows."""

from dataclasses import dataclass

from core.arrays import FloatArray
from gui.analysis.curves import LineState
from gui.widgets.records_page import RecordsState

ALL = -1
"""Shown temperature: all of them."""


@dataclass(frozen=True, slots=True)
class Settings:
    """What the operator decides about the table.

    Parameters
    ----------
    start_s, stop_s : the mean over this time is brought to zero
    block_s : length of a block
    horizon_s : how long the compensation works; 0 for the length of the records
    limit : most knots, tp
    memory : most bytes; 0 for no limit but tp
    knots : how many; 0 for as many as held-out turn-ons ask for
    channel : name or number of the output; empty for the likeliest
    rate : samples per second; 0 for that of the file
    scale_factor : output for 1 deg/s; 0 for that of the file
    """

    start_s: float = 1.5
    stop_s: float = 2.0
    block_s: float = 1.0
    horizon_s: float = 0.0
    limit: int = 16
    memory: int = 0
    knots: int = 0
    channel: str = ""
    rate: float = 0.0
    scale_factor: float = 0.0


@dataclass(frozen=True, slots=True)
class ChoiceState:
    """What can be decided now.

    Parameters
    ----------
    settings : as decided
    ambient_c : chamber temperature of the chosen record; NaN where the chip's is taken
    has_file : a record is chosen whose temperature can be stated
    """

    settings: Settings
    ambient_c: float
    has_file: bool


@dataclass(frozen=True, slots=True, eq=False)
class KnotsState:
    """The table over the plot; alone it is renewed while a knot is dragged.

    Parameters
    ----------
    times_s : (p,) knots; the first and the last stand still
    values : (m, p) of the temperatures that are shown, in the plot's unit
    reading : cost and bytes, in words
    """

    times_s: FloatArray
    values: FloatArray
    reading: str


@dataclass(frozen=True, slots=True, eq=False)
class PictureState:
    """The plots.

    Parameters
    ----------
    unit : of what is drawn
    turn_ons, means : upper plot
    left : lower plot, what each method leaves on held-out turn-ons; empty without repetitions
    """

    unit: str
    turn_ons: tuple[LineState, ...]
    means: tuple[LineState, ...]
    left: tuple[LineState, ...]


@dataclass(frozen=True, slots=True, eq=False)
class DriftState:
    """The tab.

    Parameters
    ----------
    page : list, hint, findings, actions
    choices : settings
    temperatures : what can be shown, in words; the first are all together
    shown : which of them, `ALL` or a place
    picture, knots : None while there is nothing to draw
    snap : whether dragged knots stop at the blocks
    """

    page: RecordsState
    choices: ChoiceState
    temperatures: tuple[str, ...]
    shown: int
    picture: PictureState | None
    knots: KnotsState | None
    snap: bool
