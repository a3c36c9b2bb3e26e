"""The dividing-head tab: clicks in, `HeadState` out."""

import math
from collections.abc import Mapping
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from core.plans.plan import Plan, Step
from core.procedures.measuring import Phase, means_of
from core.records.session.events import Position
from core.samples.run import Conditions
from gui.dividing_head.bench import Bench
from gui.dividing_head.cues import Scene, stage_of, steps_of
from gui.dividing_head.device import CLBACC, EMPTY
from gui.dividing_head.results import ResultsPresenter
from gui.dividing_head.settings import HeadSettings, settings_of
from gui.dividing_head.sitting import Sitting
from gui.dividing_head.state import HeadState, LiveState, Locked
from gui.settings import Settings
from gui.widgets.states import ActionBarState, measuring_actions

SECTION = "dividing_head"
_OF_SESSION = "It belongs to the session; press New session to change it"
_WHILE_MEASURING = "An accumulation is running"


class HeadPresenter(QObject):
    """Everything the view asks for.

    Parameters
    ----------
    bench : the device
    sitting : the session
    results : what is made of it
    plans : those of the dividing head, by id
    settings : where the operator's choices are remembered
    """

    changed = Signal(object)
    """A new `HeadState`."""

    def __init__(
        self,
        bench: Bench,
        sitting: Sitting,
        results: ResultsPresenter,
        plans: Mapping[str, Plan],
        settings: Settings,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._bench = bench
        self._sitting = sitting
        self._results = results
        self._plans = plans
        self._settings = settings
        sitting.changed.connect(self._tell)
        results.changed.connect(self._tell)
        results.conditions_found.connect(self._on_conditions)
        bench.changed.connect(self._on_device)
        bench.link_changed.connect(self._tell)

    # --- what the operator sets -------------------------------------------------------------------

    def set_settings(self, settings: HeadSettings) -> None:
        """Take the fields of the settings panel."""
        sitting = self._sitting
        if settings == sitting.settings or sitting.walk.measuring:
            return
        if settings.plan_id != sitting.settings.plan_id and settings.plan_id in self._plans:
            sitting.plan = self._plans[settings.plan_id]
            settings = self._for_plan(settings, sitting.plan)
        settings = replace(settings, visit=min(settings.visit, len(settings.cycle_c) - 1))
        sitting.settings = settings
        self._settings.store(SECTION, settings.to_section())
        sitting.rebegin()
        self._tell()

    def set_plan(self, plan_id: str) -> None:
        """Take another plan, with its own times and temperatures."""
        self.set_settings(replace(self._sitting.settings, plan_id=plan_id))

    def set_hands_free(self, on: bool) -> None:
        """Let the program accumulate by itself, or no longer."""
        self._sitting.settings = replace(self._sitting.settings, hands_free=on)
        self._sitting.walk.set_hands_free(on)
        self._tell()

    def add_angle(self, mount: str, head_deg: float) -> None:
        """Add a position at a free angle."""
        plan = self._sitting.plan
        number = max(step.number for step in plan.steps) + 1
        step = Step(number, "Free angles", mount, head_deg)
        self._sitting.plan = plan.with_steps((*plan.steps, step))
        self._sitting.rebegin(number)

    def set_session_name(self, name: str) -> None:
        """Name the session that has not begun."""
        self._sitting.set_name(name)

    def new_session(self) -> None:
        """Leave this session; the next accumulation makes a new one."""
        if not self._sitting.walk.measuring:
            self._sitting.leave()
            self._results.clear()
            self._tell()

    # --- what the operator does -------------------------------------------------------------------

    def choose(self, row: int) -> None:
        """Pick a step of the list."""
        self._sitting.choose(self._sitting.plan.steps[row].number)

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        {
            "accumulate": self._sitting.start,
            "stop": self._sitting.stop,
            "repeat": self._sitting.repeat,
            "discard": self._sitting.discard,
            "process": self.process,
            "undo": self._sitting.undo,
        }[key]()

    def process(self) -> None:
        """Calibrate what was measured, or what was loaded."""
        session, settings = self._sitting.keeper.session, self._sitting.settings
        if session is not None and session.positions:
            self._results.process_session(session.record, settings, self._sitting.rows_here)
        else:
            self._results.process_again(settings)

    @property
    def folder(self) -> str:
        """Where to look for files to load."""
        return str(self._sitting.root)

    # --- what the view shows ----------------------------------------------------------------------

    @property
    def state(self) -> HeadState:
        """The tab as it is now."""
        sitting, walk = self._sitting, self._sitting.walk
        settings, plan = sitting.settings, sitting.plan
        device = self._bench.device or EMPTY
        progress = sitting.progress
        status = walk.status
        session = sitting.keeper.session
        kept = sitting.keeper.positions
        pending = sitting.pending
        scene = Scene(
            status=status,
            steps=plan.steps,
            settings=settings,
            linked=self._bench.linked,
            why_not=self._bench.why_not,
            just_done=sitting.just_done,
            done_before=sum(progress.counts.values()),
            total=len(plan.steps) * settings.passes,
            last_mount=kept[-1].step.mount if kept else "",
            doubt="Not taken" if pending is not None and pending.recognition.acceptable else "",
        )
        current = None if status is None or status.step is None else status.step.number
        if status is not None and status.phase is Phase.FINISHED:
            current = None
        return HeadState(
            layout=device.layout,
            settings=settings,
            locked=Locked(
                plan=_OF_SESSION if session is not None else "",
                timing=_WHILE_MEASURING if walk.measuring else "",
            ),
            plans=tuple((plan_id, one.title) for plan_id, one in self._plans.items()),
            temperatures=settings.cycle_c if device.layout == CLBACC or settings.thermo else (),
            steps=steps_of(
                plan.steps,
                dict(progress.counts),
                settings.passes,
                current,
                None if pending is None else pending.step.number,
                self._means((*progress.before, *progress.done), device.checked),
                settings,
            ),
            step_numbers=tuple(step.number for step in plan.steps),
            stage=stage_of(scene),
            actions=ActionBarState(
                measuring_actions(self._enabled(), running=walk.measuring, why_not=self._why_not()),
                settings.hands_free,
            ),
            session=sitting.name,
            session_editable=session is None,
            folder="" if session is None else str(session.folder),
            has_results=self._results.state is not None,
        )

    def live(self) -> LiveState:
        """The live table as it is now."""
        live = self._bench.live
        return LiveState() if live is None else live.state(self._results.mg_per_unit)

    def _means(self, positions: tuple[Position, ...], checked: str) -> dict[int, list[float]]:
        here = sorted(positions, key=lambda position: position.id)
        return {p.step.number: means_of(p.accumulation, checked).tolist() for p in here}

    def _enabled(self) -> set[str]:
        sitting, status = self._sitting, self._sitting.walk.status
        if sitting.walk.measuring:
            return set()
        enabled = {"load"}
        if status is not None and self._bench.linked and status.phase is not Phase.FINISHED:
            enabled.add("accumulate")
        if sitting.pending is not None or sitting.keeper.last is not None:
            enabled |= {"repeat", "discard"} if status is not None else {"discard"}
        if not self._results.busy and (sitting.keeper.last or self._results.can_process_again):
            enabled.add("process")
        if self._results.state is not None:
            enabled.add("export")
        return enabled

    def _why_not(self) -> str:
        if self._sitting.walk.measuring:
            return _WHILE_MEASURING
        status = self._sitting.walk.status
        if status is None:
            return self._bench.why_not[1]
        if status.phase is Phase.FINISHED:
            return "All positions are done; pick one of the list to measure it once more"
        return "" if self._bench.linked else "The link is lost"

    def _on_device(self) -> None:
        """A device that stands in the other layout takes that layout's plan."""
        device, sitting = self._bench.device, self._sitting
        if device is not None and sitting.keeper.session is None:
            titles = _PLANS_OF[device.layout]
            if sitting.settings.plan_id not in titles:
                self.set_settings(replace(sitting.settings, plan_id=titles[0]))
        self._tell()

    def _on_conditions(self, conditions: object) -> None:
        """A loaded file states its own g: show it, since it is what was used."""
        if not isinstance(conditions, Conditions):
            raise TypeError(f"{type(conditions).__name__} states no conditions")
        stated = {
            name: value
            for name, value in (
                ("g_mps2", conditions.g_mps2),
                ("u_g_mps2", conditions.u_g_mps2),
                ("head_u_arcsec", conditions.head_u_arcsec),
            )
            if math.isfinite(value)
        }
        if self._sitting.keeper.session is None:
            self.set_settings(replace(self._sitting.settings, **stated))

    def _for_plan(self, settings: HeadSettings, plan: Plan) -> HeadSettings:
        """The plan's own times and temperatures, when it is taken."""
        thermal = bool(plan.temperatures_c)
        return replace(
            settings,
            accumulation_s=plan.accumulation_s,
            settle_s=plan.settle_s,
            thermo=thermal,
            cycle_c=plan.temperatures_c if thermal else settings.cycle_c,
            visit=0,
        )

    def _tell(self) -> None:
        self.changed.emit(self.state)


_PLANS_OF = {
    "clbacc": (
        "accelerometer_8",
        "accelerometer_4",
        "clbacc_24",
        "thermal_8",
    ),
    "pointer": ("pointer_8", "pointer_16", "accelerometer_8", "accelerometer_4", "thermal_8"),
}
"""Plans that each layout begins with; every plan can be chosen in both."""


def remembered(settings: Settings) -> HeadSettings:
    """The choices of the last time."""
    return settings_of(settings.section(SECTION))
