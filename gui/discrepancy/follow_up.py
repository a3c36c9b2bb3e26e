"""What to measure next, as a plan: opened in its tab, or kept among the user's own."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from core.discrepancy.result import NextMeasurement
from core.errors import LabError, Severity, StorageError
from core.plans.plan import OWN_PLANS, Plan
from core.plans.plan_text import plan_text
from core.records.atomic import make_folder, write_text_atomic
from core.records.names import safe_name
from gui.discrepancy.cards import measurements_of
from gui.discrepancy.working import Story
from gui.messages import Messages
from gui.widgets.states import BannerState

SOURCE = "discrepancy plan"


class FollowUp(QObject):
    """Opens and keeps the plans of what to measure next.

    Parameters
    ----------
    story : returns what is on the page
    open_plan : hands a plan to the tab that measures it; returns whether one took it
    root : returns the folder of all sessions; the user's plans stand in its folder ``plans``
    messages : where it is told
    """

    def __init__(
        self,
        story: Callable[[], Story | None],
        open_plan: Callable[[Plan], bool],
        root: Callable[[], Path],
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._story = story
        self._open_plan = open_plan
        self._root = root
        self._messages = messages

    def open(self, place: int) -> None:
        """Hand one of the next measurements to the tab that measures it."""
        plan = self._plan(place)
        if plan is None:
            return
        self._messages.clear(SOURCE)
        if not self._open_plan(plan):
            what = QCoreApplication.translate("Discrepancy", "No tab can take this plan now")
            meaning = QCoreApplication.translate(
                "Discrepancy", "A session holds another plan, or an accumulation is running."
            )
            self._messages.show(SOURCE, BannerState(Severity.WARNING, what, meaning))

    def keep(self, place: int) -> None:
        """Keep one of them among the user's own plans."""
        plan, story = self._plan(place), self._story()
        if plan is None or story is None:
            return
        try:
            path = keep_plan(plan, story.run.device, self._root() / OWN_PLANS)
        except LabError as error:
            words = QCoreApplication.translate("Discrepancy", "The plan is not kept")
            self._messages.tell_error(SOURCE, words, error)
            return
        words = QCoreApplication.translate("Discrepancy", "The plan is kept")
        meaning = QCoreApplication.translate(
            "Discrepancy", "{path}: after the next start it stands among the plans of its tab."
        )
        self._messages.show(SOURCE, BannerState(Severity.INFO, words, meaning.format(path=path)))

    def _plan(self, place: int) -> Plan | None:
        story = self._story()
        return None if story is None else plan_of(measurements_of(story)[place])


def plan_of(measurement: NextMeasurement) -> Plan | None:
    """The steps of a next measurement; None for one that is a profile over time."""
    plan: object = measurement.plan
    return plan if isinstance(plan, Plan) else None


def keep_plan(plan: Plan, device: str, folder: Path) -> Path:
    """Write a plan under a name that no other has; one that stands there already is left.

    Raises
    ------
    StorageError
        It cannot be written.
    """
    make_folder(folder)
    stem = safe_name(f"{device}_{plan.id}")
    for count in range(1, 1000):
        plan_id = stem if count == 1 else f"{stem}_{count}"
        path = folder / f"{plan_id}.toml"
        text = plan_text(replace(plan, id=plan_id, title=f"{plan.title} ({device})"))
        if not path.exists():
            write_text_atomic(path, text)
            return path
        if path.read_text(encoding="utf-8") == text:
            return path
    raise StorageError(f"{folder}: a thousand plans are named {stem}; take some away")
