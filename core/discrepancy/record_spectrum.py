"""The spectral view of a record at its full rate: lines, and which terms its noise has.

Lines are looked for in a periodogram over its own smooth spectrum; the highest of m independent
ordinates exceeds x with probability 1 - (1 - exp(-x))^m (Fisher 1929). Noise terms are compared by
the likelihood of the binned cosine spectrum (Whittle), each charged for being free.
"""

import math
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import cast

import numpy as np

from core.allan.conventions import unit_of
from core.allan.spectrum import Spectrum, transform
from core.allan.whittle import Bins, band_limit, covariance_of, deviance_of, maximise, misfit
from core.arrays import FloatArray, frozen
from core.discrepancy.record_problem import Samples
from core.errors import FitError

_SLOW = 40
"""Cosines of the record below which lines are left to the slow view (twenty periods)."""
_BINS = 100
_FEW, _MANY = 100, 800
"""Ordinates that make a level: in the finest bins, and in those that know it well."""
_MOST_LINES = 2
_FREE = 2.3
"""What a free coefficient costs, natural logarithm."""
_TIE = 3.0
_NEEDED = 3.0
_MISFIT = 1e-3
_MARKOV = "markov"
_SETS: tuple[tuple[str, ...], ...] = (
    (),
    ("bias_instability",),
    ("rate_random_walk",),
    ("quantization",),
    (_MARKOV,),
    ("bias_instability", "rate_random_walk"),
    ("quantization", "bias_instability"),
    ("quantization", "rate_random_walk"),
)


@dataclass(frozen=True, slots=True)
class Line:
    """A line of the spectrum.

    Parameters
    ----------
    frequency : Hz
    sine, cosine : amplitudes at the time of the first sample, output units
    u : standard uncertainty of both
    chance : probability of one so high in noise
    """

    frequency: float
    sine: float
    cosine: float
    u: float
    chance: float

    @property
    def amplitude(self) -> float:
        """Output units."""
        return math.hypot(self.sine, self.cosine)

    def at(self, t: FloatArray) -> FloatArray:
        """The line at times (n,) since the first sample, s."""
        angle = 2.0 * math.pi * self.frequency * t
        return self.sine * np.sin(angle) + self.cosine * np.cos(angle)


@dataclass(frozen=True, slots=True)
class NoiseTerm:
    """One term of the noise beyond the white.

    Parameters
    ----------
    effect : identifier in the catalogue
    value, u, unit : coefficient, standard uncertainty
    memory : of Markov noise, s; NaN for others
    evidence : natural logarithm
    probability : among the terms that could stand in its place
    rivals : identifiers of those that could as well
    """

    effect: str
    value: float
    u: float
    unit: str
    memory: float
    evidence: float
    probability: float
    rivals: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """The spectrum over its smooth course.

    Parameters
    ----------
    frequency : (k,) upper ends of the bins, Hz
    highest : (k,) highest ordinate in each, over the smooth spectrum
    level : (k,) smooth spectrum as the amplitude that a line would need to equal it, output units
    count : independent ordinates
    """

    frequency: FloatArray
    highest: FloatArray
    level: FloatArray
    count: int


def lines_of(samples: Samples, chance: float) -> tuple[tuple[Line, ...], Samples, Seen | None]:
    """Find lines and take them off.

    Parameters
    ----------
    samples : the record
    chance : probability that noise alone gives a line

    Returns
    -------
    the lines, the samples without them, the spectrum with them (None for a very short record)
    """
    found: list[Line] = []
    first: Seen | None = None
    while len(found) <= _MOST_LINES:
        flat = _without_slow(samples.whole)
        if len(flat) < 4 * _SLOW:
            break
        seen, frequency, ratio = _highest(flat, samples.rate)
        first = seen if first is None else first
        likely = -math.expm1(seen.count * math.log1p(-math.exp(-ratio)))
        if likely > chance or len(found) == _MOST_LINES:
            break
        line = _fitted(flat, samples.rate, frequency, likely)
        found.append(line)
        y = np.array(samples.run.y)
        y[:, samples.channel] -= line.at(samples.place / samples.rate)
        samples = replace(samples, run=replace(samples.run, y=y))
    return tuple(found), samples, first


