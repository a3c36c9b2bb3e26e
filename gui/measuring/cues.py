"""What the operator is told: the large line of the stage, and banners about positions."""

from dataclasses import dataclass, replace

from core.errors import Severity
from core.plans.plan import Step
from core.procedures.measuring import Outcome, Phase, Status
from core.records.session.events import Position
from gui.measuring.settings import MeasuringSettings
from gui.measuring.words import Words
from gui.widgets.number_text import fixed
from gui.widgets.states import (
    BannerAction,
    BannerState,
    Pose,
    StageState,
    StepMark,
    StepState,
    Tone,
)

REPEAT = BannerAction("repeat", "Repeat")
TAKE = BannerAction("take", "Take it anyway")
NEXT = BannerAction("next", "Go on")
ACCEPT_AS = "accept as "
"""Key of the action that takes a position under another number, which follows."""
MEASURE = "measure "
"""Key of the action that makes another step the current one; its number follows."""


@dataclass(frozen=True, slots=True)
class Scene:
    """What the stage depends on.

    Parameters
    ----------
    words : how the steps are called
    status : where the walk stands; None without a device that can be measured
    steps : of the plan
    settings : of the test
    linked : whether samples come
    why_not : why nothing can be measured, for the stage; empty if something can
    just_done : the position that was accepted a moment ago
    done_before : positions of the plan that count
    total : positions that the plan wants, all passes
    last_mount : how the unit stood last; empty before the first position
    doubt : headline over an accumulation that was not taken
    processed : whether the results are on the screen
    """

    words: Words
    status: Status | None
    steps: tuple[Step, ...]
    settings: MeasuringSettings
    linked: bool
    why_not: tuple[str, str]
    just_done: Position | None
    done_before: int
    total: int
    last_mount: str
    doubt: str
    processed: bool


def stage_of(scene: Scene) -> StageState:
    """The stage."""
    status = scene.status
    if status is None:
        return StageState(*scene.why_not)
    if not scene.linked:
        return StageState(
            "Link lost",
            "Everything accepted so far is on the disk. Measuring goes on when the device is back.",
            Tone.BAD,
            pose=None if status.step is None else _pose(status.step, scene),
        )
    if status.step is None:
        return StageState(
            scene.words.all_done(),
            f"{scene.done_before} {scene.words.nouns} are on the disk."
            + ("" if scene.processed else " Press Process Data (F5)."),
            Tone.GOOD,
        )
    if scene.just_done is not None and status.phase in (Phase.READY, Phase.TURN, Phase.MOVING):
        return _done(scene.just_done, status.step, scene)
    return _of_phase(status, status.step, scene)


def _of_phase(status: Status, step: Step, scene: Scene) -> StageState:
    words = scene.words
    pose = _pose(step, scene)
    following = _following(step, scene)
    where = f"{words.noun.capitalize()} {step.number}, {scene.done_before + 1} of {scene.total}."
    asked = f"{where} {words.mounting(step, scene.last_mount)}"
    headline = words.headline(step, scene.last_mount)
    match status.phase:
        case Phase.READY:
            time = words.time(step, scene.settings)
            if status.remaining_s > 0.0:
                then = f"It settles; then press Space to accumulate {time}."
                return replace(
                    _still(headline, asked + then, pose, following),
                    progress=status.progress,
                    remaining_s=status.remaining_s,
                )
            return _still(
                headline, f"{asked}Then press Space to accumulate {time}.", pose, following
            )
        case Phase.TURN:
            return _still(headline, asked + words.by_itself, pose, following)
        case Phase.MOVING:
            return _still(headline, asked + words.moving, pose, following)
        case Phase.SETTLING:
            return _timed("Settling", f"{where} {words.settling}", status, pose, following)
        case Phase.MEASURING:
            return _timed("Measuring", f"{where} {words.measuring}", status, pose, following)
        case _:
            return StageState(
                scene.doubt or words.wrong,
                "Nothing was recorded; see below.",
                Tone.DOUBT,
                pose=pose,
            )


def _still(
    headline: str, detail: str, pose: Pose | None, following: tuple[Pose | None, str]
) -> StageState:
    return StageState(headline, detail, Tone.ACTION, None, None, pose, *following)


def _timed(
    headline: str,
    detail: str,
    status: Status,
    pose: Pose | None,
    following: tuple[Pose | None, str],
) -> StageState:
    return StageState(
        headline, detail, Tone.BUSY, status.progress, status.remaining_s, pose, *following
    )


