"""Noise of a sensor, sample by sample and block by block alike."""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray

_CHUNK = 64
_FLICKER_TAUS_S = (0.1, 1.0, 10.0, 100.0, 1000.0, 10000.0)
# Relaxations of equal variance s^2, one a decade, add up to an Allan deviation that is flat
# within 2 % over the decades that they span, at 0.78 s.
_FLICKER_FLOOR = 0.78


class Lag:
    """First-order lag, y' = (x - y) / tau, of each column.

    Parameters
    ----------
    tau_s : time constant
    dt_s : time between samples
    start : (c,) output before the first sample
    """

    def __init__(self, tau_s: float, dt_s: float, start: FloatArray) -> None:
        self._pole = math.exp(-dt_s / tau_s) if tau_s > 0 else 0.0
        self._last = np.array(start, dtype=np.float64)
        # Response within a chunk to each of its inputs, and to the output before it.
        step = np.arange(_CHUNK)
        apart = step[:, None] - step[None, :]
        self._inner = np.where(apart >= 0, self._pole ** np.maximum(apart, 0), 0.0)
        self._decay = self._pole ** (step + 1.0)

    def filtered(self, x: FloatArray) -> FloatArray:
        """Return the output (n, c) for an input (n, c) that follows the one before."""
        return self.driven((1.0 - self._pole) * x)

    def driven(self, drive: FloatArray) -> FloatArray:
        """Return y[k] = pole * y[k-1] + drive[k], (n, c)."""
        y = np.empty_like(drive)
        for first in range(0, len(drive), _CHUNK):
            part = drive[first : first + _CHUNK]
            n = len(part)
            y[first : first + n] = self._inner[:n, :n] @ part + self._decay[:n, None] * self._last
            self._last = y[first + n - 1].copy()
        return y

    @property
    def output(self) -> FloatArray:
        """The latest output (c,)."""
        return self._last

    @property
    def pole(self) -> float:
        """How much of the last output stays in the next."""
        return self._pole


@dataclass(frozen=True, slots=True)
class NoiseLevel:
    """Noise of one output, in its own unit.

    Parameters
    ----------
    density : white noise, unit per root hertz, one-sided: sample deviation / sqrt(rate / 2)
    floor : bias instability, minimum of the Allan deviation over 0.664
    walk : random walk, unit per root second
    """

    density: float
    floor: float
    walk: float


class Noise:
    """Noise of several outputs, the same however it is cut into blocks.

    Parameters
    ----------
    levels : (c,) one for each output
    rate_hz : samples per second
    rng : the only source of chance; spawned from, one stream for each process
    """

    def __init__(
        self, levels: tuple[NoiseLevel, ...], rate_hz: float, rng: np.random.Generator
    ) -> None:
        dt = 1.0 / rate_hz
        self._white_rng, self._walk_rng, start = rng.spawn(3)
        self._white = np.array([level.density for level in levels]) * math.sqrt(rate_hz / 2.0)
        self._walk = np.array([level.walk for level in levels]) * math.sqrt(dt)
        self._position = np.zeros(len(levels))
        self._drifted = np.zeros(len(levels))
        self._count = 0
        sigma = np.array([level.floor for level in levels]) * (0.664 / _FLICKER_FLOOR)
        self._sigma = sigma
        self._relaxations = [
            (Lag(tau, dt, sigma * start.standard_normal(len(levels))), stream)
            for tau, stream in zip(_FLICKER_TAUS_S, rng.spawn(len(_FLICKER_TAUS_S)), strict=True)
            if tau > dt
        ]

    def next(self, n: int) -> FloatArray:
        """Return the noise (n, c) of the next n samples."""
        shape = (n, len(self._white))
        slow = np.zeros(shape)
        if self._walk.any():
            steps = self._walk_rng.standard_normal(shape) * self._walk
            walked = np.cumsum(steps, axis=0) + self._position
            self._position = walked[-1].copy()
            slow += walked
        if self._sigma.any():
            for lag, stream in self._relaxations:
                sigma = self._sigma * math.sqrt(1.0 - lag.pole**2)
                slow += lag.driven(stream.standard_normal(shape) * sigma)
        self._drifted += slow.sum(axis=0)
        self._count += n
        return slow + self._white_rng.standard_normal(shape) * self._white

    @property
    def drift(self) -> FloatArray:
        """Mean (c,) of all but the white noise so far: what a test cannot tell from a bias."""
        return self._drifted / max(self._count, 1)
