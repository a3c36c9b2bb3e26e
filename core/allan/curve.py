"""The Allan curve: what an analysis gives and everything else takes."""

from dataclasses import dataclass, replace

import numpy as np

from core.allan.confidence import edf_of_model, edf_of_types, interval, noise_types
from core.allan.model import NoiseModel
from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import Note


@dataclass(frozen=True, slots=True, eq=False)
class AllanCurve:
    """Overlapping Allan deviation of a rate record.

    Parameters
    ----------
    taus : (t,) averaging times, s
    deviation : (t,) in the unit of the record
    m : (t,) int64, averaging factors: taus * rate
    edf : (t,) equivalent degrees of freedom
    lower, upper : (t,) confidence limits of the deviation
    n : samples used
    rate : samples per second
    mode : ``"exact"``, ``"equivalent"`` (partial overlap) or ``"streaming"``
    notes : doubts about the record
    pairs : (t,) int64, span of the overlapping second differences behind each point
    level : two-sided confidence level of `lower` and `upper`
    """

    taus: FloatArray
    deviation: FloatArray
    m: IntArray
    edf: FloatArray
    lower: FloatArray
    upper: FloatArray
    n: int
    rate: float
    mode: str
    notes: tuple[Note, ...]
    pairs: IntArray
    level: float

    @property
    def duration(self) -> float:
        """Length of the record, s."""
        return self.n / self.rate

    @property
    def variance(self) -> FloatArray:
        """(t,) the Allan variance."""
        return self.deviation**2


def make_curve(
    m: IntArray,
    variance: FloatArray,
    pairs: IntArray,
    *,
    n: int,
    rate: float,
    mode: str,
    notes: tuple[Note, ...],
    level: float,
) -> AllanCurve:
    """Build a curve; the degrees of freedom are those of the noise the local slope shows."""
    taus = m / rate
    deviation = np.sqrt(variance)
    edf = edf_of_types(noise_types(taus, deviation, m, n), m, pairs)
    lower, upper = interval(deviation, edf, level)
    return AllanCurve(
        taus=frozen(taus),
        deviation=frozen(deviation),
        m=frozen_int(m),
        edf=frozen(edf),
        lower=lower,
        upper=upper,
        n=n,
        rate=rate,
        mode=mode,
        notes=notes,
        pairs=frozen_int(pairs),
        level=level,
    )


def with_model(curve: AllanCurve, model: NoiseModel) -> AllanCurve:
    """Return the curve with composite degrees of freedom and limits under a fitted model."""
    edf = edf_of_model(model, curve.m, curve.pairs, curve.rate)
    lower, upper = interval(curve.deviation, edf, curve.level)
    return replace(curve, edf=frozen(edf), lower=lower, upper=upper)
