"""Gyros on the rate table: scale factor and zero, (3.4) to (3.6), and how straight they are.

The sums of (3.6) are the least squares of a line; the fit centres and scales them by orthogonal
columns, so that large offsets cost no digits. Each mounting on the table is a line of its own,
since re-mounting changes what gravity does to the zero: the slope about the sensor's own axis is
its scale factor, the slopes about the two others are its cross-axis sensitivities.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FitError, Note, Severity
from core.fit.design import Design
from core.fit.estimate import Estimate, parameter, ratio
from core.fit.linear import Rows, fit_design
from core.fit.result import FitResult
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stimulus_of, table_axes
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.characteristic import (
    Hysteresis,
    Nonlinearity,
    Points,
    Shape,
    Term,
    Threshold,
    bends,
    bias_asymmetry,
    hysteresis,
    nonlinearity,
    slopes,
    threshold,
)
from core.procedures.rate_faults import examine
from core.procedures.rate_notes import sensor_notes, table_notes, temperature_notes
from core.samples.run import Conditions, Run

PROCEDURE = "gyros on the rate table, practicum (3.4) to (3.6)"
_FULL_TURN_DEG = 360.0


@dataclass(frozen=True, slots=True, eq=False)
class RateLine:
    """The line of one sensor in one mounting.

    Parameters
    ----------
    symbol : ``"k_z"`` for the sensor's own axis, ``"k_zx"`` for another
    mount : how the unit stood, e.g. ``"Z_from"``; empty where the run does not say
    rows : (m,) rows of the run that the line goes through
    set_rate : (m,) set rates about that axis, deg/s
    output : (m,) outputs
    fit : with parameters `bias` and `scale_factor` (here: the response about that axis)
    """

    symbol: str
    mount: str
    rows: IntArray
    set_rate: FloatArray
    output: FloatArray
    fit: FitResult

    @property
    def slope(self) -> Estimate:
        """Response, output per deg/s."""
        return parameter(self.fit, "scale_factor")

    @property
    def zero(self) -> Estimate:
        """Output at zero rate in this mounting: U0 plus what gravity adds to it."""
        return parameter(self.fit, "bias")


@dataclass(frozen=True, slots=True, eq=False)
class RateSensor:
    """One sensor on the table.

    Parameters
    ----------
    channel : name of the output
    axis : the sensor's own case axis
    line : about its own axis
    others : about the other axes, and further mountings about its own
    nonlinearity, bends, slopes, bias_asymmetry, hysteresis, threshold : see `characteristic`; None
        or empty where the rows do not tell them
    notes : doubts about this sensor
    """

    channel: str
    axis: str
    line: RateLine
    others: tuple[RateLine, ...]
    nonlinearity: Nonlinearity
    bends: tuple[Term, ...]
    slopes: tuple[Estimate, Estimate, Estimate] | None
    bias_asymmetry: Estimate | None
    hysteresis: Hysteresis | None
    threshold: Threshold | None
    notes: tuple[Note, ...]

    @property
    def bias(self) -> Estimate:
        """Zero over scale factor, deg/s (D_F of IEEE 952)."""
        return ratio(self.line.fit, "bias", "scale_factor", "deg/s")

    @property
    def measured_dps(self) -> FloatArray:
        """Calibrated rates (m,) in the rows of the line, deg/s: the second column of Table 3.7."""
        return frozen(self.line.set_rate + self.residuals_dps)

    @property
    def residuals_dps(self) -> FloatArray:
        """Errors (m,) of the calibrated rates, deg/s: the third column of Table 3.7."""
        return frozen(self.line.fit.residuals / self.line.slope.value)


@dataclass(frozen=True, slots=True, eq=False)
class RateTable:
    """All sensors of one run on the table.

    Parameters
    ----------
    device, unit : name of the unit, unit of its outputs
    full_scale_dps : the full scale of the nonlinearities in ppm
    sensors : those that answered
    conditions : what the laboratory states
    temperature_c : mean temperature, NaN if it was not measured in degrees
    notes : doubts about the run as a whole
    """

    device: str
    unit: str
    full_scale_dps: float
    sensors: tuple[RateSensor, ...]
    conditions: Conditions
    temperature_c: float
    notes: tuple[Note, ...]

    def sensor(self, channel: str) -> RateSensor:
        """Return the sensor of this output.

        Raises
        ------
        KeyError
            There is none, or it did not answer.
        """
        for sensor in self.sensors:
            if sensor.channel == channel:
                return sensor
        raise KeyError(channel)


def calibrate_rate_table(
    run: Run,
    conditions: Conditions,
    *,
    full_scale_dps: float | None = None,
    expected: Mapping[str, float] | None = None,
    base: BaseOrientation = LEVEL,
) -> RateTable:
    """Estimate scale factor, zero and straightness of every gyro of a run.

    Parameters
    ----------
    run : a run on the rate table, up to nine sensors; the mounts tell the axis of each row
    conditions : u of a set rate, latitude; over what the run itself states
    full_scale_dps : full scale of the sensors; None for the largest rate of the run
    expected : scale factors by channel from an earlier calibration or data sheet
    base : how the table's axis leans from the vertical

    Raises
    ------
    FitError
        The rates determine nothing, a number is not finite, or no sensor answers.
    """
    if not len(run):
        raise FitError("the run holds no rows")
    _check_outputs(run)
    along = table_axes(run)
    job = _Job(
        run=run,
        stimulus=_stimulus(run, conditions, base),
        conditions=conditions,
        mountings=_mountings(run, along),
        full_scale=full_scale_dps or float(np.abs(run.set_rate_dps).max()),
        expected=expected or {},
    )
    alive = [c for c in range(len(run.channels)) if np.ptp(run.y[:, c]) > 0]
    if not alive:
        raise FitError("the outputs are the same in every row; nothing was measured")
    notes = [*run.notes]
    notes.extend(_dead(name) for c, name in enumerate(run.channels) if c not in alive)
    sensors: list[RateSensor] = []
    for axis, channels in _by_axis(run, job.mountings[0].turned, alive).items():
        about = along[:, AXES.index(axis)]
        rows = np.flatnonzero(about)
        names = [run.channels[c] for c in channels]
        if not rows.size:
            raise FitError(f"{', '.join(names)}: no row turns about {axis}, their own axis")
        x = about[rows] * run.set_rate_dps[rows]
        _check_rates(x)
        y, se = run.y[rows][:, channels], run.y_se[rows][:, channels]
        found = examine(x, y, se, names, (rows + 1).tolist())
        notes.extend(found.notes)
        for place, channel in enumerate(channels):
            left_out = rows[found.clipped[:, place]]
            sensors.append(_sensor(job, axis, channel, left_out))
    sensors.sort(key=lambda sensor: run.channels.index(sensor.channel))
    notes.extend(table_notes([(s.residuals_dps, s.line.rows, s.bends) for s in sensors]))
    known = run.temperature_c[np.isfinite(run.temperature_c)]
    notes.extend(temperature_notes(known))
    return RateTable(
        device=run.device,
        unit=run.unit,
        full_scale_dps=job.full_scale,
        sensors=tuple(sensors),
        conditions=conditions,
        temperature_c=float(known.mean()) if known.size else float("nan"),
        notes=tuple(notes),
    )


def whole_turns_s(rate_dps: float, wanted_s: float) -> float:
    """Accumulation time nearest to the wanted one in which the table makes whole turns.

    What depends on the table's angle (wobble, the level part of the Earth's rate, a leaning axis)
    then averages out. A standing table has no turns: the wanted time is kept.
    """
    if rate_dps == 0.0:
        return wanted_s
    turn_s = _FULL_TURN_DEG / abs(rate_dps)
    return max(round(wanted_s / turn_s), 1) * turn_s


@dataclass(frozen=True, slots=True, eq=False)
class _Mounting:
    """Rows in which the unit stood alike; `turned` is the case axis on the table's."""

    mount: str
    turned: int
    rows: IntArray