def _without_slow(values: FloatArray) -> FloatArray:
    from scipy.fft import dct, idct

    waves = dct(values, type=2, norm="ortho")
    waves[:_SLOW] = 0.0
    return idct(waves, type=2, norm="ortho")


def _highest(flat: FloatArray, rate: float) -> tuple[Seen, float, float]:
    """The spectrum in bins, and frequency and height of its highest ordinate."""
    from scipy.fft import next_fast_len, rfft

    n = len(flat)
    size = next_fast_len(2 * n, real=True)
    power = np.abs(cast(FloatArray, rfft(flat, size))) ** 2 / n
    frequency = np.arange(len(power)) * rate / size
    low = int(np.ceil(0.5 * (_SLOW + 4) / n * size))
    spans, level = _levels(power, low, _FEW)
    # Few ordinates tell their level badly, many blur it: a line must stand out over both.
    smooth = np.maximum(
        _along(power, low, spans, level), _along(power, low, *_levels(power, low, _MANY))
    )
    ratio = power[low : len(power) - 1] / smooth
    best = int(np.argmax(ratio))
    seen = Seen(
        frozen([frequency[b] for _, b in spans]),
        frozen([ratio[a - low : b - low].max() for a, b in spans]),
        frozen(2.0 * np.sqrt(level / n)),
        n,
    )
    return seen, float(frequency[low + best]), float(ratio[best])


def _levels(power: FloatArray, low: int, few: int) -> tuple[list[tuple[int, int]], FloatArray]:
    """Bins of at least so many ordinates from `low` on, and the median level of each."""
    edges = np.unique(np.geomspace(low, len(power) - 1, _BINS).astype(np.int64))
    kept = [int(edges[0])]
    for edge in edges[1:].tolist():
        if edge - kept[-1] >= few:
            kept.append(edge)
    kept[-1] = len(power) - 1
    spans = list(pairwise(kept)) or [(low, len(power) - 1)]
    level = np.array([float(np.median(power[a:b])) / math.log(2.0) for a, b in spans])
    return spans, np.maximum(level, 1e-300)


def _along(
    power: FloatArray, low: int, spans: list[tuple[int, int]], level: FloatArray
) -> FloatArray:
    """The level at each ordinate from `low` on: straight lines over both logarithms."""
    middle = np.log([0.5 * (a + b) for a, b in spans])
    log = np.log(level)
    at = np.log(np.arange(low, len(power) - 1))
    found = np.interp(at, middle, log)
    if len(spans) > 1:
        # The noise of a sensor falls with frequency: below the first middle it goes on rising.
        slope = max((log[0] - log[1]) / (middle[1] - middle[0]), 0.0)
        found += slope * np.maximum(middle[0] - at, 0.0)
    return np.exp(found)


def _fitted(flat: FloatArray, rate: float, frequency: float, chance: float) -> Line:
    """The line of least squares about a frequency."""
    t = np.arange(len(flat)) / rate
    width = 0.5 * rate / len(flat)

    def solved(f: float) -> tuple[float, FloatArray]:
        angle = 2.0 * math.pi * f * t
        waves = np.column_stack([np.sin(angle), np.cos(angle)])
        solution = np.linalg.lstsq(waves.T @ waves, waves.T @ flat, rcond=None)[0]
        values = np.asarray(solution, dtype=np.float64)
        return float(values @ (waves.T @ flat)), values

    best, (gain, values) = frequency, solved(frequency)
    for _ in range(8):
        for trial in (best - width, best + width):
            other, there = solved(trial)
            if other > gain:
                best, gain, values = trial, other, there
        width *= 0.5
    u = float(np.std(flat)) * math.sqrt(2.0 / len(flat))
    return Line(best, float(values[0]), float(values[1]), u, chance)


