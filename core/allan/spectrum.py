"""Power of a record's cosine transform, in bins: what the likelihood is fitted to.

The orthonormal DCT-II diagonalises white noise and a random walk exactly (it is the eigenbasis of
the differences with free ends) and flicker noise nearly; the mean of the record drops out with
coefficient 0. A bin holds the mean square of `count` neighbouring coefficients: the fit needs no
more, for the laws are smooth.
"""

from dataclasses import dataclass
from typing import cast

import numpy as np

from core.allan.faults import Record
from core.allan.model import spectral_columns
from core.arrays import FloatArray, IntArray

SINGLE = 64
"""Coefficients below this have a bin each."""
PER_DECADE = 24
LARGEST = 1 << 21
"""Samples above which neighbours are averaged before the transform."""
TOP_SHARE = 0.1
"""Share of the sampling rate to which the spectrum of averaged samples keeps its shape."""


@dataclass(frozen=True, slots=True, eq=False)
class Spectrum:
    """Binned power of the cosine transform of a gap-free record.

    Parameters
    ----------
    amplitudes : (n - 1,) coefficients 1 ... n-1, unit of the record
    starts : (b,) first coefficient of each bin, less 1
    counts : (b,) coefficients in each bin
    dt : sampling interval after averaging, s
    averaged : raw samples averaged into one
    """

    amplitudes: FloatArray
    starts: IntArray
    counts: FloatArray
    dt: float
    averaged: int

    @property
    def n(self) -> int:
        """Samples transformed."""
        return len(self.amplitudes) + 1

    @property
    def top(self) -> float:
        """Highest frequency whose power can be trusted, Hz."""
        return (0.5 if self.averaged == 1 else TOP_SHARE) / self.dt

    @property
    def edges(self) -> FloatArray:
        """(b,) highest frequency of each bin, Hz."""
        return (self.starts + self.counts) / (2.0 * self.n * self.dt)

    def power(self) -> FloatArray:
        """Return (b,) mean squares of the coefficients."""
        return self.bins(np.zeros(1))[0]

    def bins(self, leverage: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return (b,) mean squares and (b,) counts of coefficients that a regression has fitted.

        Parameters
        ----------
        leverage : (n - 1,) share of each coefficient's variance that the regression took, or (1,)
            for all; it is given back to the mean squares and taken from the counts
        """
        left = np.broadcast_to(1.0 - leverage, self.amplitudes.shape)
        counts = np.add.reduceat(left, self.starts)
        power = np.add.reduceat(self.amplitudes**2, self.starts) / counts
        return np.maximum(power, np.finfo(np.float64).tiny), counts

    def columns(self, terms: tuple[str, ...]) -> FloatArray:
        """Return (b, len(terms)) expected powers for unit squared coefficients."""
        return bin_columns(terms, self.n, self.dt, self.starts, self.counts)


def bin_columns(
    terms: tuple[str, ...], n: int, dt: float, starts: IntArray, counts: FloatArray
) -> FloatArray:
    """Return (b, len(terms)): laws of the terms averaged over the coefficients of each bin."""
    w = np.pi * np.arange(1, n) / n
    laws = spectral_columns(terms, w, dt)
    return np.add.reduceat(laws, starts, axis=0) / counts[:, np.newaxis]


def bin_starts(n: int) -> tuple[IntArray, FloatArray]:
    """Return starts and counts of the bins of coefficients 1 ... n-1."""
    last = n - 1
    single = np.arange(min(SINGLE, last), dtype=np.int64)
    decades = np.log10(last / SINGLE) if last > SINGLE else 0.0
    wide = np.geomspace(SINGLE, max(last, SINGLE), int(np.ceil(PER_DECADE * decades)) + 1)[:-1]
    starts = np.unique(np.concatenate((single, np.rint(wide).astype(np.int64))))
    starts = starts[starts < last]
    return starts, np.diff(np.concatenate((starts, [last]))).astype(np.float64)


def ramp_amplitudes(n: int, dt: float) -> FloatArray:
    """Return (n - 1,) cosine coefficients of a ramp of one unit a second."""
    k = np.arange(1, n)
    half = 0.5 * np.pi * k / n
    result = np.cos(half) / np.sin(half) ** 2
    result *= -0.5 * dt * np.sqrt(2.0 / n)
    result[1::2] = 0.0
    return result


def transform(values: Record, start: int, stop: int, rate: float) -> Spectrum:
    """Return the spectrum of values[start:stop].

    Parameters
    ----------
    values : record without gaps between `start` and `stop`
    rate : samples per second

    Notes
    -----
    Above two million samples neighbours are averaged first: the terms of interest lie at low
    frequency. A last 0.1 % of the record at most is left out to reach a length with small factors.
    """
    from scipy.fft import dct, prev_fast_len

    averaged = -(-(stop - start) // LARGEST)
    samples = block_means(values, start, stop, averaged)
    samples = samples[: prev_fast_len(len(samples), real=True)]
    centred = samples - samples.mean()
    amplitudes = cast(FloatArray, dct(centred, type=2, norm="ortho", overwrite_x=True))[1:]
    starts, counts = bin_starts(len(samples))
    return Spectrum(amplitudes, starts, counts, averaged / rate, averaged)


def block_means(values: Record, start: int, stop: int, size: int) -> FloatArray:
    """Return the means of successive blocks of `size` samples; an incomplete last one is left."""
    if size == 1:
        return np.asarray(values[start:stop], dtype=np.float64)
    count = (stop - start) // size
    offset = float(values[start])
    means = np.empty(count)
    step = max(1 << 16, size) // size
    for at in range(0, count, step):
        end = min(at + step, count)
        part = np.asarray(values[start + at * size : start + end * size], dtype=np.float64)
        means[at:end] = (part - offset).reshape(-1, size).mean(axis=1) + offset
    return means