@dataclass(frozen=True, slots=True, eq=False)
class _Job:
    run: Run
    stimulus: Stimulus
    conditions: Conditions
    mountings: tuple[_Mounting, ...]
    full_scale: float
    expected: Mapping[str, float]
    designs: dict[tuple[bytes, int], Design] = field(
        default_factory=dict[tuple[bytes, int], Design]
    )
    shapes: dict[tuple[bytes, bytes], Shape] = field(
        default_factory=dict[tuple[bytes, bytes], Shape]
    )

    def design(self, rows: IntArray, turned: int) -> Design:
        """The line's design; sensors that turned together have it in common."""
        key = (rows.tobytes(), turned)
        if key not in self.designs:
            effects = (CATALOGUE["bias"], CATALOGUE["scale_factor"])
            model = SensorModel(Sensor("gyro", AXES[turned], self.run.unit), effects)
            self.designs[key] = Design.of(model, self.stimulus.rows(rows))
        return self.designs[key]

    def shape(self, line: RateLine) -> Shape:
        """The shape of a line; sensors that turned together and weigh alike have it in common."""
        relative = line.fit.sigma / line.fit.sigma.max()
        key = (line.rows.tobytes(), relative.tobytes())
        if key not in self.shapes:
            came = _came(self.run, line.rows)
            self.shapes[key] = Shape.of(line.set_rate, relative, came)
        return self.shapes[key]


