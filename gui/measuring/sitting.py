"""A session at the rig: the plan, the settings, the walk, and the folder on the disk."""

from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Generic

from PySide6.QtCore import QObject, Signal

from core.errors import Severity, StorageError
from core.plans.plan import Plan
from core.procedures.recognise import Nominal
from core.records.session.events import Position
from core.records.session.start import SessionStart
from gui.measuring.bench import Bench
from gui.measuring.counts import Progress, progress_of, visits_of
from gui.measuring.guide import Guide, S
from gui.measuring.keeper import Keeper, free_folder, proposed_name, start_document
from gui.measuring.walk import Walk
from gui.messages import Messages
from gui.widgets.states import BannerState


class Sitting(Generic[S], QObject):
    """What is measured, how far it is, and where it is kept.

    Parameters
    ----------
    guide : what is particular to the test
    bench : the device
    messages : where troubles are told
    root : returns the folder of all sessions
    plan, settings : to begin with
    """

    changed = Signal()

    def __init__(
        self,
        guide: Guide[S],
        bench: Bench,
        messages: Messages,
        root: Callable[[], Path],
        plan: Plan,
        settings: S,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.guide = guide
        self._bench = bench
        self._messages = messages
        self._storage = f"{guide.key} storage"
        self._other = f"{guide.key} other device"
        self._root = root
        self.plan = plan
        self.settings = settings
        self.operator = ""
        """Who measures, as every session states."""
        self.keeper = Keeper()
        self.walk = Walk(self)
        self._name = ""
        self._visits: dict[int, int] = {}
        self._known: tuple[str, Nominal | None] | None = None
        self.walk.moved.connect(self.changed)
        bench.changed.connect(self._on_device)
        bench.block.connect(self.walk.on_block)
        bench.link_changed.connect(self._on_link)

    @property
    def root(self) -> Path:
        """Folder of all sessions."""
        return self._root()

    @property
    def name(self) -> str:
        """Name of the session's folder, or of the one to come."""
        session = self.keeper.session
        if session is not None:
            return session.folder.name
        return self._name or proposed_name(self._bench.name, self.plan, datetime.now())

    def set_name(self, name: str) -> None:
        """Name the session that has not begun yet; empty takes the proposed name."""
        self._name = name.strip()
        self.changed.emit()

    @property
    def set_temperature_c(self) -> float:
        """Temperature that the chamber is set to; NaN where none is."""
        settings, device = self.settings, self._bench.device
        if device is None or not self.guide.thermal(device, settings):
            return float("nan")
        return settings.cycle_c[settings.visit]

    @property
    def positions_here(self) -> list[Position]:
        """Positions that count, of the present visit to a temperature."""
        visit = self.settings.visit
        return [p for p in self.keeper.positions if self._visits.get(p.id, 0) == visit]

    @property
    def rows_here(self) -> list[int] | None:
        """Their places in the session's run; None where no cycle is gone through."""
        if not self.settings.thermo:
            return None
        here = {position.id for position in self.positions_here}
        return [i for i, p in enumerate(self.keeper.positions) if p.id in here]

    @property
    def progress(self) -> Progress:
        """How far the plan is at the present temperature."""
        here = self.positions_here
        ids = {position.id for position in here}
        others = [p for p in self.keeper.positions if p.id not in ids]
        return progress_of(self.plan.steps, here, others, self.settings.passes)

    def belongs_here(self, position: Position) -> None:
        """A position was accepted at the present temperature."""
        self._visits[position.id] = self.settings.visit

    def begin(self) -> bool:
        """Make the session if there is none; return whether there is one."""
        if self.keeper.session is not None:
            return True
        profile, device = self._bench.profile, self._bench.device
        if profile is None or device is None:
            return False
        document = start_document(
            self._bench.name,
            self.guide.sensor,
            self._bench.channels,
            self._bench.rate,
            self.plan,
            self.settings,
            profile,
            device.layout,
            self.operator,
        )
        folder = free_folder(self._root(), self.name)
        return self.stored(lambda: self.keeper.begin(folder, document), "No session can be made")

    def rebegin(self, current: int | None = None) -> None:
        """Make the walk anew: another device, plan, setting, or another set of positions.

        Parameters
        ----------
        current : number of the step to stand at; None for the first that is to be done
        """
        device = self._bench.device
        if device is None or not self._fits():
            self.walk.end()
        else:
            progress = self.progress
            nominal = self._known_of()
            course = self.guide.course(self.plan, device, self.settings, self._bench.rate, nominal)
            self.walk.begin(course, progress.before, progress.done, current)
        self.changed.emit()

    def resume(self, folder: Path, settings: S) -> None:
        """Continue a session; raises `LabError`. The plan and the settings become its own."""
        session = self.keeper.resume(folder)
        plan = session.record.start.plan
        steps = {step.number: step for step in plan.steps}
        steps.update({p.step.number: p.step for p in session.positions})
        self.plan = plan.with_steps(tuple(steps.values()))
        self._visits = visits_of(session.positions, settings.cycle_c)
        visit = max(self._visits.values(), default=0)
        self.settings = replace(settings, visit=visit)
        for note in session.record.notes:
            self._messages.log(note.severity, note.text, "session")
        self.rebegin()

    def close(self) -> None:
        """End the session: finished if all is done, else to be continued later."""
        session = self.keeper.session
        if session is not None:
            done = self.progress.finished and bool(session.positions)
            self.stored(self.keeper.finish if done else self.keeper.close)

    def leave(self) -> None:
        """End the session; the next one begins with nothing."""
        self.close()
        self._name, self._visits, self._known = "", {}, None
        self._messages.clear(self._other)
        self.rebegin()

    def stored(self, act: Callable[[], object], what: str = "Not stored") -> bool:
        """Do something on the disk; tell if that fails, and return whether it worked."""
        try:
            act()
        except StorageError as error:
            self._messages.tell_error(self._storage, what, error)
            return False
        self._messages.clear(self._storage)
        session = self.keeper.session
        if session is not None and session.legacy_error is not None:
            self._messages.tell_error("legacy", "The text file is behind", session.legacy_error)
        return True

    def _known_of(self) -> Nominal | None:
        """What is known of the device beforehand; looked up once a session."""
        name = self._bench.name
        if self._known is None or self._known[0] != name:
            self._known = (name, self.guide.nominal(self._root(), name))
        return self._known[1]

    def _fits(self) -> bool:
        """Whether the device can go on with the session that is open."""
        session = self.keeper.session
        if session is None:
            return True
        start = session.record.start
        if start.channels != self._bench.channels:
            self._messages.show(self._other, _other_banner(start, self._bench.name))
            return False
        self._messages.clear(self._other)
        return True

    def _on_device(self) -> None:
        self.rebegin()

    def _on_link(self) -> None:
        if not self._bench.linked:
            self.walk.interrupted()
        self.changed.emit()


def _other_banner(start: SessionStart, name: str) -> BannerState:
    return BannerState(
        Severity.WARNING,
        f"{name} cannot go on with the session of {start.device}",
        "It sends other channels.",
        "Connect the unit that the session was begun with, or press New session.",
    )
