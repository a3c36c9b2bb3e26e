"""A triad in a climate chamber, written out by hand; and the public record of a standing unit."""

import gzip
from pathlib import Path

import numpy as np
import pytest

from core.plans.plan import load_plans
from core.samples.run import Run
from tests.plain_run import plain_run

G = 9.8106
PLAN = load_plans()["thermal_8"]
RECORD = Path(__file__).parents[3] / "data" / "tofupilot_imu_thermal" / "imu_thermal.csv.gz"
BIAS = np.array([[40.0, 0.8, 0.004], [-25.0, -0.5, 0.0], [10.0, 0.0, 0.0]])
"""Code, code/degC, code/degC^2 about 27 degC."""
SCALE = np.array([[800.0, 0.16, 0.0], [810.0, -0.2, 0.0], [-790.0, 0.05, 0.0]])
CROSS = np.array([[0.0, 5.0, -3.0], [2.0, 0.0, 4.0], [-6.0, 1.0, 0.0]])


def chamber(
    noise: float = 1.0,
    *,
    seed: int = 0,
    temperatures: tuple[float, ...] = PLAN.temperatures_c,
    hysteresis: float = 0.0,
    bias: np.ndarray = BIAS,
) -> Run:
    """The plan's positions at each temperature; `hysteresis` adds to X after heating."""
    rng = np.random.default_rng(seed)
    rows, actual, before = [], [], temperatures[0]
    for nominal in temperatures:
        lag = hysteresis if nominal > before else 0.0
        for step in PLAN.steps:
            t = nominal + rng.uniform(-0.4, 0.4)
            s, c = np.sin(np.radians(step.head_deg)), np.cos(np.radians(step.head_deg))
            a = G * np.array({"X_from": (0.0, -s, c), "Y_from": (s, 0.0, c)}[step.mount])
            powers = (t - 27.0) ** np.arange(3)
            k = np.diag(SCALE @ powers) + CROSS
            rows.append(bias @ powers + k @ a + np.array([lag, 0.0, 0.0]))
            actual.append(t)
        before = nominal
    y = np.array(rows)
    n = len(y)
    steps = PLAN.steps * len(temperatures)
    return plain_run(
        channels=("X", "Y", "Z"),
        y=y + noise * rng.standard_normal(y.shape),
        y_se=np.full_like(y, noise),
        run=np.arange(n) // 8 + 1,
        mount=tuple(step.mount for step in steps),
        head_deg=np.array([step.head_deg for step in steps]),
        temperature_c=np.array(actual),
    )


def standing(kind: str) -> Run:
    """The public record: ``"rate"`` or ``"acc"``."""
    with gzip.open(RECORD, "rt", encoding="utf-8") as file:
        table = np.genfromtxt(file, delimiter=",", names=True)
    names = tuple(f"{kind}_{axis}" for axis in "xyz")
    y = np.column_stack([table[name] for name in names])
    return plain_run(
        test="record",
        sensor="gyro" if kind == "rate" else "accelerometer",
        device="chamber",
        channels=names,
        unit="deg/s" if kind == "rate" else "m/s^2",
        y=y,
        temperature_c=table["temperature_c"],
        t_s=table["t_s"],
    )


@pytest.fixture
def make_chamber():
    return chamber


@pytest.fixture(scope="session")
def rates() -> Run:
    return standing("rate")


@pytest.fixture(scope="session")
def forces() -> Run:
    return standing("acc")
