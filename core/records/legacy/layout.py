"""Columns of the legacy text files: one row a measurement, the device's name first.

The practicum prints them as Tables 1.2 (ClbAcc), 2.2 and 2.4 (Pointer), 3.2 and 3.3 (ClbDUS).
What it does not print is inferred, and stands here and nowhere else:

* Accuracy files, columns 16-24: three magnetometer codes, six temperatures (gyros, then
  accelerometers). Column 2 counts the rows, as Table 2.4 shows it.
* ClbAcc, a free angle between two 15-degree steps: its position number is that of a neighbour.
* RotationTable files: the table turns about Z, the assembly lies on it.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.plans.plan import Plan, load_plans

STEP_DEG = 15.0
"""ClbAcc's list of positions goes in steps of this angle."""


@dataclass(frozen=True, slots=True)
class LegacyColumn:
    """One column after the device's name.

    Parameters
    ----------
    name : unique in its layout; outputs, temperatures and angles carry it into the `Run`
    low, high : smallest and largest number that it may hold
    integer : whether only whole numbers are possible
    write : number -> text
    """

    name: str
    low: float
    high: float
    integer: bool
    write: Callable[[float], str]

    def doubt(self, value: float) -> str:
        """What is wrong with a number in this column; empty if nothing is."""
        if self.integer and value != round(value):
            return f"{value:g} stands where the {self.name} must be a whole number"
        if not self.low <= value <= self.high:
            span = "0" if self.low == self.high else f"{self.low:g} to {self.high:g}"
            return f"{value:g} stands where the {self.name} must be {span}"
        return ""


@dataclass(frozen=True, slots=True)
class LegacyLayout:
    """One kind of legacy file.

    Parameters
    ----------
    id : key in `LEGACY_FORMATS`
    program : the old program, as device profiles name it
    title : program and table, for messages
    stem : how the file names begin
    test : test of the `Run` by the sensor that is looked at
    columns : columns 2, 3, ... of the file
    outputs : output columns of each sensor kind; the first kind is the default
    axes : case axis of each output of each sensor kind
    plan : plan whose steps the position numbers name (number + 1); empty where they name none
    """

    id: str
    program: str
    title: str
    stem: str
    test: Mapping[str, str]
    columns: tuple[LegacyColumn, ...]
    outputs: Mapping[str, tuple[str, ...]]
    axes: Mapping[str, tuple[str, ...]]
    plan: str = ""

    @property
    def width(self) -> int:
        """Number of columns with the device's name."""
        return len(self.columns) + 1

    @property
    def sensor(self) -> str:
        """The sensor kind that the file was made for."""
        return next(iter(self.outputs))

    def has(self, name: str) -> bool:
        """Whether there is a column of this name."""
        return any(column.name == name for column in self.columns)

    def index(self, name: str) -> int:
        """Place of a column in `columns`."""
        return next(i for i, column in enumerate(self.columns) if column.name == name)

    def valid(self, values: FloatArray) -> NDArray[np.bool_]:
        """Whether each row (n,) of numbers (n, width - 1) can be a row of this layout."""
        low = np.array([column.low for column in self.columns])
        high = np.array([column.high for column in self.columns])
        integer = np.array([column.integer for column in self.columns])
        good = (values >= low) & (values <= high) & (~integer | (values == np.round(values)))
        rows = good.all(axis=1)
        if self.has("head angle"):
            rows &= np.abs(values[:, _POSITION] - values[:, _ANGLE] / STEP_DEG) < 1.0
        return rows

    def first_doubt(self, row: FloatArray) -> tuple[int, str]:
        """Column number in the file, 1-based, and what is wrong in it; ``(0, "")`` if nothing."""
        for place, (column, value) in enumerate(zip(self.columns, row, strict=True)):
            doubt = column.doubt(float(value))
            if doubt:
                return place + 2, doubt
        if self.has("head angle") and abs(row[_POSITION] - row[_ANGLE] / STEP_DEG) >= 1.0:
            angle, position = float(row[_ANGLE]), float(row[_POSITION])
            return _POSITION + 2, (
                f"position number {position:g} does not belong to head angle {angle:g} deg"
                f" (column 3), which is position {position_of(angle)}"
            )
        return 0, ""


