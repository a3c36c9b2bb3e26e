"""What is particular to one kind of test: the one thing that a measuring tab has to write."""

from abc import ABC, abstractmethod
from pathlib import Path
from typing import Generic, TypeVar

from core.plans.plan import Plan
from core.procedures.measuring import Outcome
from core.procedures.recognise import Nominal
from core.records.session.start import SessionStart
from core.samples.block import Channel
from drivers.profile import Profile
from gui.measuring.device import MeasuredDevice
from gui.measuring.settings import MeasuringSettings
from gui.measuring.walk import Course
from gui.measuring.words import Words
from gui.settings import Section

S = TypeVar("S", bound=MeasuringSettings)


class Guide(ABC, Generic[S]):
    """Tells the common machinery what a tab measures and how it is called.

    Attributes
    ----------
    key : short name: the section of the preferences, and the start of the sources of banners
    tests : tests of the plans that the tab measures, of `core.plans.plan.TESTS`
    sensor : ``"accelerometer"`` or ``"gyro"``: stored with every session
    empty : how the tab looks before a device is there
    tells_damage : whether this tab, of all, tells of sessions that cannot be read
    """

    key: str
    tests: tuple[str, ...]
    sensor: str
    empty: MeasuredDevice
    tells_damage = False

    @abstractmethod
    def device_of(self, profile: Profile, channels: tuple[Channel, ...]) -> MeasuredDevice | None:
        """How a device is measured in this tab; None if it cannot be."""

    @abstractmethod
    def missing(self, name: str) -> tuple[str, str]:
        """Headline and sentence of the stage for a device that cannot be measured here."""

    @abstractmethod
    def words(self, plan: Plan) -> Words:
        """How the steps of a plan are called."""

    @abstractmethod
    def course(
        self,
        plan: Plan,
        device: MeasuredDevice,
        settings: S,
        rate: float,
        nominal: Nominal | None,
    ) -> Course:
        """What a walk through the plan is made of.

        Parameters
        ----------
        plan : with the steps as they are now
        device : whose sensors are measured
        settings : of the operator
        rate : samples per second
        nominal : what `nominal` told of the device
        """

    @abstractmethod
    def settings_of(self, section: Section) -> S:
        """The settings in a section of the preferences."""

    @abstractmethod
    def settings_of_session(self, start: SessionStart, screen: S) -> S:
        """The settings that a session was begun with; the screen's where it states none."""

    def nominal(self, root: Path, name: str) -> Nominal | None:  # noqa: ARG002
        """What earlier calibrations under the folder of sessions tell of a device."""
        return None

    def plans_of(self, device: MeasuredDevice) -> tuple[str, ...]:  # noqa: ARG002
        """Plans that suit a device; the first is taken instead of another. Empty: all suit."""
        return ()

    def thermal(self, device: MeasuredDevice, settings: S) -> bool:  # noqa: ARG002
        """Whether the chamber's temperature is set and stored."""
        return settings.thermo

    def for_plan(self, settings: S, plan: Plan) -> S:  # noqa: ARG002
        """The settings once another plan is taken; its times are in them already."""
        return settings

    def reviewed(self, outcome: Outcome, plan: Plan) -> Outcome:  # noqa: ARG002
        """The outcome with further doubts, or in the words of the test, before it is taken."""
        return outcome
