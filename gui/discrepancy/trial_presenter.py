"""Blind trials: a sealed case is looked at, named, opened, and scored."""

from dataclasses import replace

from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.discrepancy.settings import Settings as SearchSettings
from core.errors import LabError, Severity
from core.model.catalogue.listing import CATALOGUE
from gui.discrepancy.presenter import DiscrepancyPresenter
from gui.discrepancy.trial import (
    KINDS,
    Score,
    hidden_in,
    is_right,
    make_case,
    named_by_operator,
    named_by_program,
    score_of,
    story_of,
)
from gui.discrepancy.trial_case import Case
from gui.discrepancy.trial_state import NameRow, TrialState
from gui.discrepancy.words import effect_words
from gui.discrepancy.working import Story
from gui.messages import Messages
from gui.settings import Settings
from gui.widgets.states import Tone

SECTION = "blind trial"
SOURCE = "blind trial"
_CHOICE = "kind"


class TrialPresenter(QObject):
    """Makes cases, keeps the answer until the seal is opened, and counts.

    Parameters
    ----------
    comparison : the tab on which a case is looked at
    settings : where the score is remembered
    messages : where it is told that it cannot be
    """

    changed = Signal(object)
    """A new `TrialState`, or None where no case is on the page."""

    def __init__(
        self,
        comparison: DiscrepancyPresenter,
        settings: Settings,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._comparison = comparison
        self._settings = settings
        self._messages = messages
        self._made: list[Case] = []
        self._case: Case | None = None
        chosen = settings.section(SECTION).get(_CHOICE)
        self._next = chosen if chosen in KINDS else KINDS[0]
        self._kind = self._making = self._next
        self._named: list[str] = []
        self._opening = False
        self._lines: tuple[str, ...] = ()
        self._tone = Tone.IDLE
        self._scores: dict[str, Score] = {
            kind: score_of(settings.section(section_of(kind))) for kind in KINDS
        }
        comparison.changed.connect(self._on_changed)
        comparison.trial_wanted.connect(self.begin)

    @property
    def state(self) -> TrialState | None:
        """The page as it is now; None where no case is on it."""
        case = self._case
        if case is None:
            return None
        busy = bool(self._comparison.busy)
        opened = bool(self._lines)
        template = QCoreApplication.translate("Trial", "Case {number}")
        kinds = kind_words()
        return TrialState(
            title=f"{template.format(number=case.seed)}: {kinds[self._kind]}",
            seal=case.seal,
            kinds=tuple(kinds.items()),
            kind=self._next,
            names=tuple(
                NameRow(name, effect_words(name), CATALOGUE[name].plain, name in self._named)
                for name in hidden_in(self._kind)
            ),
            answer=_answer(self._named),
            opened=opened,
            lines=self._lines,
            tone=self._tone,
            score=self._score_words(),
            can_open=not (busy or opened or self._opening),
            can_begin=not busy,
        )

    def begin(self) -> None:
        """Make the next case and put it on the page."""
        if self._comparison.busy:
            return
        # A case that was left unopened does not come again: it was looked at.
        kind = self._next
        seed = self._scores[kind].begun + 1
        self._scores[kind] = replace(self._scores[kind], begun=seed)
        self._remember(kind)
        made: list[Case] = []
        self._made, self._making = made, kind

        def work() -> Story:
            case = make_case(seed, kind)
            made.append(case)
            return story_of(case, SearchSettings(), lambda _: None)

        self._comparison.open_alone(work, "case")

    def choose(self, kind: str) -> None:
        """Of which kind the next case is."""
        if kind in KINDS and kind != self._next:
            self._next = kind
            self._remember(KINDS[0])
            self._tell()

    def tick(self, name: str, on: bool) -> None:
        """Name an effect, or take the name back."""
        if self._lines or self._opening or (name in self._named) == on:
            return
        if on:
            self._named.append(name)
        else:
            self._named.remove(name)
        self._tell()

    def open_seal(self) -> None:
        """Commit the answer, let the program answer, and open the seal."""
        if self._case is None or self._lines or self._opening:
            return
        self._opening = True
        self._comparison.unseal()
        self._tell()

    def _on_changed(self) -> None:
        story = self._comparison.story
        if self._made and story is not None and story.run is self._made[0].run:
            case = self._made[0]
            if self._case is not case:
                self._case, self._named, self._lines = case, [], ()
                self._kind = self._making
                self._tone, self._opening = Tone.IDLE, False
            elif self._opening and story.proposed is not None and not self._comparison.busy:
                self._opening = False
                self._judge(case, story)
        elif self._case is not None and (story is None or story.run is not self._case.run):
            self._case = None
        self._tell()

    def _judge(self, case: Case, story: Story) -> None:
        told = story.proposed or story.told
        steps = named_by_program(told)
        operator = is_right(case.truth, named_by_operator(told, self._named))
        program = is_right(case.truth, steps)
        score = self._scores[self._kind].after(operator=operator, program=program)
        self._scores[self._kind] = score
        self._tone = Tone.GOOD if operator else Tone.BAD
        words = {
            True: QCoreApplication.translate("Trial", "correct"),
            False: QCoreApplication.translate("Trial", "not correct"),
        }
        template = QCoreApplication.translate("Trial", "Step {number} of the program: {names}")
        by_program = (
            template.format(number=number, names="; ".join(effect_words(name) for name in step))
            for number, step in enumerate(steps, 1)
        )
        self._lines = (
            QCoreApplication.translate("Trial", "Hidden: {names}").format(
                names=_answer(case.truth)
            ),
            QCoreApplication.translate("Trial", "You: {names} ({verdict})").format(
                names=_answer(self._named), verdict=words[operator]
            ),
            *by_program,
            QCoreApplication.translate("Trial", "Program: {count} named ({verdict})").format(
                count=len(steps), verdict=words[program]
            ),
            QCoreApplication.translate(
                "Trial", "The seal is the SHA-256 of this text: {key}"
            ).format(key=case.key),
        )
        self._remember(self._kind)

    def _remember(self, kind: str) -> None:
        """Keep the score of a kind, and which kind is next."""
        self._settings.store(section_of(kind), dict(self._scores[kind].to_section()))
        first = self._scores[KINDS[0]].to_section()
        self._settings.store(SECTION, {**first, _CHOICE: self._next})
        try:
            self._settings.save()
        except LabError as error:
            self._messages.log(Severity.WARNING, str(error), SOURCE)

    def _score_words(self) -> str:
        score = self._scores[self._kind]
        if not score.cases:
            return QCoreApplication.translate("Trial", "No case was opened yet.")
        return QCoreApplication.translate(
            "Trial", "Of {cases} cases you had {operator} right, the program {program}."
        ).format(cases=score.cases, operator=score.operator, program=score.program)

    def _tell(self) -> None:
        self.changed.emit(self.state)


def section_of(kind: str) -> str:
    """Where the score of a kind is remembered."""
    return SECTION if kind == KINDS[0] else f"{SECTION} {kind}"


def kind_words() -> dict[str, str]:
    """What each kind of case is called."""
    return {
        "head": QCoreApplication.translate("Trial", "accelerometer on the dividing head"),
        "table": QCoreApplication.translate("Trial", "gyro on the rate table"),
        "rest": QCoreApplication.translate("Trial", "gyro at rest on the head"),
        "record": QCoreApplication.translate("Trial", "record of a vibratory gyro"),
    }


def _answer(names: "list[str] | tuple[str, ...]") -> str:
    if not names:
        return QCoreApplication.translate("Trial", "nothing is missing")
    return "; ".join(effect_words(name) for name in names)
