"""How the rates of a plan are called."""

from PySide6.QtCore import QCoreApplication

from core.plans.plan import Step
from core.procedures.rate_table import whole_turns_s
from gui.measuring.settings import MeasuringSettings
from gui.measuring.words import Words
from gui.rate_table.settings import RateSettings
from gui.widgets.states import Pose
from gui.widgets.table_picture import rate_words, up_words

_TURN_DEG = 360.0
_WHOLE = 0.01
"""A turn that is whole to this share of it."""


class TableWords(Words):
    """Rates, with the way that the table turns."""

    noun = "rate"
    nouns = "rates"

    def __init__(self) -> None:
        translate = QCoreApplication.translate
        self.by_itself = translate(
            "RateTable", "Accumulates by itself once the table turns steadily."
        )
        self.moving = translate("RateTable", "The rate is changing.")
        self.settling = translate("RateTable", "The table turns steadily; hands off.")
        self.measuring = translate("RateTable", "Leave the table alone.")
        self.moved = translate("RateTable", "The rate changed")
        self.wrong = translate("RateTable", "Wrong rate")
        self.lists = translate("RateTable", "Rates")

    def setting(self, step: Step) -> str:
        return rate_words(step.rate_dps)

    def place(self, step: Step) -> str:
        return up_words(step.mount)

    def order(self, step: Step) -> str:
        if step.rate_dps == 0:
            return QCoreApplication.translate("RateTable", "Stop the table")
        return QCoreApplication.translate("RateTable", "Turn at {rate}").format(
            rate=rate_words(step.rate_dps)
        )

    def pose(self, step: Step, settings: MeasuringSettings) -> Pose:  # noqa: ARG002
        return Pose(step.mount, 0.0, rate_dps=step.rate_dps)

    def mounting(self, step: Step, last_mount: str) -> str:
        translate = QCoreApplication.translate
        if last_mount and last_mount != step.mount:
            return translate("RateTable", "Stop the table and bolt the unit on with {up}. ").format(
                up=self.place(step)
            )
        if step.rate_dps == 0:
            return f"{self.place(step)}. "
        way = (
            translate("RateTable", "counter-clockwise seen from above")
            if step.rate_dps > 0
            else translate("RateTable", "clockwise seen from above")
        )
        return f"{self.place(step)}, {way}. "

    def time(self, step: Step, settings: MeasuringSettings) -> str:
        if not isinstance(settings, RateSettings):
            return super().time(step, settings)
        return seconds_and_turns(step.rate_dps, settings)


def seconds_and_turns(rate_dps: float, settings: RateSettings) -> str:
    """``"36 s (2 turns)"``; where turns are left broken, what would make them whole."""
    translate = QCoreApplication.translate
    seconds = settings.seconds_at(rate_dps)
    if rate_dps == 0:
        return f"{seconds:g} s"
    turns = abs(rate_dps) * seconds / _TURN_DEG
    if abs(turns - round(turns)) < _WHOLE * turns:
        return translate("RateTable", "{seconds} s (whole turns: {turns})").format(
            seconds=f"{seconds:.4g}", turns=round(turns)
        )
    whole = whole_turns_s(rate_dps, settings.accumulation_s)
    return translate(
        "RateTable", "{seconds} s ({turns} turns; {whole} s would be whole turns)"
    ).format(seconds=f"{seconds:.4g}", turns=f"{turns:.2f}", whole=f"{whole:.4g}")
