"""The tab Model vs data: clicks in, `StoryState` out."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Qt, Signal

from core.arrays import FloatArray
from core.discrepancy.result import Candidate
from core.discrepancy.settings import Settings
from core.errors import LabError, Severity
from gui.discrepancy.cards import (
    chosen_of,
    detail_of,
    following_of,
    lights_of,
    proposals_of,
)
from gui.discrepancy.handed import addition_of
from gui.discrepancy.ladder_rows import regressors_of, rungs_of
from gui.discrepancy.overview import advice_of, found_of, gaps_of, measured_words, notes_of
from gui.discrepancy.picture import picture_of, where_of
from gui.discrepancy.rerun import played
from gui.discrepancy.scene import (
    actions_of,
    empty_state,
    hint_words,
    is_rejected,
    judgement_of,
    sensors_asked,
)
from gui.discrepancy.state import PictureState, StoryState
from gui.discrepancy.words import phase_words
from gui.discrepancy.working import Story, added, all_added, opened, searched
from gui.jobs import Jobs
from gui.measuring.loading import Choice, mounts_asked
from gui.messages import Messages
from gui.services import Addition
from gui.widgets.states import ActionBarState, BannerState

SOURCE = "discrepancy"


class DiscrepancyPresenter(QObject):
    """Everything the view asks for.

    Parameters
    ----------
    jobs : reads and computes
    messages : where refused files are told
    calibrate_with : hands the run with its effects to the tab that calibrates it; see `Services`
    settings : of the search
    """

    changed = Signal(object)
    """A new `StoryState`."""
    trial_wanted = Signal()
    """A sealed case is to be made."""
    _phase = Signal(str)

    def __init__(
        self,
        jobs: Jobs,
        messages: Messages,
        calibrate_with: Callable[[Addition, bool], bool],
        settings: Settings | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages
        self._calibrate_with = calibrate_with
        self._settings = Settings() if settings is None else settings
        self._story: Story | None = None
        self._before: list[Story] = []
        self._asked: tuple[Path, ...] = ()
        self._given: tuple[str | None, Sequence[str] | None, str | None] = (None, None, None)
        self._output = ""
        self._then_find = False
        self._busy = ""
        self._chosen = ""
        self._regressor = ""
        self._channel = 0
        self._after = False
        self._alone = ""
        self._again: FloatArray | None = None
        self._actions = {
            "find": self.find,
            "add": self.add_effect,
            "all": self.add_all,
            "undo": self.undo,
            "play": self.play,
            "calibrate": self.calibrate,
            "trial": self.trial_wanted.emit,
        }
        self._phase.connect(self._on_phase, Qt.ConnectionType.QueuedConnection)
        messages.action.connect(self._on_action)

    @property
    def story(self) -> Story | None:
        """What is on the page."""
        return self._story

    @property
    def busy(self) -> str:
        """What is being done; empty for nothing."""
        return self._busy

    @property
    def alone(self) -> str:
        """What is on the page in place of data: ``"case"`` while it is sealed, ``"plan"``."""
        return self._alone

    @property
    def state(self) -> StoryState:
        """The tab as it is now."""
        story = self._story
        if story is None:
            return empty_state(self._busy or hint_words(), self._busy, self._items())
        told, judged = story.told, story.proposed
        candidate = self._candidate()
        verdict, summary, tone = judgement_of(told, judged, alone=self._alone)
        outputs = story.outputs or told.channels
        channel = outputs.index(told.channels[0]) if story.outputs else self._channel
        return StoryState(
            title=measured_words(story),
            source=" + ".join(path.name for path in story.paths),
            verdict=verdict,
            summary=summary,
            tone=tone,
            gaps="" if self._alone == "plan" else gaps_of(story),
            found=() if self._alone else found_of(story),
            advice=advice_of(story, rejected=is_rejected(told), alone=self._alone),
            rungs=rungs_of(story),
            regressors=regressors_of(where_of(story, after=self._after)),
            regressor=self._regressor,
            channels=outputs,
            channel=channel,
            picture=self._picture(candidate),
            after=self._after,
            can_after=bool(told.where_after),
            again=self._again is not None,
            proposals=proposals_of(story),
            chosen="" if candidate is None else candidate.effect,
            detail=None if candidate is None else detail_of(candidate),
            following=() if self._alone else following_of(story),
            lights=lights_of(told),
            notes=notes_of(story, summary),
            actions=self._items(),
            hint="",
            busy=self._busy,
        )

    # --- what the operator does -------------------------------------------------------------------

    def open(self, names: Sequence[str], *, find: bool = False) -> None:
        """Read files of one unit: a session's folder, run files, legacy files.

        Parameters
        ----------
        find : look for what is missing at once
        """
        if self._busy or not names:
            return
        self._asked, self._then_find = tuple(Path(name) for name in names), find
        self._alone = ""
        self._output = ""
        self._read(None, None, None)

    def open_alone(self, work: Callable[[], Story], kind: str) -> None:
        """Put rows on the page in which nothing is looked for.

        Parameters
        ----------
        work : makes the rows
        kind : ``"case"``, until it is unsealed; ``"plan"``, by which nothing was measured
        """
        if not self._busy:
            self._alone, self._asked = kind, ()
            self._messages.clear(SOURCE)
            self._start(kind, work)

    def unseal(self) -> None:
        """Look for what is hidden in the case on the page."""
        self._alone = ""
        self.find()

    def find(self) -> None:
        """Look for what is missing."""
        story = self._story
        if story is not None and not self._alone:
            self._start("search", lambda: searched(story, self._phase.emit))

    def add_effect(self) -> None:
        """Add the chosen effect to the model."""
        story, candidate = self._story, self._candidate()
        if story is not None and candidate is not None:
            self._start("add", lambda: added(story, candidate.effect, self._phase.emit))

    def add_all(self) -> None:
        """Add all that was found."""
        if self._story is not None and self._story.proposals and not self._busy:
            self._take(all_added(self._story))

    def undo(self) -> None:
        """Take the last addition back."""
        if self._before and not self._busy and self._story is not None:
            old = self._story
            self._show(self._before.pop())
            self._renew(old)

    def undo_from(self, number: int) -> None:
        """Take back a rung and all above it."""
        old = self._story
        while self._before and not self._busy and self._story is not None:
            if len(self._story.told.steps) < number:
                break
            self._show(self._before.pop())
        if old is not None:
            self._renew(old)

    def play(self) -> None:
        """Play the same rows with the model and its noise, or take them away again."""
        story = self._story
        if story is None or self._busy:
            return
        if self._again is None:
            self._start("play", lambda: played(story, len(story.told.steps) + 1))
        else:
            self._again = None
            self._tell()

    def calibrate(self) -> None:
        """Hand the run with its effects to the tab that calibrates it, and show that tab."""
        story = self._story
        if story is None or self._busy:
            return
        self._messages.clear(SOURCE)
        if not self._calibrate_with(addition_of(story), True):
            what = QCoreApplication.translate("Discrepancy", "No tab calibrates this run")
            self._messages.show(SOURCE, BannerState(Severity.WARNING, what))

    def choose(self, effect: str) -> None:
        """Look at another candidate."""
        if effect != self._chosen:
            self._chosen = effect
            self._tell()

    def against(self, regressor: str) -> None:
        """Plot against another regressor."""
        if regressor != self._regressor:
            self._regressor = regressor
            self._tell()

    def show_channel(self, channel: int) -> None:
        """Plot another output; of a record, compare that one."""
        story = self._story
        if story is not None and story.outputs:
            if not self._busy and story.outputs[channel] != story.told.channels[0]:
                self._output = story.outputs[channel]
                self._then_find = story.proposed is not None
                self._read(*self._given)
        elif channel != self._channel:
            self._channel = channel
            self._tell()

    def show_after(self, after: bool) -> None:
        """Show the residuals of the plain model, or those with the added effects."""
        if after != self._after:
            self._after = after
            self._tell()

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        self._actions[key]()

    # --- the work ---------------------------------------------------------------------------------

    def _read(self, device: str | None, mounts: Sequence[str] | None, sensor: str | None) -> None:
        self._given = device, mounts, sensor
        paths, settings, output = self._asked, self._settings, self._output
        self._messages.clear(SOURCE)
        self._start(
            "reading",
            lambda: opened(paths, settings, self._phase.emit, device, mounts, sensor, output),
        )

    def _start(self, phase: str, work: Callable[[], object]) -> None:
        if self._busy:
            return
        self._busy = phase_words(phase)
        self._jobs.start("model vs data", work, self._on_done, self._on_failed)
        self._tell()

    def _on_phase(self, key: str) -> None:
        if self._busy:
            self._busy = phase_words(key)
            self._tell()

    def _on_done(self, result: object) -> None:
        self._busy = ""
        match result:
            case Choice():
                self._messages.show(SOURCE, result.banner())
                self._tell()
            case Story():
                self._take(result)
            case np.ndarray() | None:
                self._again = result
                self._tell()
            case _:
                raise TypeError(f"a comparison brought {type(result).__name__}")
        if self._then_find:
            self._then_find = False
            self.find()

    def _on_failed(self, error: LabError) -> None:
        self._busy, self._then_find, self._alone = "", False, ""
        what = QCoreApplication.translate("Discrepancy", "Model and data cannot be compared")
        self._messages.tell_error(SOURCE, what, error, *mounts_asked(error), *sensors_asked(error))
        self._tell()

    def _on_action(self, source: str, key: str) -> None:
        if source != SOURCE or not self._asked:
            return
        kind, _, value = key.partition(" ")
        if kind == "device":
            self._read(value, None, None)
        elif kind == "mounts":
            self._read(None, value.split(","), None)
        elif kind == "sensor":
            self._read(None, None, value)

    def _take(self, story: Story) -> None:
        """Show what a job brought; what was added can be taken back."""
        old = self._story
        if old is None or old.run is not story.run:
            self._before.clear()
            self._channel, self._regressor = 0, ""
        elif len(story.told.steps) != len(old.told.steps):
            self._before.append(old)
            self._chosen = ""
        self._show(story)
        if old is not None and self._before and old.run is story.run:
            self._renew(old)

    def _renew(self, old: Story) -> None:
        """A page of results that shows this run follows what is added and taken back."""
        story = self._story
        if story is not None and len(story.told.steps) != len(old.told.steps):
            self._calibrate_with(addition_of(story), False)

    def _show(self, story: Story) -> None:
        self._story = story
        self._after = bool(story.told.where_after)
        self._again = None
        if story.proposals and self._chosen not in {c.effect for c in story.candidates}:
            self._chosen = story.proposals[0].effect
        elif not story.proposals:
            self._chosen = ""
        where = where_of(story, after=self._after)
        if where and self._regressor not in {one.regressor for one in where}:
            self._regressor = where[0].regressor
            self._channel = where[0].shown
        self._tell()

    # --- what is shown ----------------------------------------------------------------------------

    def _candidate(self) -> Candidate | None:
        return None if self._story is None else chosen_of(self._story, self._chosen)

    def _picture(self, candidate: Candidate | None) -> PictureState | None:
        story = self._story
        if story is None:
            return None
        for one in where_of(story, after=self._after):
            if one.regressor == self._regressor:
                return picture_of(
                    story,
                    one,
                    self._channel,
                    after=self._after,
                    again=self._again,
                    candidate=candidate,
                )
        return None

    def _items(self) -> ActionBarState:
        return actions_of(
            self._story,
            candidate=self._candidate() is not None,
            added=bool(self._before),
            again=self._again is not None,
            busy=bool(self._busy),
            alone=self._alone,
        )

    def _tell(self) -> None:
        self.changed.emit(self.state)
