"""The row of buttons, the judgement above all, and the tab without a run."""

from PySide6.QtCore import QCoreApplication

from core.discrepancy.result import Explanation
from core.errors import LabError
from gui.discrepancy.ladder_rows import SIGNIFICANT
from gui.discrepancy.plan_grade import counts_of
from gui.discrepancy.state import StoryState
from gui.discrepancy.words import TONES, closed_words, summary_words, verdict_words
from gui.discrepancy.working import Story
from gui.widgets.states import ActionBarState, ActionItem, BannerAction, Tone

_REJECTED = 1e-3
_SENSORS = ("accelerometer", "gyro")


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
    closed = ladder and story is not None and bool(story.told.steps) and not candidate
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
                default=story is not None and story.proposed is None,
                enabled=able,
                why_not=nothing,
            ),
            ActionItem(
                "add",
                QCoreApplication.translate("Discrepancy", "Add to Model"),
                "Ctrl+Return",
                default=candidate,
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
                default=closed,
                enabled=able and ladder,
                why_not=nothing,
            ),
            ActionItem(
                "load",
                QCoreApplication.translate("ActionBar", "Load Data"),
                "Ctrl+O",
                default=story is None,
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
    """Headline, sentence and tone; before anything was looked for only whether the model holds.

    The sentence is empty where the steps that were found tell it.
    """
    if alone == "plan":
        return _plan_judged(told)
    if proposed is not None or told.verdict == "not_enough_data":
        judged = told if proposed is None else proposed
        sentence = "" if judged.steps else summary_words(judged)
        tone = TONES[judged.verdict]
        if proposed is not None and told.steps and len(told.steps) == len(proposed.steps):
            closed = closed_words(judged.verdict)
            tone = Tone.GOOD if judged.verdict == "explained" else tone
            return closed or verdict_words(judged.verdict), sentence, tone
        return verdict_words(judged.verdict), sentence, tone
    if alone:
        return QCoreApplication.translate("Discrepancy", "A sealed case"), "", Tone.ACTION
    if is_rejected(told):
        words = QCoreApplication.translate("Discrepancy", "The plain model is rejected")
        return words, "", Tone.DOUBT
    words = QCoreApplication.translate("Discrepancy", "No regressor speaks against the plain model")
    return words, "", Tone.IDLE


def is_rejected(told: Explanation) -> bool:
    """Whether the plain model does not hold, by where its residuals are or how large."""
    return told.before.p_value < _REJECTED or any(one.p_value < SIGNIFICANT for one in told.where)


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


def hint_words() -> str:
    """What the tab without a run says."""
    return QCoreApplication.translate(
        "Discrepancy",
        "Load Data (Ctrl+O) takes a session's folder, run files, records or text files of the old"
        " programs; several of one unit are compared as one run.\n\n"
        "Find (Space) then looks for what the model lacks, names it, and says how sure that is;"
        " or press “Model vs data” on a page of results.\n\n"
        "Practice (F8) hides something in rows of the simulated rig, for you to name.",
    )


def empty_state(hint: str, busy: str, items: ActionBarState) -> StoryState:
    """The tab before a run is there."""
    return StoryState(
        title="",
        source="",
        verdict="",
        summary="",
        tone=Tone.IDLE,
        gaps="",
        found=(),
        advice="",
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
        notes=(),
        actions=items,
        hint=hint,
        busy=busy,
    )


def sensors_asked(error: LabError) -> tuple[BannerAction, ...]:
    """Buttons for a file that holds both sensors."""
    if "sensor" not in str(error) or not all(name in str(error) for name in _SENSORS):
        return ()
    return tuple(BannerAction(f"sensor {name}", name.capitalize()) for name in _SENSORS)
