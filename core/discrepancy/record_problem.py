"""The slow view of a long record: means of blocks, with regressors without their noise."""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.discrepancy.problem import Problem
from core.discrepancy.smooth import smoothed
from core.errors import RankDeficient
from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.record_slow import BiasCurve, SlowPickup
from core.model.effect import Effect, Kind, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Run

ROWS = 360
FEWEST_BLOCKS = 40
FEWEST_SAMPLES = 120


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """One output of a record on an even grid of time.

    Parameters
    ----------
    run : the record, one row a sample
    channel : which output
    rate : samples per second
    place : (n,) number of each sample by its time, from 0
    good : (n,) whether a sample can be used
    """

    run: Run
    channel: int
    rate: float
    place: IntArray
    good: FloatArray

    @classmethod
    def of(cls, run: Run, channel: int = 0) -> "Samples":
        """Find the grid.

        Raises
        ------
        FitError
            Time stands still, runs backwards, or is not uniform.
        RankDeficient
            There are too few samples.
        """
        t = run.t_s
        if len(t) < FEWEST_SAMPLES:
            raise RankDeficient(
                ("any effect of a record",),
                f"{len(t)} samples are no record; record at least {FEWEST_SAMPLES}",
            )
        if not np.all(np.isfinite(t)):
            raise RankDeficient(
                ("any effect of time",),
                "the times of some rows are missing; state the samples per second",
            )
        steps = np.diff(t)
        if np.any(steps < 0.0):
            at = int(np.flatnonzero(steps < 0.0)[0]) + 1
            raise RankDeficient(
                ("any effect of time",),
                f"time runs backwards at sample {at + 1}: two records were joined, take one",
            )
        step = float(np.median(steps))
        off = np.abs(steps / step - np.rint(steps / step)) if step > 0.0 else np.ones(1)
        if float(np.mean(off > _OFF)) > _MANY:
            raise RankDeficient(
                ("any effect of time",),
                "the samples are not uniform in time; use the counter of the device, or resample",
            )
        place = np.concatenate([[0], np.cumsum(np.rint(steps / step))]).astype(np.int64)
        rate = float(place[-1]) / float(t[-1] - t[0])
        y = run.y[:, channel]
        good = np.isfinite(y) & np.concatenate([[True], np.diff(place) > 0])
        if int(good.sum()) < FEWEST_SAMPLES:
            raise RankDeficient(
                ("any effect of a record",),
                f"only {int(good.sum())} samples of {run.channels[channel]} are numbers",
            )
        if np.ptp(y[good]) == 0.0:
            raise RankDeficient(
                ("any effect of a record",),
                f"all samples of {run.channels[channel]} are equal: it is stuck or not connected",
            )
        return cls(run, channel, rate, frozen_int(place), frozen(good))

    @property
    def usable(self) -> IntArray:
        """Rows of the usable samples."""
        return np.flatnonzero(self.good > 0.0).astype(np.int64)

    @property
    def y(self) -> FloatArray:
        """(n,) the output."""
        return self.run.y[:, self.channel]

    def without(self, rows: IntArray) -> "Samples":
        """The same with some samples that cannot be used."""
        good = np.array(self.good)
        good[rows] = 0.0
        return replace(self, good=frozen(good))

    @property
    def whole(self) -> FloatArray:
        """(m,) the output on the whole grid; what is missing lies on the line between its ends."""
        rows = self.usable
        grid = np.arange(int(self.place[-1]) + 1)
        return np.interp(grid, self.place[rows], self.y[rows])


_OFF, _MANY = 0.3, 0.02
_BEYOND, _LINE = 60, 9


