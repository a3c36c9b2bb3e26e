"""What each method gives, what it needs, and its model."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Effect
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.plans.plan import Plan
from core.procedures.earth import level_dps
from core.procedures.fourier.faults import check_angles
from core.procedures.fourier.series import Harmonics
from core.procedures.gyrocompass import EarthTurn
from core.procedures.prediction.bench import CHAMBER, HEAD, LEVEL_BASE, TABLE, Bench
from core.procedures.prediction.design import (
    Predicted,
    Prediction,
    Quantity,
    predict_design,
    stimulus_of_plan,
)
from core.procedures.thermal.over_temperature import OverTemperature
from core.units import DEG_PER_RAD, DPH_PER_DPS, MILLI, PPM

_EXCITED = 1e-6
_LEAST_LEVEL = 0.01
_SHOWN = {
    "scale_factor": (1.0 / PPM, "ppm"),
    "cross_axis": (1.0 / MILLI, "mrad"),
}
"""Ratios by the start of their names: factor and unit in which they are told."""

Predictor = Callable[[Plan, Bench], Prediction]


@dataclass(frozen=True, slots=True)
class Method:
    """One way of calibrating.

    Parameters
    ----------
    title : as the operator knows it
    kind : of the sensor
    tools : what the rig must have
    tests : plans of these tests serve
    over_temperature : whether the plan goes through temperatures
    gives, needs : in words
    page : name of its page in the docs
    predict : uncertainty of each parameter; None where there is no plan to predict from
    """

    title: str
    kind: str
    tools: tuple[str, ...]
    tests: tuple[str, ...]
    over_temperature: bool
    gives: str
    needs: str
    page: str
    predict: Predictor | None


def _positions(plan: Plan, bench: Bench) -> Prediction:
    """Bias, scale factor and cross axes from positions on the head, or from rates on the table."""
    stimulus = stimulus_of_plan(plan, bench)
    cross = _excited(bench.sensor.input(stimulus), bench.axis)
    effects = (CATALOGUE["bias"], CATALOGUE["scale_factor"], CrossAxis(cross))
    return _predict(plan, bench, stimulus, effects, _missing("cross_axis_", cross, bench.axis))


def _thermal(plan: Plan, bench: Bench) -> Prediction:
    """Bias to the second and scale factor to the first order of the temperature."""
    stimulus = stimulus_of_plan(plan, bench)
    cross = _excited(bench.sensor.input(stimulus), bench.axis)
    levels = len(set(plan.temperatures_c))
    reference = plan.temperatures_c[0]
    effects = (
        OverTemperature(CATALOGUE["bias"], min(2, levels - 1), reference),
        OverTemperature(CATALOGUE["scale_factor"], min(1, levels - 1), reference),
        CrossAxis(cross),
    )
    return _predict(plan, bench, stimulus, effects, _missing("cross_axis_", cross, bench.axis))


def _g_sensitivity(plan: Plan, bench: Bench) -> Prediction:
    """Zero and g-sensitivity of a gyro at rest."""
    stimulus = stimulus_of_plan(plan, bench)
    seen = _excited(stimulus.a)
    effects = (CATALOGUE["bias"], AccelerationSensitiveDrift(seen))
    return _predict(plan, bench, stimulus, effects, _missing("g_sensitivity_", seen))


def _tumble(plan: Plan, bench: Bench) -> Prediction:
    """Harmonics of one accelerometer over a turn."""
    stimulus = stimulus_of_plan(plan, bench)
    if len({step.mount for step in plan.steps}) > 1:
        raise FitError("a tumble is the turn of one mount")
    cross = _excited(stimulus.a, bench.axis)
    if len(cross) != 1 or _excited(stimulus.a).find(bench.axis) < 0:
        raise FitError(f"the {bench.axis} axis lies along the shaft")
    other = AXES.index(cross)
    alpha = np.arctan2(stimulus.a[:, bench.sensor.index], stimulus.a[:, other]) * DEG_PER_RAD
    check_angles(alpha, 2)
    g = bench.conditions.g_mps2
    model = SensorModel(bench.sensor, (Harmonics(2, cross),))
    quantities = (
        Quantity("bias", "C0", "m/s^2", (1.0, 0.0, 0.0, 0.0, 0.0)),
        Quantity("scale_factor", "k", "ppm", (0.0, 1.0 / g / PPM, 0.0, 0.0, 0.0)),
        Quantity("misalignment", "d", "deg", (0.0, 0.0, DEG_PER_RAD / g, 0.0, 0.0)),
        Quantity("second_sine", "C3", "m/s^2", (0.0, 0.0, 0.0, 1.0, 0.0)),
        Quantity("second_cosine", "C4", "m/s^2", (0.0, 0.0, 0.0, 0.0, 1.0)),
    )
    nominal = np.array([0.0, g, 0.0, 0.0, 0.0])
    found = predict_design(plan, bench, stimulus, model, nominal, quantities)
    return _with_gravity(found, bench)


def _with_gravity(found: Prediction, bench: Bench) -> Prediction:
    """Add the uncertainty of g to the scale factor; harmonics themselves do not depend on it."""
    u_g = float(np.nan_to_num(bench.conditions.u_g_mps2)) / bench.conditions.g_mps2 / PPM
    changed: list[Predicted] = []
    for one in found.parameters:
        if one.name == "scale_factor" and u_g > 0:
            total = float(np.hypot(one.u, u_g))
            kept = (one.u / total) ** 2
            shares = (one.noise * kept, one.memory * kept, one.setting * kept, (u_g / total) ** 2)
            changed.append(Predicted(one.name, one.symbol, one.unit, total, *shares))
        else:
            changed.append(one)
    return replace(found, parameters=tuple(changed))


def _gyrocompass(plan: Plan, bench: Bench) -> Prediction:
    """Heading and drift of a gyro on a level base."""
    latitude = bench.conditions.latitude_deg
    level = level_dps(latitude)
    if not level > _LEAST_LEVEL * level_dps(0.0):
        raise FitError("a gyrocompass needs the latitude, and a place that is no pole")
    headings = np.array([step.head_deg for step in plan.steps])
    nothing = np.zeros((len(headings), 3))
    columns = {"head_deg": headings, "tilt_deg": np.zeros_like(headings)}
    stimulus = Stimulus(nothing, nothing, nothing, nothing, columns)
    model = SensorModel(bench.sensor, (EarthTurn(),))
    quantities = (
        Quantity("heading", "psi", "deg", (0.0, DEG_PER_RAD / level, 0.0)),
        Quantity("drift", "d", "deg/h", (0.0, 0.0, DPH_PER_DPS)),
    )
    nominal = np.array([level, 0.0, 0.0])
    return predict_design(plan, bench, stimulus, model, nominal, quantities)


def _predict(
    plan: Plan, bench: Bench, stimulus: Stimulus, effects: tuple[Effect, ...], free: tuple[str, ...]
) -> Prediction:
    model = SensorModel(bench.sensor, effects)
    nominal = np.array([float(p.name == "scale_factor") for p in model.parameters])
    return predict_design(plan, bench, stimulus, model, nominal, _shown(model), free)


def _shown(model: SensorModel) -> list[Quantity]:
    """Every parameter of a model, ratios in ppm and mrad."""
    found: list[Quantity] = []
    for place, p in enumerate(model.parameters):
        weights, unit = np.zeros(len(model.parameters)), p.unit
        weights[place] = 1.0
        for start, (factor, name) in _SHOWN.items():
            if p.name.startswith(start):
                # What follows the ratio of output to input stays, e.g. /degC.
                weights[place], unit = factor, name + p.unit.partition(")")[2]
        found.append(Quantity(p.name, p.symbol, unit, tuple(weights.tolist())))
    return found


def _excited(values: FloatArray, own: str = "") -> str:
    """Axes other than `own` along which the input (n, 3) changes."""
    return "".join(
        axis for i, axis in enumerate(AXES) if axis != own and np.ptp(values[:, i]) > _EXCITED
    )


def _missing(start: str, seen: str, own: str = "") -> tuple[str, ...]:
    return tuple(f"{start}{axis}" for axis in AXES if axis not in seen and axis != own)


METHODS: dict[str, Method] = {
    "positions": Method(
        title="Positions on the dividing head",
        kind="accelerometer",
        tools=(HEAD,),
        tests=("dividing_head",),
        over_temperature=False,
        gives="bias, scale factor and cross-axis sensitivity of one to nine accelerometers; of a"
        " triad the matrix Q, non-orthogonality and mounting",
        needs="g; four positions about one axis for a part, six or eight for all of them",
        page="dividing_head",
        predict=_positions,
    ),
    "tumble": Method(
        title="Fourier tumble",
        kind="accelerometer",
        tools=(HEAD,),
        tests=("dividing_head",),
        over_temperature=False,
        gives="bias, sensitivity and misalignment of one accelerometer in the plane of rotation,"
        " and its second and third harmonic (nonlinearity)",
        needs="g; at least 5 different angles that are not all multiples of 90 degrees, better 80;"
        " a second run with the sensor turned over to tell the fixture from the sensor",
        page="tumble",
        predict=_tumble,
    ),
    "thermal": Method(
        title="Positions over temperature",
        kind="accelerometer",
        tools=(HEAD, CHAMBER),
        tests=("dividing_head",),
        over_temperature=True,
        gives="bias and scale factor against temperature, told apart, and their hysteresis",
        needs="g; each axis up and down at two temperatures or more, S + 2 for order S; both ways"
        " through the temperatures to see hysteresis",
        page="thermal",
        predict=_thermal,
    ),
    "rate_table": Method(
        title="Rates on the table",
        kind="gyro",
        tools=(TABLE,),
        tests=("rate_table",),
        over_temperature=False,
        gives="scale factor and zero of gyros, nonlinearity, asymmetry; cross axes by re-mounting",
        needs="three rates or more, of both signs",
        page="gyro",
        predict=_positions,
    ),
    "g_sensitivity": Method(
        title="g-sensitivity on the dividing head",
        kind="gyro",
        tools=(HEAD,),
        tests=("static_positions",),
        over_temperature=False,
        gives="how gravity shifts the zero of gyros",
        needs="g; four positions about one axis, eight for all three; the latitude for gyros that"
        " feel the Earth",
        page="gyro",
        predict=_g_sensitivity,
    ),
    "drift": Method(
        title="Drift after switching on",
        kind="gyro",
        tools=(CHAMBER,),
        tests=(),
        over_temperature=True,
        gives="a table of the drift against time and chip temperature, for a microcontroller",
        needs="about five turn-ons at each of several temperatures, at most 10 to 20 degC apart,"
        " cooled down between them",
        page="drift",
        predict=None,
    ),
    "gyrocompass": Method(
        title="Gyrocompass",
        kind="gyro",
        tools=(LEVEL_BASE,),
        tests=("headings",),
        over_temperature=False,
        gives="heading of the base and systematic drift of the gyro",
        needs="a gyro with far less drift than the level part of the Earth's rate; three headings"
        " or more, best in steps of 90 degrees; the tilt by an accelerometer; no pole",
        page="gyrocompass",
        predict=_gyrocompass,
    ),
}
