"""Mean, scatter and trend of any stretch of a long record without reading all of it again.

Sums are kept about the mean of each bin and merged pairwise (Chan, Golub, LeVeque 1979), because
differences of large plain sums lose the digits that matter: 23.733621 us with a scatter of 1e-6.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray

BIN = 4096


@dataclass(frozen=True, slots=True)
class Moments:
    """Centred sums over the samples that came; k is the sample number.

    Parameters
    ----------
    count : number of samples that are numbers
    k_mean, mean : means of sample number and of value
    kk, xx, kx : sums of products of the deviations from those means
    """

    count: float = 0.0
    k_mean: float = 0.0
    mean: float = math.nan
    kk: float = 0.0
    xx: float = 0.0
    kx: float = 0.0

    @property
    def sigma(self) -> float:
        """Standard deviation, n - 1 in the denominator; NaN below two samples."""
        return math.sqrt(self.xx / (self.count - 1.0)) if self.count > 1 else math.nan

    @property
    def slope(self) -> float:
        """Slope of the straight line fitted by least squares, per sample; NaN below two samples."""
        return self.kx / self.kk if self.kk > 0.0 else math.nan

    @classmethod
    def of(cls, samples: FloatArray, first: int) -> "Moments":
        """Moments of samples numbered from `first`."""
        there = ~np.isnan(samples)
        x = samples[there]
        if not x.size:
            return cls()
        k = np.flatnonzero(there).astype(np.float64)
        k_mean, mean = float(k.mean()), float(x.mean())
        dk, dx = k - k_mean, x - mean
        return cls(
            float(x.size), k_mean + first, mean, float(dk @ dk), float(dx @ dx), float(dk @ dx)
        )

    def shifted(self, offset: int) -> "Moments":
        """The same samples with `offset` added to their numbers."""
        return replace(self, k_mean=self.k_mean + offset)

    @classmethod
    def merge(cls, parts: Iterable["Moments"]) -> "Moments":
        """Moments of all parts together."""
        filled = [part for part in parts if part.count]
        rows = [(p.count, p.k_mean, p.mean, p.kk, p.xx, p.kx) for p in filled]
        return _merged(np.array(rows, dtype=np.float64).reshape(-1, 6))


def _merged(rows: FloatArray) -> Moments:
    """Join rows of count, k_mean, mean, kk, xx, kx."""
    count = float(rows[:, 0].sum())
    if not count:
        return Moments()
    weight = rows[:, 0]
    # About the first row, so that the sums stay small beside the values.
    k0, x0 = rows[0, 1], rows[0, 2]
    k_mean = k0 + float(weight @ (rows[:, 1] - k0)) / count
    mean = x0 + float(weight @ (rows[:, 2] - x0)) / count
    dk, dx = rows[:, 1] - k_mean, rows[:, 2] - mean
    return Moments(
        count,
        k_mean,
        mean,
        float(rows[:, 3].sum() + weight @ (dk * dk)),
        float(rows[:, 4].sum() + weight @ (dx * dx)),
        float(rows[:, 5].sum() + weight @ (dk * dx)),
    )


class MomentTable:
    """Moments of whole bins of `BIN` samples."""

    def __init__(self) -> None:
        self.count = 0
        self._rows = np.empty((64, 6))

    def extend(self, samples: FloatArray) -> None:
        """Add the next bins; the length is a multiple of `BIN`."""
        bins = samples.reshape(-1, BIN)
        end = self.count + len(bins)
        if end > len(self._rows):
            grown = np.empty((max(end, 2 * len(self._rows)), 6))
            grown[: self.count] = self._rows[: self.count]
            self._rows = grown
        for number, one in enumerate(bins, start=self.count):
            part = Moments.of(one, number * BIN)
            self._rows[number] = (
                part.count,
                part.k_mean,
                part.mean,
                part.kk,
                part.xx,
                part.kx,
            )
        self.count = end

    def merged(self, start: int, stop: int) -> Moments:
        """Moments of bins start to stop."""
        rows = self._rows[start:stop]
        return _merged(rows[rows[:, 0] > 0])
