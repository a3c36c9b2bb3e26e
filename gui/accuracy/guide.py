"""What is particular to measuring the accuracy of pitch and roll."""

from core.arrays import FloatArray
from core.plans.plan import Plan, Step
from core.procedures.accuracy_plan import kind_of, wanted_deg
from core.procedures.recognise import Expectation, Nominal
from core.procedures.recognise_angles import AngleExpectation
from core.records.session.start import SessionStart
from core.samples.block import Channel
from drivers.profile import Profile
from gui.accuracy.settings import AccuracySettings, settings_of, settings_of_session
from gui.accuracy.texts import kind_word, say
from gui.measuring.device import MeasuredDevice, SensorRow, roles_of, triad
from gui.measuring.guide import Guide
from gui.measuring.head_words import HeadWords, angle_words
from gui.measuring.walk import Course
from gui.settings import Section

POINTER = "pointer"
_ANGLES = "angle."
EMPTY = MeasuredDevice(POINTER, "accelerometer", "acc.", (), (), "code")


class AccuracyWords(HeadWords):
    """Steps by the pitch or roll that they reach, and the dial that reaches it.

    The plans keep X (or Y) away from the head, so the dial runs against the angle: both are told.
    """

    def __init__(self, plan: Plan) -> None:
        self._kind = kind_word(kind_of(plan))
        self._wanted = wanted_deg(plan)
        self.nouns = say("angles")
        self.noun = say("angle")
        self.lists = say("Angles")

    def setting(self, step: Step) -> str:
        return f"{angle_words(self._reached(step))} ({self._dial(step)})"

    def order(self, step: Step) -> str:
        return say("Turn to {dial}").format(dial=angle_words(step.head_deg))

    def mounting(self, step: Step, last_mount: str) -> str:
        reached = f"{self._kind} {angle_words(self._reached(step))}. "
        # The picture shows the mount at every step; it is worth words where it changes.
        changes = "" if last_mount == step.mount else super().mounting(step, last_mount)
        return f"{reached}{changes}"

    def label(self, step: Step) -> str:
        return say("{kind} {angle} ({dial}, {place})").format(
            kind=self._kind.lower(),
            angle=angle_words(self._reached(step)),
            dial=self._dial(step),
            place=self.place(step),
        )

    def _dial(self, step: Step) -> str:
        return say("dial {angle}").format(angle=angle_words(step.head_deg))

    def _reached(self, step: Step) -> float:
        return self._wanted.get(step.number, 0.0)


class AccuracyGuide(Guide[AccuracySettings]):
    """Units that tell raw codes of three accelerometers, or pitch and roll, or both."""

    key = "accuracy"
    tests = ("accuracy",)
    sensor = "accelerometer"
    empty = EMPTY

    def device_of(self, profile: Profile, channels: tuple[Channel, ...]) -> MeasuredDevice | None:  # noqa: ARG002
        roles = roles_of(channels)
        if all(f"acc.{axis}" in roles for axis in "xyz"):
            return triad(roles, POINTER, "accelerometer")
        if "angle.pitch" in roles and "angle.roll" in roles:
            rows = tuple(
                SensorRow(role.removeprefix(_ANGLES), role)
                for role in roles
                if role.startswith(_ANGLES)
            )
            return MeasuredDevice(POINTER, "accelerometer", _ANGLES, ("",) * len(rows), rows, "deg")
        return None

    def missing(self, name: str) -> tuple[str, str]:
        return (
            say("No pitch, no roll"),
            say(
                "{name} sends neither angles nor three accelerometers: there is nothing to check"
                " here. Choose another device."
            ).format(name=name),
        )

    def words(self, plan: Plan) -> AccuracyWords:
        return AccuracyWords(plan)

    def course(
        self,
        plan: Plan,
        device: MeasuredDevice,
        settings: AccuracySettings,
        rate: float,
        nominal: Nominal | None,  # noqa: ARG002
    ) -> Course:
        def input_of(step: Step) -> FloatArray:
            """Specific force (3,) on the case axes in a step, m/s^2."""
            return step.specific_force(settings.g_mps2, settings.base)

        kind = kind_of(plan)
        angles = device.checked == _ANGLES
        expectation: Expectation = (
            AngleExpectation(kind) if angles else Expectation(settings.g_mps2, device.axes)
        )
        return Course(
            steps=plan.steps,
            input_of=input_of,
            label_of=self.words(plan).label,
            expectation=expectation,
            # The heading of a unit on its side, and its roll at 90 deg of pitch, never rest.
            checked=f"{_ANGLES}{kind}" if angles else device.checked,
            accumulation_s=settings.accumulation_s,
            settle_s=settings.settle_s,
            rate=rate,
            hands_free=settings.hands_free,
        )

    def settings_of(self, section: Section) -> AccuracySettings:
        return settings_of(section)

    def settings_of_session(
        self, start: SessionStart, screen: AccuracySettings
    ) -> AccuracySettings:
        return settings_of_session(start, screen)