def record_problem(samples: Samples) -> Problem:
    """Return the slow view of a record as a problem of some 360 rows.

    Parameters
    ----------
    samples : the record

    Raises
    ------
    RankDeficient
        Too few blocks hold samples.
    """
    run = samples.run
    size = max(1, -(-int(samples.place[-1] + 1) // ROWS))
    block = samples.place // size
    rows = samples.usable
    counts = np.bincount(block[rows], minlength=int(block[-1]) + 1)
    # Half a block at the end has a noise of its own.
    kept = np.flatnonzero(counts >= max(1, size // 2))
    if len(kept) < FEWEST_BLOCKS:
        raise RankDeficient(
            ("any effect of a record",),
            f"{len(kept)} blocks of {size} samples hold enough samples; record longer",
        )

    def mean(values: FloatArray) -> FloatArray:
        own = rows[np.isfinite(values[rows])]
        count = np.bincount(block[own], minlength=len(counts))
        total = np.bincount(block[own], values[own], minlength=len(counts))
        with np.errstate(invalid="ignore"):
            return (total / np.where(count > 0, count, np.nan))[kept]

    y = mean(samples.y)
    t = np.asarray((kept + 0.5) * size / samples.rate, dtype=np.float64)
    columns = {
        name: _regressor(mean(values), t)
        for name, values in {"temperature_c": run.temperature_c, **run.extra}.items()
    }
    n = len(kept)
    spread = _scatter(y) * np.sqrt(size / counts[kept])
    blocks = Run(
        test="record",
        sensor=run.sensor,
        device=run.device,
        channels=(run.channels[samples.channel],),
        axes=(run.axes[samples.channel],),
        unit=run.unit,
        y=y[:, None],
        y_se=spread[:, None],
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n, dtype=np.int64),
        mount=("",) * n,
        head_deg=np.full(n, np.nan),
        set_rate_dps=np.full(n, np.nan),
        temperature_c=columns["temperature_c"],
        t_s=t,
        conditions=run.conditions,
        notes=run.notes,
    )
    zero = np.zeros((n, 3))
    usable = {name: column for name, column in columns.items() if np.all(np.isfinite(column))}
    stimulus = Stimulus(
        zero, zero, zero, zero, {"t_s": t, "mount": np.zeros(n), "run": np.ones(n), **usable}
    )
    sensor = Sensor(run.sensor, run.axes[samples.channel] or "z", run.unit)
    effects, untested = _effects(stimulus, run.sensor)
    return Problem(
        run=blocks,
        stimulus=stimulus,
        models=(SensorModel(sensor, (CATALOGUE["bias"],)),),
        y=y,
        se=spread,
        right=y,
        effects=effects,
        untested=untested,
        notes=run.notes,
    )


def _regressor(values: FloatArray, t: FloatArray) -> FloatArray:
    """A channel without its noise; all NaN if it is missing in many blocks or stands still."""
    known = np.isfinite(values)
    if known.mean() < 0.9:
        return np.full(len(values), np.nan)
    values = np.interp(t, t[known], values[known])
    if np.ptp(values) == 0.0:
        return np.full(len(values), np.nan)
    # Mirrored through its ends, so that the smoother keeps the slope there.
    more = min(_BEYOND, len(values) - 1)
    first, last = _end(values[:_LINE][::-1]), _end(values[-_LINE:])
    before, after = 2.0 * first - values[more:0:-1], 2.0 * last - values[-2 : -more - 2 : -1]
    return smoothed(np.concatenate([before, values, after]))[more : more + len(values)]


def _end(values: FloatArray) -> float:
    """The last of some values by a straight line through them."""
    x = np.arange(len(values)) - (len(values) - 1.0)
    _, there = np.polyfit(x, values, 1).tolist()
    return float(there)


def _scatter(y: FloatArray) -> float:
    """Standard deviation of what changes from block to block."""
    bend = np.abs(np.diff(y, 2))
    size = 1.4826 * float(np.median(bend)) / np.sqrt(6.0)
    return max(size, 1e-9 * float(np.ptp(y)), 1e-300)


def _effects(stimulus: Stimulus, sensor: str) -> tuple[tuple[Effect, ...], dict[str, str]]:
    # The paths of a telegraph are those that what is left of a first search suggests.
    wider = {"bias_temperature": BiasCurve(), "pickup": SlowPickup(), "telegraph": None}
    chosen: list[Effect] = []
    untested: dict[str, str] = {}
    for effect in CATALOGUE.values():
        fits = "record" in effect.tests and sensor in effect.sensors
        if not fits or effect.kind not in (Kind.BLOCK, Kind.EVENT):
            continue
        missing = [name for name in effect.needs if name not in stimulus.columns]
        one = wider.get(effect.id, effect)
        if missing:
            untested[effect.id] = missing[0]
        elif one is not None:
            chosen.append(one)
    return tuple(chosen), untested
