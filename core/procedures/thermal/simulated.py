"""A simulated triad taken through a temperature cycle on the dividing head, for trying out."""

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.plans.plan import Plan
from core.samples.run import Conditions, Run

G_MPS2 = 9.8106
UNIT = "code"
BIAS = frozen([[40.0, 0.8, 0.004], [-25.0, -0.5, 0.0], [10.0, 0.0, 0.0]])
"""Of X, Y, Z: code, code/degC, code/degC^2 about 27 degC."""
SCALE = frozen([[800.0, 0.16], [810.0, -0.2], [-790.0, 0.05]])
"""Of X, Y, Z: code/(m/s^2), and that over degC."""
CROSS = frozen([[0.0, 5.0, -3.0], [2.0, 0.0, 4.0], [-6.0, 1.0, 0.0]])
"""Cross-axis sensitivity, code/(m/s^2)."""
REFERENCE_C = 27.0
_WANDER_C = 0.4
_LAG = 6.0
"""What the bias of X is more after heating than after cooling, code."""


def simulated_cycle(plan: Plan, seed: int, *, noise: float = 1.0, lag: float = _LAG) -> Run:
    """The plan's positions at each of its temperatures.

    Parameters
    ----------
    plan : of the dividing head, with temperatures
    seed : of noise and chamber
    noise : standard deviation of a mean, code
    lag : hysteresis of the X sensor, code
    """
    rng = np.random.default_rng(seed)
    rows: list[FloatArray] = []
    measured: list[float] = []
    before = plan.temperatures_c[0]
    for nominal in plan.temperatures_c:
        heated = lag if nominal > before else 0.0
        for step in plan.steps:
            t = nominal + rng.uniform(-_WANDER_C, _WANDER_C)
            powers = (t - REFERENCE_C) ** np.arange(3)
            k = np.diag(SCALE @ powers[:2]) + CROSS
            rows.append(BIAS @ powers + k @ step.specific_force(G_MPS2) + [heated, 0.0, 0.0])
            measured.append(t)
        before = nominal
    y = np.array(rows) + noise * rng.standard_normal((len(rows), 3))
    n, steps = len(y), plan.steps * len(plan.temperatures_c)
    unknown = frozen(np.full(n, np.nan))
    return Run(
        test=plan.test,
        sensor="accelerometer",
        device="simulated triad",
        channels=("X", "Y", "Z"),
        axes=("x", "y", "z"),
        unit=UNIT,
        y=frozen(y),
        y_se=frozen(np.full_like(y, noise)),
        run=frozen_int(np.arange(n) // len(plan.steps) + 1),
        order=frozen_int(np.arange(n)),
        mount=tuple(step.mount for step in steps),
        head_deg=frozen([step.head_deg for step in steps]),
        set_rate_dps=unknown,
        temperature_c=frozen(measured),
        t_s=unknown,
        conditions=Conditions(g_mps2=G_MPS2, accumulation_s=plan.accumulation_s),
        meta={"plan": plan.id},
    )
