"""What a longer record would resolve, before anyone waits for it.

The Fisher information of the cosine spectrum is known from the model alone. The uncertainty of N
falls with the square root of the record, that of B more slowly than that until the corner of
white and flicker noise is long behind, and that of K only with the number of periods at the
lowest frequencies.
"""

import math
from dataclasses import dataclass

import numpy as np

from core.allan.model import RANDOM, NoiseModel, spectral_columns
from core.allan.spectrum import bin_starts
from core.allan.whittle import Bins, covariance_of
from core.arrays import FloatArray
from core.errors import FitError

DETECTION = 1.6448536269514722 + 0.8416212335729143
"""Standard uncertainties at which a one-sided 5 % test finds a term four times in five."""
TURNS = 50


@dataclass(frozen=True, slots=True)
class Preview:
    """What a record of one length would give.

    Parameters
    ----------
    factor : length over that of the present record
    duration : s
    random_walk, bias_instability, rate_random_walk : relative standard uncertainty of N, B, K;
        infinite where the model has none of it, above 0.5 or so it means "not detectable"
    smallest_bias_instability : B found with 80 % probability beside the N and K of the model, in
        the unit of the record
    """

    factor: float
    duration: float
    random_walk: float
    bias_instability: float
    rate_random_walk: float
    smallest_bias_instability: float


def preview(
    model: NoiseModel,
    rate: float,
    duration: float,
    *,
    band: float | None = None,
    factors: tuple[float, ...] = (1.0, 2.0, 4.0, 8.0, 24.0),
) -> tuple[Preview, ...]:
    """Predict the uncertainties of records `factors` times as long.

    Parameters
    ----------
    model : fitted or supposed noise; N must not be 0
    rate : samples per second
    duration : of the present record, s
    band : highest frequency that can be fitted, Hz; half the rate unless given

    Raises
    ------
    FitError
        A model without random walk, or a record too short to hold a spectrum.
    """
    if model.random_walk <= 0.0:
        raise FitError("the preview needs a model with a random walk N above zero")
    top = 0.5 * rate if band is None else band
    return tuple(_preview(model, rate, factor, factor * duration, top) for factor in factors)


def _preview(model: NoiseModel, rate: float, factor: float, duration: float, top: float) -> Preview:
    n = round(duration * rate)
    starts, counts = bin_starts(max(n, 2))
    inside = (starts + counts) / (2.0 * duration) <= top * (1.0 + 1e-9)
    if np.count_nonzero(inside) <= len(RANDOM):
        raise FitError(f"a record of {duration:.4g} s holds no spectrum up to {top:.4g} Hz")
    starts, counts = starts[inside], counts[inside]
    # Coefficients of a bin: starts + 1 ... starts + counts; its middle stands for all.
    w = np.pi * np.sqrt((starts + 1.0) * (starts + counts)) / n
    columns = spectral_columns(RANDOM, w, 1.0 / rate)
    squares = np.array([model.coefficient(term) ** 2 for term in RANDOM])
    spread = _uncertainty(columns, counts, squares)
    relative = [
        float(u / (2.0 * square)) if square > 0.0 else math.inf
        for u, square in zip(spread.tolist(), squares.tolist(), strict=True)
    ]
    return Preview(
        factor,
        duration,
        relative[0],
        relative[1],
        relative[2],
        math.sqrt(_detectable(columns, counts, squares)),
    )


def _uncertainty(columns: FloatArray, counts: FloatArray, squares: FloatArray) -> FloatArray:
    """Return standard uncertainties of the squared coefficients."""
    bins = Bins(np.ones(len(counts)), counts, columns)
    return np.sqrt(np.diag(covariance_of(bins, squares)))


def _detectable(columns: FloatArray, counts: FloatArray, squares: FloatArray) -> float:
    """Return the square of the smallest B: it is DETECTION times its own uncertainty."""
    place = RANDOM.index("bias_instability")
    trial = squares.copy()
    trial[place] = 0.0
    for _ in range(TURNS):
        trial[place] = DETECTION * float(_uncertainty(columns, counts, trial)[place])
    return float(trial[place])
