"""What is particular to gyros on the rate table, and at rest on the dividing head."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from core.arrays import FloatArray
from core.errors import Note, Severity
from core.plans.orientation import case_from_base
from core.plans.plan import Plan, Step
from core.procedures.measuring import Outcome
from core.procedures.rate_recognition import RateExpectation
from core.procedures.recognise import Expectation, Nominal, Recognition, Verdict
from core.records.session.start import SessionStart
from core.samples.accumulate import Accumulation
from core.samples.block import Channel, chosen_columns
from drivers.profile import Profile
from gui.measuring.device import MeasuredDevice
from gui.measuring.guide import Guide
from gui.measuring.head_words import HeadWords
from gui.measuring.nominal import nominal_of
from gui.measuring.walk import Course
from gui.measuring.words import Words
from gui.rate_table.device import CVGCOM, EMPTY, gyro_device
from gui.rate_table.settings import RateSettings, settings_of, settings_of_session
from gui.rate_table.words import TableWords
from gui.settings import Section

ON_TABLE, ON_HEAD = "rate_table", "static_positions"


class StaticWords(HeadWords):
    """Gyros at rest in positions of the head."""


class Silent(Expectation):
    """Gyros at rest say nothing of how they stand: every position may be the right one."""

    def recognise(
        self,
        outputs: FloatArray,  # noqa: ARG002
        inputs: FloatArray,  # noqa: ARG002
        labels: tuple[str, ...],  # noqa: ARG002
        chosen: int,  # noqa: ARG002
    ) -> Recognition:
        """Claim nothing."""
        return Recognition(Verdict.CANNOT_TELL, (), "")


class RateGuide(Guide[RateSettings]):
    """Gyros recognised by the rate of the table, on the head by gravity where they can be."""

    key = "rate_table"
    tests = (ON_TABLE, ON_HEAD)
    sensor = "gyro"
    empty = EMPTY

    def __init__(self) -> None:
        self._of_table, self._of_head = TableWords(), StaticWords()
        self._accelerometers: tuple[str, ...] = ()

    def device_of(self, profile: Profile, channels: tuple[Channel, ...]) -> MeasuredDevice | None:
        roles = [channel.role for channel in channels]
        self._accelerometers = tuple(
            role.removeprefix("acc.") for role in roles if role.startswith("acc.")
        )
        return gyro_device(profile, channels)

    def missing(self, name: str) -> tuple[str, str]:
        return (
            "No gyros",
            f"{name} sends none, so that it cannot be measured here. Choose another device.",
        )

    def words(self, plan: Plan) -> Words:
        return self._of_table if plan.test == ON_TABLE else self._of_head

    def course(
        self,
        plan: Plan,
        device: MeasuredDevice,
        settings: RateSettings,
        rate: float,
        nominal: Nominal | None,
    ) -> Course:
        known = nominal if nominal is not None and len(nominal.bias) == len(device.axes) else None
        course = Course(
            steps=plan.steps,
            input_of=rates_of,
            label_of=self.words(plan).label,
            expectation=RateExpectation(_largest(plan), device.axes, known),
            checked=device.checked,
            accumulation_s=lambda step: settings.seconds_at(step.rate_dps),
            settle_s=settings.settle_s,
            rate=rate,
            hands_free=settings.hands_free,
            must_move=plan.steps[0].rate_dps != 0,
        )
        if plan.test == ON_TABLE:
            return course
        g, axes = settings.g_mps2, self._accelerometers
        return replace(
            course,
            input_of=lambda step: step.specific_force(g, settings.base),
            expectation=Expectation(g, axes) if axes else Silent(g, device.axes),
            checked="acc." if axes else device.checked,
            accumulation_s=settings.accumulation_s,
            must_move=False,
        )

    def settings_of(self, section: Section) -> RateSettings:
        return settings_of(section)

    def settings_of_session(self, start: SessionStart, screen: RateSettings) -> RateSettings:
        return settings_of_session(start, screen)

    def nominal(self, root: Path, name: str) -> Nominal | None:
        return nominal_of(root, name, self.sensor)

    def plans_of(self, device: MeasuredDevice) -> tuple[str, ...]:
        if device.layout != CVGCOM:
            return ()
        return ("rate_table_cvg40", "g_sensitivity_8", "g_sensitivity_4")

    def reviewed(self, outcome: Outcome, plan: Plan) -> Outcome:
        found = outcome.accumulation
        if plan.test == ON_TABLE:
            found = replace(found, notes=tuple(_on_table(note) for note in found.notes))
        for note in _at_the_limit(found):
            found = found.with_note(note)
        return replace(outcome, accumulation=found)


def rates_of(step: Step) -> FloatArray:
    """Rate (3,) of the table on the case axes in a step, deg/s."""
    return case_from_base(step.mount, 0.0)[:, 0] * step.rate_dps


def _largest(plan: Plan) -> float:
    return max(abs(step.rate_dps) for step in plan.steps) or 1.0


def _on_table(note: Note) -> Note:
    """What is moved on the table is its rate."""
    if note.subject != "moved":
        return note
    which = note.text.partition("(")[2].partition(" changed")[0]
    text = (
        f"the table changed its rate during the accumulation ({which}): it stopped, slowed down or"
        " was still gaining speed; wait until it turns steadily and accumulate again"
    )
    return replace(note, text=text)


def _at_the_limit(accumulation: Accumulation) -> list[Note]:
    """Gyros whose output did not change by a digit: at the end of their range, or stuck."""
    gyros = [
        place for role in ("rate.", "adc.") for place in chosen_columns(accumulation.channels, role)
    ]
    std, mean = accumulation.std[gyros], accumulation.mean[gyros]
    frozen = np.flatnonzero((std == 0.0) & (mean != 0.0))
    return [
        Note(
            Severity.ERROR,
            "clipped",
            f"{accumulation.channels[gyros[i]].name} stood at {mean[i]:g} throughout: the gyro or"
            " its converter is at the end of its range, or the channel is stuck; leave the rate"
            " out, or measure a smaller one",
        )
        for i in frozen.tolist()
    ]
