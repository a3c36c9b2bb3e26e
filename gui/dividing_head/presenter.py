"""The dividing-head tab: clicks in, `HeadState` out."""

import math
from collections.abc import Mapping
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from core.plans.plan import Plan, Step
from core.samples.run import Conditions
from gui.dividing_head.bench import Bench
from gui.dividing_head.results import ResultsPresenter
from gui.dividing_head.scene import head_state
from gui.dividing_head.settings import HeadSettings, settings_of
from gui.dividing_head.sitting import Sitting
from gui.dividing_head.state import HeadState, LiveState
from gui.dividing_head.taking import Taking
from gui.settings import Settings

SECTION = "dividing_head"
_PLANS_OF = {
    "clbacc": ("accelerometer_8", "accelerometer_4", "clbacc_24", "thermal_8"),
    "pointer": ("pointer_8", "pointer_16", "accelerometer_8", "accelerometer_4", "thermal_8"),
}
"""Plans that are kept when a device of a layout comes; the first is taken instead of others."""


class HeadPresenter(QObject):
    """Everything the view asks for.

    Parameters
    ----------
    bench : the device
    sitting : the session
    taking : what becomes of accumulations
    results : what is made of the session
    plans : those of the dividing head, by id
    settings : where the operator's choices are remembered
    """

    changed = Signal(object)
    """A new `HeadState`."""

    def __init__(
        self,
        bench: Bench,
        sitting: Sitting,
        taking: Taking,
        results: ResultsPresenter,
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
    def state(self) -> HeadState:
        """The tab as it is now."""
        return head_state(self._bench, self._sitting, self._taking, self._results, self._plans)

    def live(self) -> LiveState:
        """The live table as it is now."""
        live = self._bench.live
        return LiveState() if live is None else live.state(self._results.mg_per_unit)

    @property
    def folder(self) -> str:
        """Where to look for files to load."""
        return str(self._sitting.root)

    # --- what the operator sets -------------------------------------------------------------------

    def set_settings(self, settings: HeadSettings) -> None:
        """Take the fields of the settings panel."""
        sitting = self._sitting
        if settings == sitting.settings or sitting.walk.measuring:
            return
        if settings.plan_id != sitting.settings.plan_id and settings.plan_id in self._plans:
            sitting.plan = self._plans[settings.plan_id]
            settings = _for_plan(settings, sitting.plan)
        sitting.settings = replace(settings, visit=min(settings.visit, len(settings.cycle_c) - 1))
        self._settings.store(SECTION, sitting.settings.to_section())
        sitting.rebegin()

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
            self._results.process_session(session.record, settings, rows)
        else:
            self._results.process_again(settings)

    # --- what comes from elsewhere ----------------------------------------------------------------

    def _on_device(self) -> None:
        """A device that stands in the other layout takes that layout's plan."""
        device, sitting = self._bench.device, self._sitting
        if device is not None and sitting.keeper.session is None:
            plans = _PLANS_OF[device.layout]
            if sitting.settings.plan_id not in plans:
                self.set_plan(plans[0])
        self._tell()

    def _on_conditions(self, conditions: Conditions) -> None:
        """A loaded file states its own g: show it, since it is what was used."""
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

    def _tell(self) -> None:
        self.changed.emit(self.state)


def _for_plan(settings: HeadSettings, plan: Plan) -> HeadSettings:
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


def remembered(settings: Settings) -> HeadSettings:
    """The choices of the last time."""
    return settings_of(settings.section(SECTION))
