"""Everything that the tab Model vs data shows."""

from dataclasses import dataclass

from core.arrays import FloatArray
from core.errors import Note
from gui.widgets.states import ActionBarState, Tone


@dataclass(frozen=True, slots=True)
class RungState:
    """One rung of the ladder.

    Parameters
    ----------
    number : 0 for the plain model
    title : what was added
    gap : what is left with it, in noise floors; NaN where nothing can be said
    held_out : the same of rows that were left out of the fit; NaN where it was not computed
    facts : chi-square, evidence and the like, for one line
    parameters : estimates with their uncertainties, one line each
    tone, certainty : how sure its name is, as a sign and in words; empty for the plain model
    proposed : found, and not yet added
    kept : it cannot be taken back: a fault of the data that stands whatever the model
    """

    number: int
    title: str
    gap: float
    held_out: float
    facts: tuple[str, ...]
    parameters: tuple[str, ...]
    tone: Tone = Tone.IDLE
    certainty: str = ""
    proposed: bool = False
    kept: bool = False


@dataclass(frozen=True, slots=True)
class StepRow:
    """One missing effect at a glance.

    Parameters
    ----------
    tone, certainty : how sure the name is, as a sign and in words
    name : standard name
    added : it is in the model
    """

    tone: Tone
    name: str
    certainty: str
    added: bool


@dataclass(frozen=True, slots=True)
class RegressorRow:
    """One line of the list of regressors.

    Parameters
    ----------
    key : name of the regressor
    title, detail : two lines
    tone : `Tone.BAD` where structure is significant
    """

    key: str
    title: str
    detail: str
    tone: Tone


@dataclass(frozen=True, slots=True)
class CandidateRow:
    """One effect that could be added.

    Parameters
    ----------
    key : identifier
    name, value : standard name; its numbers as they would be fitted
    share : length of the evidence bar, 0 to 1
    evidence : in words
    gap_after : what would be left, in words
    """

    key: str
    name: str
    value: str
    share: float
    evidence: str
    gap_after: str


@dataclass(frozen=True, slots=True)
class ProposalCard:
    """One missing effect, or several that these data cannot tell apart.

    Parameters
    ----------
    title : over the card
    tied : the effects of the set, best first
    same : further names that fit, in words; empty for none
    others : less likely ones
    """

    title: str
    tied: tuple[CandidateRow, ...]
    same: str
    others: tuple[CandidateRow, ...]


@dataclass(frozen=True, slots=True)
class DetailState:
    """The chosen candidate.

    Parameters
    ----------
    key, name, plain, equation : identifier, standard name, plain words, the term it adds
    lines : how it shows, what to do about it: what is told, and the words
    """

    key: str
    name: str
    plain: str
    equation: str
    lines: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class NextCard:
    """One measurement that would decide.

    Parameters
    ----------
    title, why : in words
    facts : positions and time
    parts : what is done one after another, where no tab does it
    chance : that the answer is unique afterwards, 0 to 1
    opens : there is a plan of steps, which a tab measures
    """

    title: str
    why: str
    facts: str
    chance: float
    parts: tuple[str, ...] = ()
    opens: bool = True


@dataclass(frozen=True, slots=True)
class LightRow:
    """What the rows can show of one effect.

    Parameters
    ----------
    tone : good: at its usual size and alone; doubt: only larger or with others; bad: not at all
    title, detail : name, and from which size on, or as what, or why not
    """

    tone: Tone
    title: str
    detail: str


@dataclass(frozen=True, slots=True, eq=False)
class PictureState:
    """Both plots of one channel against one regressor.

    Parameters
    ----------
    title : what the residual shows, one sentence
    x_label, unit : label of the regressor with its unit; unit of the output
    x, measured, simulated, residual : (n,) by rows
    played, again : (n,) output of the same rows on the simulated bench, and its residual; empty if
        they were not walked there
    knots, mean, curve, band : (k,) mean residual at each knot, smooth estimate, half width of the
        simultaneous band
    marked : (k,) 1 where the mean leaves the band
    worst : place of the largest disagreement among the knots, and its words; -1 for none
    worst_words : beside it
    preview, preview_name : (k,) what the chosen candidate would explain; empty for none
    """

    title: str
    x_label: str
    unit: str
    x: FloatArray
    measured: FloatArray
    simulated: FloatArray
    residual: FloatArray
    played: FloatArray
    again: FloatArray
    knots: FloatArray
    mean: FloatArray
    curve: FloatArray
    band: FloatArray
    marked: FloatArray
    worst: int
    worst_words: str
    preview: FloatArray
    preview_name: str


@dataclass(frozen=True, slots=True, eq=False)
class StoryState:
    """The tab.

    Parameters
    ----------
    title, source : device and rows; file
    verdict, summary, tone : the judgement; the sentence is empty where `found` tells it
    gaps : the gap before and after, in noise floors; empty where nothing can be said
    found : every missing effect that was found, with how sure its name is
    advice : what to do next; empty for nothing
    rungs : the ladder, from the plain model on; proposed rungs last
    regressors, regressor : the list, and the chosen key
    channels, channel : names of the outputs, and the chosen one
    picture : None while there is nothing to draw
    after, can_after : whether residuals are those with the effects added; whether there are any
    again : the rows played by the model are shown
    proposals, chosen, detail : what could be added; identifier of the chosen one
    following : what to measure next
    lights : what these rows can show, effect by effect
    notes : every doubt
    actions : the row of buttons
    hint : instead of all that; empty if there is something
    busy : what is being done; empty for nothing
    """

    title: str
    source: str
    verdict: str
    summary: str
    tone: Tone
    gaps: str
    found: tuple[StepRow, ...]
    advice: str
    rungs: tuple[RungState, ...]
    regressors: tuple[RegressorRow, ...]
    regressor: str
    channels: tuple[str, ...]
    channel: int
    picture: PictureState | None
    after: bool
    can_after: bool
    again: bool
    proposals: tuple[ProposalCard, ...]
    chosen: str
    detail: DetailState | None
    following: tuple[NextCard, ...]
    lights: tuple[LightRow, ...]
    notes: tuple[Note, ...]
    actions: ActionBarState
    hint: str
    busy: str
