"""Plans of an accuracy check: which pitch or roll each step sets, and plans over free lists.

A plan holds head angles. With X (or Y) away from the head they run against the pitch (or roll)
that they set, so the operator must be told both.
"""

import math
import re

import numpy as np

from core.errors import FitError, FormatError
from core.plans.orientation import Mount
from core.plans.plan import Plan, Step, load_plans
from core.procedures.angle_errors import PITCH, ROLL, main_angle

ACCURACY = "accuracy"
_AXES = {"X": PITCH, "Y": ROLL}
_PRACTICUM = {PITCH: "pitch_accuracy", ROLL: "roll_accuracy"}
_FREE = 101
"""First number of a step whose angle is not in the practicum's list: no legacy row is taken for one
of that list."""
_MOST = 400


def accuracy_plans(kind: str) -> dict[str, Plan]:
    """The packaged plans that set `PITCH` or `ROLL`, by id; that of the practicum first."""
    found = {key: p for key, p in load_plans().items() if p.test == ACCURACY and kind_of(p) == kind}
    first = _PRACTICUM[kind]
    return {first: found.pop(first), **found}


def kind_of(plan: Plan) -> str:
    """`PITCH` or `ROLL`, by the axis along the shaft.

    Raises
    ------
    FitError
        The plan turns about neither X nor Y, or about both.
    """
    axes = {Mount.parse(step.mount).axis for step in plan.steps}
    if len(axes) != 1 or not axes <= set(_AXES):
        raise FitError(f"{plan.title}: pitch is set with X along the shaft, roll with Y")
    return _AXES[axes.pop()]


def wanted_deg(plan: Plan) -> dict[int, float]:
    """Pitch or roll to be reached in each step, by its number, 0 to 360.

    A head that has come back to where it began has set 360.
    """
    kind = kind_of(plan)
    force = np.array([step.specific_force(1.0) for step in plan.steps])
    angles = np.round(main_angle(kind, force, full_turn=True), 9) % 360.0
    began = plan.steps[0].number
    return {
        step.number: 360.0 if angle == 0.0 and step.number != began else float(angle)
        for step, angle in zip(plan.steps, angles, strict=True)
    }


def with_angles(plan: Plan, angles_deg: tuple[float, ...]) -> Plan:
    """The plan over a free list of pitch or roll angles, in this order.

    Raises
    ------
    FitError
        There is no angle, or there are too many.
    """
    if not 0 < len(angles_deg) <= _MOST:
        raise FitError(f"a list of angles holds 1 to {_MOST} of them, not {len(angles_deg)}")
    kind = kind_of(plan)
    first = plan.steps[0]
    mount = Mount.parse(first.mount)
    sign = -1.0 if mount.sense == "from" else 1.0
    numbers = _numbers(kind, angles_deg)
    steps = tuple(
        Step(number, first.group, first.mount, (sign * angle - mount.reindex_deg) % 360.0)
        for number, angle in zip(numbers, angles_deg, strict=True)
    )
    return plan.with_steps(steps)


def angles_of_text(text: str) -> tuple[float, ...]:
    """Angles, deg, from a list as it is typed: ``0, 30, 60`` or ``0 30,5 60``.

    Raises
    ------
    FormatError
        A word is no angle between -360 and 360, or there is none.
    """
    # A comma inside a word is a decimal mark where blanks part the words.
    words = re.split(r"[\s;]+|,\s+|,(?=$)", text.strip()) if " " in text else text.split(",")
    angles: list[float] = []
    for word in (word.strip() for word in words):
        if not word:
            continue
        try:
            angle = float(word.replace(",", ".").rstrip("°"))
        except ValueError:
            raise FormatError("Angles", f"{word!r} is no angle; write e.g. 0, 30, 60") from None
        if not (math.isfinite(angle) and abs(angle) <= 360.0):
            raise FormatError("Angles", f"{word} is no angle from -360 to 360 deg")
        angles.append(angle)
    if not angles:
        raise FormatError("Angles", "the list is empty; write e.g. 0, 30, 60")
    return tuple(angles)


def _numbers(kind: str, angles_deg: tuple[float, ...]) -> list[int]:
    """Numbers in the practicum's list where all angles are in it, which legacy files tell."""
    known = {
        angle: number
        for number, angle in wanted_deg(accuracy_plans(kind)[_PRACTICUM[kind]]).items()
    }
    numbers = [known.get(angle, 0) for angle in angles_deg]
    if all(numbers) and len(set(numbers)) == len(numbers):
        return numbers
    return list(range(_FREE, _FREE + len(angles_deg)))
