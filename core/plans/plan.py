"""A procedure as data.

A plan file names groups of steps; each step is one accumulation. Nothing else in the program
knows a list of angles or rates.
"""

import tomllib
from dataclasses import dataclass, replace
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, cast

from core.arrays import FloatArray
from core.errors import FormatError
from core.plans.orientation import LEVEL, BaseOrientation, Mount, earth_rate, specific_force

TESTS = ("dividing_head", "rate_table", "static_positions", "accuracy", "record", "headings")
OWN_PLANS = "plans"
"""Folder of the user's own plans, beside his sessions."""
_LARGEST = 1e9
"""Beyond any angle, rate, temperature and number of a step; not-a-number is no number either."""


@dataclass(frozen=True, slots=True)
class Step:
    """One accumulation of a plan.

    Parameters
    ----------
    number : the number that operators know (screen position, rate number), unique in a plan
    group : title of the group that the step stands in
    mount : how the unit is bolted on, e.g. ``"X_from"``; on the table ``"Z_from"`` has Z up
    head_deg : angle to set on the dividing head
    rate_dps : rate to set on the table, deg/s, counter-clockwise from above; 0 on the head
    axis : table tests: the case axis along the table's axis, ``"x"``, ``"y"`` or ``"z"``
    """

    number: int
    group: str
    mount: str = "X_from"
    head_deg: float = 0.0
    rate_dps: float = 0.0
    axis: str = "z"

    def specific_force(self, g: float, base: BaseOrientation = LEVEL) -> FloatArray:
        """Specific force (3,) on the case axes, m/s^2."""
        return specific_force(self.mount, self.head_deg, g, base)

    def earth_rate(self, latitude_deg: float, base: BaseOrientation = LEVEL) -> FloatArray:
        """Rate of the Earth (3,) on the case axes, deg/s."""
        return earth_rate(self.mount, self.head_deg, latitude_deg, base)


@dataclass(frozen=True, slots=True)
class Plan:
    """Steps in the order of measuring, with the settings of the test.

    Parameters
    ----------
    id : file stem; stored with every session
    test : one of `TESTS`
    accumulation_s, settle_s : seconds to accumulate, seconds to wait once at rest
    temperatures_c : chamber temperatures to go through; empty for room temperature
    """

    id: str
    title: str
    test: str
    source: str
    accumulation_s: float
    settle_s: float
    temperatures_c: tuple[float, ...]
    steps: tuple[Step, ...]

    def step(self, number: int) -> Step:
        """Return the step with this number.

        Raises
        ------
        KeyError
            The plan has no such step.
        """
        for step in self.steps:
            if step.number == number:
                return step
        raise KeyError(number)

    def with_steps(self, steps: tuple[Step, ...]) -> "Plan":
        """The same plan over other steps, e.g. a free list of angles."""
        return replace(self, steps=steps)


def load_plan(path: Path | Traversable) -> Plan:
    """Read one plan file.

    Raises
    ------
    FormatError
        The file is no plan; the message names the table and key.
    """
    name = str(path)
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise FormatError(name, f"cannot be read: {error}") from error
    try:
        document = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # also numbers of too many digits
        raise FormatError(name, f"not TOML: {error}") from error
    return plan_from_dict(document, Path(name).stem, name)


def plan_from_dict(document: dict[str, Any], plan_id: str, name: str) -> Plan:
    """Build a plan from a parsed document; `name` stands in error messages."""
    reader = _Reader(name)
    head = reader.table(document, "plan", "the file")
    test = reader.text(head, "test")
    if test not in TESTS:
        raise FormatError(name, f"[plan] test = {test!r}; expected one of {', '.join(TESTS)}")
    groups = document.get("group")
    if not isinstance(groups, list) or not groups:
        raise FormatError(name, "a plan needs at least one [[group]]")
    steps: list[Step] = []
    for group in cast(list[object], groups):
        if not isinstance(group, dict):
            raise FormatError(name, f"a group is {group!r}; write it as a table [[group]]")
        steps.extend(_steps(reader, cast(dict[str, Any], group), len(steps)))
    numbers = [step.number for step in steps]
    repeated = {number for number in numbers if numbers.count(number) > 1}
    if repeated:
        raise FormatError(name, f"step numbers used twice: {sorted(repeated)}")
    return Plan(
        id=plan_id,
        title=reader.text(head, "title"),
        test=test,
        source=str(head.get("source", "")),
        accumulation_s=reader.positive(head, "accumulation_s"),
        settle_s=reader.numbers([head.get("settle_s", 3.0)], "settle_s")[0],
        temperatures_c=reader.numbers(head.get("temperatures_c", []), "temperatures_c"),
        steps=tuple(steps),
    )


