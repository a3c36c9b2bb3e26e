"""g-sensitivity of gyros on the dividing head, (3.7) to (3.9).

At rest in different positions a gyro feels the gravity that shifts its zero, and the Earth that it
is meant to feel. The vertical part of the Earth's rate follows the position exactly as gravity
does: left out, it goes one to one into b_ii (11.6 deg/h per g in Kyiv). So latitude and azimuth
belong to the stimulus wherever the gyro is good enough.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note
from core.fit.estimate import Estimate, parameter, quotient, ratio
from core.fit.linear import Rows, fit_sensor
from core.fit.result import FitResult
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Effect, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stimulus_of
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.added import NOTHING, Added, AddedEffect, with_effects
from core.procedures.calibration import Calibration, Provenance
from core.procedures.earth import azimuth_missing, feels, latitude_missing, level_dps, vertical_dps
from core.samples.run import Conditions, Run
from core.units import DPH_PER_DPS, EARTH_RATE_DPS
from core.version import SOFTWARE

PROCEDURE = "g-sensitivity on the dividing head, practicum (3.7) to (3.9)"
EXCITED = 1e-6
"""Inputs that change by less, in their own unit, tell nothing."""


@dataclass(frozen=True, slots=True, eq=False)
class GSensor:
    """One gyro at rest in different positions.

    Parameters
    ----------
    channel, axis : name of the output, the sensor's own case axis
    fit : `bias` and `g_sensitivity_*`; with the table also `scale_factor` and `cross_axis_*`
    scale_factor : output per deg/s, from the fit or from an earlier one; None where none is known
    g_mps2 : local gravity
    notes : doubts about this sensor
    effects : what was added to its plain model
    """

    channel: str
    axis: str
    fit: FitResult
    scale_factor: Estimate | None
    g_mps2: float
    notes: tuple[Note, ...]
    effects: tuple[AddedEffect, ...] = ()

    @property
    def axes(self) -> tuple[str, ...]:
        """The case axes whose g-sensitivity the positions tell."""
        return tuple(name[-1] for name in self.fit.names if name.startswith("g_sensitivity_"))

    def b(self, axis: str) -> Estimate:
        """g-sensitivity along a case axis, output/(m/s^2)."""
        return parameter(self.fit, f"g_sensitivity_{axis}")

    def b_dps(self, axis: str) -> Estimate:
        """The same in (deg/s)/(m/s^2).

        Raises
        ------
        FitError
            No scale factor is known.
        """
        return self._in_rate(f"g_sensitivity_{axis}", "(deg/s)/(m/s^2)")

    def b_dps_per_g(self, axis: str) -> Estimate:
        """The same in (deg/s)/g of local gravity."""
        return self.b_dps(axis).scaled(self.g_mps2, "(deg/s)/g")

    def b_dph_per_g(self, axis: str) -> Estimate:
        """The same in (deg/h)/g of local gravity."""
        return self.b_dps_per_g(axis).scaled(DPH_PER_DPS, "(deg/h)/g")

    @property
    def bias(self) -> Estimate:
        """Zero without gravity over scale factor, deg/s."""
        return self._in_rate("bias", "deg/s")

    def _in_rate(self, name: str, unit: str) -> Estimate:
        if "scale_factor" in self.fit.names:
            return ratio(self.fit, name, "scale_factor", unit)
        if self.scale_factor is None:
            raise FitError(
                f"{self.channel}: no scale factor is known, so that codes cannot become deg/s;"
                " measure it on the rate table"
            )
        return quotient(parameter(self.fit, name), self.scale_factor, unit)


@dataclass(frozen=True, slots=True, eq=False)
class GSensitivity:
    """All gyros of one head run, with or without a table run.

    Parameters
    ----------
    device, unit : name of the unit, unit of its outputs
    sensors : (c,) one a gyro
    conditions : what the laboratory states
    temperature_c : mean temperature, NaN if it was not measured in degrees
    procedure : which of the two it was
    notes : doubts about the runs as a whole
    """

    device: str
    unit: str
    sensors: tuple[GSensor, ...]
    conditions: Conditions
    temperature_c: float
    procedure: str
    notes: tuple[Note, ...]

    def sensor(self, channel: str) -> GSensor:
        """Return the sensor of this output.

        Raises
        ------
        KeyError
            There is none.
        """
        for sensor in self.sensors:
            if sensor.channel == channel:
                return sensor
        raise KeyError(channel)

    def calibration(self) -> Calibration:
        """The same as what exports and reports take."""
        return Calibration(
            sensor="gyro",
            unit=self.unit,
            channels=tuple(sensor.channel for sensor in self.sensors),
            axes=tuple(sensor.axis for sensor in self.sensors),
            fits=tuple(sensor.fit for sensor in self.sensors),
            conditions=self.conditions,
            temperature_c=self.temperature_c,
            notes=(*self.notes, *(note for sensor in self.sensors for note in sensor.notes)),
            provenance=Provenance(
                procedure=self.procedure,
                device=self.device,
                software=SOFTWARE,
                computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
            ),
            effects=tuple(s.effects for s in self.sensors)
            if any(s.effects for s in self.sensors)
            else (),
        )


@dataclass(frozen=True, slots=True)
class HeadSite:
    """How the head stands on the Earth.

    Parameters
    ----------
    base : how its base plate stands; its psi is the azimuth of the shaft
    azimuth_known : whether psi is stated; without it only the vertical part of the Earth's rate
        enters the stimulus
    bias_stability_dps : stated stability of the gyros' zero; NaN if none is
    """

    base: BaseOrientation = LEVEL
    azimuth_known: bool = False
    bias_stability_dps: float = float("nan")


UNKNOWN_SITE = HeadSite()


def fit_g_sensitivity(
    head: Run,
    conditions: Conditions,
    site: HeadSite = UNKNOWN_SITE,
    scale_factors: Mapping[str, Estimate] | None = None,
    added: Added = NOTHING,
) -> GSensitivity:
    """Estimate zero and g-sensitivity of every gyro of a run on the head.

    Parameters
    ----------
    head : gyros at rest in 4, 8 or any positions
    conditions : g, u of a head setting, latitude
    site : how the head stands
    scale_factors : by channel, from the rate table; needed to take the Earth's rate out and to
        give deg/s
    added : effects beyond zero and g-sensitivity

    Raises
    ------
    FitError
        g is missing, a number is not finite, or the positions determine nothing.
    """
    stimulus = head_stimulus(head, conditions, site)
    sensors: list[GSensor] = []
    for channel, name in enumerate(head.channels):
        axis = own_axis(head, channel)
        k = (scale_factors or {}).get(name)
        earth = 0.0 if k is None else k.value * stimulus.w[:, AXES.index(axis)]
        effects = (CATALOGUE["bias"], g_effect(stimulus))
        model = SensorModel(Sensor("gyro", axis, head.unit), effects)
        rows = rows_of(head, channel, earth - added.change(name, slice(None)))
        fit = fit_sensor(model, stimulus, rows, conditions)
        fit, acting = with_effects(
            fit, model.sensor, stimulus, rows, conditions, added.of(name), added.columns
        )
        sensor = GSensor(name, axis, fit, k, conditions.g_mps2, (), acting)
        sensors.append(replace(sensor, notes=earth_notes(sensor, conditions, site)))
    return result_of(head, sensors, conditions, PROCEDURE, head.notes)


def head_stimulus(head: Run, conditions: Conditions, site: HeadSite) -> Stimulus:
    """What acts on gyros on the head, with as much of the Earth's rate as is stated."""
    if not len(head):
        raise FitError("the run holds no rows")
    g = conditions.g_mps2
    if not g > 0:
        raise FitError("local gravity is missing; state it in m/s^2, e.g. 9.8106 for Kyiv")
    if not np.isfinite(conditions.latitude_deg):
        return stimulus_of(head, g, base=site.base)
    if site.azimuth_known:
        return stimulus_of(head, g, latitude_deg=conditions.latitude_deg, base=site.base)
    still = stimulus_of(head, g, base=site.base)
    # The vertical part acts along the specific force of a unit at rest.
    return replace(still, w=still.a / g * vertical_dps(conditions.latitude_deg))


