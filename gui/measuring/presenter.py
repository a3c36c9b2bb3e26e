"""A measuring tab: clicks in, `MeasuringState` out."""

import math
from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Generic

from PySide6.QtCore import QObject, Signal

from core.plans.orientation import Mount
from core.plans.plan import Plan, Step
from core.samples.run import Conditions
from gui.measuring.bench import Bench
from gui.measuring.guide import S
from gui.measuring.results import Results
from gui.measuring.scene import measuring_state
from gui.measuring.sitting import Sitting
from gui.measuring.state import LiveState, MeasuringState
from gui.measuring.taking import Taking
from gui.settings import Settings


class MeasuringPresenter(Generic[S], QObject):
    """Everything the view asks for.

    Parameters
    ----------
    bench : the device
    sitting : the session
    taking : what becomes of accumulations
    results : what is made of the session
    plans : those of the tab, by id
    settings : where the operator's choices are remembered
    """

    changed = Signal(object)
    """A new `MeasuringState`."""
    hands_free_on = Signal()
    """Another tab that is hands-free has to let go."""

    def __init__(
        self,
        bench: Bench,
        sitting: Sitting[S],
        taking: Taking,
        results: Results,
        plans: Mapping[str, Plan],
        settings: Settings,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._bench = bench
        self._sitting = sitting
        self._taking = taking
        self._results = results
        self._plans = plans
        self._settings = settings
        self._actions = {
            "accumulate": taking.start,
            "stop": taking.stop,
            "repeat": taking.repeat,
            "discard": taking.discard,
            "undo": taking.undo,
            "process": self.process,
        }
        sitting.changed.connect(self._tell)
        taking.changed.connect(self._tell)
        results.changed.connect(self._tell)
        results.conditions_found.connect(self._on_conditions)
        bench.changed.connect(self._on_device)
        bench.link_changed.connect(self._tell)

    @property
    def state(self) -> MeasuringState[S]:
        """The tab as it is now."""
        return measuring_state(self._bench, self._sitting, self._taking, self._results, self._plans)

    def live(self) -> LiveState:
        """The live table as it is now."""
        live = self._bench.live
        return (
            LiveState()
            if live is None
            else live.state(self._results.live_scale, self._results.live_unit)
        )

    @property
    def folder(self) -> str:
        """Where to look for files to load."""
        return str(self._sitting.root)

    # --- what the operator sets -------------------------------------------------------------------

    def set_settings(self, settings: S) -> None:
        """Take the fields of the settings panel."""
        sitting = self._sitting
        if settings == sitting.settings or sitting.walk.measuring:
            return
        if settings.plan_id != sitting.settings.plan_id and settings.plan_id in self._plans:
            sitting.plan = self._plans[settings.plan_id]
            settings = sitting.guide.for_plan(_timed(settings, sitting.plan), sitting.plan)
        sitting.settings = replace(settings, visit=min(settings.visit, len(settings.cycle_c) - 1))
        self._settings.store(sitting.guide.key, sitting.settings.to_section())
        sitting.rebegin()

    def set_plan(self, plan_id: str) -> None:
        """Take another plan, with its own times and temperatures."""
        self.set_settings(replace(self._sitting.settings, plan_id=plan_id))

    def set_hands_free(self, on: bool) -> None:
        """Let the program accumulate by itself, or no longer."""
        if on:
            self.hands_free_on.emit()
        self._sitting.settings = replace(self._sitting.settings, hands_free=on)
        self._sitting.walk.set_hands_free(on)
        self._tell()

    def add_angle(self, mount: str, head_deg: float) -> None:
        """Add a position at a free angle."""
        self.add_step("Free angles", mount, head_deg=head_deg)

    def add_step(
        self, group: str, mount: str, *, head_deg: float = 0.0, rate_dps: float = 0.0
    ) -> None:
        """Add a step of the operator's own to the end of the plan."""
        plan = self._sitting.plan
        number = max(step.number for step in plan.steps) + 1
        step = Step(number, group, mount, head_deg, rate_dps, Mount.parse(mount).axis.lower())
        self._sitting.plan = plan.with_steps((*plan.steps, step))
        self._sitting.rebegin(number)

    def set_steps(self, steps: tuple[Step, ...]) -> None:
        """Measure these steps instead of those of the plan."""
        if self._sitting.keeper.session is None and not self._sitting.walk.measuring:
            self._sitting.plan = self._sitting.plan.with_steps(steps)
            self._sitting.rebegin()

    def set_session_name(self, name: str) -> None:
        """Name the session that has not begun."""
        self._sitting.set_name(name)

    def new_session(self) -> None:
        """Leave this session; the next accumulation makes a new one."""
        if not self._sitting.walk.measuring:
            self._taking.drop()
            self._results.clear()
            self._sitting.plan = self._plans.get(self._sitting.settings.plan_id, self._sitting.plan)
            self._sitting.leave()

    # --- what the operator does -------------------------------------------------------------------

    def choose(self, row: int) -> None:
        """Pick a step of the list."""
        self._taking.choose(self._sitting.plan.steps[row].number)

    def act(self, key: str) -> None:
        """A button of the row of actions, or ``"undo"``."""
        self._actions[key]()

    def process(self) -> None:
        """Calibrate what was measured, or what was loaded."""
        session, settings = self._sitting.keeper.session, self._sitting.settings
        if session is not None and session.positions:
            rows = self._sitting.rows_here
            self._results.source_path = None
            self._results.process_session(session.record, settings, rows)
        else:
            self._results.process_again(settings)

    # --- what comes from elsewhere ----------------------------------------------------------------

    def _on_device(self) -> None:
        """A device that stands in the other layout takes that layout's plan."""
        device, sitting = self._bench.device, self._sitting
        if device is not None and sitting.keeper.session is None:
            suitable = sitting.guide.plans_of(device)
            if suitable and sitting.settings.plan_id not in suitable:
                self.set_plan(suitable[0])
        self._tell()

    def _on_conditions(self, conditions: Conditions) -> None:
        """A loaded file states its own g: show it, since it is what was used."""
        settings = self._sitting.settings
        known = {field.name for field in fields(settings)}
        stated = {
            name: value
            for name in ("g_mps2", "u_g_mps2", "head_u_arcsec")
            if name in known and math.isfinite(value := getattr(conditions, name))
        }
        if self._sitting.keeper.session is None:
            self.set_settings(replace(settings, **stated))

    def _tell(self) -> None:
        self.changed.emit(self.state)


def _timed(settings: S, plan: Plan) -> S:
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
