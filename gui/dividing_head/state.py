"""Everything that the dividing-head tab shows."""

from dataclasses import dataclass, field

from gui.dividing_head.settings import HeadSettings
from gui.widgets.states import ActionBarState, StageState, StepState


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
class HeadState:
    """The tab.

    Parameters
    ----------
    layout : ``"clbacc"`` or ``"pointer"``
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
    settings: HeadSettings
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
    acc_mean: str = ""
    acc_std: str = ""
    acc_temp: str = ""
    rate_mean: str = ""
    rate_temp: str = ""


@dataclass(frozen=True, slots=True)
class LiveState:
    """The live table.

    Parameters
    ----------
    rows : one a sensor
    unit : of the means
    std_unit : ``"mg"`` once the scale factors are known
    has_rates : whether the columns of the gyros are shown
    """

    rows: tuple[LiveRow, ...] = field(default_factory=tuple)
    unit: str = "code"
    std_unit: str = "code"
    has_rates: bool = False
