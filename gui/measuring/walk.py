"""The walk through the plan, fed with samples."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal

from core.arrays import FloatArray
from core.plans.plan import Step
from core.procedures.measuring import Measuring, Outcome, Phase, Status, means_of
from core.procedures.recognise import Expectation
from core.records.session.events import Position
from core.samples.block import SampleBlock

_PIECE_S = 0.25
_STEP_S = 0.1
"""The screen follows the seconds that remain in steps of this."""


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """What a walk is made of; the tab's guide makes it.

    Parameters
    ----------
    steps : of the plan
    input_of : true input (3,) of a step for the sensors that a step is recognised by
    label_of : how the operator calls a step in a sentence
    expectation : what these sensors should give
    checked : start of their roles
    accumulation_s : seconds to accumulate, of every step or as the step tells
    settle_s : hands-free: seconds to wait once at rest
    rate : samples per second
    hands_free : whether the program accumulates by itself
    must_move : hands-free, while nothing is known yet: wait until the rig has moved
    """

    steps: tuple[Step, ...]
    input_of: Callable[[Step], FloatArray]
    label_of: Callable[[Step], str]
    expectation: Expectation
    checked: str
    accumulation_s: float | Callable[[Step], float]
    settle_s: float
    rate: float
    hands_free: bool = False
    must_move: bool = False


class Walk(QObject):
    """Owns the `Measuring` of one pass through the plan."""

    moved = Signal()
    """The status is another one."""
    outcome = Signal(object)
    """`Outcome` of a full accumulation; the receiver calls `accept` or `reject`."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._measuring: Measuring | None = None
        self._seen: object = None

    def begin(
        self,
        course: Course,
        before: Sequence[Position],
        done: Sequence[Position],
        current: int | None,
    ) -> None:
        """Begin a pass, or go on with one.

        Parameters
        ----------
        course : what to walk
        before : accepted positions that only teach what the sensors give
        done : accepted positions of this pass
        current : number of the step to stand at; None for the first that is to be done
        """
        checked, expectation = course.checked, course.expectation
        for position in before:
            means = means_of(position.accumulation, checked)
            expectation.learn(course.input_of(position.step), means)
        measuring = Measuring(
            course.steps,
            course.input_of,
            course.label_of,
            expectation,
            checked,
            accumulation_s=course.accumulation_s,
            settle_s=course.settle_s,
            rate=course.rate,
        )
        for position in done:
            measuring.restore(position.step.number, means_of(position.accumulation, checked))
        numbers = {position.step.number for position in done}
        to_do = [step.number for step in course.steps if step.number not in numbers]
        if current is not None:
            measuring.choose(current)
        elif to_do:
            measuring.choose(to_do[0])
        if course.must_move and not before and not done:
            measuring.wait_for_motion()
        measuring.set_hands_free(course.hands_free)
        self._measuring = measuring
        self._tell()

    def end(self) -> None:
        """There is nothing to walk any more."""
        self._measuring = None
        self._tell()

    @property
    def status(self) -> Status | None:
        """Where the walk stands; None without a device."""
        return None if self._measuring is None else self._measuring.status

    @property
    def measuring(self) -> bool:
        """Whether an accumulation runs."""
        status = self.status
        return status is not None and status.phase is Phase.MEASURING

    def on_block(self, block: SampleBlock) -> None:
        """Take samples of the device."""
        for part in _parts(block):
            if self._measuring is None:
                return
            outcome = self._measuring.feed(part)
            if outcome is not None:
                self.outcome.emit(outcome)
            self._tell()

    def start(self) -> None:
        """Accumulate the current step now."""
        self._order(lambda walk: walk.start())

    def cancel(self) -> None:
        """Give up the accumulation that runs."""
        self._order(lambda walk: walk.cancel())

    def interrupted(self) -> None:
        """The link broke: what is being accumulated is given up."""
        self._order(lambda walk: walk.interrupted())

    def choose(self, number: int) -> None:
        """Make this step the current one."""
        self._order(lambda walk: walk.choose(number))

    def accept(self, outcome: Outcome) -> None:
        """The outcome is on the disk."""
        self._order(lambda walk: walk.accept(outcome))

    def reject(self, outcome: Outcome) -> None:
        """The outcome was not taken."""
        self._order(lambda walk: walk.reject(outcome))

    def set_hands_free(self, on: bool) -> None:
        """Start or stop accumulating without the operator."""
        self._order(lambda walk: walk.set_hands_free(on))

    def _order(self, order: Callable[[Measuring], None]) -> None:
        if self._measuring is not None:
            order(self._measuring)
            self._tell()

    def _tell(self) -> None:
        """Say that the status moved, if the screen would show it."""
        status = self.status
        seen = (
            None
            if status is None
            else (status.phase, status.step, round(status.remaining_s / _STEP_S), status.text)
        )
        if seen != self._seen:
            self._seen = seen
            self.moved.emit()


def _parts(block: SampleBlock) -> Iterator[SampleBlock]:
    """The block in pieces so short that no motion can begin and end within one.

    After the window was held up for a second all samples of that second come at once.
    """
    most = max(round(_PIECE_S * block.rate), 1) if block.rate > 0 else len(block.index)
    if len(block.index) <= most:
        yield block
        return
    for first in range(0, len(block.index), most):
        piece = slice(first, first + most)
        yield replace(block, index=block.index[piece], data=block.data[piece])
