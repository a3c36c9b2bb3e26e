"""What a plan can show before anything is measured.

Usual sensors walk it on the simulated bench, with noise and nothing else. Needs no Qt.
"""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.discrepancy.ladder import Ladder, explain
from core.discrepancy.result import Explanation
from core.discrepancy.settings import Settings
from core.errors import RankDeficient
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Effect, Sensor
from core.model.sensor_model import SensorModel
from core.plans.plan import Plan
from core.samples.run import Conditions, Run
from core.units import PPM, RAD_PER_ARCSEC
from drivers.virtual.rows import Found, walk_rows
from gui.discrepancy.working import Story

_G = 9.8106
_HEAD_ARCSEC, _TABLE_PPM = 5.0, 100.0
_BETWEEN_S = 10.0
_SETTINGS = Settings(advise=False)


@dataclass(frozen=True, slots=True)
class _Nominal:
    """A usual sensor: kind, scale factor, zero, white noise of a sample stream, slow noise."""

    kind: str
    scale: float
    zero: float
    density: float
    drift: float


_ACCELEROMETER = _Nominal("accelerometer", 1335.0, -230.0, 1.6, 0.3)
_GYRO = _Nominal("gyro", 79.4, -438.0, 4.0, 0.6)


def graded(plan: Plan, passes: int) -> Story:
    """A walk through a plan with nominal sensors in which nothing is hidden.

    Parameters
    ----------
    plan : on the head or on the table
    passes : how often it is walked
    """
    run = nominal_run(plan, passes)
    path = (Path(plan.title),)
    try:
        ladder = Ladder.of(run, _SETTINGS)
    except RankDeficient:
        return Story(run, path, None, explain(run, _SETTINGS))
    return Story(run, path, ladder, ladder.explanation)


def nominal_run(plan: Plan, passes: int) -> Run:
    """The rows of a plan, measured by usual sensors of which every axis that turns has one."""
    nominal = _ACCELEROMETER if plan.test == "dividing_head" else _GYRO
    steps = plan.steps * passes
    n = len(steps)
    axes = _axes(plan)
    every = plan.accumulation_s + plan.settle_s + _BETWEEN_S
    t = every * np.arange(n)
    white = nominal.density / np.sqrt(2.0 * plan.accumulation_s)
    on_table = plan.test == "rate_table"
    rates = np.array([step.rate_dps for step in steps])
    empty = Run(
        test=plan.test,
        sensor=nominal.kind,
        device=plan.title,
        channels=tuple(f"{nominal.kind[:4]}_{axis}" for axis in axes),
        axes=tuple(axes),
        unit="code",
        y=np.random.default_rng(1).standard_normal((n, len(axes))),
        y_se=np.full((n, len(axes)), white),
        run=frozen_int([1 + place // len(plan.steps) for place in range(n)]),
        order=np.arange(n),
        mount=tuple(step.mount for step in steps),
        head_deg=frozen([np.nan if on_table else step.head_deg for step in steps]),
        set_rate_dps=frozen(rates if on_table else np.full(n, np.nan)),
        temperature_c=frozen(24.0 + 0.6 * (1.0 - np.exp(-t / 1500.0)) + 0.02 * np.sin(t / 97.0)),
        t_s=frozen(t),
        conditions=Conditions(
            g_mps2=_G,
            accumulation_s=plan.accumulation_s,
            head_u_arcsec=_HEAD_ARCSEC,
            rate_u_ppm=_TABLE_PPM,
            sample_rate_hz=10.0,
        ),
    )
    setting = PPM * _TABLE_PPM * np.abs(rates)
    if not on_table:
        setting = np.full(n, RAD_PER_ARCSEC * _HEAD_ARCSEC)
    found = Found(
        models=[_model(plan.test, nominal, axis) for axis in axes],
        white=np.full(len(axes), white),
        drift=np.full(len(axes), nominal.drift),
        setting=setting,
        repeating=setting,
    )
    scaled = np.full((n, len(axes)), nominal.scale * max(_G, float(np.abs(rates).max())))
    y = walk_rows(replace(empty, y=frozen(scaled)), found, 1)
    return replace(empty, y=frozen(y))


def counts_of(told: Explanation) -> tuple[int, int, int]:
    """How many effects the rows can name alone, only together with others, and not at all."""
    tied = sum(bool(each.aliases) for each in told.smallest)
    return len(told.smallest) - tied, tied, len(told.invisible) + len(told.untested)


def _axes(plan: Plan) -> str:
    if plan.test != "rate_table":
        return "xyz"
    turned = {(step.mount or step.axis or "z")[:1].lower() for step in plan.steps}
    return "".join(axis for axis in AXES if axis in turned)


def _model(test: str, nominal: _Nominal, axis: str) -> tuple[SensorModel, FloatArray]:
    if test == "static_positions":
        effects: tuple[Effect, ...] = (CATALOGUE["bias"], AccelerationSensitiveDrift("xyz"))
        model = SensorModel(Sensor(nominal.kind, axis, "code"), effects)
        return model, frozen([nominal.zero, 0.4, 1.2, -0.5])
    response = tuple(nominal.scale * (1.0 if other == axis else 0.01) for other in AXES)
    model = SensorModel(
        Sensor(nominal.kind, axis, "code", response),
        (CATALOGUE["bias"], CATALOGUE["scale_factor"], CrossAxis("xyz")),
    )
    return model, frozen([nominal.zero, nominal.scale, *([0.01 * nominal.scale] * 2)])
