"""The wording of every test on the dividing head."""

from core.plans.plan import Step
from gui.measuring.settings import MeasuringSettings
from gui.measuring.words import Words
from gui.widgets.states import Pose


class HeadWords(Words):
    """Positions by mount and head angle."""

    def setting(self, step: Step) -> str:
        return angle_words(step.head_deg)

    def place(self, step: Step) -> str:
        return mount_words(step.mount)

    def order(self, step: Step) -> str:
        return f"Turn to {angle_words(step.head_deg)}"

    def pose(self, step: Step, settings: MeasuringSettings) -> Pose:  # noqa: ARG002
        return Pose(step.mount, step.head_deg)


def mount_words(mount: str) -> str:
    """``X_from@90`` as the old screens say it: "X from ODH, re-indexed by 90°"."""
    place, _, reindex = mount.partition("@")
    words = f"{place.replace('_', ' ')} ODH"
    return f"{words}, re-indexed by {reindex}°" if reindex else words


def angle_words(angle_deg: float) -> str:
    """An angle of the head."""
    return f"{angle_deg:g}°".replace("-", "\N{MINUS SIGN}")