def g_effect(stimulus: Stimulus) -> Effect:
    """g-sensitivity along those axes that the positions excite."""
    excited = np.ptp(stimulus.a, axis=0) > EXCITED
    if not excited.any():
        raise FitError(
            "gravity acts alike in every row: no g-sensitivity can be told from it; measure"
            " positions that turn the unit over"
        )
    return AccelerationSensitiveDrift("".join(np.array(AXES)[excited]))


def own_axis(run: Run, channel: int) -> str:
    """Case axis of a sensor; a single-axis assembly calls it Z."""
    return run.axes[channel] or "z"


def rows_of(run: Run, channel: int, earth: FloatArray | float = 0.0) -> Rows:
    """Outputs of one sensor less what the Earth's rate adds to them."""
    dof = run.extra.get("se_dof", np.full(len(run), np.inf))
    return Rows(run.y[:, channel] - earth, run.y_se[:, channel], dof)


def earth_notes(sensor: GSensor, conditions: Conditions, site: HeadSite) -> tuple[Note, ...]:
    """Say so where the Earth's rate is left out and this gyro feels it."""
    if sensor.scale_factor is None or (site.azimuth_known and np.isfinite(conditions.latitude_deg)):
        return ()
    finest = min(sensor.b_dps_per_g(axis).expanded() for axis in sensor.axes)
    stability = site.bias_stability_dps
    if not np.isfinite(conditions.latitude_deg):
        if not feels(finest, EARTH_RATE_DPS, stability):
            return ()
        symbol = f"b_{sensor.axis}{sensor.axis}"
        return (latitude_missing(f"{symbol} of {sensor.channel}", "state the latitude"),)
    level = level_dps(conditions.latitude_deg)
    if not feels(finest, level, stability):
        return ()
    return (azimuth_missing(f"the g-sensitivity of {sensor.channel}", level),)


def result_of(
    head: Run,
    sensors: list[GSensor],
    conditions: Conditions,
    procedure: str,
    notes: tuple[Note, ...],
) -> GSensitivity:
    """Put the sensors of a head run together."""
    known = head.temperature_c[np.isfinite(head.temperature_c)]
    return GSensitivity(
        device=head.device,
        unit=head.unit,
        sensors=tuple(sensors),
        conditions=conditions,
        temperature_c=float(known.mean()) if known.size else float("nan"),
        procedure=procedure,
        notes=notes,
    )
