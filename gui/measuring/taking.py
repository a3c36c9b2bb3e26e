"""What becomes of an accumulation: taken, doubted, repeated, discarded, taken back."""

from dataclasses import replace
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from core.errors import Note, Severity
from core.plans.plan import Step
from core.procedures.measuring import Outcome, Phase
from core.records.session.events import Position, RawRange
from gui.measuring.bench import Bench
from gui.measuring.cues import (
    ACCEPT_AS,
    MEASURE,
    NEXT,
    REPEAT,
    TAKE,
    doubt_banner,
    elsewhere_banner,
    next_temperature_banner,
)
from gui.measuring.sitting import Sitting
from gui.measuring.words import Words
from gui.messages import Messages
from gui.widgets.states import BannerAction, BannerState

STORE = BannerAction("store", "Store again")
_FLASH_MS = 1500


class Taking(QObject):
    """Decides on outcomes as far as a program may, and asks the operator about the rest.

    Parameters
    ----------
    sitting : whose walk brings outcomes, and where they are kept
    bench : the device
    messages : where the operator is asked
    """

    changed = Signal()
    cue = Signal(str)
    """``"start"``, ``"done"`` or ``"error"``: what the loudspeaker says."""

    def __init__(
        self, sitting: Sitting[Any], bench: Bench, messages: Messages, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._sitting = sitting
        self._bench = bench
        self._messages = messages
        self._source = f"{sitting.guide.key} position"
        self._not_stored = f"{sitting.guide.key} not stored"
        self.pending: Outcome | None = None
        """An accumulation that was not taken, while the operator decides."""
        self.just_done: Position | None = None
        """The position that was accepted a moment ago."""
        self.chosen: int | None = None
        """Number of the step that the operator picked, until it is measured."""
        self._repeat_of: Position | None = None
        self._raw_first = 0
        self._was: tuple[Phase, tuple[int, ...]] = (Phase.READY, ())
        self._flash = QTimer(self, singleShot=True, interval=_FLASH_MS)
        self._flash.timeout.connect(self._end_flash)
        sitting.walk.moved.connect(self._on_moved)
        sitting.walk.outcome.connect(self._on_outcome)
        messages.action.connect(self._on_action)

    # --- what the operator does -------------------------------------------------------------------

    def start(self) -> None:
        """Accumulate the current step now."""
        if self._sitting.begin():
            self._bench.catch_up()
            self._sitting.walk.start()

    def stop(self) -> None:
        """Give up the accumulation that runs."""
        self._repeat_of = None
        self._sitting.walk.cancel()

    def choose(self, number: int) -> None:
        """The operator picked a step."""
        self.drop()
        self._repeat_of = None
        self.chosen = number
        self._sitting.walk.choose(number)
        self.changed.emit()

    def repeat(self) -> None:
        """Measure the doubtful position again, or the last one instead of what it gave."""
        if self.pending is not None:
            number = self.pending.step.number
        else:
            self._repeat_of = self._sitting.keeper.last
            if self._repeat_of is None:
                return
            number = self._repeat_of.step.number
        self.drop()
        self._sitting.walk.choose(number)
        self.start()

    def discard(self) -> None:
        """Drop the doubtful position, else the picked one, else the last."""
        sitting = self._sitting
        if self.pending is not None:
            number = self.pending.step.number
            self.drop()
            sitting.walk.choose(number)
            return
        picked = [p for p in sitting.positions_here if p.step.number == self.chosen]
        target = picked[-1] if picked else sitting.keeper.last
        if target is not None and sitting.stored(lambda: sitting.keeper.discard(target)):
            self._messages.log(Severity.INFO, f"{self._label(target.step)} discarded", self._source)
            sitting.rebegin(target.step.number)

    def undo(self) -> None:
        """Take the latest act back."""
        sitting = self._sitting
        if sitting.keeper.can_undo and not sitting.walk.measuring:
            acts: list[Position] = []
            if sitting.stored(lambda: acts.append(sitting.keeper.undo())):
                self.drop()
                self._messages.log(
                    Severity.INFO, f"{self._label(acts[0].step)} taken back", self._source
                )
                sitting.rebegin(acts[0].step.number)

    def drop(self) -> None:
        """Nothing is doubted any more."""
        self.pending = None
        self._messages.clear(self._source)
        self._messages.clear(self._not_stored)

    # --- what the walk brings ---------------------------------------------------------------------

    def _on_moved(self) -> None:
        status = self._sitting.walk.status
        if status is None or (status.phase, status.candidates) == self._was:
            return
        before, self._was = self._was[0], (status.phase, status.candidates)
        if status.phase is Phase.WRONG:
            if self.pending is None and status.text and status.step is not None:
                banner = elsewhere_banner(status.text, status.candidates, status.step, self._words)
                self._messages.show(self._source, banner)
                if before is not Phase.WRONG:
                    self.cue.emit("error")
        elif status.phase is Phase.MEASURING:
            self.drop()
            self._raw_first = self._bench.raw_size
            self.cue.emit("start")
        elif status.phase in (Phase.MOVING, Phase.SETTLING) and self.pending is None:
            self._messages.clear(self._source)

    def _on_outcome(self, outcome: Outcome) -> None:
        sitting = self._sitting
        outcome = sitting.guide.reviewed(outcome, sitting.plan)
        self.pending = outcome
        if outcome.acceptable:
            self._take(outcome)
            return
        sitting.walk.reject(outcome)
        self._messages.show(self._source, doubt_banner(outcome, sitting.plan.steps, self._words))
        self.cue.emit("error")
        self.changed.emit()

    def _take(self, outcome: Outcome) -> None:
        """Store an outcome, and only then say so."""
        sitting = self._sitting
        kept: list[Position] = []
        if not (sitting.begin() and sitting.stored(lambda: kept.append(self._accept(outcome)))):
            self._ask_to_store(outcome)
            return
        sitting.belongs_here(kept[0])
        self._repeat_of, self.chosen = None, None
        self.just_done = kept[0]
        self._flash.start()
        self.drop()
        sitting.walk.accept(outcome)
        self.cue.emit("done")
        progress = sitting.progress
        if progress.finished:
            self._finished()
        elif not progress.done:
            sitting.rebegin()
        self.changed.emit()

    def _accept(self, outcome: Outcome) -> Position:
        superseded: tuple[int, ...] = ()
        if self._repeat_of is not None and self._repeat_of.step.number == outcome.step.number:
            superseded = (self._repeat_of.id,)
        raw = None
        path = self._bench.raw_path
        keeper = self._sitting.keeper
        if path is not None:
            self._bench.sync()
            keeper.attach_raw(path)
            raw = RawRange(path.name, self._raw_first, path.stat().st_size)
        temperature = self._sitting.set_temperature_c
        return keeper.accept(outcome.step, outcome.accumulation, temperature, raw, superseded)

    def _ask_to_store(self, outcome: Outcome) -> None:
        self.pending = outcome
        self._sitting.walk.reject(outcome)
        self._messages.show(
            self._not_stored,
            BannerState(
                Severity.ERROR,
                f"{self._label(outcome.step)} is measured, but not on the disk".capitalize(),
                "It is held in memory until it is stored or measured again.",
                "Make room on the disk, then store it again.",
                (STORE, REPEAT),
                closable=False,
            ),
        )
        self.cue.emit("error")
        self.changed.emit()

    def _finished(self) -> None:
        settings = self._sitting.settings
        after = settings.visit + 1
        if settings.thermo and after < len(settings.cycle_c):
            banner = next_temperature_banner(
                self._sitting.set_temperature_c, settings.cycle_c[after], self._words.nouns
            )
            self._messages.show(self._source, banner)

    def _on_action(self, source: str, key: str) -> None:
        if source not in (self._source, self._not_stored):
            return
        if key == NEXT.key:
            self._next_temperature()
        elif key.startswith(MEASURE):
            self.choose(int(key.removeprefix(MEASURE)))
        elif key == REPEAT.key:
            self.repeat()
        elif self.pending is not None:
            self._decide(self.pending, key)
        self.changed.emit()

    def _decide(self, outcome: Outcome, key: str) -> None:
        if key == STORE.key:
            self._take(outcome)
        elif key == TAKE.key:
            self._take(_noted(outcome, outcome.step, "taken by the operator"))
        elif key.startswith(ACCEPT_AS):
            step = self._sitting.plan.step(int(key.removeprefix(ACCEPT_AS)))
            words = f"accumulated for {self._label(outcome.step)}, recorded as {self._label(step)}"
            self._take(_noted(outcome, step, words))

    def _next_temperature(self) -> None:
        self.drop()
        settings = self._sitting.settings
        self._sitting.settings = replace(settings, visit=settings.visit + 1)
        self._sitting.rebegin()

    @property
    def _words(self) -> Words:
        return self._sitting.guide.words(self._sitting.plan)

    def _label(self, step: Step) -> str:
        return self._words.label(step)

    def _end_flash(self) -> None:
        self.just_done = None
        self.changed.emit()


def _noted(outcome: Outcome, step: Step, words: str) -> Outcome:
    """The outcome under a step, with what the operator decided."""
    text = f"{outcome.recognition.text}: {words}" if outcome.recognition.text else words
    note = Note(Severity.WARNING, "taken_anyway", text)
    return replace(outcome, step=step, accumulation=outcome.accumulation.with_note(note))
