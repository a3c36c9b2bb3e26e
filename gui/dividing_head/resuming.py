"""Sessions that wait to be continued, and going on with one."""

import math
from datetime import datetime

from PySide6.QtCore import QObject, Signal

from core.errors import Severity
from core.plans.orientation import BaseOrientation
from core.records.session.find import Unfinished
from core.records.session.start import SessionStart
from gui.dividing_head.settings import TILTERS, HeadSettings, Tilter
from gui.messages import Messages
from gui.settings import number_of, text_of
from gui.widgets.states import BannerAction, BannerState

SOURCE = "unfinished"
RESUME = BannerAction("resume", "Continue it")
LEAVE = BannerAction("leave", "Leave it")


class Resuming(QObject):
    """Offers the newest unfinished session, once, at the start of the program."""

    chosen = Signal(object)
    """`Unfinished` that the operator wants to continue."""

    def __init__(self, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._messages = messages
        self._offered: Unfinished | None = None
        messages.action.connect(self._on_action)

    def offer(self, waiting: tuple[Unfinished, ...]) -> None:
        """Tell of what waits; damaged sessions go to the log."""
        for one in waiting:
            if one.record is None:
                self._messages.log(Severity.WARNING, one.problem, SOURCE)
        good = [one for one in waiting if one.record is not None and one.done]
        of_head = [one for one in good if one.record and one.record.start.plan.test == _TEST]
        if not of_head:
            return
        self._offered = of_head[0]
        self._messages.show(SOURCE, _banner(of_head[0], len(of_head) - 1))

    def withdraw(self) -> None:
        """Another session has begun: the offer is over."""
        self._offered = None
        self._messages.clear(SOURCE)

    def _on_action(self, source: str, key: str) -> None:
        offered = self._offered
        if source != SOURCE or offered is None:
            return
        self.withdraw()
        if key == RESUME.key:
            self.chosen.emit(offered)


_TEST = "dividing_head"


def _banner(one: Unfinished, others: int) -> BannerState:
    record = one.record
    if record is None:
        raise ValueError("a session that cannot be read is not offered")
    started = datetime.fromisoformat(record.start.started)
    total = len(record.start.plan.steps)
    more = f" {others} older ones wait in the folder of sessions." if others else ""
    return BannerState(
        Severity.INFO,
        f"A session of {record.start.device} is not finished",
        f"Begun {started:%d.%m.%Y %H:%M}, {one.done} of {total} positions are on the disk.{more}",
        "",
        (RESUME, LEAVE),
    )


def settings_of_session(start: SessionStart, screen: HeadSettings) -> HeadSettings:
    """The settings that a session was begun with; what it does not state stays as it is."""
    conditions, extra = start.conditions, start.settings
    tilter = start.tilter
    mode = text_of(tilter, "mode", "None")
    return HeadSettings(
        plan_id=start.plan.id,
        passes=round(number_of(extra, "passes", 1, 1, 9)),
        accumulation_s=_or(conditions.accumulation_s, screen.accumulation_s),
        settle_s=number_of(extra, "settle_s", screen.settle_s, 0, 600),
        g_mps2=_or(conditions.g_mps2, screen.g_mps2),
        u_g_mps2=_or(conditions.u_g_mps2, screen.u_g_mps2),
        head_u_arcsec=_or(conditions.head_u_arcsec, screen.head_u_arcsec),
        base=BaseOrientation(
            start.base.alpha_arcmin,
            start.base.beta_arcmin,
            start.base.gamma_deg,
            start.base.psi_deg,
        ),
        thermo=extra.get("thermo") is True,
        cycle_c=start.plan.temperatures_c or screen.cycle_c,
        tilter=Tilter(
            mode if mode in TILTERS else "None",
            round(number_of(tilter, "number", 1, 1, 99)),
            round(number_of(tilter, "position", 1, 1, 99)),
            number_of(tilter, "psi_deg", 0, -360, 360),
            number_of(tilter, "theta_deg", 0, -360, 360),
            number_of(tilter, "gamma_deg", 0, -360, 360),
        ),
        hands_free=screen.hands_free,
    )


def _or(value: float, otherwise: float) -> float:
    return value if math.isfinite(value) else otherwise
