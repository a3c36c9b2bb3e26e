"""Sessions that wait to be continued, and going on with one."""

from datetime import datetime

from PySide6.QtCore import QObject, Signal

from core.errors import Severity
from core.records.session.find import Unfinished
from gui.messages import Messages
from gui.widgets.states import BannerAction, BannerState

RESUME = BannerAction("resume", "Continue it")
LEAVE = BannerAction("leave", "Leave it")


class Resuming(QObject):
    """Offers the newest unfinished session, once, at the start of the program.

    Parameters
    ----------
    key, tests, nouns : of the tab's guide and its words: whose sessions, what they are made of
    messages : where it is offered
    """

    chosen = Signal(object)
    """`Unfinished` that the operator wants to continue."""

    def __init__(
        self,
        key: str,
        tests: tuple[str, ...],
        nouns: str,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._source = f"{key} unfinished"
        self._tests = tests
        self._nouns = nouns
        self._messages = messages
        self._offered: Unfinished | None = None
        messages.action.connect(self._on_action)

    def offer(self, waiting: tuple[Unfinished, ...]) -> None:
        """Tell of what waits."""
        good = [one for one in waiting if one.record is not None and one.done]
        own = [one for one in good if one.record and one.record.start.plan.test in self._tests]
        if not own:
            return
        self._offered = own[0]
        self._messages.show(self._source, _banner(own[0], len(own) - 1, self._nouns))

    def withdraw(self) -> None:
        """Another session has begun: the offer is over."""
        self._offered = None
        self._messages.clear(self._source)

    def _on_action(self, source: str, key: str) -> None:
        offered = self._offered
        if source != self._source or offered is None:
            return
        self.withdraw()
        if key == RESUME.key:
            self.chosen.emit(offered)


def _banner(one: Unfinished, others: int, nouns: str) -> BannerState:
    record = one.record
    if record is None:
        raise ValueError("a session that cannot be read is not offered")
    started = datetime.fromisoformat(record.start.started)
    total = len(record.start.plan.steps)
    more = f" {others} older ones wait in the folder of sessions." if others else ""
    return BannerState(
        Severity.INFO,
        f"A session of {record.start.device} is not finished",
        f"Begun {started:%Y-%m-%d %H:%M}, {one.done} of {total} {nouns} are on the disk.{more}",
        "",
        (RESUME, LEAVE),
    )
