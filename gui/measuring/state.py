"""Everything that a measuring tab shows."""

from dataclasses import dataclass, field
from typing import Generic, TypeVar

from gui.measuring.settings import MeasuringSettings
from gui.widgets.states import ActionBarState, StageState, StepState

S = TypeVar("S", bound=MeasuringSettings)


@dataclass(frozen=True, slots=True)
class Locked:
    """Which settings cannot be changed now, and why.

    Parameters
    ----------
    plan : why not the plan, the base, the tilter: they belong to the session; empty if they can
    timing : why not the times; empty if they can
    """

    plan: str = ""
    timing: str = ""


@dataclass(frozen=True, slots=True)
class MeasuringState(Generic[S]):
    """The tab.

    Parameters
    ----------
    layout : of the device
    sensors : how many rows the live table has
    test : of the plan
    lists : accessible name of the list of steps
    settings : as the operator set them
    locked : which of them cannot be changed
    plans : identifiers and titles of the plans
    temperatures : of the thermal cycle; empty where the plan has none and the layout shows none
    steps : the plan
    stage : the large line
    actions : the row of buttons
    session : name of the session's folder, or of the one to come
    session_editable : whether the name can still be changed
    folder : where the session stands, empty before it exists
    has_samples : whether there is anything to draw in the graph
    has_results : whether there is something to show beside the stage
    """

    layout: str
    sensors: int
    test: str
    lists: str
    settings: S
    locked: Locked
    plans: tuple[tuple[str, str], ...]
    temperatures: tuple[float, ...]
    steps: tuple[StepState, ...]
    stage: StageState
    actions: ActionBarState
    session: str
    session_editable: bool
    folder: str
    has_samples: bool
    has_results: bool


@dataclass(frozen=True, slots=True)
class LiveRow:
    """One sensor in the live table; texts, empty where there is nothing."""

    name: str
    mean: str = ""
    std: str = ""
    temp: str = ""
    other_mean: str = ""
    other_temp: str = ""


@dataclass(frozen=True, slots=True)
class LiveState:
    """The live table.

    Parameters
    ----------
    rows : one a sensor
    sensor : ``"accelerometer"`` or ``"gyro"``: what the first columns are of
    unit : of the means
    std_unit : another, e.g. ``"mg"``, once the scale factors are known
    has_others : whether the columns of the other kind of sensor are shown
    """

    rows: tuple[LiveRow, ...] = field(default_factory=tuple)
    sensor: str = "accelerometer"
    unit: str = "code"
    std_unit: str = "code"
    has_others: bool = False
