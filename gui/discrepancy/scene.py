"""The row of buttons, the judgement above all, and the tab without a run."""

from PySide6.QtCore import QCoreApplication

from core.discrepancy.result import Explanation
from gui.discrepancy.ladder_rows import SIGNIFICANT
from gui.discrepancy.plan_grade import counts_of
from gui.discrepancy.state import StoryState
from gui.discrepancy.words import TONES, summary_words, verdict_words
from gui.discrepancy.working import Story
from gui.widgets.number_text import fixed
from gui.widgets.states import ActionBarState, ActionItem, Tone

_REJECTED = 1e-3


def actions_of(
    story: Story | None, *, candidate: bool, added: bool, again: bool, busy: bool, alone: str
) -> ActionBarState:
    """The row of buttons.

    Parameters
    ----------
    candidate : an effect is chosen
    added : something can be taken back
    again : the rows played by the model are shown
    busy : a job runs
    alone : what stands there in place of data; see `DiscrepancyPresenter.alone`
    """
    able = story is not None and story.able and not busy and not alone
    ladder = story is not None and story.ladder is not None
    addable = ladder or (story is not None and story.known is not None)
    nothing = QCoreApplication.translate("Discrepancy", "There is nothing to compare yet.")
    if alone == "plan":
        nothing = QCoreApplication.translate("Discrepancy", "Nothing was measured yet.")
    elif alone:
        nothing = QCoreApplication.translate("Discrepancy", "The case is sealed: answer first.")
    none = QCoreApplication.translate("Discrepancy", "Find proposes effects first.")
    return ActionBarState(
        (
            ActionItem(
                "find",
                QCoreApplication.translate("Discrepancy", "Find"),
                "Space",
                default=True,
                enabled=able,
                why_not=nothing,
            ),
            ActionItem(
                "add",
                QCoreApplication.translate("Discrepancy", "Add to Model"),
                "Ctrl+Return",
                enabled=able and candidate and addable,
                why_not=none,
            ),
            ActionItem(
                "all",
                QCoreApplication.translate("Discrepancy", "Add All"),
                "Ctrl+Shift+Return",
                enabled=able and story is not None and bool(story.proposals),
                why_not=none,
            ),
            ActionItem(
                "undo",
                QCoreApplication.translate("Discrepancy", "Undo"),
                "Ctrl+Z",
                enabled=added and not busy,
                why_not=QCoreApplication.translate("Discrepancy", "Nothing was added."),
            ),
            ActionItem(
                "play",
                QCoreApplication.translate("Discrepancy", "Simulate with This Model")
                if not again
                else QCoreApplication.translate("Discrepancy", "Hide Simulation"),
                "F6",
                enabled=able and ladder,
                why_not=nothing,
            ),
            ActionItem(
                "calibrate",
                QCoreApplication.translate("Discrepancy", "Use in Calibration"),
                "F7",
                enabled=able and ladder,
                why_not=nothing,
            ),
            ActionItem(
                "load",
                QCoreApplication.translate("ActionBar", "Load Data"),
                "Ctrl+O",
                enabled=not busy,
            ),
            ActionItem(
                "report",
                QCoreApplication.translate("Discrepancy", "Report"),
                "Ctrl+E",
                enabled=story is not None and not busy and not alone,
                why_not=nothing,
            ),
            ActionItem(
                "trial",
                QCoreApplication.translate("Discrepancy", "Practice"),
                "F8",
                enabled=not busy,
            ),
        )
    )


def judgement_of(
    told: Explanation, proposed: Explanation | None, *, alone: str = ""
) -> tuple[str, str, Tone]:
    """Headline, sentence and tone; before anything was looked for only whether the model holds."""
    if alone == "plan":
        return _plan_judged(told)
    if proposed is not None or told.verdict == "not_enough_data":
        judged = told if proposed is None else proposed
        return verdict_words(judged.verdict), summary_words(judged), TONES[judged.verdict]
    rejected = any(one.p_value < SIGNIFICANT for one in told.where)
    rejected = rejected or told.before.p_value < _REJECTED
    gap = fixed(told.before.gap, 2)
    if alone:
        words = QCoreApplication.translate("Discrepancy", "A sealed case")
        template = QCoreApplication.translate(
            "Discrepancy", "Its gap is {gap} noise floors; what is behind it is yours to name."
        )
        return words, template.format(gap=gap), Tone.ACTION
    if rejected:
        template = QCoreApplication.translate(
            "Discrepancy", "Its gap is {gap} noise floors. Find (Space) looks for the reason."
        )
        words = QCoreApplication.translate("Discrepancy", "The plain model is rejected")
        return words, template.format(gap=gap), Tone.DOUBT
    template = QCoreApplication.translate(
        "Discrepancy",
        "Its gap is {gap} noise floors. Find (Space) looks closer.",
    )
    words = QCoreApplication.translate("Discrepancy", "No regressor speaks against the plain model")
    return words, template.format(gap=gap), Tone.IDLE


def _plan_judged(told: Explanation) -> tuple[str, str, Tone]:
    """What a plan can show, counted."""
    if told.verdict == "not_enough_data":
        words = QCoreApplication.translate("Discrepancy", "This plan can show nothing")
        meaning = QCoreApplication.translate(
            "Discrepancy",
            "Its rows leave nothing that could contradict the plain model: measure more positions,"
            " and each twice.",
        )
        return words, meaning, Tone.BAD
    alone, tied, hidden = counts_of(told)
    words = QCoreApplication.translate("Discrepancy", "What this plan can show")
    template = QCoreApplication.translate(
        "Discrepancy",
        "{alone} effects by themselves, {tied} only together with others, {hidden} not at all; for"
        " usual sensors on a usual head or table.",
    )
    return words, template.format(alone=alone, tied=tied, hidden=hidden), Tone.ACTION


def empty_state(hint: str, busy: str, items: ActionBarState) -> StoryState:
    """The tab before a run is there."""
    return StoryState(
        title="",
        source="",
        verdict="",
        summary="",
        tone=Tone.IDLE,
        rungs=(),
        regressors=(),
        regressor="",
        channels=(),
        channel=0,
        picture=None,
        after=False,
        can_after=False,
        again=False,
        proposals=(),
        chosen="",
        detail=None,
        following=(),
        lights=(),
        grade=(),
        notes=(),
        actions=items,
        hint=hint,
        busy=busy,
    )
