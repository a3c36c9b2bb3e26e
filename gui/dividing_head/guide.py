"""What is particular to accelerometers on the dividing head."""

from pathlib import Path

from core.arrays import FloatArray
from core.plans.orientation import tilter_rotation
from core.plans.plan import Plan, Step
from core.procedures.recognise import Expectation, Nominal
from core.records.session.start import SessionStart
from core.samples.block import Channel
from drivers.profile import Profile
from gui.dividing_head.device import CLBACC, EMPTY, head_device
from gui.dividing_head.settings import HeadSettings, settings_of, settings_of_session
from gui.measuring.device import MeasuredDevice
from gui.measuring.guide import Guide
from gui.measuring.head_words import HeadWords
from gui.measuring.nominal import nominal_of
from gui.measuring.settings import MeasuringSettings
from gui.measuring.walk import Course
from gui.settings import Section
from gui.widgets.states import Pose

_PLANS_OF = {
    "clbacc": ("accelerometer_8", "accelerometer_4", "clbacc_24", "thermal_8"),
    "pointer": ("pointer_8", "pointer_16", "accelerometer_8", "accelerometer_4", "thermal_8"),
}
"""Plans that are kept when a device of a layout comes; the first is taken instead of others."""


class AccelerometerWords(HeadWords):
    """Positions of the head, with the tilter in the picture."""

    def pose(self, step: Step, settings: MeasuringSettings) -> Pose:
        tilted = isinstance(settings, HeadSettings)
        return Pose(
            step.mount, step.head_deg, settings.tilter.angles_deg if tilted else (0.0, 0.0, 0.0)
        )


class HeadGuide(Guide[HeadSettings]):
    """Accelerometers recognised by gravity."""

    key = "dividing_head"
    tests = ("dividing_head",)
    sensor = "accelerometer"
    empty = EMPTY
    tells_damage = True

    def device_of(self, profile: Profile, channels: tuple[Channel, ...]) -> MeasuredDevice | None:
        return head_device(profile, channels)

    def missing(self, name: str) -> tuple[str, str]:
        return (
            "No accelerometers",
            f"{name} sends none, so that it cannot be measured here. Choose another device.",
        )

    def words(self, plan: Plan) -> AccelerometerWords:  # noqa: ARG002
        return AccelerometerWords()

    def course(
        self,
        plan: Plan,
        device: MeasuredDevice,
        settings: HeadSettings,
        rate: float,
        nominal: Nominal | None,
    ) -> Course:
        # An earlier calibration leaves unused places of an assembly out.
        known = nominal if nominal is not None and len(nominal.bias) == len(device.axes) else None

        def input_of(step: Step) -> FloatArray:
            """Specific force (3,) on the case axes in a step, m/s^2."""
            force = step.specific_force(settings.g_mps2, settings.base)
            return tilter_rotation(*settings.tilter.angles_deg) @ force

        return Course(
            steps=plan.steps,
            input_of=input_of,
            label_of=self.words(plan).label,
            expectation=Expectation(settings.g_mps2, device.axes, known),
            checked=device.checked,
            accumulation_s=settings.accumulation_s,
            settle_s=settings.settle_s,
            rate=rate,
            hands_free=settings.hands_free,
        )

    def settings_of(self, section: Section) -> HeadSettings:
        return settings_of(section)

    def settings_of_session(self, start: SessionStart, screen: HeadSettings) -> HeadSettings:
        return settings_of_session(start, screen)

    def nominal(self, root: Path, name: str) -> Nominal | None:
        return nominal_of(root, name, self.sensor)

    def plans_of(self, device: MeasuredDevice) -> tuple[str, ...]:
        return _PLANS_OF[device.layout]

    def thermal(self, device: MeasuredDevice, settings: HeadSettings) -> bool:
        return settings.thermo or device.layout == CLBACC
