"""Orders to the simulated rig, and an operator who turns the head by himself."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, QTimer, Signal

from core.model.stimulus import TABLE
from core.plans.orientation import Mount
from core.plans.plan import Plan, Step
from drivers.virtual.address import rig_of
from drivers.virtual.faults import Faults
from drivers.virtual.operator import Operator
from drivers.virtual.rig import Rig, RigState
from gui.devices.connection import Connection

_PERIOD_MS = 100
_BURST_MS = 700
_THERE = 1e-6
NOISY = Faults(bit_error=2e-4, garbage=0.05, half=0.02)
DROPPING = Faults(drop=0.05)


@dataclass(frozen=True, slots=True)
class RigView:
    """What the dock shows.

    Parameters
    ----------
    rig : the rig as it stands
    operator : whether somebody turns the head for the user
    fault : ``""``, ``"noise"``, ``"drop"`` or ``"stuck"``
    """

    rig: RigState
    operator: bool
    fault: str


class RigPresenter(QObject):
    """Follows the port: there is a rig only behind a simulated one.

    Parameters
    ----------
    connection : whose port it is
    wanted : returns what the test wants to be set now; None for nothing
    """

    changed = Signal(object)
    """A new `RigView`, ten times a second; None without a rig."""

    def __init__(
        self,
        connection: Connection,
        wanted: Callable[[], tuple[Plan, Step] | None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._connection = connection
        self._wanted = wanted
        self._rig: Rig | None = None
        self._operator = False
        self._fault = ""
        self._at: tuple[Plan, Step] | None = None
        self._hand: Operator | None = None
        self._timer = QTimer(self)
        self._timer.setInterval(_PERIOD_MS)
        self._timer.timeout.connect(self._look)
        self._mend = QTimer(self, singleShot=True, interval=_BURST_MS)
        self._mend.timeout.connect(self._on_burst_over)
        connection.changed.connect(self.follow)

    @property
    def rig(self) -> Rig | None:
        """The rig behind the port."""
        return self._rig

    def turn(self, head_deg: float) -> None:
        """Turn the head."""
        if self._rig is not None:
            self._rig.turn(head_deg)

    def remount(self, mount: str) -> None:
        """Bolt the unit on another way."""
        if self._rig is not None:
            self._rig.remount(mount)

    def heat(self, celsius: float) -> None:
        """Set the chamber, and have the unit at its temperature at once."""
        if self._rig is not None:
            self._rig.be_at(celsius)

    def spin(self, rate_dps: float) -> None:
        """Put the unit on the rate table, the axis of its mount upright, and turn it."""
        if self._rig is not None:
            axis = self._rig.state.axis or Mount.parse(self._rig.state.mount).axis.lower()
            self._rig.spin(rate_dps, axis)

    def set_plugged(self, plugged: bool) -> None:
        """Pull the cable, or put it back."""
        if self._rig is not None:
            (self._rig.plug_in if plugged else self._rig.unplug)()
            self._look()

    def burst(self) -> None:
        """Noise on the line for a moment."""
        if self._rig is not None:
            self._rig.fail(NOISY)
            self._mend.start()

    def set_fault(self, fault: str) -> None:
        """Let one thing go wrong from now on; an empty name mends all."""
        self._fault = fault
        self._mend.stop()
        if self._rig is not None:
            self._rig.fail(self._faults())
        self._look()

    def set_operator(self, on: bool) -> None:
        """Let somebody turn the head to every position that the test wants."""
        self._operator = on
        self._at = None
        self._look()

    def _faults(self) -> Faults:
        if self._fault == "stuck":
            return replace(Faults(), stuck=(0,))
        return {"noise": NOISY, "drop": DROPPING}.get(self._fault, Faults())

    def _on_burst_over(self) -> None:
        if self._rig is not None:
            self._rig.fail(self._faults())

    def follow(self) -> None:
        """Look whether the port is simulated, and which rig stands behind it."""
        link = self._connection.link
        simulated = link is not None and link.setup.simulated
        self._rig = rig_of(link.setup.url) if link is not None and simulated else None
        self._at, self._hand, self._fault = None, None, ""
        if self._rig is not None:
            self._timer.start()
        else:
            self._timer.stop()
        self._look()

    def _look(self) -> None:
        rig = self._rig
        if rig is None:
            self.changed.emit(None)
            return
        if self._operator:
            self._turn_for_the_user(rig)
        self.changed.emit(RigView(rig.state, self._operator, self._fault))

    def _turn_for_the_user(self, rig: Rig) -> None:
        wanted = self._wanted()
        if wanted is None or wanted == self._at:
            return
        plan, step = wanted
        if self._hand is None or self._at is None or self._at[0] is not plan:
            self._hand = Operator(rig, plan)
        self._at = wanted
        state = rig.state
        there = state.mount == step.mount and abs(state.head_target_deg - step.head_deg) < _THERE
        if plan.test == TABLE:
            turning = state.table_target_dps if state.axis == step.axis else math.nan
            there = there and abs(turning - step.rate_dps) < _THERE
        elif state.axis:
            there = False
        if not there or state.moving:
            self._hand.goto(step)
