"""N seconds of samples, by the device's counter, become one mean with its honest uncertainty."""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import Note, Severity
from core.samples.block import Channel, SampleBlock
from core.samples.mean_error import standard_error
from core.samples.turning import turning_columns, unwrapped, within_turn

_MIN_SAMPLES = 16
_MOST_LOST = 0.25
"""Share of lost samples beyond which the mean is no longer one over the time that was asked."""


@dataclass(frozen=True, slots=True, eq=False)
class Accumulation:
    """Means of one accumulation.

    Parameters
    ----------
    channels : (c,) what was accumulated
    n : samples that came
    seconds : time from the first to the last sample, by the counter
    lost : samples that the counter passed over
    first : index of the first sample
    mean, std : (c,) mean and standard deviation of the samples
    se, se_dof : (c,) standard error of the mean, which respects correlated noise, and its
        effective degrees of freedom
    slope, slope_se : (c,) drift during the accumulation, per second
    notes : doubts about this accumulation
    """

    channels: tuple[Channel, ...]
    n: int
    seconds: float
    lost: int
    first: int
    mean: FloatArray
    std: FloatArray
    se: FloatArray
    se_dof: FloatArray
    slope: FloatArray
    slope_se: FloatArray
    notes: tuple[Note, ...]

    def of_role(self, role: str) -> float:
        """Mean of the channel with this role; NaN if the device has none."""
        for position, channel in enumerate(self.channels):
            if channel.role == role:
                return float(self.mean[position])
        return float("nan")

    def with_note(self, note: Note) -> "Accumulation":
        """The same with one more doubt."""
        return replace(self, notes=(*self.notes, note))


class Accumulator:
    """Collects blocks until N seconds have passed on the device's counter.

    Parameters
    ----------
    seconds : how long to accumulate; N seconds are N * rate steps of the counter
    rate : samples per second
    """

    def __init__(self, seconds: float, rate: float) -> None:
        if not (seconds > 0 and rate > 0):
            raise ValueError(f"cannot accumulate {seconds} s at {rate} samples/s")
        self._wanted = max(round(seconds * rate), 1)
        self._rate = rate
        self._blocks: list[SampleBlock] = []
        self._first = -1
        self._next = -1

    @property
    def progress(self) -> float:
        """Share of the time that has passed, 0 to 1."""
        if self._first < 0:
            return 0.0
        return min((self._next - self._first) / self._wanted, 1.0)

    @property
    def remaining_s(self) -> float:
        """Seconds still to go."""
        return (1.0 - self.progress) * self._wanted / self._rate

    def feed(self, block: SampleBlock) -> bool:
        """Take a block; return True once the time is full. Samples beyond it are left out."""
        if not len(block.index) or self.progress >= 1.0:
            return self.progress >= 1.0
        if self._first < 0:
            self._first = int(block.index[0])
        inside = int(np.searchsorted(block.index, self._first + self._wanted))
        if inside:
            self._blocks.append(
                SampleBlock(block.channels, block.index[:inside], block.data[:inside], block.rate)
            )
        self._next = int(block.index[-1]) + 1
        return self.progress >= 1.0

    def samples(self) -> tuple[FloatArray, FloatArray]:
        """Everything collected so far: seconds since the first sample (n,), data (n, c).

        Angles run on past the end of their turn.
        """
        t, data = self._samples()
        return t, unwrapped(data, turning_columns(self._blocks[0].channels))

    def _samples(self) -> tuple[FloatArray, FloatArray]:
        index = np.concatenate([block.index for block in self._blocks])
        data = np.concatenate([block.data for block in self._blocks])
        return (index - self._first) / self._rate, data

    def result(self) -> Accumulation:
        """Return the means of what has been collected, also before the time is full.

        Raises
        ------
        ValueError
            Nothing has been collected.
        """
        if not self._blocks:
            raise ValueError("nothing has been accumulated")
        t, data = self._samples()
        steps = min(self._next - self._first, self._wanted)
        return accumulation_of(
            self._blocks[0].channels,
            t,
            data,
            first=self._first,
            lost=steps - len(t),
            wanted=self._wanted,
        )


def accumulation_of(
    channels: tuple[Channel, ...],
    t: FloatArray,
    data: FloatArray,
    *,
    first: int = 0,
    lost: int = 0,
    wanted: int | None = None,
) -> Accumulation:
    """Return the means of samples that are already together.

    Parameters
    ----------
    channels : (c,) what the columns are
    t : (n,) seconds by the counter
    data : (n, c) samples; angles (``angle.*``, deg) may pass the end of their turn
    first, lost : index of the first sample, samples passed over
    wanted : samples that were asked for, None if what came is what was asked for
    """
    n = len(t)
    turning = turning_columns(channels)
    raw, data = data, unwrapped(data, turning)
    mean = data.mean(axis=0)
    for at in turning:
        mean[at] = within_turn(float(mean[at]), raw[:, at])
    slope, slope_se = np.zeros_like(mean), np.full_like(mean, np.nan)
    se, dof = np.full_like(mean, np.nan), np.zeros_like(mean)
    notes = list(_faults(channels, data, n, lost, wanted))
    if n >= _MIN_SAMPLES:
        se, dof = standard_error(data, [channel.unit == "code" for channel in channels])
        centred = t - t.mean()
        slope = centred @ (data - data.mean(axis=0)) / (centred @ centred)
        # A mean over the same time with the same noise: its error times sqrt(12)/T.
        slope_se = se * np.sqrt(12.0) / max(float(t[-1] - t[0]), np.finfo(float).tiny)
    return Accumulation(
        channels=channels,
        n=n,
        seconds=float(t[-1] - t[0]) if n > 1 else 0.0,
        lost=lost,
        first=first,
        mean=frozen(mean),
        std=frozen(data.std(axis=0, ddof=1) if n > 1 else np.full_like(mean, np.nan)),
        se=frozen(se),
        se_dof=frozen(dof),
        slope=frozen(slope),
        slope_se=frozen(slope_se),
        notes=tuple(notes),
    )


def _faults(
    channels: tuple[Channel, ...], data: FloatArray, n: int, lost: int, wanted: int | None
) -> list[Note]:
    notes: list[Note] = []
    if n < _MIN_SAMPLES or (wanted is not None and n + lost < 0.99 * wanted):
        asked = "" if wanted is None else f" of {wanted}"
        notes.append(
            Note(Severity.ERROR, "too_short", f"too short: {n}{asked} samples; accumulate again")
        )
    if lost:
        much = lost > _MOST_LOST * (n + lost)
        notes.append(
            Note(
                Severity.ERROR if much else Severity.WARNING,
                "lost_samples",
                f"{lost} of {n + lost} samples were lost on the line; the mean is over the rest",
            )
        )
    stuck = [
        channel.name
        for channel, column in zip(channels, data.T, strict=True)
        if measures(channel) and n >= _MIN_SAMPLES and np.ptp(column) == 0.0 and column[0] != 0.0
    ]
    if stuck:
        notes.append(
            Note(
                Severity.WARNING,
                "stuck",
                f"{', '.join(stuck)}: the same number in all {n} samples; is the sensor alive, or"
                " its noise below one code?",
            )
        )
    return notes


def measures(channel: Channel) -> bool:
    """Whether a channel is the output of an inertial sensor."""
    return channel.role.startswith(("acc.", "rate.", "adc."))