def load_plans(own: Path | None = None) -> dict[str, Plan]:
    """Return the packaged plans by id, then those of the user.

    Parameters
    ----------
    own : folder of the user's plan files; need not exist. One with the name of a packaged plan
        takes its place

    Raises
    ------
    FormatError
        A file of the user is no plan.
    """
    folder = resources.files("resources") / "plans"
    found = sorted((e for e in folder.iterdir() if e.name.endswith(".toml")), key=lambda e: e.name)
    users = sorted(own.glob("*.toml")) if own is not None else []
    return {plan.id: plan for plan in map(load_plan, [*found, *users])}


def _steps(reader: "_Reader", group: dict[str, Any], before: int) -> list[Step]:
    title = reader.text(group, "title")
    mount = str(group.get("mount", "Z_from" if "rates_dps" in group else "X_from"))
    try:
        axis = Mount.parse(mount).axis.lower()
    except ValueError as error:
        raise FormatError(reader.name, f"[[group]] {title}: {error}") from error
    angles = reader.numbers(group.get("head_deg", []), "head_deg")
    rates = reader.numbers(group.get("rates_dps", []), "rates_dps")
    if bool(angles) == bool(rates):
        raise FormatError(
            reader.name, f"[[group]] {title}: give either head_deg or rates_dps, a list of numbers"
        )
    count = len(angles) or len(rates)
    numbers = [
        int(number)
        for number in reader.numbers(
            group.get("numbers", list(range(before + 1, before + count + 1))), "numbers"
        )
    ]
    if len(numbers) != count:
        raise FormatError(
            reader.name, f"[[group]] {title}: {len(numbers)} numbers for {count} steps"
        )
    if angles:
        return [
            Step(number, title, mount, angle) for number, angle in zip(numbers, angles, strict=True)
        ]
    return [
        Step(number, title, mount, 0.0, rate, axis)
        for number, rate in zip(numbers, rates, strict=True)
    ]


@dataclass(frozen=True, slots=True)
class _Reader:
    """Typed look-ups that name the file and the key when they fail."""

    name: str

    def table(self, document: dict[str, Any], key: str, where: str) -> dict[str, Any]:
        value = document.get(key)
        if not isinstance(value, dict):
            raise FormatError(self.name, f"{where} needs a table [{key}]")
        return cast(dict[str, Any], value)

    def text(self, table: dict[str, Any], key: str) -> str:
        value = table.get(key)
        if not isinstance(value, str) or not value:
            raise FormatError(self.name, f"{key} is missing or no text")
        return value

    def numbers(self, value: object, key: str) -> tuple[float, ...]:
        if not isinstance(value, list):
            raise FormatError(self.name, f"{key} must be a list of numbers")
        items = cast(list[object], value)
        for item in items:
            known = isinstance(item, int | float) and not isinstance(item, bool)
            if not known or not -_LARGEST <= cast(float, item) <= _LARGEST:
                raise FormatError(self.name, f"{key} holds {item!r}, which is no number")
        return tuple(float(cast(float, item)) for item in items)

    def positive(self, table: dict[str, Any], key: str) -> float:
        (value,) = self.numbers([table.get(key)], key)
        if value <= 0:
            raise FormatError(self.name, f"{key} = {value:g}; must be above zero")
        return value