def _stimulus(run: Run, conditions: Conditions, base: BaseOrientation) -> Stimulus:
    latitude = conditions.latitude_deg if np.isfinite(conditions.latitude_deg) else None
    return stimulus_of(run, conditions.g_mps2, latitude_deg=latitude, base=base)


def _mountings(run: Run, along: FloatArray) -> tuple[_Mounting, ...]:
    found: list[_Mounting] = []
    for mount in dict.fromkeys(run.mount):
        rows = frozen_int([row for row, own in enumerate(run.mount) if own == mount])
        found.append(_Mounting(mount, int(np.argmax(np.abs(along[rows[0]]))), rows))
    return tuple(found)


def _by_axis(run: Run, turned: int, alive: list[int]) -> dict[str, list[int]]:
    """Channels by their own axis; where none is stated it is the one that turned first."""
    channels: dict[str, list[int]] = {}
    for c in alive:
        channels.setdefault(run.axes[c] or AXES[turned], []).append(c)
    return channels


def _check_outputs(run: Run) -> None:
    bad = np.argwhere(~np.isfinite(run.y))
    if bad.size:
        row, channel = bad[0]
        raise FitError(f"row {row + 1}: the output {run.channels[channel]} is not a number")


def _check_rates(x: FloatArray) -> None:
    if len(np.unique(x)) < 2:
        raise FitError(
            f"every row has the same rate ({x[0]:g} deg/s): neither the scale factor nor the zero"
            " can be told from it; measure at two rates or more, better eleven"
        )


def _sensor(job: _Job, axis: str, channel: int, left_out: IntArray) -> RateSensor:
    lines = [_line(job, axis, channel, mounting, left_out) for mounting in job.mountings]
    own = [line for line in lines if line.symbol == f"k_{axis}"]
    main = max(own, key=lambda line: len(line.rows))
    points = Points(job.shape(main), main.output, main.fit, job.full_scale)
    terms = bends(points, job.run.unit)
    halves = slopes(points)
    name = job.run.channels[channel]
    return RateSensor(
        channel=name,
        axis=axis,
        line=main,
        others=tuple(line for line in lines if line is not main),
        nonlinearity=nonlinearity(points),
        bends=terms,
        slopes=halves,
        bias_asymmetry=bias_asymmetry(points),
        hysteresis=hysteresis(points),
        threshold=threshold(points),
        notes=sensor_notes(
            name,
            main.fit,
            points,
            terms,
            halves,
            earth_known=bool(np.isfinite(job.conditions.latitude_deg)),
            expected=job.expected.get(name),
        ),
    )


def _line(job: _Job, axis: str, channel: int, mounting: _Mounting, left_out: IntArray) -> RateLine:
    run, turned = job.run, mounting.turned
    rows = mounting.rows[~np.isin(mounting.rows, left_out)]
    design = job.design(rows, turned)
    se_dof = run.extra.get("se_dof", np.full(len(run), np.inf))[rows]
    y = run.y[rows, channel]
    fit = fit_design(design, Rows(y, run.y_se[rows, channel], se_dof), job.conditions)
    return RateLine(
        symbol=f"k_{axis}" if AXES[turned] == axis else f"k_{axis}{AXES[turned]}",
        mount=mounting.mount,
        rows=frozen_int(rows),
        set_rate=frozen(design.stimulus.dw_drate[:, turned] * run.set_rate_dps[rows]),
        output=frozen(y),
        fit=fit,
    )


def _came(run: Run, rows: IntArray) -> FloatArray:
    """Whether each of the rows (m,) was reached by a rising (+) or a falling (-) rate."""
    came = np.zeros(len(run))
    by_time = np.argsort(run.order, kind="stable")
    came[by_time[1:]] = np.sign(np.diff(run.set_rate_dps[by_time]))
    return came[rows]


def _dead(channel: str) -> Note:
    return Note(
        Severity.WARNING,
        "dead",
        f"{channel}: the same output in every row; the sensor is dead or not connected",
    )