def position_of(angle_deg: float) -> int:
    """Index of a head angle in ClbAcc's list of 15-degree steps: 90 -> 6."""
    return int(np.floor(angle_deg / STEP_DEG + 0.5))


_ANGLE, _POSITION = 1, 2
_ANY = 1e12


def _code_text(value: float) -> str:
    return f"{value:.2f}"


def _whole_text(value: float) -> str:
    """Whole numbers as the tables print them; a mean of codes keeps two digits."""
    return f"{value:.0f}" if value == round(value) else f"{value:.2f}"


def _signed_text(value: float) -> str:
    return f"{value:+.6f}".rstrip("0").rstrip(".")


def _plain_text(value: float) -> str:
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _angle_text(value: float) -> str:
    """Two digits, a third where there is one (Table 2.4)."""
    text = f"{value:.3f}"
    return text[:-1] if text.endswith("0") else text


def _zeros(*names: str) -> tuple[LegacyColumn, ...]:
    return tuple(LegacyColumn(name, 0.0, 0.0, True, _whole_text) for name in names)


def _outputs(names: tuple[str, ...]) -> tuple[LegacyColumn, ...]:
    return tuple(LegacyColumn(name, -_ANY, _ANY, False, _code_text) for name in names)


def _codes(names: tuple[str, ...]) -> tuple[LegacyColumn, ...]:
    return tuple(LegacyColumn(name, -_ANY, _ANY, False, _whole_text) for name in names)


def _attitude(names: tuple[str, ...]) -> tuple[LegacyColumn, ...]:
    return tuple(LegacyColumn(name, -360.0, 360.0, False, _angle_text) for name in names)


def _number(name: str, last: int) -> LegacyColumn:
    return LegacyColumn(name, 0.0, float(last), True, _whole_text)


_XYZ = ("x", "y", "z")
_NINE = range(1, 10)
_TEMP = tuple(f"temp_{i}" for i in _NINE)
_ACC = tuple(f"acc_{i}" for i in _NINE)
_GYRO = tuple(f"gyro_{i}" for i in _NINE)
_ACC_XYZ = tuple(f"acc_{axis}" for axis in _XYZ)
_GYRO_XYZ = tuple(f"gyro_{axis}" for axis in _XYZ)
_MAG_XYZ = tuple(f"mag_{axis}" for axis in _XYZ)
_UNIT_ANGLES = ("unit_heading_deg", "unit_pitch_deg", "unit_roll_deg")
_MAG_ANGLES = ("mag_heading_deg", "mag_pitch_deg", "mag_roll_deg")
_TEMP_SIX = tuple(f"temp_{name}" for name in (*_GYRO_XYZ, *_ACC_XYZ))
_TEMP_MAG = tuple(f"temp_{name}" for name in _MAG_XYZ)
_TRIADS = {"accelerometer": _ACC_XYZ, "gyro": _GYRO_XYZ}
_TRIAD_AXES = {"accelerometer": _XYZ, "gyro": _XYZ}
# In an assembly every sensor's own axis is called Z (practicum, models 1.3 and 3.3).
_Z9 = ("z",) * 9
_HEAD_TESTS = {"accelerometer": "dividing_head", "gyro": "static_positions"}
_ODH = "OpticalDividingHead"

CLBACC = LegacyLayout(
    id="clbacc",
    program="clbacc",
    title="OpticalDividingHead of ClbAcc (Table 1.2)",
    stem=_ODH,
    test=_HEAD_TESTS,
    columns=(
        LegacyColumn("set temperature", -200.0, 200.0, False, _signed_text),
        LegacyColumn("head angle", -720.0, 720.0, False, _plain_text),
        LegacyColumn("position number", -48.0, 48.0, True, _whole_text),
        *_zeros("column 5", "column 6"),
        *_outputs(_ACC),
        *_codes(_TEMP),
    ),
    outputs={"accelerometer": _ACC},
    axes={"accelerometer": _Z9},
)

