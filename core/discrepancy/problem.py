"""A run with its plain model: rows of all channels one below the other."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, IntArray
from core.discrepancy.smooth import smoothed
from core.errors import FitError, Note, RankDeficient, Severity
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.gyro import AccelerationSensitiveDrift
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Effect, Kind, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stimulus_of
from core.samples.run import Run
from core.units import STANDARD_GRAVITY

TESTS = ("dividing_head", "static_positions", "rate_table")
COMMON, EACH = -1, -2
"""In the place of a channel: all by the same parameters; all, each by its own."""
_EXCITED = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """What is compared.

    Parameters
    ----------
    run : the measured rows
    stimulus : what acted, n rows, regressors without their noise
    models : (c,) plain model of each channel; its sensor knows its response
    y, se : (n c,) outputs and standard errors of all channels one below the other
    right : (n c,) outputs with what is known to be mistaken in them put right
    effects : what can be proposed
    untested : identifiers that a missing column keeps from being tested, with the column
    notes : doubts that arose on the way
    """

    run: Run
    stimulus: Stimulus
    models: tuple[SensorModel, ...]
    y: FloatArray
    se: FloatArray
    right: FloatArray
    effects: tuple[Effect, ...]
    untested: Mapping[str, str]
    notes: tuple[Note, ...]

    @classmethod
    def of(cls, run: Run) -> "Problem":
        """Prepare a run.

        Raises
        ------
        RankDeficient
            The rows do not determine even the plain model.
        FitError
            The run is of another test, or an output is missing.
        """
        if run.test not in TESTS:
            raise FitError(f"a run of test {run.test!r} is not compared; {', '.join(TESTS)} are")
        bad = np.argwhere(~np.isfinite(run.y))
        if bad.size:
            row, channel = bad[0]
            raise FitError(
                f"row {row + 1}, {run.channels[channel]}: the output is not a number; leave the"
                " row out or measure it again"
            )
        stimulus, notes = _stimulus(run)
        run, left_out = _excited(run, stimulus)
        notes = (*notes, *left_out)
        models = tuple(_model(run, stimulus, channel) for channel in range(run.y.shape[1]))
        effects, untested = _effects(run, stimulus)
        return cls(
            run=run,
            stimulus=stimulus,
            models=models,
            y=run.y.T.ravel(),
            se=run.y_se.T.ravel(),
            right=run.y.T.ravel(),
            effects=effects,
            untested=untested,
            notes=notes,
        )

    def corrected(self, change: FloatArray) -> "Problem":
        """With the responses that the outputs have with this change; the outputs stay."""
        right = self.y + change
        run = replace(self.run, y=right.reshape(self.channels, self.rows).T)
        models = tuple(_model(run, self.stimulus, channel) for channel in range(self.channels))
        return replace(self, models=models, right=right)

    @property
    def rows(self) -> int:
        """Rows of one channel."""
        return len(self.stimulus)

    @property
    def channels(self) -> int:
        """Number of channels."""
        return len(self.models)

    @property
    def channel(self) -> IntArray:
        """(n c,) channel of each stacked row."""
        return np.repeat(np.arange(self.channels), self.rows)

    def design(self, stimulus: Stimulus | None = None) -> FloatArray:
        """Design (n c, p) of the plain model of all channels."""
        acted = self.stimulus if stimulus is None else stimulus
        return _blocks([model.design(acted) for model in self.models])

    def columns(self, effect: Effect, channel: int = COMMON) -> FloatArray:
        """Columns (n c, p) of an effect in one channel, `COMMON` to all, or in `EACH` its own."""
        if channel == EACH:
            return np.hstack([self.columns(effect, one) for one in range(self.channels)])
        if channel == COMMON:
            return np.vstack([effect.columns(self.stimulus, m.sensor) for m in self.models])
        block = effect.columns(self.stimulus, self.models[channel].sensor)
        found = np.zeros((self.rows * self.channels, block.shape[1]))
        found[channel * self.rows : (channel + 1) * self.rows] = block
        return found

    def slope(self) -> FloatArray:
        """(n c,) output per radian of the head angle, or per deg/s of the set rate."""
        key = "da_dhead" if self.run.sensor == "accelerometer" else "dw_drate"
        change = getattr(self.stimulus, key)
        return np.concatenate([change @ model.sensor.sensitivity for model in self.models])


def _blocks(parts: list[FloatArray]) -> FloatArray:
    rows = sum(len(part) for part in parts)
    found = np.zeros((rows, sum(part.shape[1] for part in parts)))
    row = column = 0
    for part in parts:
        found[row : row + len(part), column : column + part.shape[1]] = part
        row, column = row + len(part), column + part.shape[1]
    return found


def _stimulus(run: Run) -> tuple[Stimulus, tuple[Note, ...]]:
    notes: list[Note] = []
    g = run.conditions.g_mps2
    if not np.isfinite(g) and run.test != "rate_table":
        g = STANDARD_GRAVITY
        notes.append(
            Note(
                Severity.INFO,
                "gravity_unknown",
                f"local gravity is not stated; {g} m/s^2 is taken, which changes the scale factor"
                " alone",
            )
        )
    stimulus = stimulus_of(run, g)
    columns = dict(stimulus.columns)
    for name in ("temperature_c", "AntiNodeAmplitude"):
        values = columns.get(name)
        if values is not None and np.all(np.isfinite(values)):
            columns[name] = smoothed(values)
    length = run.conditions.accumulation_s
    if np.isfinite(length):
        columns["accumulation_s"] = np.full(len(run), length)
    if np.all(np.isfinite(run.y_se)):
        columns["y_se"] = run.y_se.max(axis=1)
    columns["repeated"] = _repeated(run)
    return replace(stimulus, columns=columns), tuple(notes)


def _repeated(run: Run) -> FloatArray:
    """1 where all outputs equal those of the row before, bit for bit, at another setting."""
    same = np.zeros(len(run))
    same[1:] = np.all(run.y[1:] == run.y[:-1], axis=1)
    # Where rows are rounded so coarsely that many are equal, equality tells nothing.
    coarse = len(np.unique(run.y[:, 0])) < 0.7 * len(run)
    moved = np.ones(len(run), dtype=bool)
    for column in (run.head_deg, run.set_rate_dps):
        if np.all(np.isfinite(column)):
            moved[1:] = column[1:] != column[:-1]
    return np.zeros(len(run)) if coarse else same * moved


def _excited(run: Run, stimulus: Stimulus) -> tuple[Run, tuple[Note, ...]]:
    """The run without the outputs of a unit whose own input never changes, each with a note."""
    if run.test == "static_positions" or len(run.channels) < 2:
        return run, ()
    kept: list[int] = []
    for channel, axis in enumerate(run.axes):
        sensor = Sensor(run.sensor, axis or "z", run.unit)
        if np.ptp(sensor.input(stimulus)[:, sensor.index]) > _EXCITED:
            kept.append(channel)
    if not kept or len(kept) == len(run.channels):
        return run, ()
    notes = tuple(
        Note(
            Severity.WARNING,
            "not_excited",
            f"{name} is left out: its own input never changes in these rows; add positions",
        )
        for channel, name in enumerate(run.channels)
        if channel not in kept
    )
    few = replace(
        run,
        y=run.y[:, kept],
        y_se=run.y_se[:, kept],
        channels=tuple(run.channels[channel] for channel in kept),
        axes=tuple(run.axes[channel] for channel in kept),
    )
    return few, notes


def _model(run: Run, stimulus: Stimulus, channel: int) -> SensorModel:
    axis = run.axes[channel] or "z"
    sensor = Sensor(run.sensor, axis, run.unit)
    acts = stimulus.a if run.test == "static_positions" else sensor.input(stimulus)
    seen = [a for i, a in enumerate(AXES) if np.ptp(acts[:, i]) > _EXCITED]
    chosen: list[Effect] = [CATALOGUE["bias"]]
    if run.test == "static_positions":
        chosen.append(AccelerationSensitiveDrift("".join(seen)))
    else:
        if axis not in seen:
            raise RankDeficient(
                ("scale_factor",),
                f"{run.channels[channel]}: the input along {axis} does not change; add positions",
            )
        chosen.append(CATALOGUE["scale_factor"])
        chosen.append(CrossAxis("".join(a for a in seen if a != axis)))
    model = SensorModel(sensor, tuple(chosen))
    design = model.design(stimulus)
    size = np.linalg.norm(design, axis=0)
    if len(run) < design.shape[1] or np.linalg.matrix_rank(design / size) < design.shape[1]:
        raise RankDeficient(
            tuple(parameter.name for parameter in model.parameters),
            f"{run.channels[channel]}: {len(run)} rows for the {design.shape[1]} parameters of the"
            " plain model; add positions",
        )
    if run.test == "static_positions":
        return model
    # Outliers must not bend the response through which the errors of the rig act.
    values = _robust(design, run.y[:, channel])
    response = np.zeros(3)
    for parameter, value in zip(model.parameters, values, strict=True):
        if parameter.name == "scale_factor":
            response[sensor.index] = value
        elif parameter.name.startswith("cross_axis_"):
            response[AXES.index(parameter.name[-1])] = value
    return replace(model, sensor=replace(sensor, response=tuple(response.tolist())))


def _robust(design: FloatArray, y: FloatArray) -> FloatArray:
    """Estimates by Huber's weights."""
    weight = np.ones(len(y))
    values = np.zeros(design.shape[1])
    for _ in range(8):
        root = np.sqrt(weight)
        values = np.linalg.lstsq(design * root[:, None], y * root, rcond=None)[0]
        residual = np.abs(y - design @ values)
        scale = 1.4826 * float(np.median(residual))
        if scale <= 0.0:
            break
        weight = np.minimum(1.0, 2.0 * scale / np.maximum(residual, 1e-300))
    return np.asarray(values, dtype=np.float64)


def _effects(run: Run, stimulus: Stimulus) -> tuple[tuple[Effect, ...], dict[str, str]]:
    chosen: list[Effect] = []
    untested: dict[str, str] = {}
    for effect in CATALOGUE.values():
        if effect.kind is Kind.MODEL or run.test not in effect.tests:
            continue
        if run.sensor not in effect.sensors:
            continue
        missing = [
            name
            for name in effect.needs
            if name not in stimulus.columns or not np.all(np.isfinite(stimulus.columns[name]))
        ]
        if missing:
            untested[effect.id] = missing[0]
        else:
            chosen.append(effect)
    return tuple(chosen), untested