def _done(position: Position, step: Step, scene: Scene) -> StageState:
    words = scene.words
    return StageState(
        f"{words.noun.capitalize()} {position.step.number} done",
        f"On the disk. Next: {words.noun} {step.number}, {words.place(step)},"
        f" {words.setting(step)}.",
        Tone.GOOD,
        pose=_pose(step, scene),
    )


def _following(step: Step, scene: Scene) -> tuple[Pose | None, str]:
    places = [i for i, other in enumerate(scene.steps) if other.number == step.number]
    place = places[0] + 1 if places else len(scene.steps)
    if place >= len(scene.steps):
        return None, ""
    after = scene.steps[place]
    return _pose(after, scene), scene.words.setting(after)


def _pose(step: Step, scene: Scene) -> Pose | None:
    return scene.words.pose(step, scene.settings)


def doubt_banner(outcome: Outcome, steps: tuple[Step, ...], words: Words) -> BannerState:
    """What to say of an accumulation that was not taken."""
    errors = [n for n in outcome.accumulation.notes if n.severity is Severity.ERROR]
    recognition = outcome.recognition
    if recognition.acceptable:
        what = {"too_short": "Too short", "moved": words.moved}.get(errors[0].subject, "Not taken")
        why = errors[0].text
        others: tuple[BannerAction, ...] = ()
    else:
        what, why = _sentence(recognition.text).rstrip("."), ""
        others = tuple(
            BannerAction(
                f"{ACCEPT_AS}{steps[place].number}", f"Accept as {words.noun} {steps[place].number}"
            )
            for place in recognition.candidates[:2]
            if steps[place].number != outcome.step.number
        )
        if errors:
            why = errors[0].text
    return BannerState(
        Severity.WARNING,
        what,
        " ".join(
            part
            for part in (
                _sentence(why),
                f"Nothing has been recorded under {words.label(outcome.step)}.",
            )
            if part
        ),
        "",
        (*others, REPEAT, TAKE),
    )


def elsewhere_banner(
    text: str, candidates: tuple[int, ...], step: Step, words: Words
) -> BannerState:
    """What to say, hands-free, when the unit rests in another position than the current one."""
    others = [number for number in candidates if number != step.number]
    return BannerState(
        Severity.WARNING,
        _sentence(text).rstrip("."),
        "Nothing is being measured.",
        f"{words.order(step)}, {words.place(step)}; or measure what is there.",
        tuple(
            BannerAction(f"{MEASURE}{number}", f"Measure {words.noun} {number}")
            for number in others[:2]
        ),
    )


def next_temperature_banner(here_c: float, after_c: float, nouns: str) -> BannerState:
    """What to say when all steps at a temperature are done."""
    here, after = (f"{value:+g} °C".replace("-", "\N{MINUS SIGN}") for value in (here_c, after_c))
    return BannerState(
        Severity.INFO,
        f"All {nouns} at {here} are done",
        "",
        f"Set the chamber to {after}, wait until the unit has its temperature, then go on.",
        (NEXT,),
        closable=False,
    )


def steps_of(
    steps: tuple[Step, ...],
    counts: dict[int, int],
    wanted: int,
    current: int | None,
    problem: int | None,
    means: dict[int, list[float]],
    words: Words,
    settings: MeasuringSettings,
) -> tuple[StepState, ...]:
    """The rows of the step list."""
    return tuple(
        StepState(
            label=f"{step.number}   {words.setting(step)}",
            mark=_mark(step.number, counts, wanted, current, problem),
            pose=words.pose(step, settings),
            values=_values(means.get(step.number, [])),
            replicates=counts.get(step.number, 0),
            group=step.group,
        )
        for step in steps
    )


def _mark(
    number: int, counts: dict[int, int], wanted: int, current: int | None, problem: int | None
) -> StepMark:
    if number == problem:
        return StepMark.PROBLEM
    if number == current:
        return StepMark.NOW
    return StepMark.DONE if counts.get(number, 0) >= wanted else StepMark.TO_COME


def _values(means: list[float]) -> str:
    few = means if len(means) <= 3 else means[:2]
    shown = "  ".join(_short(value) for value in few)
    return f"{shown} …" if len(means) > len(few) else shown


def _short(value: float) -> str:
    """A mean: codes are large, volts small."""
    size = abs(value)
    return fixed(value, 0 if size >= 100.0 else 1 if size >= 10.0 else 4)


def _sentence(text: str) -> str:
    text = text.strip()
    return "" if not text else text[0].upper() + text[1:] + ("" if text[-1] in ".!?" else ".")
