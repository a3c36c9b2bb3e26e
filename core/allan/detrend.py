"""The Allan curve before and after regression on temperature or other channels.

The coefficients are found by generalised least squares: each cosine coefficient of the record is
weighted by the noise there, and the noise is fitted to what the regression leaves. An ordinary
straight-line fit would give the wandering of the bias to whatever channel happens to move, with
an uncertainty ten times too small.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from core.allan.curve import AllanCurve
from core.allan.deviation import curve_of, overlapping
from core.allan.faults import Record
from core.allan.model import RANDOM, spectral_columns
from core.allan.record import GapPolicy, survey
from core.allan.spectrum import Spectrum, bin_starts, block_means
from core.allan.taus import averaging_factors
from core.allan.whittle import Bins, expected_squares, maximise
from core.arrays import FloatArray, IntArray, frozen
from core.errors import FitError, Note, RankDeficient, Severity

MOST = 1 << 17
"""Samples after averaging: the channels move slowly."""
TURNS = 8
MOST_LEVERAGE = 0.99
"""A coefficient that the regression fits altogether says nothing about the noise."""
DEPENDENT = 1e-7
"""Smallest singular value of the scaled design, over the largest, that is told from zero."""
INSIGNIFICANT = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class Regressor:
    """A channel that may explain the drift.

    Parameters
    ----------
    name, unit : e.g. ``"temp"``, ``"degC"``
    values : (n,) beside the samples of the record
    """

    name: str
    unit: str
    values: Record


@dataclass(frozen=True, slots=True, eq=False)
class Detrended:
    """A record less what other channels explain.

    Parameters
    ----------
    names : (p,) ``"temp"``, ``"temp^2"``, ...: powers of the channel less its mean
    values, u : (p,) coefficients and their standard uncertainties
    units : (p,)
    covariance : (p, p)
    references : channel means from which the powers are taken, by channel
    start : first sample of the record that was analysed
    residual : (n,) the record less the regression; its mean is that of the record
    before, after : Allan curves
    notes : doubts
    """

    names: tuple[str, ...]
    values: FloatArray
    u: FloatArray
    units: tuple[str, ...]
    covariance: FloatArray
    references: tuple[float, ...]
    start: int
    residual: FloatArray
    before: AllanCurve
    after: AllanCurve
    notes: tuple[Note, ...]


def detrend(
    values: Record,
    rate: float,
    regressors: Sequence[Regressor],
    *,
    order: int = 1,
    unit: str = "deg/s",
    gaps: GapPolicy = "longest",
    index: IntArray | None = None,
) -> Detrended:
    """Regress a record on channels and compare its Allan curve before and after.

    Parameters
    ----------
    values : (n,) samples
    rate : samples per second
    regressors : channels recorded with it
    order : highest power of each channel, 1 to 3
    unit : unit of the samples
    gaps : ``"refuse"`` or ``"longest"``
    index : (n,) sample numbers by the device's counter, where there are any

    Raises
    ------
    RankDeficient
        A channel does not move, or moves exactly as others do.
    FitError
        As for `overlapping`; or a channel has values that are not finite.
    """
    if gaps == "stretches":
        raise ValueError("a regression needs one stretch without gaps: choose 'longest'")
    found = survey(values, index, gaps)
    start, stop = found.longest
    columns, names, units, references = _design(regressors, order, unit, start, stop)
    averaged = -(-(stop - start) // MOST)
    design = np.stack([block_means(one, 0, stop - start, averaged) for one in columns], axis=1)
    scale = _scaled(design, names)
    coefficients, covariance = _regress(
        block_means(values, start, stop, averaged), design / scale, averaged / rate
    )
    coefficients /= scale
    covariance /= np.outer(scale, scale)
    residual = np.asarray(values[start:stop], dtype=np.float64).copy()
    for one, coefficient in zip(columns, coefficients.tolist(), strict=True):
        residual -= coefficient * (one - one.mean())
    m = averaging_factors(stop - start)
    u = np.sqrt(np.diag(covariance))
    return Detrended(
        names=names,
        values=frozen(coefficients),
        u=frozen(u),
        units=units,
        covariance=frozen(covariance),
        references=references,
        start=start,
        residual=frozen(residual),
        before=curve_of(values, found, m, rate, "exact"),
        after=overlapping(residual, rate, m=m),
        notes=(*found.notes, *_doubts(names, coefficients, u, units)),
    )


def _design(
    regressors: Sequence[Regressor], order: int, unit: str, start: int, stop: int
) -> tuple[list[FloatArray], tuple[str, ...], tuple[str, ...], tuple[float, ...]]:
    """Return columns, names, units of their coefficients, and the mean of each channel."""
    columns: list[FloatArray] = []
    names: list[str] = []
    units: list[str] = []
    means: list[float] = []
    for one in regressors:
        channel = np.asarray(one.values[start:stop], dtype=np.float64)
        if not np.all(np.isfinite(channel)):
            raise FitError(f"channel {one.name} has values that are not finite; choose another")
        means.append(float(channel.mean()))
        for power in range(1, order + 1):
            suffix = "" if power == 1 else f"^{power}"
            columns.append((channel - means[-1]) ** power)
            names.append(one.name + suffix)
            units.append(f"{unit}/{one.unit}{suffix}")
    return columns, tuple(names), tuple(units), tuple(means)


def _scaled(design: FloatArray, names: tuple[str, ...]) -> FloatArray:
    """Return the standard deviation of each column; refuse columns that say nothing new."""
    centred = design - design.mean(axis=0)
    scale = centred.std(axis=0)
    still = scale <= 1e-12 * np.abs(design).max(axis=0, initial=0.0)
    if np.any(still):
        free = tuple(name for name, flag in zip(names, still.tolist(), strict=True) if flag)
        raise RankDeficient(free, "the channel did not move during the record; leave it out")
    _, singular, directions = np.linalg.svd(centred / scale, full_matrices=False)
    if singular[-1] < DEPENDENT * singular[0]:
        involved = np.abs(directions[-1]) > 0.1
        free = tuple(name for name, flag in zip(names, involved.tolist(), strict=True) if flag)
        raise RankDeficient(free, "these move together; leave one out or lower the order")
    return scale


def _regress(samples: FloatArray, design: FloatArray, dt: float) -> tuple[FloatArray, FloatArray]:
    """Return coefficients and covariance by least squares weighted with the noise."""
    from scipy.fft import dct

    n = len(samples)
    y = cast(FloatArray, dct(samples - samples.mean(), type=2, norm="ortho"))[1:]
    x = dct(design, type=2, norm="ortho", axis=0)[1:]
    starts, counts = bin_starts(n)
    laws = spectral_columns(RANDOM, np.pi * np.arange(1, n) / n, dt)
    columns = Spectrum(y, starts, counts, dt, 1).columns(RANDOM)
    weights = likely = np.ones(n - 1)
    coefficients, covariance = _weighted(y, x, weights)
    for _ in range(TURNS):
        left = Spectrum(y - x @ coefficients, starts, counts, dt, 1)
        leverage = np.einsum("ij,jk,ik->i", x, covariance, x) * weights
        bins = Bins(*left.bins(np.minimum(leverage, MOST_LEVERAGE)), columns)
        squares = maximise(bins).squares
        weights = 1.0 / (laws @ squares)
        coefficients, covariance = _weighted(y, x, weights)
        likely = 1.0 / (laws @ expected_squares(bins, squares))
    return coefficients, _weighted(y, x, likely)[1]


def _weighted(y: FloatArray, x: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    weighted = x * weights[:, np.newaxis]
    covariance = np.asarray(np.linalg.inv(x.T @ weighted), dtype=np.float64)
    return covariance @ (weighted.T @ y), covariance


def _doubts(
    names: tuple[str, ...], values: FloatArray, u: FloatArray, units: tuple[str, ...]
) -> list[Note]:
    return [
        Note(
            Severity.INFO,
            "insignificant",
            f"{name}: {value:.3g} +- {spread:.2g} {unit} (k = 1) is not told from zero; "
            "the regression on it removes noise only",
        )
        for name, value, spread, unit in zip(names, values.tolist(), u.tolist(), units, strict=True)
        if abs(value) < INSIGNIFICANT * spread
    ]
