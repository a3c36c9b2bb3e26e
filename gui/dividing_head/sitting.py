"""A session at the head: what the walk brings goes to the disk, and what is there shows the way."""

from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from core.errors import Note, Severity, StorageError
from core.plans.plan import Plan, Step
from core.procedures.measuring import Outcome
from core.procedures.recognise import Nominal
from core.records.session.events import Position, RawRange
from gui.dividing_head.bench import Bench
from gui.dividing_head.counts import Progress, progress_of, visits_of
from gui.dividing_head.cues import ACCEPT_AS, REPEAT, TAKE, doubt_banner
from gui.dividing_head.device import CLBACC
from gui.dividing_head.keeper import Keeper, free_folder, proposed_name, start_document
from gui.dividing_head.measure import Course, Walk, label_of
from gui.dividing_head.settings import HeadSettings
from gui.messages import Messages
from gui.widgets.states import BannerAction

SOURCE = "position"
STORE = BannerAction("store", "Store again")
_FLASH_MS = 1500


class Sitting(QObject):
    """Joins the walk with the session.

    Parameters
    ----------
    bench : the device
    messages : where doubts are told
    root : returns the folder of all sessions
    nominal_of : what earlier calibrations tell of a device, by its name
    """

    changed = Signal()
    cue = Signal(str)
    """``"start"``, ``"done"`` or ``"error"``: what the loudspeaker says."""
    finished = Signal()
    """The last position of the plan was accepted."""

    def __init__(
        self,
        bench: Bench,
        messages: Messages,
        root: Callable[[], Path],
        nominal_of: Callable[[str], Nominal | None],
        plan: Plan,
        settings: HeadSettings,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._bench = bench
        self._messages = messages
        self._root = root
        self._nominal_of = nominal_of
        self.plan = plan
        self.settings = settings
        self.keeper = Keeper()
        self.walk = Walk(self)
        self.pending: Outcome | None = None
        """An accumulation that was not taken, while the operator decides."""
        self.just_done: Position | None = None
        self.chosen: int | None = None
        """Number of the step that the operator picked, until it is measured."""
        self._name = ""
        self._visits: dict[int, int] = {}
        self._repeat_of: Position | None = None
        self._raw_first = 0
        self._flash = QTimer(self, singleShot=True, interval=_FLASH_MS)
        self._flash.timeout.connect(self._end_flash)
        self.walk.moved.connect(self.changed)
        self.walk.outcome.connect(self._on_outcome)
        bench.changed.connect(self.rebegin)
        bench.block.connect(self.walk.on_block)
        bench.link_changed.connect(self._on_link)
        messages.action.connect(self._on_action)

    @property
    def name(self) -> str:
        """Name of the session's folder, or of the one to come."""
        session = self.keeper.session
        if session is not None:
            return session.folder.name
        return self._name or proposed_name(self._bench.name, self.plan, datetime.now())

    @property
    def root(self) -> Path:
        """Folder of all sessions."""
        return self._root()

    def set_name(self, name: str) -> None:
        """Name the session that has not begun yet; empty takes the proposed name."""
        self._name = name.strip()
        self.changed.emit()

    @property
    def set_temperature_c(self) -> float:
        """Temperature that the chamber is set to; NaN where none is."""
        settings, device = self.settings, self._bench.device
        if device is None or not (settings.thermo or device.layout == CLBACC):
            return float("nan")
        return settings.cycle_c[settings.visit]

    @property
    def progress(self) -> Progress:
        """How far the plan is at the present temperature."""
        visit = self.settings.visit
        here = [p for p in self.keeper.positions if self._visits.get(p.id, 0) == visit]
        others = [p for p in self.keeper.positions if self._visits.get(p.id, 0) != visit]
        return progress_of(self.plan.steps, here, others, self.settings.passes)

    @property
    def rows_here(self) -> list[int] | None:
        """Which positions are of the present temperature; None where no cycle is gone through."""
        if not self.settings.thermo:
            return None
        visit = self.settings.visit
        positions = self.keeper.positions
        return [i for i, p in enumerate(positions) if self._visits.get(p.id, 0) == visit]

    def rebegin(self, current: int | None = None) -> None:
        """Make the walk anew: another device, plan, setting, or another set of positions."""
        device = self._bench.device
        if device is None:
            self.walk.end()
            return
        progress = self.progress
        nominal = self._nominal_of(self._bench.name)
        course = Course(self.plan.steps, device, self.settings, self._bench.rate, nominal)
        self.walk.begin(course, progress.before, progress.done, current)
        self.changed.emit()

    def begin(self) -> bool:
        """Make the session if there is none; return whether there is one."""
        if self.keeper.session is not None:
            return True
        profile, device = self._bench.profile, self._bench.device
        if profile is None or device is None:
            return False
        document = start_document(
            self._bench.name,
            self._bench.channels,
            self._bench.rate,
            self.plan,
            self.settings,
            profile,
            device.layout,
        )
        try:
            self.keeper.begin(free_folder(self._root(), self.name), document)
        except StorageError as error:
            self._messages.tell_error("storage", "No session can be made", error)
            return False
        self._messages.clear("storage")
        return True

    def start(self) -> None:
        """Accumulate the current step now."""
        if not self.begin():
            return
        self._drop_doubt()
        self._raw_first = self._bench.raw_size
        self.walk.start()
        self.cue.emit("start")

    def choose(self, number: int) -> None:
        """The operator picked a step."""
        self._drop_doubt()
        self._repeat_of = None
        self.chosen = number
        self.walk.choose(number)
        self.changed.emit()

    def repeat(self) -> None:
        """Measure the doubtful position again, or the last one instead of what it gave."""
        if self.pending is not None:
            number = self.pending.step.number
        else:
            self._repeat_of = self.keeper.last
            if self._repeat_of is None:
                return
            number = self._repeat_of.step.number
        self._drop_doubt()
        self.walk.choose(number)
        self.start()

    def discard(self) -> None:
        """Drop the doubtful position, else the picked one, else the last."""
        if self.pending is not None:
            number = self.pending.step.number
            self._drop_doubt()
            self.walk.choose(number)
            return
        picked = [p for p in self.keeper.positions if p.step.number == self.chosen]
        target = picked[-1] if picked else self.keeper.last
        if target is not None and self._stored(lambda: self.keeper.discard(target)):
            self._messages.log(Severity.INFO, f"{label_of(target.step)} discarded", SOURCE)
            self.rebegin(target.step.number)

    def undo(self) -> None:
        """Take the latest act back."""
        if self.keeper.can_undo and not self.walk.measuring:
            acts: list[Position] = []
            if self._stored(lambda: acts.append(self.keeper.undo())):
                self._drop_doubt()
                self.rebegin(acts[0].step.number)

    def stop(self) -> None:
        """Give up the accumulation that runs."""
        self._repeat_of = None
        self.walk.cancel()

    def resume(self, folder: Path, settings: HeadSettings) -> None:
        """Continue a session; raises `LabError`. The plan and the settings become its own."""
        session = self.keeper.resume(folder)
        steps = {step.number: step for step in session.record.start.plan.steps}
        steps.update({p.step.number: p.step for p in session.positions})
        self.plan = session.record.start.plan.with_steps(tuple(steps.values()))
        self._visits = visits_of(session.positions, settings.cycle_c)
        visit = max(self._visits.values(), default=0)
        self.settings = replace(settings, visit=visit)
        self.rebegin()

    def close(self) -> None:
        """End the session: finished if all is done, else to be continued later."""
        session = self.keeper.session
        if session is not None:
            done = self.progress.finished and bool(session.positions)
            self._stored(self.keeper.finish if done else self.keeper.close)

    def leave(self) -> None:
        """End the session; the next one begins with nothing."""
        self.close()
        self._name, self._visits, self.just_done = "", {}, None
        self._drop_doubt()
        self.rebegin()

    # --- what the walk brings ---------------------------------------------------------------------

    def _on_outcome(self, outcome: Outcome) -> None:
        if not self.begin():
            self.walk.reject(outcome)
        elif outcome.acceptable:
            self._take(outcome, outcome)
        else:
            self.pending = outcome
            self.walk.reject(outcome)
            self._messages.show(SOURCE, doubt_banner(outcome, self.plan.steps))
            self.cue.emit("error")
        self.changed.emit()

    def _take(self, outcome: Outcome, walked: Outcome) -> None:
        """Store an outcome, and only then say so."""
        superseded: tuple[int, ...] = ()
        if self._repeat_of is not None and self._repeat_of.step.number == outcome.step.number:
            superseded = (self._repeat_of.id,)
        kept: list[Position] = []
        self.pending = outcome
        if not self._stored(lambda: kept.append(self._accept(outcome, superseded))):
            self.walk.reject(walked)
            return
        self._visits[kept[0].id] = self.settings.visit
        self._repeat_of, self.chosen, self.pending = None, None, None
        self.just_done = kept[0]
        self._flash.start()
        self._messages.clear(SOURCE)
        self.walk.accept(outcome)
        self.cue.emit("done")
        progress = self.progress
        if progress.finished:
            self.finished.emit()
        elif len(progress.done) == 0:
            self.rebegin()

    def _accept(self, outcome: Outcome, superseded: tuple[int, ...]) -> Position:
        raw = None
        path = self._bench.raw_path
        if path is not None:
            self._bench.sync()
            self.keeper.attach_raw(path)
            raw = RawRange(path.name, self._raw_first, path.stat().st_size)
            self._raw_first = self._bench.raw_size
        return self.keeper.accept(
            outcome.step, outcome.accumulation, self.set_temperature_c, raw, superseded
        )

    def _stored(self, act: Callable[[], object]) -> bool:
        """Do something on the disk; tell if that fails, and return whether it worked."""
        try:
            act()
        except StorageError as error:
            again = (STORE,) if self.pending is None else ()
            self._messages.tell_error("storage", "Not stored", error, *again)
            self.cue.emit("error")
            return False
        self._messages.clear("storage")
        session = self.keeper.session
        if session is not None and session.legacy_error is not None:
            self._messages.tell_error("legacy", "The text file is behind", session.legacy_error)
        return True

    def _on_action(self, source: str, key: str) -> None:
        outcome = self.pending
        if source not in (SOURCE, "storage") or outcome is None:
            return
        if key == REPEAT.key:
            self.repeat()
        elif key == TAKE.key:
            self._take(_noted(outcome, outcome.step, "taken by the operator"), outcome)
        elif key == STORE.key:
            self._take(outcome, outcome)
        elif key.startswith(ACCEPT_AS):
            step = self.plan.step(int(key.removeprefix(ACCEPT_AS)))
            words = f"accumulated for {label_of(outcome.step)}, recorded as {label_of(step)}"
            self._take(_noted(outcome, step, words), outcome)
        self.changed.emit()

    def _on_link(self) -> None:
        if not self._bench.linked:
            self.walk.interrupted()
        self.changed.emit()

    def _drop_doubt(self) -> None:
        self.pending = None
        self._messages.clear(SOURCE)

    def _end_flash(self) -> None:
        self.just_done = None
        self.changed.emit()


def _noted(outcome: Outcome, step: Step, words: str) -> Outcome:
    """The outcome under a step, with what the operator decided."""
    text = f"{outcome.recognition.text}: {words}" if outcome.recognition.text else words
    note = Note(Severity.WARNING, "taken_anyway", text)
    return replace(outcome, step=step, accumulation=outcome.accumulation.with_note(note))
