"""One hidden unit on one hidden rig: everything that is not an effect under test.

Accelerometers are computed in g, gyros in deg/s; `World.scale` turns both into output units.
"""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tests.blind.geometry import ARCSEC
from tests.blind.plans import Plan

KYIV_DEG = 50.45


@dataclass(frozen=True)
class Hidden:
    """One hidden effect: how much of it, and its shape (places, phases, time constants)."""

    size: float
    shape: dict[str, Any] = field(default_factory=dict)


Effects = dict[str, Hidden]


@dataclass(frozen=True)
class Levels:
    """Standard deviations of the noise; `angle` in rad or as a part of the rate."""

    white: float
    setting: float
    certificate: float
    drift: float
    drift_tau: float
    quick: float = 0.0
    """A second, four times faster drift; zero unless the noise is meant to be coloured."""
    walk: float = 0.0
    """Random walk, for each square root of an hour."""


NOMINAL = {
    "accelerometer": Levels(25e-6, 3 * ARCSEC, 5 * ARCSEC, 30e-6, 1200.0),
    "rate_gyro": Levels(6.5e-3, 150e-6, 100e-6, 8e-3, 1200.0),
    "mems_gyro": Levels(3e-3, 3 * ARCSEC, 5 * ARCSEC, 4e-3, 1200.0),
    "cvg": Levels(3e-5, 3 * ARCSEC, 5 * ARCSEC, 5e-5, 1200.0),
    "cvg_record": Levels(3e-4, 0.0, 0.0, 2e-5, 600.0),
}
FACTORS = {
    "white": (0.8, 1.25),
    "setting": (0.5, 1.5),
    "certificate": (0.5, 1.3),
    "drift": (0.5, 1.8),
    "drift_tau": (0.5, 2.0),
}


@dataclass(frozen=True)
class World:
    plan: Plan
    sensor: str
    axes: tuple[int, ...]
    """Case axis of each output."""
    unit: str
    scale: np.ndarray
    offset: np.ndarray
    linear: np.ndarray
    """(c, 3) answer to specific force; a rate table has one column, the scale factor error."""
    levels: Levels
    warmth: np.ndarray
    """(n,) true temperature at the sensor, degC."""
    recorded: np.ndarray
    """(n,) temperature as it stands in the file."""
    lsb: float
    first_sense: float
    """Direction from which the very first setting was reached."""
    amplitude: np.ndarray
    """(n,) vibration amplitude of a resonator, V."""
    has_temperature: bool = True
    has_se: bool = True
    has_amplitude: bool = False

    @property
    def outputs(self) -> int:
        return len(self.axes)


def true_levels(sensor: str, rng: np.random.Generator, coloured: bool) -> Levels:
    """Nominal noise, each component multiplied by a factor that nobody is told."""
    nominal = NOMINAL[sensor]
    drawn = {
        name: getattr(nominal, name) * np.exp(rng.uniform(*np.log(limits)))
        for name, limits in FACTORS.items()
    }
    if coloured:
        drawn["quick"] = drawn["drift"] * rng.uniform(0.5, 1.0)
        drawn["walk"] = drawn["drift"] * rng.uniform(0.3, 0.8)
    return replace(nominal, **drawn)


def wander(time: np.ndarray, sigma: float, tau: float, rng: np.random.Generator) -> np.ndarray:
    """Ornstein-Uhlenbeck process at the given times."""
    keep = np.exp(-np.diff(time, prepend=time[0]) / tau)
    kicks = rng.normal(size=len(time)) * sigma * np.sqrt(np.maximum(1.0 - keep**2, 0.0))
    kicks[0] = sigma * rng.normal()
    if len(time) > 2000:  # a record: even steps
        from scipy.signal import lfilter

        return lfilter([1.0], [1.0, -keep[1]], kicks)
    out = np.empty(len(time))
    now = 0.0
    for row in range(len(time)):
        now = keep[row] * now + kicks[row]
        out[row] = now
    return out


def temperatures(plan: Plan, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """True and recorded temperature: self-heating, a slow room, a thermometer of its own lag."""
    t = plan.time
    rise, tau = rng.uniform(0.4, 0.9), rng.uniform(600.0, 2400.0)
    room = wander(t, 0.15, 3600.0, rng)
    true = 26.0 + rng.uniform(-1.5, 1.5) + rise * (1.0 - np.exp(-t / tau)) + room
    lag = rng.uniform(5.0, 30.0)
    seen = np.empty(len(t))
    seen[0] = true[0]
    for row in range(1, len(t)):
        part = 1.0 - np.exp(-(t[row] - t[row - 1]) / lag)
        seen[row] = seen[row - 1] + part * (true[row] - seen[row - 1])
    return true, np.round((seen + rng.normal(size=len(t)) * 0.01) / 0.02) * 0.02


SENSORS = {"dividing_head": ("accelerometer",), "rate_table": ("rate_gyro",)}


def world_of(
    plan: Plan,
    rng: np.random.Generator,
    *,
    triad: bool = False,
    coloured: bool = False,
    has_temperature: bool = True,
    has_se: bool = True,
    has_amplitude: bool = False,
) -> World:
    """Draw a unit and a rig for a plan with settings (records: see `long_record`)."""
    sensor = str(rng.choice(SENSORS.get(plan.test, ("mems_gyro", "cvg"))))
    axes = (0, 1, 2) if triad else (int(rng.choice(across(plan))),)
    count = len(axes)
    unit, per_unit, lsb = str(rng.choice(["code", "V"])), 1.0, 1.0
    if sensor == "accelerometer":
        per_unit, lsb = (13100.0, 1.0) if unit == "code" else (1.0, 7.6e-5)
    else:
        per_unit, lsb = (79.4, 1.0) if unit == "code" else (0.024, 1e-4)
        lsb *= 0.01 if sensor == "cvg" else 1.0
    scale = per_unit * rng.uniform(0.9, 1.1, count) * rng.choice([1.0, 1.0, -1.0], count)
    if sensor == "accelerometer":
        linear = rng.normal(size=(count, 3)) * 0.01
        linear[np.arange(count), list(axes)] = 1.0
        offset = rng.normal(size=count) * 0.05
    else:
        linear = rng.normal(size=(count, 3)) * (3e-4 if sensor == "cvg" else 0.08)
        offset = rng.normal(size=count) * (0.01 if sensor == "cvg" else 1.0)
    true, recorded = temperatures(plan, rng)
    amplitude = 1.9 + wander(plan.time, 2e-4, 900.0, rng)
    return World(
        plan=plan,
        sensor=sensor,
        axes=axes,
        unit=unit,
        scale=scale,
        offset=offset,
        linear=linear,
        levels=true_levels(sensor, rng, coloured),
        warmth=true,
        recorded=recorded,
        lsb=lsb,
        first_sense=float(rng.choice([-1.0, 1.0])),
        amplitude=amplitude,
        has_temperature=has_temperature,
        has_se=has_se,
        has_amplitude=has_amplitude,
    )


def across(plan: Plan) -> list[int]:
    """Case axes that no setup lays along the shaft; failing that the one laid there last."""
    laid = ["XYZ".index(mount[0]) for mount in plan.mount]
    if plan.test == "rate_table":
        return [2]
    free = [axis for axis in range(3) if axis not in laid]
    return free or [2]
