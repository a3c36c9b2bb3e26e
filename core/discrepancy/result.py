"""What the comparison of a model with a run gives.

All arrays are read-only. Residuals and curves are in units of the output; `gap` numbers are in
units of the noise floor, so that 1 means that nothing is left to explain.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from core.arrays import FloatArray, IntArray
from core.errors import Note
from core.plans.plan import Plan

VERDICTS = (
    "adequate",
    "explained",
    "ambiguous",
    "unexplained_structure",
    "excess_noise",
    "data_fault",
    "not_enough_data",
)
"""Every explanation has exactly one of these."""

UNKNOWN = "unexplained_structure"
"""Stands in a step in the place of an effect's identifier where no effect explains what is seen."""


@dataclass(frozen=True, slots=True)
class NoiseFloor:
    """The noise that the model is judged against.

    Parameters
    ----------
    sigma : root mean square over the rows, output units
    unit : of `sigma` and of `components`
    components : root mean square of each part: ``white``, ``setting`` (scatter of the angles or
        rates), ``head`` or ``table`` (errors that repeat at the same setting), ``drift``
    ratios : by how much each part was found larger than stated; 1 where it cannot be found
    source : ``"replicates"``, ``"y_se"`` (standard errors and certificates alone) or ``"residual"``
    dof : degrees of freedom of the replicates
    """

    sigma: float
    unit: str
    components: Mapping[str, float]
    ratios: Mapping[str, float]
    source: str
    dof: int


@dataclass(frozen=True, slots=True)
class Gap:
    """How far model and data are apart.

    Parameters
    ----------
    rms : root mean square of the residuals, output units
    gap : root mean square of the whitened residuals; 1 is the noise floor
    chi2_red : their sum of squares over `dof`
    dof : rows minus parameters
    p_value : probability of more with a right model
    lack_p : the same of the part between positions alone (lack of fit); NaN without replicates
    """

    rms: float
    gap: float
    chi2_red: float
    dof: int
    p_value: float
    lack_p: float


@dataclass(frozen=True, slots=True, eq=False)
class Where:
    """Residuals against one regressor, with a band that holds all points of a right model at once.

    Parameters
    ----------
    regressor : ``head_deg``, ``set_rate_dps``, ``a_x``..., ``order``, ``t_s``, ``temperature_c``,
        ``position``, ``mount``, ``run``, ``direction``, ``previous``, ``channel``
    unit : of the regressor, empty where it only counts
    p_value : of structure in it, adjusted for all regressors together (Westfall-Young)
    share : part of the excess chi-square that a smooth curve in it explains, 0 to 1
    worst_value, worst_sigma : where the residual is largest, and how many sigmas
    x : (n,) regressor of each row
    residual : (n,) residual of each row, output units, of channel `channel`
    channel : (n,) output that the row belongs to, from 0
    knots : (k,) regressor at which the curve and the band are given, ascending
    curve : (k,) smooth estimate of the structure, output units
    band : (k,) half width of the simultaneous 95 % band about zero for the mean residual at each
        knot, output units
    shown : channel that curve and band belong to: that with the strongest structure
    """

    regressor: str
    unit: str
    p_value: float
    share: float
    worst_value: float
    worst_sigma: float
    x: FloatArray
    residual: FloatArray
    channel: IntArray
    knots: FloatArray
    curve: FloatArray
    band: FloatArray
    shown: int = 0


@dataclass(frozen=True, slots=True)
class Fitted:
    """One parameter of an added effect.

    Parameters
    ----------
    name, unit : of the parameter
    value, u : estimate and its standard uncertainty; NaN where a number only says which row, run
        or mount it is
    """

    name: str
    value: float
    u: float
    unit: str


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """An effect that could be added next, or stands in for a step.

    Parameters
    ----------
    effect : identifier in the catalogue
    name, plain, equation : standard name, plain words, the term that it adds
    evidence : natural logarithm of how much better it explains the data than the model without it,
        averaged over its places and shapes
    probability : among all candidates of the same step
    parameters : as they would be fitted
    gap_after : what would be left
    alias : whether no analysis of these data can tell it from the best candidate
    curve : (n,) what it adds to each row, output units
    """

    effect: str
    name: str
    plain: str
    equation: str
    evidence: float
    probability: float
    parameters: tuple[Fitted, ...]
    gap_after: float
    alias: bool
    curve: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class NextMeasurement:
    """What to measure next.

    Parameters
    ----------
    title : short
    why : which effects it separates, in words
    plan : ready to be opened in the head or rate tab
    probability : that the answer is unique afterwards, 0 to 1
    minutes : of bench time
    """

    title: str
    why: str
    plan: Plan
    probability: float
    minutes: float