def noise_terms(samples: Samples, unit: str) -> tuple[tuple[NoiseTerm, ...], dict[str, float]]:
    """Name the terms of the noise.

    Parameters
    ----------
    samples : the record without what was found in it
    unit : of the output

    Returns
    -------
    terms beyond white noise, and the coefficient of the white noise with its unit as the key
    """
    whole = samples.whole
    spectrum = transform(whole, 0, len(whole), samples.rate)
    used = int(np.searchsorted(spectrum.edges, spectrum.top * (1.0 + 1e-9), side="right"))
    readings = _readings(spectrum, used)
    best = max(readings, key=lambda one: one.evidence)
    if misfit(best.bins, best.squares) < _MISFIT:
        # A filter or a resonance of the sensor: only what lies below tells of these terms.
        plain = ("random_walk", "bias_instability", "rate_random_walk")
        bins = Bins(spectrum.power(), spectrum.counts, spectrum.columns(plain))
        try:
            used, _ = band_limit(spectrum, bins)
        except FitError:
            return (), {}
        readings = _readings(spectrum, used)
        best = max(readings, key=lambda one: one.evidence)
    white = {f"N {unit_of('random_walk', unit)}": math.sqrt(max(float(best.squares[0]), 0.0))}
    terms: list[NoiseTerm] = []
    for place, name in enumerate(best.names, 1):
        others = tuple(other for other in best.names if other != name)
        without = next(r for r in readings if r.names == others)
        if best.evidence - without.evidence < _NEEDED:
            continue
        terms.append(_term(name, place, others, best, without, readings, unit))
    return tuple(terms), white


@dataclass(frozen=True, slots=True, eq=False)
class _Reading:
    names: tuple[str, ...]
    bins: Bins
    squares: FloatArray
    evidence: float
    memory: float


def _readings(spectrum: Spectrum, used: int) -> list[_Reading]:
    """All sets of terms, each with its evidence over the same bins."""
    return [_reading(spectrum, used, names) for names in _SETS]


def _reading(spectrum: Spectrum, used: int, names: tuple[str, ...]) -> _Reading:
    power, counts = spectrum.power()[:used], spectrum.counts[:used]
    if _MARKOV not in names:
        columns = spectrum.columns(("random_walk", *names))[:used]
        bins = Bins(power, counts, columns)
        found = maximise(bins)
        cost = _FREE * len(names)
        return _Reading(names, bins, found.squares, -0.5 * found.deviance - cost, math.nan)
    white = spectrum.columns(("random_walk",))[:used]
    span = spectrum.n * spectrum.dt
    tried: list[_Reading] = []
    for memory in np.geomspace(4.0 * spectrum.dt, 0.1 * span, 16).tolist():
        columns = np.column_stack([white, _markov(spectrum, memory)[:used]])
        bins = Bins(power, counts, columns)
        squares = maximise(bins).squares
        evidence = -0.5 * deviance_of(bins, squares) - _FREE
        tried.append(_Reading(names, bins, squares, evidence, memory))
    best = max(tried, key=lambda one: one.evidence)
    values = np.array([one.evidence for one in tried])
    mean = best.evidence + math.log(float(np.mean(np.exp(values - best.evidence))))
    return replace(best, evidence=mean)


def _markov(spectrum: Spectrum, memory: float) -> FloatArray:
    """(b,) law of Markov noise of unit variance, sampled."""
    w = np.pi * np.arange(1, spectrum.n) / spectrum.n
    keep = math.exp(-spectrum.dt / memory)
    law = (1.0 - keep**2) / (1.0 - 2.0 * keep * np.cos(w) + keep**2)
    return np.add.reduceat(law, spectrum.starts) / spectrum.counts


def _term(
    name: str,
    place: int,
    others: tuple[str, ...],
    best: _Reading,
    without: _Reading,
    readings: list[_Reading],
    unit: str,
) -> NoiseTerm:
    # What could stand in the place of this term, with the others as they are.
    rivals = {
        next(n for n in one.names if n not in others): one.evidence
        for one in readings
        if len(one.names) == len(best.names) and set(others) < set(one.names)
    }
    weights = np.exp(np.array(list(rivals.values())) - best.evidence)
    value = math.sqrt(float(best.squares[place]))
    spread = math.sqrt(float(covariance_of(best.bins, best.squares)[place, place]))
    return NoiseTerm(
        effect=name,
        value=value,
        u=spread / (2.0 * value) if value > 0.0 else math.nan,
        unit=unit if name == _MARKOV else unit_of(name, unit),
        memory=best.memory if name == _MARKOV else math.nan,
        evidence=best.evidence - without.evidence,
        probability=float(1.0 / weights.sum()),
        rivals=tuple(
            other
            for other, evidence in rivals.items()
            if other != name and evidence > best.evidence - _TIE
        ),
    )
