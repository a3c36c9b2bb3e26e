"""Everything that the page Which procedure? shows."""

from dataclasses import dataclass

from core.errors import Note
from core.plans.plan import Plan, Step
from core.procedures.prediction.bench import TOOLS
from core.procedures.prediction.design import Prediction
from core.procedures.prediction.propose import Proposal
from gui.widgets.analysis_page import AnalysisState

Noise = tuple[float, float, float]
"""N, B, K in deg/s or m/s^2, with seconds."""
TYPICAL: dict[str, Noise] = {
    "accelerometer": (1e-3, 0.0, 0.0),
    "gyro": (1.6667e-4, 0.0, 0.0),
}
"""White noise to begin with: 0.1 mg sqrt(s), nearly, and 0.01 deg/sqrt(h)."""


@dataclass(frozen=True, slots=True)
class AdvisorChoices:
    """The sensor, the rig, and what was changed in the plan.

    Parameters
    ----------
    kind, axis : of the sensor
    noise, noise_source : of the sensor, and where it was taken from
    tools : of `core.procedures.prediction.bench.TOOLS`
    accumulation_s : instead of the plan's; 0 for the plan's own
    pause_s : time to turn the rig
    g_mps2, u_g_mps2, head_u_arcsec, rate_u_ppm, latitude_deg : what the laboratory states
    method, plan_id : the chosen proposal; empty for the first
    dropped : numbers of the steps that are left out
    added : steps that the operator added
    """

    kind: str = "accelerometer"
    axis: str = "z"
    noise: Noise = TYPICAL["accelerometer"]
    noise_source: str = ""
    tools: frozenset[str] = frozenset(TOOLS)
    accumulation_s: float = 0.0
    pause_s: float = 15.0
    g_mps2: float = 9.8106
    u_g_mps2: float = 0.0005
    head_u_arcsec: float = 10.0
    rate_u_ppm: float = 50.0
    latitude_deg: float = 50.45
    method: str = ""
    plan_id: str = ""
    dropped: frozenset[int] = frozenset()
    added: tuple[Step, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Advised:
    """What a job brings.

    Parameters
    ----------
    choices : for which it was computed, with the proposal that was chosen
    proposals : the best first
    whole : the chosen plan as it is in its file; None where there is none
    plan : the same with the operator's changes; None where no step is left
    before, after : prediction of `whole` and of `plan`; None where there is none
    why : why there is no `after`; empty if there is
    unseen : what `plan` cannot see
    """

    choices: AdvisorChoices
    proposals: tuple[Proposal, ...] = ()
    whole: Plan | None = None
    plan: Plan | None = None
    before: Prediction | None = None
    after: Prediction | None = None
    why: str = ""
    unseen: tuple[Note, ...] = ()


@dataclass(frozen=True, slots=True)
class ProposalRow:
    """One proposal of the list."""

    key: tuple[str, str]
    title: str
    detail: str


@dataclass(frozen=True, slots=True)
class StepRow:
    """One step of the chosen plan.

    Parameters
    ----------
    number : its number; negative for a place in `added`, from -1
    text : as the operator knows it
    group : heading above it
    kept : whether it is measured
    """

    number: int
    text: str
    group: str
    kept: bool


@dataclass(frozen=True, slots=True)
class AdvisorState:
    """The page.

    Parameters
    ----------
    choices : what is decided
    proposals : to choose from
    current : key of the chosen one
    steps : of its plan
    on_table : whether steps are rates rather than angles
    mounts : that a step which is added may have
    frame : hint, findings, actions
    """

    choices: AdvisorChoices
    proposals: tuple[ProposalRow, ...]
    current: tuple[str, str]
    steps: tuple[StepRow, ...]
    on_table: bool
    mounts: tuple[str, ...]
    frame: AnalysisState
