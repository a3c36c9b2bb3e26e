"""An operator for the simulated rig: does what a step of a plan asks, as a person would."""

import numpy as np

from core.plans.plan import Plan, Step
from core.units import ARCSEC_PER_DEG
from drivers.virtual.bench import Manner
from drivers.virtual.rig import Rig

_ON_THE_TABLE = "rate_table"
_NEARLY_DEG = 2.0


class Operator:
    """Turns the head, re-mounts the unit and sets the table.

    Parameters
    ----------
    rig : where
    plan : what is being measured
    seed : of the hesitations and setting errors
    setting_arcsec : standard deviation of the angle that is really set on the head
    """

    def __init__(self, rig: Rig, plan: Plan, *, seed: int = 0, setting_arcsec: float = 0.0) -> None:
        self._rig = rig
        self._plan = plan
        self._rng = np.random.default_rng([seed, 0x0FE8])
        self._setting_deg = setting_arcsec / ARCSEC_PER_DEG
        self._mount = rig.state.mount

    def goto(self, step: Step) -> float:
        """Begin to set a step; return the seconds of the rig until all will be at rest."""
        manner = self._rig.options.manner
        t = self._hesitation()
        if step.mount != self._mount:
            t = self._stop_table(t, manner)
            self._rig.remount(step.mount, after_s=t)
            self._mount = step.mount
            t += manner.remount_s + self._hesitation()
        if self._plan.test == _ON_THE_TABLE:
            return self._spin(step, t, manner)
        return self._turn(step, t, manner)

    def _turn(self, step: Step, t: float, manner: Manner) -> float:
        """Turn nearly there, look, and set the angle."""
        error = self._setting_deg * self._rng.standard_normal()
        nearly = step.head_deg + _NEARLY_DEG * self._rng.uniform(-1.0, 1.0)
        self._rig.turn(nearly, after_s=t)
        t += 180.0 / manner.head_dps + self._hesitation()
        self._rig.turn(step.head_deg + error, after_s=t)
        return t + _NEARLY_DEG / manner.head_dps

    def _spin(self, step: Step, t: float, manner: Manner) -> float:
        if step.head_deg != self._rig.state.head_target_deg:
            self._rig.turn(step.head_deg, after_s=t)
            t += 180.0 / manner.head_dps
        self._rig.spin(step.rate_dps, step.axis, after_s=t)
        change = abs(step.rate_dps - self._rig.state.table_target_dps)
        return t + change / manner.table_dps2

    def _stop_table(self, t: float, manner: Manner) -> float:
        """Nobody bolts a unit on anew while the table turns."""
        state = self._rig.state
        if not state.axis or not state.table_target_dps:
            return t
        self._rig.spin(0.0, state.axis, after_s=t)
        return t + abs(state.table_target_dps) / manner.table_dps2 + self._hesitation()

    def _hesitation(self) -> float:
        return float(self._rng.uniform(0.4, 1.2))
