"""The state of the tab, put together from its parts."""

from collections.abc import Iterable, Mapping

from core.plans.plan import Plan
from core.procedures.measuring import Phase, Status, means_of
from core.records.session.events import Position
from gui.measuring.bench import Bench
from gui.measuring.cues import Scene, stage_of, steps_of
from gui.measuring.guide import S
from gui.measuring.results import Results
from gui.measuring.sitting import Sitting
from gui.measuring.state import Locked, MeasuringState
from gui.measuring.taking import Taking
from gui.widgets.states import ActionBarState, measuring_actions

_OF_SESSION = "It belongs to the session; press New session to change it"
_WHILE_MEASURING = "An accumulation is running"


def measuring_state(
    bench: Bench,
    sitting: Sitting[S],
    taking: Taking,
    results: Results,
    plans: Mapping[str, Plan],
) -> MeasuringState[S]:
    """Everything that the view shows now."""
    settings, plan, walk, guide = sitting.settings, sitting.plan, sitting.walk, sitting.guide
    device = bench.device or guide.empty
    words = guide.words(plan)
    progress = sitting.progress
    status = walk.status
    session = sitting.keeper.session
    pending = taking.pending
    last = sitting.keeper.last
    scene = Scene(
        words=words,
        status=status,
        steps=plan.steps,
        settings=settings,
        linked=bench.linked,
        why_not=bench.why_not,
        just_done=taking.just_done,
        done_before=sum(progress.counts.values()),
        total=len(plan.steps) * settings.passes,
        last_mount="" if last is None else last.step.mount,
        doubt="Not taken" if pending is not None and pending.recognition.acceptable else "",
        processed=results.page is not None,
    )
    return MeasuringState(
        layout=device.layout,
        sensors=len(device.rows),
        test=plan.test,
        lists=words.lists,
        settings=settings,
        locked=Locked(
            plan=_OF_SESSION if session is not None else "",
            timing=_WHILE_MEASURING if walk.measuring else "",
        ),
        plans=tuple((plan_id, one.title) for plan_id, one in plans.items()),
        temperatures=settings.cycle_c if guide.thermal(device, settings) else (),
        steps=steps_of(
            plan.steps,
            dict(progress.counts),
            settings.passes,
            _current(status),
            None if pending is None else pending.step.number,
            _means(sitting.positions_here, device.checked),
            words,
            settings,
        ),
        stage=stage_of(scene),
        actions=ActionBarState(
            measuring_actions(
                _enabled(bench, sitting, taking, results),
                running=walk.measuring,
                why_not=_why_not(bench, status, walk.measuring),
            ),
            settings.hands_free,
        ),
        session=sitting.name,
        session_editable=session is None,
        folder="" if session is None else str(session.folder),
        has_samples=bench.device is not None,
        has_results=results.page is not None,
    )


def _current(status: Status | None) -> int | None:
    return None if status is None or status.step is None else status.step.number


def _means(positions: Iterable[Position], checked: str) -> dict[int, list[float]]:
    """Means of the latest position of each step."""
    return {p.step.number: means_of(p.accumulation, checked).tolist() for p in positions}


def _enabled(bench: Bench, sitting: Sitting[S], taking: Taking, results: Results) -> set[str]:
    status = sitting.walk.status
    if sitting.walk.measuring:
        return set()
    enabled = {"load"}
    if status is not None and bench.linked and status.phase is not Phase.FINISHED:
        enabled.add("accumulate")
    if taking.pending is not None or sitting.keeper.last is not None:
        enabled.add("discard")
        if status is not None and bench.linked:
            enabled.add("repeat")
    if not results.busy and (sitting.keeper.last or results.can_process_again):
        enabled.add("process")
    if results.page is not None:
        enabled.add("export")
    return enabled


def _why_not(bench: Bench, status: Status | None, measuring: bool) -> str:
    if measuring:
        return _WHILE_MEASURING
    if status is None:
        return bench.why_not[1]
    if status.phase is Phase.FINISHED:
        return "All is done; pick a line of the list to measure it once more"
    return "" if bench.linked else "The link is lost"
