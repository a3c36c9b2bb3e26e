"""The walk through a plan, made from the plan and from what the device sends."""

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.model.effect import AXES
from core.plans.orientation import LEVEL, BaseOrientation
from core.plans.plan import Plan, Step
from core.procedures.measuring import Measuring
from core.procedures.recognise import Expectation, Nominal
from core.samples.block import Channel, chosen_columns

_ON_TABLE, _ON_BASE = "rate_table", "headings"
_RECOGNISED_BY = {_ON_TABLE: ("rate.", "adc."), _ON_BASE: ("rate.", "adc.")}
_OTHERWISE = ("acc.", "adc.", "rate.")


def label_of(plan: Plan, step: Step) -> str:
    """How the operator calls a step: ``"position 3 (180 deg)"``, ``"rate 2 (-80 deg/s)"``."""
    if plan.test == _ON_TABLE:
        return f"rate {step.number} ({step.rate_dps:+g} deg/s)"
    if plan.test == _ON_BASE:
        return f"heading {step.number} ({step.head_deg:g} deg)"
    return f"position {step.number} ({step.head_deg:g} deg)"


def checked_role(plan: Plan, channels: tuple[Channel, ...]) -> str:
    """Start of the role of the channels that tell one step of a plan from another.

    Raises
    ------
    FitError
        The device sends nothing that would.
    """
    for role in _RECOGNISED_BY.get(plan.test, _OTHERWISE):
        if chosen_columns(channels, role):
            return role
    raise FitError(f"the device sends no sensor output that the plan {plan.title!r} could measure")


def walk_of(
    plan: Plan,
    channels: tuple[Channel, ...],
    rate: float,
    g: float,
    base: BaseOrientation = LEVEL,
    *,
    nominal: Nominal | None = None,
) -> Measuring:
    """Return the walk through a plan for one device.

    Parameters
    ----------
    plan : its steps, accumulation and settling times
    channels : what the device sends
    rate : samples per second
    g : local gravity, m/s^2
    base : how the head's base plate stands
    nominal : what is known of the sensors beforehand

    Raises
    ------
    FitError
        The device sends nothing that the plan measures.
    """
    role = checked_role(plan, channels)

    def input_of(step: Step) -> FloatArray:
        if plan.test not in _RECOGNISED_BY:
            return step.specific_force(g, base)
        # A level base sets no rate; what the Earth does is what is sought.
        rates = np.zeros(3)
        rates[AXES.index(step.axis)] = step.rate_dps
        return rates

    largest = max(abs(step.rate_dps) for step in plan.steps)
    full = largest or 1.0 if plan.test in _RECOGNISED_BY else g
    axes = tuple(_axis(channels[place]) for place in chosen_columns(channels, role))
    return Measuring(
        plan.steps,
        input_of,
        lambda step: label_of(plan, step),
        Expectation(full, axes, nominal),
        role,
        accumulation_s=plan.accumulation_s,
        settle_s=plan.settle_s,
        rate=rate,
    )


def _axis(channel: Channel) -> str:
    """Case axis of a sensor by its role; empty for the places of an assembly."""
    which = channel.role.partition(".")[2]
    return which if which in AXES else ""