@dataclass(frozen=True, slots=True, eq=False)
class Step:
    """One rung of the ladder.

    Parameters
    ----------
    effect : identifier, or `UNKNOWN`
    name, plain, equation : standard name, plain words, the term that it adds
    seen_as, remedy : how it shows, what to do about it
    parameters : what was fitted
    probability : of this name among all that compete for this step
    p_value : of so much evidence for any name in data without any effect
    evidence : of the effect, see `Candidate`
    indistinguishable_from : identifiers of the others of its ambiguity set
    after : the gap with this and all earlier steps in the model
    held_out_gap_after : gap of rows that were left out of the fit, run by run (stability, no proof)
    advice : what to do next about this step
    curve : (n,) what the step adds to each row, output units
    candidates : all names that compete for this step, best first, this one included
    added_by_hand : the operator added it, the search did not
    """

    effect: str
    name: str
    plain: str
    equation: str
    seen_as: str
    remedy: str
    parameters: tuple[Fitted, ...]
    probability: float
    p_value: float
    evidence: float
    indistinguishable_from: tuple[str, ...]
    after: Gap
    held_out_gap_after: float
    advice: str
    curve: FloatArray
    candidates: tuple[Candidate, ...]
    added_by_hand: bool = False

    @property
    def gap_after(self) -> float:
        """The gap with this and all earlier steps in the model."""
        return self.after.gap


@dataclass(frozen=True, slots=True)
class Smallest:
    """The smallest size of an effect that these data would have named (8 sigmas of it visible).

    Parameters
    ----------
    effect, name : identifier and standard name
    parameter, size, unit : which number must reach which size
    typical : what is usual for a sensor of this kind, same unit; NaN where nothing is usual
    aliases : identifiers of effects that these rows cannot tell from it, whatever its size
    """

    effect: str
    name: str
    parameter: str
    size: float
    unit: str
    typical: float
    aliases: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Explanation:
    """The whole story of one run.

    Parameters
    ----------
    verdict : one of `VERDICTS`
    summary : one or two sentences for the operator
    noise : the floor
    before, after : gap of the plain model, and of the model with all steps
    held_out_before : as `Step.held_out_gap_after`, of the plain model
    where : regressors of the plain model's residuals, most significant first
    where_after : the same with all steps in the model
    steps : in the order of being added
    candidates : what could be added next, best first; empty where nothing exceeds `threshold`
    threshold : evidence that the best name must have, so that clean data give a name in `alpha`
    next_measurements : best first; empty where there is nothing to decide
    smallest : by name, of all effects that the plan can show
    invisible : identifiers of effects that the plan cannot show, whatever their size
    untested : identifiers that a missing column keeps from being tested, with the column
    notes : every doubt
    measured : (n,) output of each row, channel by channel one below the other
    predicted_before, predicted : (n,) of the plain model and of the model with all steps
    sigma : (n,) standard deviation of the noise of each row
    channel : (n,) output that the row belongs to, from 0
    channels, unit : names of the outputs, their unit
    """

    verdict: str
    summary: str
    noise: NoiseFloor
    before: Gap
    after: Gap
    held_out_before: float
    where: tuple[Where, ...]
    where_after: tuple[Where, ...]
    steps: tuple[Step, ...]
    candidates: tuple[Candidate, ...]
    threshold: float
    next_measurements: tuple[NextMeasurement, ...]
    smallest: tuple[Smallest, ...]
    invisible: tuple[str, ...]
    untested: Mapping[str, str]
    notes: tuple[Note, ...]
    measured: FloatArray
    predicted_before: FloatArray
    predicted: FloatArray
    sigma: FloatArray
    channel: IntArray
    channels: tuple[str, ...]
    unit: str

    @property
    def closure(self) -> float:
        """Closed part of the gap above the noise floor, 0 to 1; NaN where there was none."""
        before = self.before.gap - 1.0
        return (self.before.gap - self.after.gap) / before if before > 0 else float("nan")
