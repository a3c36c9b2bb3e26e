"""All rows of a temperature cycle at once (source 002, (4) to (7)).

The source stands each axis along gravity while the chamber warms up. That puts the temperature
coefficient of the scale factor into that of the bias: 0.02 %/degC of scale factor reads as 0.2
mg/degC of bias. Here each temperature holds the axis up and down, as the positions of the dividing
head do, and one fit separates the two. The points a_tj of (7) must be a_j - G_j p_j + b_j with the
static p_j, not with p_tj.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from itertools import product

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note, RankDeficient, Severity
from core.fit.linear import Rows, fit_sensor
from core.fit.result import FitResult
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stimulus_of
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.calibration import Provenance
from core.procedures.thermal.orders import (
    OrderScore,
    highest_order,
    lowest_orders,
    order_scores,
)
from core.procedures.thermal.over_temperature import OverTemperature
from core.procedures.thermal.plateaus import Plateau, plateaus_of
from core.procedures.thermal.points import Hysteresis, ThermalPoint, hysteresis_of, points_of
from core.procedures.triad import Triad, triad_of
from core.samples.run import Conditions, Run
from core.version import SOFTWARE

PROCEDURE = "sensors over temperature, source 002 (4) to (7)"
HIGHEST = 3
_MARGIN_C = 1.0
"""Visits to one temperature of the chamber scatter by some tenths of a degree."""


@dataclass(frozen=True, slots=True, eq=False)
class ThermalChannel:
    """One sensor over temperature.

    Parameters
    ----------
    channel, axis : output, its nominal case axis
    fit : `bias`, `bias_t1`, ..., `scale_factor`, `scale_factor_t1`, ..., cross axes
    bias_order, scale_order : of the polynomials
    scores : how other orders did at temperatures left out; empty where none could be
    points : bias and scale factor of each plateau by itself
    hysteresis : for each temperature reached both ways
    """

    channel: str
    axis: str
    fit: FitResult
    bias_order: int
    scale_order: int
    scores: tuple[OrderScore, ...]
    points: tuple[ThermalPoint, ...]
    hysteresis: tuple[Hysteresis, ...]

    @property
    def largest_hysteresis(self) -> float:
        """Largest difference of the bias between heating and cooling, output unit; NaN if none."""
        return max((abs(one.bias.value) for one in self.hysteresis), default=float("nan"))


@dataclass(frozen=True, slots=True, eq=False)
class ThermalCalibration:
    """The sensors of a unit over temperature.

    Parameters
    ----------
    unit : of the outputs
    channels : (c,) one a sensor
    reference_c : polynomials are in the temperature less this
    low_c, high_c : measured temperatures
    notes : doubts about the unit as a whole; each fit has its own besides
    provenance : where it comes from
    """

    unit: str
    channels: tuple[ThermalChannel, ...]
    reference_c: float
    low_c: float
    high_c: float
    conditions: Conditions
    notes: tuple[Note, ...]
    provenance: Provenance

    def fit_at(self, channel: int, temperature_c: float, *, extrapolate: bool = False) -> FitResult:
        """The fit of one sensor with its parameters at one temperature.

        Raises
        ------
        FitError
            The temperature was not measured, and `extrapolate` does not allow it.
        """
        self._refuse_beyond(np.array([temperature_c]), extrapolate)
        fit = self.channels[channel].fit
        names = [name for name in fit.names if "_t" not in name]
        t = temperature_c - self.reference_c
        to_now = np.zeros((len(names), len(fit.names)))
        for place, full in enumerate(fit.names):
            name, _, power = full.partition("_t")
            to_now[names.index(name), place] = t ** int(power or 0)
        return replace(
            fit,
            parameters=tuple(fit.parameters[fit.index(name)] for name in names),
            values=frozen(to_now @ fit.values),
            covariance=frozen(to_now @ fit.covariance @ to_now.T),
            shared=frozen(to_now @ fit.shared),
            t_dof=frozen(np.full(len(names), fit.t_dof.min())),
        )

    def triad_at(self, temperature_c: float, *, extrapolate: bool = False) -> Triad:
        """Three sensors as one, at one temperature.

        Raises
        ------
        FitError
            As `fit_at`; or the sensors are no triad.
        """
        axes = tuple(one.axis for one in self.channels)
        fits = (self.fit_at(c, temperature_c, extrapolate=extrapolate) for c in range(len(axes)))
        return triad_of(axes, tuple(fits))

    def _refuse_beyond(self, temperature_c: FloatArray, extrapolate: bool) -> None:
        if extrapolate:
            return
        low, high = self.low_c - _MARGIN_C, self.high_c + _MARGIN_C
        if not (temperature_c.min() >= low and temperature_c.max() <= high):
            raise FitError(
                f"{temperature_c.min():.1f} ... {temperature_c.max():.1f} degC leaves the measured"
                f" {self.low_c:.1f} ... {self.high_c:.1f} degC; polynomials mean nothing outside"
            )


def calibrate_thermal(
    run: Run,
    conditions: Conditions,
    *,
    base: BaseOrientation = LEVEL,
    bias_order: int | None = None,
    scale_order: int | None = None,
    cross_order: int = 0,
    reference_c: float = np.nan,
) -> ThermalCalibration:
    """Estimate every sensor of a run over the temperatures of the run.

    Parameters
    ----------
    run : rows on the dividing head (or the rate table), each with its temperature
    conditions : g with its uncertainty, setting errors
    base : how the head's base plate stands
    bias_order, scale_order : of the polynomials; chosen by cross-validation if not stated
    cross_order : the same of the cross axes
    reference_c : temperature at which the constant terms hold; by default that of the first rows

    Raises
    ------
    FitError
        One temperature only, too few temperatures for an order, or a temperature is missing.
    RankDeficient
        The axis stood in one sense only: bias and scale factor cannot be told apart.
    """
    plateaus = plateaus_of(run.temperature_c, run.order)
    levels = max(plateau.level for plateau in plateaus) + 1
    if levels < 2:
        raise FitError(
            f"all rows were measured at {plateaus[0].temperature_c:.1f} degC; a dependence on"
            " temperature needs two temperatures, to test one three"
        )
    for order in (bias_order or 0, scale_order or 0, cross_order):
        if order > levels - 1:
            raise FitError(
                f"order {order} needs {order + 1} temperatures ({order + 2} to test it), there are"
                f" {levels}"
            )
    if np.isnan(reference_c):
        reference_c = round(plateaus[0].temperature_c, 1)
    stimulus = stimulus_of(run, conditions.g_mps2, base=base)
    asked = (bias_order, scale_order, cross_order)
    channels = tuple(
        _channel(run, stimulus, conditions, c, plateaus, asked, reference_c)
        for c in range(len(run.channels))
    )
    return ThermalCalibration(
        unit=run.unit,
        channels=channels,
        reference_c=reference_c,
        low_c=float(run.temperature_c.min()),
        high_c=float(run.temperature_c.max()),
        conditions=conditions,
        notes=(*run.notes, *_notes(levels, plateaus, channels)),
        provenance=Provenance(
            procedure=PROCEDURE,
            device=run.device,
            profile=str(run.meta.get("profile", "")),
            plan=str(run.meta.get("plan", "")),
            software=SOFTWARE,
            measured_utc=str(run.meta.get("measured_utc", "")),
            computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
        ),
    )


_Asked = tuple[int | None, int | None, int]


def _channel(
    run: Run,
    stimulus: Stimulus,
    conditions: Conditions,
    channel: int,
    plateaus: tuple[Plateau, ...],
    asked: _Asked,
    reference_c: float,
) -> ThermalChannel:
    axis = run.axes[channel]
    if not axis:
        raise FitError(f"{run.channels[channel]}: state the case axis along which it looks")
    sensor = Sensor(run.sensor, axis, run.unit)
    inputs = sensor.input(stimulus)
    excited = [other for other in sensor.cross_axes if np.ptp(inputs[:, AXES.index(other)]) > 1e-9]

    def model(bias: int, scale: int) -> SensorModel:
        effects = (
            OverTemperature(CATALOGUE["bias"], bias, reference_c),
            OverTemperature(CATALOGUE["scale_factor"], scale, reference_c),
            OverTemperature(CrossAxis("".join(excited)), asked[2], reference_c),
        )
        return SensorModel(sensor, effects)

    def design(bias: int, scale: int) -> FloatArray:
        return model(bias, scale).design(stimulus)

    if np.ptp(inputs[:, sensor.index]) < 1e-6 * np.abs(inputs).max():
        raise RankDeficient(
            ("U0", f"k_{axis}"),
            f"the {axis} axis felt the same in all rows, where a change of the scale factor with"
            " temperature reads as one of the bias; measure it up and down at each temperature",
        )
    y = run.y[:, channel]
    bias, scale, scores = _orders(asked, design, y, plateaus)
    se_dof = run.extra.get("se_dof", np.full(len(run), np.inf))
    rows = Rows(y, run.y_se[:, channel], se_dof)
    fit = fit_sensor(model(bias, scale), stimulus, rows, conditions)
    t = np.array([plateau.temperature_c for plateau in plateaus]) - reference_c
    modelled = (_polynomial(fit, "bias", t), _polynomial(fit, "scale_factor", t))
    points = points_of(fit, inputs[:, sensor.index], modelled, plateaus)
    return ThermalChannel(
        channel=run.channels[channel],
        axis=axis,
        fit=fit,
        bias_order=bias,
        scale_order=scale,
        scores=scores,
        points=points,
        hysteresis=hysteresis_of(points),
    )


def _polynomial(fit: FitResult, name: str, t: FloatArray) -> FloatArray:
    total = np.zeros_like(t)
    for full, value in zip(fit.names, fit.values, strict=True):
        base, _, power = full.partition("_t")
        if base == name:
            total += value * t ** int(power or 0)
    return total


def _orders(
    asked: _Asked,
    design: Callable[[int, int], FloatArray],
    y: FloatArray,
    plateaus: tuple[Plateau, ...],
) -> tuple[int, int, tuple[OrderScore, ...]]:
    level = np.zeros(len(y), dtype=np.int64)
    for plateau in plateaus:
        level[plateau.rows] = plateau.level
    highest = highest_order(int(level.max()) + 1, HIGHEST)
    biases, scales = (
        range(highest + 1) if order is None else (order,) for order in (asked[0], asked[1])
    )
    scores = order_scores(list(product(biases, scales)), design, y, level)
    if not scores:
        return max(biases), max(scales), ()
    best = lowest_orders(scores)
    return best.bias, best.scale, scores


def _notes(
    levels: int, plateaus: tuple[Plateau, ...], channels: tuple[ThermalChannel, ...]
) -> list[Note]:
    notes: list[Note] = []
    if levels == 2:
        notes.append(
            Note(
                Severity.WARNING,
                "two_temperatures",
                "two temperatures give a straight line that nothing can contradict; measure a"
                " third between them",
            )
        )
    one_sense = sorted(
        {
            f"{plateau.temperature_c:.0f}"
            for channel in channels
            for plateau, point in zip(plateaus, channel.points, strict=True)
            if np.isnan(point.scale_factor.value)
        }
    )
    if one_sense:
        notes.append(
            Note(
                Severity.WARNING,
                "one_sense",
                f"at {', '.join(one_sense)} degC an axis did not stand both up and down; there the"
                " scale factor is taken from the other temperatures",
            )
        )
    for channel in channels:
        seen = [one for one in channel.hysteresis if one.bias.significant]
        if seen:
            worst = max(seen, key=lambda one: abs(one.bias.value))
            notes.append(
                Note(
                    Severity.WARNING,
                    "hysteresis",
                    f"{channel.channel}: at {worst.temperature_c:.0f} degC the bias reached by"
                    f" heating is {worst.bias.value:+.3g} {worst.bias.unit} from that reached by"
                    " cooling; no function of the temperature can compensate that",
                )
            )
    return notes
