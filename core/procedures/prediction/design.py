"""Uncertainty of each parameter from the design matrix of a plan and the noise.

The estimate is linear in the rows, values = inverse @ y, so its covariance follows before any y is
known: white noise and noise with memory through the times of the accumulations, the error of each
setting through the slope of the output, g common to all.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.fit.design import Design
from core.fit.variance import setting_errors
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stimulus_of
from core.plans.plan import Plan
from core.procedures.prediction.bench import Bench
from core.procedures.slow_noise import combined_covariance, in_turn
from core.samples.run import Run

_MINUTE = 60.0


@dataclass(frozen=True, slots=True)
class Quantity:
    """What is reported: a linear combination of the parameters of a model.

    Parameters
    ----------
    name, symbol, unit : of the quantity
    weights : (p,) of the parameters
    """

    name: str
    symbol: str
    unit: str
    weights: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Predicted:
    """One parameter before it is measured.

    Parameters
    ----------
    name, symbol, unit : of the parameter
    u : standard uncertainty, k = 1
    noise, memory, setting, gravity : shares of its square: white noise; flicker and random walk;
        settings of head or table; local g
    """

    name: str
    symbol: str
    unit: str
    u: float
    noise: float
    memory: float
    setting: float
    gravity: float

    @property
    def limited_by(self) -> str:
        """What contributes most."""
        shares = {
            "white noise": self.noise,
            "noise with memory": self.memory,
            "settings": self.setting,
            "local g": self.gravity,
        }
        return max(shares, key=lambda name: shares[name])


@dataclass(frozen=True, slots=True)
class Prediction:
    """All parameters of a plan.

    Parameters
    ----------
    parameters : what the plan determines
    free : what the method could give, but not by this plan
    dof : rows less parameters; what is left to contradict the model
    rows : accumulations
    minutes : time that they take with settling and turning, without waiting for temperatures
    """

    parameters: tuple[Predicted, ...]
    free: tuple[str, ...]
    dof: int
    rows: int
    minutes: float

    def u(self, name: str) -> float:
        """Predicted standard uncertainty of one parameter; NaN where it stays free."""
        return next((one.u for one in self.parameters if one.name == name), float("nan"))


def run_of_plan(plan: Plan, bench: Bench) -> Run:
    """The rows that a plan will give, their outputs still zero."""
    steps = plan.steps * max(len(plan.temperatures_c), 1)
    n = len(steps)
    temperatures = np.repeat(plan.temperatures_c or (np.nan,), len(plan.steps))
    starts, _ = _schedule(plan, bench, n)
    return Run(
        test=plan.test,
        sensor=bench.kind,
        device="",
        channels=("u",),
        axes=(bench.axis,),
        unit=bench.sensor.unit,
        y=np.zeros((n, 1)),
        y_se=np.full((n, 1), np.nan),
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n, dtype=np.int64),
        mount=tuple(step.mount for step in steps),
        head_deg=np.array([step.head_deg for step in steps]),
        set_rate_dps=np.array([step.rate_dps for step in steps]),
        temperature_c=temperatures,
        t_s=starts,
    )


def stimulus_of_plan(plan: Plan, bench: Bench) -> Stimulus:
    """What will act on the sensor, row by row.

    Raises
    ------
    FitError
        Local gravity is not stated where the plan needs it.
    """
    return stimulus_of(run_of_plan(plan, bench), bench.conditions.g_mps2, base=bench.base)


def predict_design(
    plan: Plan,
    bench: Bench,
    stimulus: Stimulus,
    model: SensorModel,
    nominal: FloatArray,
    quantities: Sequence[Quantity],
    free: tuple[str, ...] = (),
) -> Prediction:
    """Predict the uncertainty of quantities that follow from a linear model.

    Parameters
    ----------
    plan, bench : what will be measured, and with what
    stimulus : what will act
    model : the effects that will be fitted
    nominal : (p,) expected values, for the slope of the output at each setting
    quantities : what to report
    free : what the method could give, but not by this plan

    Raises
    ------
    RankDeficient
        The plan leaves parameters of the model free.
    FitError
        The noise is not known.
    """
    design = Design.of(model, stimulus)
    n = len(stimulus)
    if not bench.noise.random_walk > 0:
        raise FitError("state the white noise of the sensor (N of its Allan analysis)")
    settings = setting_errors(model, nominal, stimulus, bench.conditions)
    white = bench.noise.random_walk**2 / plan.accumulation_s
    variance = white + (settings**2).sum(axis=0)
    inverse = design.solve(np.zeros(n), variance).inverse
    to_reported = np.array([quantity.weights for quantity in quantities])
    weights = to_reported @ inverse
    starts, lengths = _schedule(plan, bench, n)
    parts = np.array(
        [
            (weights**2).sum(axis=1) * white,
            np.diag(combined_covariance(bench.noise, weights, starts, lengths)),
            ((weights**2) @ (settings**2).sum(axis=0)),
            _by_gravity(model, stimulus, nominal, weights, bench),
        ]
    )
    parts[1] = np.maximum(parts[1] - parts[0], 0.0)
    total = parts.sum(axis=0)
    return Prediction(
        parameters=tuple(
            Predicted(q.name, q.symbol, q.unit, float(np.sqrt(t)), *(shares / t).tolist())
            for q, t, shares in zip(quantities, total, parts.T, strict=True)
        ),
        free=free,
        dof=n - len(nominal),
        rows=n,
        minutes=float(starts[-1] + lengths[-1]) / _MINUTE,
    )


def _schedule(plan: Plan, bench: Bench, n: int) -> tuple[FloatArray, FloatArray]:
    return in_turn(n, plan.accumulation_s, plan.settle_s + bench.pause_s)


def _by_gravity(
    model: SensorModel, stimulus: Stimulus, nominal: FloatArray, weights: FloatArray, bench: Bench
) -> FloatArray:
    """Variance (q,) by the uncertainty of g."""
    conditions = bench.conditions
    if not conditions.u_g_mps2 > 0:
        return np.zeros(len(weights))
    relative = conditions.u_g_mps2 / conditions.g_mps2
    step = 1e-6
    changed = model.predict(stimulus.scaled_force(1.0 + step), nominal)
    slope = (changed - model.predict(stimulus, nominal)) / step
    return (weights @ slope * relative) ** 2
