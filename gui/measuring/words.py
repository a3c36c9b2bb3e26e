"""How the steps of a test are called, on the stage, in the list and in the banners."""

from abc import ABC, abstractmethod

from core.plans.plan import Step
from gui.measuring.settings import MeasuringSettings
from gui.widgets.states import Pose


class Words(ABC):
    """The wording of one kind of test.

    Attributes
    ----------
    noun, nouns : "position", "positions": what a step is
    by_itself, moving, settling, measuring : sentences of the stage in the phases of a step
    moved : headline of the banner when the rig moved in an accumulation
    wrong : headline of the stage over a step that was not taken
    lists : accessible name of the list of steps
    """

    noun = "position"
    nouns = "positions"
    by_itself = "Accumulates by itself once the unit is at rest."
    moving = "The unit is moving."
    settling = "At rest; hands off."
    measuring = "Do not touch the head."
    moved = "The head moved"
    wrong = "Wrong position"
    lists = "Positions"

    @abstractmethod
    def setting(self, step: Step) -> str:
        """What is set: "90°", "−100 deg/s"."""

    @abstractmethod
    def place(self, step: Step) -> str:
        """How the unit is mounted: "X from ODH"."""

    @abstractmethod
    def order(self, step: Step) -> str:
        """What to do: "Turn to 90°"."""

    @abstractmethod
    def pose(self, step: Step, settings: MeasuringSettings) -> Pose | None:
        """The picture."""

    def label(self, step: Step) -> str:
        """How a step is called in a sentence."""
        return f"{self.noun} {step.number} ({self.place(step)}, {self.setting(step)})"

    def headline(self, step: Step, last_mount: str) -> str:
        """The large line that asks for a step; `last_mount` is empty before the first."""
        order = self.order(step)
        if last_mount and last_mount != step.mount:
            return f"Re-mount, {order[0].lower()}{order[1:]}"
        return order

    def mounting(self, step: Step, last_mount: str) -> str:
        """The sentence about the mount."""
        if last_mount and last_mount != step.mount:
            return f"Bolt the unit on anew with {self.place(step)}. "
        return f"{self.place(step)}. "

    def time(self, step: Step, settings: MeasuringSettings) -> str:  # noqa: ARG002
        """How long is accumulated."""
        return f"{settings.accumulation_s:g} s"

    def all_done(self) -> str:
        """Headline at the end of the plan."""
        return f"All {self.nouns} done"
