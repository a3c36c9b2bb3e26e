"""Rows that were measured, measured again on the simulated bench, sample by sample.

The unit on the bench is a model that was found, not one of the rig's own; an operator sets the
same positions at the same times, and every mean is that of so many noisy, rounded samples.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, table_axes
from core.plans.orientation import Mount
from core.samples.block import Channel
from core.samples.run import Run
from core.units import DEG_PER_RAD
from drivers.virtual.bench import Bench, Manner, Place
from drivers.virtual.devices import Device, Output
from drivers.virtual.noise import NoiseLevel
from drivers.virtual.unit import Unit

_RATE_HZ = 100.0
_SLOWEST_HZ = 4.0
_SECONDS_AT_FULL_RATE = 5000.0
_ACCUMULATION_S = 10.0
_SETTLE_S = 1.5
_BLOCK = 4096
_MOST_MOVING_S = 120.0
_WARM_C = 27.0


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """A model that was found, and its noise.

    Parameters
    ----------
    models : (c,) of each output, and the values of its parameters
    white : (c,) standard deviation of a mean from the noise within an accumulation
    drift : (c,) standard deviation of the slow part of the noise over the whole test
    setting : (n,) standard deviation of each setting, rad of the head or deg/s of the table
    repeating : (n,) the same of what comes back at the same setting
    columns : (n,) further regressors of the rows, by name
    """

    models: Sequence[tuple[SensorModel, FloatArray]]
    white: FloatArray
    drift: FloatArray
    setting: FloatArray
    repeating: FloatArray
    columns: Mapping[str, FloatArray] = field(default_factory=dict[str, FloatArray])


def walk_rows(run: Run, found: Found, seed: int) -> FloatArray:
    """Return the means (n, c) of the same rows, walked through on the simulated bench.

    Parameters
    ----------
    run : which positions or rates were set, when, how warm it was
    found : what stands on the bench
    seed : of all chance
    """
    return _Walk(run, found, seed).means()


class _Walk:
    """One walk through the rows."""

    def __init__(self, run: Run, found: Found, seed: int) -> None:
        self._run, self._found = run, found
        bench_rng, unit_rng, self._rng = np.random.default_rng([seed, 0x40B5]).spawn(3)
        self._seconds = _known(run.conditions.accumulation_s, _ACCUMULATION_S)
        span = float(np.ptp(run.t_s)) if np.all(np.isfinite(run.t_s)) else 0.0
        span = max(span, len(run) * self._seconds)
        wanted = _known(run.conditions.sample_rate_hz, _RATE_HZ)
        # Of a long test fewer samples are made; their noise is that of the mean all the same.
        self._hz = max(min(wanted, _RATE_HZ * _SECONDS_AT_FULL_RATE / span), _SLOWEST_HZ)
        device = self._device(span)
        # On the equator nothing of the Earth's rate lies along an upright table: what it does to
        # the zero is in the bias that was found.
        place = Place(_known(run.conditions.g_mps2, 9.80665), latitude_deg=0.0)
        self._bench = Bench(place, Manner(), self._hz, bench_rng, timed=device.timed)
        channels = tuple(
            Channel(name, run.unit, output.role)
            for name, output in zip(run.channels, device.outputs, strict=True)
        )
        self._unit = Unit(device, channels, self._hz, unit_rng)
        self._lead_s = 0.0
        warm = run.temperature_c
        self._reference = float(np.mean(warm)) if np.all(np.isfinite(warm)) else _WARM_C

    def means(self) -> FloatArray:
        """Set every row, wait for its time, and accumulate."""
        run = self._run
        wrong = self._setting_errors()
        means = np.zeros((len(run), len(run.channels)))
        timed = np.all(np.isfinite(run.t_s))
        for row in range(len(run)):
            self._set(row, float(wrong[row]))
            self._rest(row)
            if row == 0:
                self._lead_s = self._bench.time_s
            elif timed:
                due = self._lead_s + float(run.t_s[row] - run.t_s[0])
                self._let_pass(row, due - self._bench.time_s)
            count = max(round(self._seconds * self._hz), 1)
            means[row] = self._samples(row, count).mean(axis=0)
        return frozen(means)

    def _device(self, span_s: float) -> Device:
        largest = np.abs(self._run.y).max(axis=0)
        white = self._found.white * np.sqrt(2.0 * self._seconds)
        walk = self._found.drift / np.sqrt(span_s / 6.0)
        outputs = tuple(
            Output(
                f"out.{place}",
                model,
                values,
                NoiseLevel(float(white[place]), 0.0, float(walk[place])),
                warm_up=0.0,
                limit=4.0 * max(float(largest[place]), 1.0),
            )
            for place, (model, values) in enumerate(self._found.models)
        )
        return Device("found", "", outputs, {})

    def _setting_errors(self) -> FloatArray:
        """Error (n,) of every setting: its own, and what comes back at the same one."""
        run = self._run
        on_table = run.test == "rate_table"
        place = run.set_rate_dps if on_table else np.mod(run.head_deg, 360.0)
        back = np.unique(place.round(6), return_inverse=True)[1]
        repeated = self._rng.standard_normal(int(back.max()) + 1)[back]
        own = self._rng.standard_normal(len(run))
        return self._found.setting * own + self._found.repeating * repeated

    def _set(self, row: int, wrong: float) -> None:
        """Do what the operator does at this row."""
        run, bench = self._run, self._bench
        warm = float(run.temperature_c[row])
        if np.isfinite(warm):
            bench.be_at(warm)
        if run.test == "rate_table":
            up = table_axes(run)[row]
            axis = "xyz"[int(np.argmax(np.abs(up)))]
            if run.mount[row]:
                bench.remount(run.mount[row])
            elif Mount.parse(bench.mount).axis.lower() != axis:
                bench.remount(f"{axis.upper()}_from")
            bench.spin(float(run.set_rate_dps[row]) + wrong, axis)
        else:
            bench.remount(run.mount[row])
            bench.turn(float(run.head_deg[row]) + wrong * DEG_PER_RAD)

    def _rest(self, row: int) -> None:
        """Let the rig come to rest."""
        limit = self._bench.time_s + _MOST_MOVING_S
        while self._bench.moving and self._bench.time_s < limit:
            self._let_pass(row, 0.25)
        self._let_pass(row, _SETTLE_S)

    def _let_pass(self, row: int, seconds: float) -> None:
        if seconds > 0.0:
            self._samples(row, max(round(seconds * self._hz), 1))

    def _samples(self, row: int, count: int) -> FloatArray:
        blocks: list[FloatArray] = []
        while count > 0:
            step = min(count, _BLOCK)
            blocks.append(self._unit.sends(self._acting(row, step), step))
            count -= step
        return np.vstack(blocks)

    def _acting(self, row: int, count: int) -> Stimulus:
        """What acts, with the regressors of the row beside those of the bench."""
        acts = self._bench.stimulus(count)
        n = len(acts)
        first = self._run.t_s[0]
        began = self._lead_s - (float(first) if np.isfinite(first) else 0.0)
        fixed = {
            name: np.full(n, values[row])
            for name, values in self._found.columns.items()
            if name not in ("head_deg", "set_rate_dps", "temperature_c", "t_s")
        }
        columns = {
            **acts.columns,
            **fixed,
            "t_s": acts.columns["t_s"] - began,
            "start_s": np.full(n, float(np.nan_to_num(first))),
            "reference_c": np.full(n, self._reference),
        }
        return replace(acts, columns=columns)


def _known(value: float, otherwise: float) -> float:
    return float(value) if np.isfinite(value) and value > 0 else otherwise