POINTER = LegacyLayout(
    id="pointer",
    program="pointer",
    title="OpticalDividingHead of Pointer (Table 2.2)",
    stem=_ODH,
    test=_HEAD_TESTS,
    columns=(
        _number("position number", 15),
        *_zeros("column 3", "column 4"),
        *_outputs(_GYRO_XYZ),
        *_outputs(_ACC_XYZ),
        *_codes((*_TEMP_SIX, *_TEMP_MAG)),
    ),
    outputs=_TRIADS,
    axes=_TRIAD_AXES,
    plan="pointer_16",
)

CLBDUS_HEAD = LegacyLayout(
    id="clbdus_head",
    program="clbdus",
    title="OpticalDividingHead of ClbDUS (Table 3.3)",
    stem=_ODH,
    test=_HEAD_TESTS,
    columns=(
        _number("position number", 7),
        *_zeros("column 3", "column 4"),
        *_outputs(_GYRO),
        *_codes(_TEMP),
    ),
    outputs={"gyro": _GYRO},
    axes={"gyro": _Z9},
    plan="accelerometer_8",
)

ROTATION_TABLE = LegacyLayout(
    id="rotation_table",
    program="clbdus",
    title="RotationTable of ClbDUS (Table 3.2)",
    stem="RotationTable",
    test={"gyro": "rate_table"},
    columns=(
        _number("rate number", 9999),
        *_zeros("column 3", "column 4"),
        LegacyColumn("set rate", -1e5, 1e5, False, _plain_text),
        *_outputs(_GYRO),
        *_codes(_TEMP),
    ),
    outputs={"gyro": _GYRO},
    axes={"gyro": _Z9},
)

_ACCURACY_PRINTED = (
    _number("row number", 9999),
    *_zeros("column 3"),
    *_attitude(_UNIT_ANGLES),
    *_attitude(_MAG_ANGLES),
    *_outputs(_GYRO_XYZ),
    *_outputs(_ACC_XYZ),
)

ACCURACY = LegacyLayout(
    id="accuracy",
    program="pointer",
    title="Accuracy of Pointer (Table 2.4)",
    stem="Accuracy",
    test={"accelerometer": "accuracy"},
    columns=(
        *_ACCURACY_PRINTED,
        *_outputs(_MAG_XYZ),
        *_codes(_TEMP_SIX),
    ),
    outputs={"accelerometer": _ACC_XYZ},
    axes={"accelerometer": _XYZ},
)

ACCURACY_15 = LegacyLayout(
    id="accuracy_15",
    program="pointer",
    title="Accuracy of Pointer, the 15 columns that Table 2.4 prints",
    stem="Accuracy",
    test={"accelerometer": "accuracy"},
    columns=_ACCURACY_PRINTED,
    outputs={"accelerometer": _ACC_XYZ},
    axes={"accelerometer": _XYZ},
)

LEGACY_FORMATS: dict[str, LegacyLayout] = {
    layout.id: layout
    for layout in (CLBACC, POINTER, CLBDUS_HEAD, ROTATION_TABLE, ACCURACY, ACCURACY_15)
}
"""Every layout that is read and written, by identifier."""


def legacy_for(program: str, test: str, plan: Plan) -> LegacyLayout | None:
    """The layout that an old program writes in a test; None if it cannot hold the plan.

    Parameters
    ----------
    program : ``layout`` of the device's profile: ``"clbacc"``, ``"pointer"``, ``"clbdus"``
    test : test of the run
    plan : its steps need position numbers in layouts that have no head angle
    """
    for layout in LEGACY_FORMATS.values():
        if layout.program == program and test in layout.test.values():
            numbered = position_numbers(layout.plan) if layout.plan else {}
            fits = not layout.plan or all(
                (step.mount, step.head_deg % 360.0) in numbered for step in plan.steps
            )
            return layout if fits else None
    return None


@cache
def plan_of(plan_id: str) -> Plan:
    """The packaged plan of this identifier."""
    return load_plans()[plan_id]


def position_numbers(plan_id: str) -> dict[tuple[str, float], int]:
    """Zero-based position numbers of a plan by mount and head angle."""
    steps = plan_of(plan_id).steps
    return {(step.mount, step.head_deg % 360.0): step.number - 1 for step in steps}
