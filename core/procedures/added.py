"""Effects that were added to the plain model of a calibration, and the fit with them.

Model and data are compared elsewhere; what was found to be missing there comes here as a list of
effects, and every sensor is fitted anew with those that act on it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import FitError
from core.fit.linear import Rows, fit_sensor
from core.fit.result import FitResult
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Effect, Parameter, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions

IN_USE = frozenset(
    (
        *("second_order_nonlinearity", "third_order_nonlinearity", "odd_quadratic_nonlinearity"),
        *("cross_axis_nonlinearity", "cross_coupling", "scale_factor_asymmetry"),
        *("bias_asymmetry", "bias_temperature", "scale_factor_temperature"),
    )
)
"""Effects of the sensor itself, which act wherever it is used and are taken out there; all others
belong to the test that showed them."""

_ROUNDS = 3
_NOTHING_SEEN = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Added:
    """What is added to the plain models of a run.

    Parameters
    ----------
    effects : (name of the output, effect) in the order of being added; an empty name for all
    changes : (n,) by output: what has to be added to its rows so that they mean what they say
        (positions that were exchanged, a mount that was another one)
    columns : (n,) further regressors that the effects need
    """

    effects: tuple[tuple[str, Effect], ...] = ()
    changes: Mapping[str, FloatArray] = field(default_factory=dict[str, FloatArray])
    columns: Mapping[str, FloatArray] = field(default_factory=dict[str, FloatArray])

    def __bool__(self) -> bool:
        return bool(self.effects or self.changes)

    def of(self, channel: str) -> tuple[Effect, ...]:
        """Effects of one output."""
        return tuple(effect for name, effect in self.effects if name in ("", channel))

    def change(self, channel: str, rows: IntArray | slice) -> FloatArray | float:
        """What has to be added to these rows of an output."""
        found = self.changes.get(channel)
        return 0.0 if found is None else found[rows]


NOTHING = Added()


@dataclass(frozen=True, slots=True)
class AddedEffect:
    """One effect in a fit.

    Parameters
    ----------
    effect, name, equation : identifier, standard name, the term that it adds to the output
    shape : name, value and unit of what it is fixed at (time constant, level, row)
    places : places of its parameters in the fit
    """

    effect: str
    name: str
    equation: str
    shape: tuple[tuple[str, float, str], ...]
    places: tuple[int, ...]

    @property
    def in_use(self) -> bool:
        """Whether it acts wherever the sensor is used, and not in this test alone."""
        return self.effect in IN_USE

    @property
    def reach(self) -> str:
        """The same in words, for the exports."""
        return "of the sensor" if self.in_use else "of this test alone"


class _Fixed(Effect):
    """An effect with the columns that it has in rows which were picked from a run."""

    def __init__(self, effect: Effect, columns: FloatArray) -> None:
        self.effect, self._columns = effect, columns

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Those of the effect."""
        return self.effect.parameters(sensor)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:  # noqa: ARG002
        """The columns, whatever acts: an effect is small, its changes by errors are nothing."""
        return self._columns


def with_effects(
    plain: FitResult,
    sensor: Sensor,
    stimulus: Stimulus,
    rows: Rows,
    conditions: Conditions,
    effects: Sequence[Effect],
    columns: Mapping[str, FloatArray],
    chosen: IntArray | None = None,
) -> tuple[FitResult, tuple[AddedEffect, ...]]:
    """Fit one sensor with further effects.

    Parameters
    ----------
    plain : its fit without them; bias, scale factor, cross axes, g-sensitivity
    sensor : whose output
    stimulus : what acted in all rows of the run, n rows
    rows : what was measured, m rows
    conditions : as those of the plain fit
    effects : to be added; what does not act on this sensor is passed over
    columns : (n,) further regressors that they need
    chosen : (m,) rows of the run that were fitted; None for all

    Returns
    -------
    The fit, its first parameters those of the plain one, and what was added.

    Raises
    ------
    RankDeficient
        The rows cannot tell an effect from the plain model.
    """
    picked = np.arange(len(stimulus)) if chosen is None else chosen
    wide = replace(stimulus, columns={**stimulus.columns, **columns})
    own = stimulus.rows(picked)
    base = _plain_effects(plain.names)
    fit, acting = plain, tuple[_Fixed, ...]()
    model = SensorModel(sensor, base)
    for _ in range(_ROUNDS):
        # The effects act by the response that is being fitted.
        model = SensorModel(replace(sensor, response=response_of(sensor, fit)), base)
        found = (_Fixed(e, e.columns(wide, model.sensor)[picked]) for e in effects)
        acting = tuple(one for one in found if _acts(one, own, model.sensor))
        if not acting:
            return plain, ()
        model = SensorModel(model.sensor, (*base, *acting))
        fit = fit_sensor(model, own, rows, conditions)
    fit = replace(fit, parameters=_told_apart(fit.parameters, model.sensor))
    added = tuple(
        AddedEffect(
            one.effect.id,
            one.effect.name,
            one.effect.equation,
            tuple((p.name, value, p.unit) for p, value in one.effect.shape),
            tuple(range(place.start, place.stop)),
        )
        for one, place in zip(acting, model.places[len(base) :], strict=True)
    )
    return fit, added


def response_of(sensor: Sensor, fit: FitResult) -> tuple[float, ...]:
    """Output per input along the case axes; empty where the fit tells no scale factor."""
    if "scale_factor" not in fit.names:
        return ()
    known = dict(zip(fit.names, fit.values.tolist(), strict=True))
    return tuple(
        known.get("scale_factor" if axis == sensor.axis else f"cross_axis_{axis}", 0.0)
        for axis in AXES
    )


def _plain_effects(names: Sequence[str]) -> tuple[Effect, ...]:
    """The plain model whose parameters have these names."""
    effects: list[Effect] = [CATALOGUE["bias"]]
    if "scale_factor" in names:
        effects.append(CATALOGUE["scale_factor"])
    crosses = [name[-1] for name in names if name.startswith("cross_axis_")]
    if crosses:
        effects.append(CrossAxis("".join(crosses)))
    gravity = [name[-1] for name in names if name.startswith("g_sensitivity_")]
    if gravity:
        effects.append(AccelerationSensitiveDrift("".join(gravity)))
    if len(names) != 1 + ("scale_factor" in names) + len(crosses) + len(gravity):
        raise FitError(f"effects are added to plain models alone, not to {', '.join(names)}")
    return tuple(effects)


def _acts(one: _Fixed, stimulus: Stimulus, sensor: Sensor) -> bool:
    columns = one.columns(stimulus, sensor)
    size = max(float(np.abs(sensor.sensitivity).max()), 1e-300)
    return columns.shape[1] > 0 and bool(np.all(np.abs(columns).max(axis=0) > _NOTHING_SEEN * size))


def bare_name(name: str) -> str:
    """A parameter's name without the number that tells it from another of the same name."""
    return name.rstrip("_0123456789")


def _told_apart(parameters: Sequence[Parameter], sensor: Sensor) -> tuple[Parameter, ...]:
    """The same with a number behind a name that stands there already.

    A gyro at rest has told no scale factor; its numbers are in units of the output.
    """
    bare = sensor.kind == "gyro" and not sensor.response
    seen: dict[str, int] = {}
    found: list[Parameter] = []
    for one in parameters:
        count = seen[one.name] = seen.get(one.name, 0) + 1
        unit = one.unit.replace("deg/s", sensor.unit) if bare else one.unit
        if count == 1:
            found.append(replace(one, unit=unit))
        else:
            found.append(Parameter(f"{one.name}_{count}", f"{one.symbol}_{count}", unit))
    return tuple(found)
