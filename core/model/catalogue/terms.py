"""What the effects of the catalogue are made of: scaled inputs, neighbours in time, groups.

Effects of accelerometers are stated in the unit "g" of 9.80665 m/s^2 at the input (mg, mg/g^2,
ppm), those of gyros in deg/s; the response of the sensor turns them into output.
"""

from collections.abc import Iterable

import numpy as np

from core.arrays import FloatArray, IntArray
from core.model.effect import Parameter, Sensor
from core.model.stimulus import Stimulus
from core.units import MILLI, STANDARD_GRAVITY

STATIC = ("dividing_head", "static_positions")
HEAD = ("dividing_head",)
TABLE = ("rate_table",)
ALL = (*STATIC, *TABLE)
RECORD = ("record",)
_SAME = 1e-9


def unit_of(sensor: Sensor) -> float:
    """One g in m/s^2 for an accelerometer, one deg/s for a gyro."""
    return STANDARD_GRAVITY if sensor.kind == "accelerometer" else 1.0


def scaled(stimulus: Stimulus, sensor: Sensor) -> FloatArray:
    """The input (n, 3) in g or deg/s."""
    return sensor.input(stimulus) / unit_of(sensor)


def own(stimulus: Stimulus, sensor: Sensor) -> FloatArray:
    """The input (n,) along the axis that the sensor really has, in g or deg/s.

    A sensor that stands askew by 10 mrad turns its sign elsewhere than the case axis does.
    """
    response = sensor.sensitivity
    return scaled(stimulus, sensor) @ (response / response[sensor.index])


def gain(sensor: Sensor) -> float:
    """Output per g or per deg/s along the own axis."""
    return float(sensor.sensitivity[sensor.index]) * unit_of(sensor)


def small_gain(sensor: Sensor) -> float:
    """Output per `small_unit`."""
    return gain(sensor) * (MILLI if sensor.kind == "accelerometer" else 1.0)


def small_unit(sensor: Sensor, power: int = 0) -> str:
    """``mg`` or ``deg/s``, per g or deg/s to a power."""
    base, per = ("mg", "g") if sensor.kind == "accelerometer" else ("deg/s", "(deg/s)")
    if power == 0:
        return base
    return f"{base}/{per}" + (f"^{power}" if power > 1 else "")


def ideal(stimulus: Stimulus, sensor: Sensor) -> FloatArray:
    """Output (n,) of the linear sensor without bias."""
    return sensor.input(stimulus) @ sensor.sensitivity


def per_head_angle(stimulus: Stimulus, sensor: Sensor) -> FloatArray:
    """Output (n,) per radian of the head angle."""
    change = stimulus.da_dhead if sensor.kind == "accelerometer" else 0.0 * stimulus.da_dhead
    return change @ sensor.sensitivity


def column(*columns: FloatArray) -> FloatArray:
    """Columns (n,) side by side."""
    return np.column_stack(columns)


def hours(stimulus: Stimulus) -> FloatArray:
    """Time (n,) since the first row, h; one minute a row where no time is known.

    A column ``start_s`` names another beginning: blocks of a record have one in common.
    """
    t = stimulus.columns.get("t_s")
    if t is None or not np.all(np.isfinite(t)):
        return np.arange(len(stimulus)) / 60.0
    return (t - stimulus.columns.get("start_s", t)[0]) / 3600.0


def warmth(stimulus: Stimulus) -> FloatArray:
    """Temperature (n,) from its mean, or from a column ``reference_c``."""
    t = stimulus.column("temperature_c")
    return t - stimulus.columns.get("reference_c", t).mean()


def setups(stimulus: Stimulus) -> IntArray:
    """Number (n,) of the mounting in the order of measuring; bolting on again is a new one."""
    mount = stimulus.column("mount")
    return np.cumsum(np.diff(mount, prepend=mount[:1]) != 0).astype(np.int64)


def sweeps(stimulus: Stimulus) -> IntArray:
    """Number (n,) of the sweep; a mounting, a run or an angle seen before begins a new one."""
    place = np.column_stack([setups(stimulus), stimulus.column("run")])
    head = np.mod(stimulus.column("head_deg"), 360.0).round(6)
    number = np.zeros(len(stimulus), dtype=np.int64)
    broken = np.any(np.diff(place, axis=0) != 0, axis=1).tolist()
    angles: list[float] = head.tolist()
    seen = {angles[0]}
    for row in range(1, len(stimulus)):
        new = broken[row - 1] or angles[row] in seen
        number[row] = number[row - 1] + new
        seen = {angles[row]} if new else seen | {angles[row]}
    return number


def previous(stimulus: Stimulus, memory: str) -> IntArray:
    """Row (n,) before each row; its own number where nothing is known of what came before.

    Parameters
    ----------
    memory : ``"all"`` rows in the order of measuring, those of one ``"mounting"`` without a break,
        or of one ``"run"``
    """
    n = len(stimulus)
    before = np.maximum(np.arange(n) - 1, 0)
    if memory != "all" and "mount" in stimulus.columns:
        place = setups(stimulus)
        before = np.where(place[before] == place, before, np.arange(n))
    if memory == "run" and "run" in stimulus.columns:
        run = stimulus.columns["run"]
        before = np.where(run[before] == run, before, np.arange(n))
    return before.astype(np.int64)


MEMORIES = ("all", "mounting", "run")


def sign(values: FloatArray) -> FloatArray:
    """Sign (n,), 0 for what is zero but for rounding."""
    return np.where(np.abs(values) < _SAME, 0.0, np.sign(values))


def levels(values: FloatArray) -> list[float]:
    """Different finite values, ascending."""
    return sorted(set(values[np.isfinite(values)].tolist()))


def grid(low: float, high: float, count: int) -> list[float]:
    """Numbers from low to high in equal ratios."""
    return np.geomspace(low, high, count).tolist()


def numbered(name: str, symbol: str, unit: str, count: int) -> tuple[Parameter, ...]:
    """Parameters with numbers from 1."""
    if count == 1:
        return (Parameter(name, symbol, unit),)
    return tuple(Parameter(f"{name}_{i}", f"{symbol}{i}", unit) for i in range(1, count + 1))


def indicators(groups: FloatArray | IntArray, chosen: Iterable[float]) -> FloatArray:
    """Columns (n, k) of ones where a row belongs to a group."""
    return np.column_stack([(groups == one).astype(np.float64) for one in chosen])
