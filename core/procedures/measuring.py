"""The walk through a plan: choose a step, come to rest, settle, accumulate, check, accept.

The same object serves the operator's clicks and the hands-free mode; it holds no clock of its
own, since all times are counted in samples of the device.
"""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import Note, Severity
from core.plans.plan import Step
from core.procedures.recognise import Expectation, Recognition
from core.samples.accumulate import Accumulation, Accumulator
from core.samples.block import SampleBlock, chosen_columns
from core.samples.stillness import StillnessDetector, moved


class Phase(Enum):
    """Where the walk stands."""

    READY = "ready"
    """Manual mode: waiting for the operator to start."""
    TURN = "turn"
    """Hands-free: waiting for the head to be turned to the current step."""
    MOVING = "moving"
    """The head moves."""
    SETTLING = "settling"
    """At rest in a place that may be the right one; waiting the settling time."""
    MEASURING = "measuring"
    """Accumulating."""
    WRONG = "wrong"
    """At rest in a place that is not the current step."""
    FINISHED = "finished"
    """All steps are done."""


@dataclass(frozen=True, slots=True)
class Status:
    """What the operator must see now.

    Parameters
    ----------
    phase : where the walk stands
    step : the current step, None when all are done
    progress : share of the settling or accumulation time that has passed, 0 to 1
    remaining_s : seconds that it still takes; while ready, of the settling after the last motion
    text : the sentence of the last doubt, empty if there is none
    candidates : numbers of the steps that the unit seems to stand in, while it stands wrong
    """

    phase: Phase
    step: Step | None
    progress: float
    remaining_s: float
    text: str
    candidates: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """A finished accumulation, checked; the caller stores it and calls `accept` or `reject`.

    Parameters
    ----------
    step : the step that it was made for
    accumulation : the means, with the notes of the check added
    recognition : what the means say about the position
    """

    step: Step
    accumulation: Accumulation
    recognition: Recognition

    @property
    def acceptable(self) -> bool:
        """Whether nothing forbids taking it as it is."""
        return self.recognition.acceptable and self.whole

    @property
    def whole(self) -> bool:
        """Whether the accumulation itself is sound, wherever the unit stands."""
        return not any(note.severity is Severity.ERROR for note in self.accumulation.notes)


class Measuring:
    """One walk through the steps of a plan.

    Parameters
    ----------
    steps : the steps, in the order proposed to the operator
    input_of : true input (3,) of a step for the sensors that are checked
    label_of : how the operator calls a step
    expectation : what the sensors should give, learning as steps are accepted
    checked : start of the role of the channels that a position is recognised by, e.g. ``"acc."``
    accumulation_s : seconds to accumulate, of every step or as the step tells
    settle_s : seconds to wait once at rest
    rate : samples per second
    """

    def __init__(
        self,
        steps: tuple[Step, ...],
        input_of: Callable[[Step], FloatArray],
        label_of: Callable[[Step], str],
        expectation: Expectation,
        checked: str,
        *,
        accumulation_s: float | Callable[[Step], float],
        settle_s: float,
        rate: float,
    ) -> None:
        self._steps = steps
        self._inputs = np.array([input_of(step) for step in steps])
        self._labels = tuple(label_of(step) for step in steps)
        self._expectation = expectation
        self._checked = checked
        self._accumulation_s = accumulation_s
        self._settle_samples = max(round(settle_s * rate), 1)
        self._rate = rate
        self._done: set[int] = set()
        self._place = 0
        self._hands_free = False
        self._phase = Phase.READY
        self._settled = 0
        self._rested = self._settle_samples
        """Samples at rest since the last motion, no more than are waited for."""
        self._text = ""
        self._candidates: tuple[int, ...] = ()
        self._still = StillnessDetector(rate, checked)
        self._accumulator: Accumulator | None = None
        self._at_step: int | None = None

    @property
    def status(self) -> Status:
        """What the operator must see now."""
        step = None if self._phase is Phase.FINISHED else self._steps[self._place]
        progress, remaining = 0.0, 0.0
        if self._accumulator is not None:
            progress = self._accumulator.progress
            remaining = self._accumulator.remaining_s
        elif self._phase is Phase.SETTLING:
            progress = min(self._settled / self._settle_samples, 1.0)
            remaining = (1.0 - progress) * self._settle_samples / self._rate
        elif self._phase is Phase.READY and self._rested < self._settle_samples:
            progress = self._rested / self._settle_samples
            remaining = (1.0 - progress) * self._settle_samples / self._rate
        standing = self._candidates if self._phase is Phase.WRONG else ()
        return Status(self._phase, step, progress, remaining, self._text, standing)

    @property
    def done(self) -> frozenset[int]:
        """Numbers of the steps that have an accepted accumulation."""
        return frozenset(self._steps[place].number for place in self._done)

    @property
    def hands_free(self) -> bool:
        """Whether the program starts accumulating by itself."""
        return self._hands_free

    def set_hands_free(self, on: bool) -> None:
        """Start or stop recognising and accumulating without the operator."""
        self._hands_free = on
        if self._phase not in (Phase.MEASURING, Phase.FINISHED):
            self._wait()

    def choose(self, number: int) -> None:
        """Make this step the current one; an accumulation that runs is given up."""
        self._place = next(i for i, step in enumerate(self._steps) if step.number == number)
        self._give_up()

    def start(self) -> None:
        """Accumulate the current step now (manual mode)."""
        self._text = ""
        self._begin()

    def cancel(self) -> None:
        """Give up the accumulation that runs."""
        if self._phase is not Phase.FINISHED:
            self._give_up()

    def wait_for_motion(self) -> None:
        """Hands-free: the rig is not set yet; begin only after it has moved."""
        self._at_step = self._place

    def interrupted(self) -> None:
        """The link broke: what was being accumulated is incomplete and is given up.

        What came before stays in the window of stillness, so that a turn meanwhile is seen.
        """
        self.cancel()

    def feed(self, block: SampleBlock) -> Outcome | None:
        """Take samples; return an outcome when an accumulation is full."""
        if not len(block.index):
            return None
        self._still.feed(block)
        if self._accumulator is not None:
            return self._finish() if self._accumulator.feed(block) else None
        if self._still.full and not self._still.at_rest:
            self._at_step = None
            self._rested = 0
        else:
            self._rested = min(self._rested + len(block.index), self._settle_samples)
        if self._hands_free and self._phase is not Phase.FINISHED:
            self._watch(len(block.index))
        return None

    def accept(self, outcome: Outcome) -> None:
        """The outcome was stored: learn from it and go on to the next step to be done."""
        place = self._steps.index(outcome.step)
        self._done.add(place)
        self._at_step = place
        self._expectation.learn(self._inputs[place], means_of(outcome.accumulation, self._checked))
        self._advance(place)

    def restore(self, number: int, means: FloatArray) -> None:
        """Take over a step that an earlier part of the session has accepted."""
        place = next(i for i, step in enumerate(self._steps) if step.number == number)
        self._done.add(place)
        self._expectation.learn(self._inputs[place], means)
        self._advance(place)

    def reject(self, outcome: Outcome) -> None:
        """The outcome was not stored: stay at its step and say why."""
        self._text = outcome.recognition.text or next(
            (note.text for note in outcome.accumulation.notes if note.severity is Severity.ERROR),
            "",
        )
        self._candidates = ()
        self._at_step = None
        self._phase = Phase.WRONG

    def reopen(self, number: int) -> None:
        """A step's result was discarded: it is to be done again and is the current one."""
        place = next(i for i, step in enumerate(self._steps) if step.number == number)
        self._done.discard(place)
        self._place = place
        self._at_step = None
        self._give_up()

    def _advance(self, place: int) -> None:
        order = [*range(place + 1, len(self._steps)), *range(place + 1)]
        following = [i for i in order if i not in self._done]
        self._text = ""
        if following:
            self._place = following[0]
            self._wait()
        else:
            self._phase = Phase.FINISHED

    def _wait(self) -> None:
        self._settled = 0
        self._phase = Phase.TURN if self._hands_free else Phase.READY

    def _give_up(self) -> None:
        self._accumulator = None
        self._text = ""
        self._wait()

    def _begin(self) -> None:
        wanted = self._accumulation_s
        seconds = wanted(self._steps[self._place]) if callable(wanted) else wanted
        self._accumulator = Accumulator(seconds, self._rate)
        self._phase = Phase.MEASURING

    def _watch(self, samples: int) -> None:
        """Hands-free: motion, rest, recognition, settling."""
        if not self._still.full:
            return
        if not self._still.at_rest:
            self._phase = Phase.MOVING
            self._settled = 0
        elif self._phase is Phase.SETTLING:
            self._settled += samples
            if self._settled >= self._settle_samples:
                self._begin()
        elif self._at_step is None:  # else still where the last step was measured
            recognition = self._recognise(self._still.mean())
            self._text = recognition.text
            self._candidates = tuple(self._steps[i].number for i in recognition.candidates)
            self._phase = Phase.SETTLING if recognition.acceptable else Phase.WRONG
            self._settled = 0

    def _recognise(self, means: FloatArray) -> Recognition:
        return self._expectation.recognise(means, self._inputs, self._labels, self._place)

    def _finish(self) -> Outcome:
        accumulator = self._accumulator
        if accumulator is None:
            raise RuntimeError("no accumulation is running")
        self._accumulator = None
        self._phase = Phase.READY
        accumulation = accumulator.result()
        data = accumulator.samples()[1]
        chosen = chosen_columns(accumulation.channels, self._checked)
        recognition = self._recognise(means_of(accumulation, self._checked))
        changed = np.flatnonzero(moved(data[:, chosen]))
        if changed.size:
            accumulation = accumulation.with_note(_moved_note(accumulation, chosen, changed))
        return Outcome(self._steps[self._place], accumulation, recognition)


def means_of(accumulation: Accumulation, checked: str) -> FloatArray:
    """Means of the channels whose role starts with `checked`."""
    return accumulation.mean[chosen_columns(accumulation.channels, checked)]


def _moved_note(accumulation: Accumulation, chosen: list[int], changed: IntArray) -> Note:
    names = ", ".join(accumulation.channels[chosen[int(i)]].name for i in changed)
    return Note(
        Severity.ERROR,
        "moved",
        f"the head moved during accumulation ({names} changed); wait and accumulate again",
    )
