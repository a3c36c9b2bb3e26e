"""Noise coefficients of a record: every method, intervals, and what to doubt.

The values to publish are those of the maximum likelihood on the cosine spectrum; the least squares
fit of the Allan variance stands beside them as an independent opinion, and the graphical reading
for those who learned it.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from core.allan.coefficients import NoiseCoefficients, NoiseRow
from core.allan.conventions import unit_of
from core.allan.curve import with_model
from core.allan.deviation import curve_of
from core.allan.faults import Record
from core.allan.graphical import read_curve
from core.allan.leastsquares import fit_variance
from core.allan.model import RANDOM, from_squares
from core.allan.ramp import Ramp, fit_ramp
from core.allan.record import GapPolicy, survey
from core.allan.rows import graphical_rows, likelihood_rows, ramp_row, variance_rows
from core.allan.spectrum import LARGEST, Spectrum, transform
from core.allan.taus import averaging_factors
from core.allan.whittle import Bins, Likelihood, band_limit, maximise, misfit
from core.arrays import IntArray
from core.errors import FitError, Note, Severity

SHORTEST = 256
"""Samples below which the terms cannot be told apart."""
BAND_PER_BANDWIDTH = 0.2
"""Share of a sensor's bandwidth in which its noise is still flat (taus from 5 / bandwidth)."""
DISAGREE = 3.0
"""Standard uncertainties between two methods that are worth a note."""
LINE = 1e-4
"""Probability that chance alone makes the highest bin of the spectrum as high as it is."""
MISFIT = 1e-4
OUTPUTS: dict[str, tuple[str, ...]] = {"rate": RANDOM, "increment": (*RANDOM, "quantization")}
"""Noise terms by what the device sends: rate, or increments of angle (velocity) over dt."""


def fit_noise(
    values: Record,
    rate: float,
    *,
    unit: str = "deg/s",
    output: str = "rate",
    bandwidth: float | None = None,
    gaps: GapPolicy = "longest",
    index: IntArray | None = None,
) -> NoiseCoefficients:
    """Fit random walk, bias instability, rate random walk, ramp (and quantisation) to a record.

    Parameters
    ----------
    values : (n,) samples at rest
    rate : samples per second
    unit : unit of the samples: ``"deg/s"``, ``"m/s^2"``, or any other as it is
    output : ``"rate"``, or ``"increment"`` for a device that sends increments of angle or velocity
        (samples = increment * rate); only these have quantisation noise in the sense of (6.4)
    bandwidth : -3 dB bandwidth of the sensor, Hz; found from the record where None
    gaps : ``"refuse"`` or ``"longest"``; the fit needs one contiguous stretch
    index : (n,) sample numbers by the device's counter, where there are any

    Returns
    -------
    NoiseCoefficients

    Raises
    ------
    FitError
        Fewer than 256 samples in one stretch, gaps that are not allowed, equal samples, or a
        spectrum that no such noise has.

    Notes
    -----
    The Allan curve is exact up to two million samples, of partial overlap above.
    """
    if gaps == "stretches":
        raise ValueError("a noise fit needs one stretch without gaps: choose 'longest'")
    found = survey(values, index, gaps)
    start, stop = found.longest
    if found.n < SHORTEST:
        raise FitError(
            f"{found.n} samples without a gap: the noise terms cannot be told apart in fewer than "
            f"{SHORTEST}; record longer"
        )
    terms = OUTPUTS[output]
    mode = "exact" if found.n <= LARGEST else "equivalent"
    curve = curve_of(values, found, averaging_factors(found.n), rate, mode)

    spectrum = transform(values, start, stop, rate)
    whole = Bins(spectrum.power(), spectrum.counts, spectrum.columns(terms))
    used, limited = band_limit(spectrum, whole, bandwidth and BAND_PER_BANDWIDTH * bandwidth)
    bins = whole.upto(used)
    ramp, bins, best = fit_ramp(spectrum, terms, bins, maximise(bins))
    model = from_squares(terms, best.squares)
    if ramp.significant:
        model = replace(model, rate_ramp=abs(ramp.value))

    band = float(spectrum.edges[used - 1])
    shortest = 2.0 / band if limited or spectrum.averaged > 1 else 0.0
    rows = likelihood_rows(bins, best, terms, unit)
    rows.append(ramp_row(ramp, unit))
    rows.extend(variance_rows(fit_variance(curve, (*terms, "rate_ramp"), shortest), unit))
    rows.extend(graphical_rows(read_curve(curve, terms=(*terms, "rate_ramp")), unit))
    notes = list(found.notes)
    if limited:
        notes.append(_band_note(spectrum, band))
    if ramp.significant:
        notes.append(_ramp_note(ramp, unit))
    notes.extend(_shape_notes(spectrum, bins, best))
    notes.extend(_disagreements(rows))
    return NoiseCoefficients(
        tuple(rows), model, with_model(curve, model), band, shortest, unit, tuple(notes)
    )


def _band_note(spectrum: Spectrum, band: float) -> Note:
    return Note(
        Severity.INFO,
        "band",
        f"the noise is not flat up to {spectrum.top:.4g} Hz (a filter in the sensor, a resonance, "
        f"vibration); frequencies up to {band:.3g} Hz and tau from {2.0 / band:.3g} s were fitted",
    )


def _ramp_note(ramp: Ramp, unit: str) -> Note:
    return Note(
        Severity.WARNING,
        "ramp",
        f"the record drifts steadily by {ramp.value:.3g} +- {ramp.u:.1g} "
        f"{unit_of('rate_ramp', unit)} (k = 1); it was taken off before the noise was fitted. "
        "Was the sensor warmed up?",
    )


def _shape_notes(spectrum: Spectrum, bins: Bins, best: Likelihood) -> Iterator[Note]:
    """Yield a line that stands out of the spectrum, or that the spectrum is of another shape."""
    from scipy.special import gammaincc

    half = 0.5 * bins.counts
    ratio = bins.power / (bins.columns @ best.squares)
    chance = np.asarray(gammaincc(half, half * ratio), dtype=np.float64)
    highest = int(chance.argmin())
    if chance[highest] * len(chance) < LINE:
        frequency = float(spectrum.edges[highest])
        yield Note(
            Severity.WARNING,
            "line",
            f"the spectrum is {ratio[highest]:.3g} times the fitted noise about {frequency:.3g} Hz "
            f"(period {1.0 / frequency:.3g} s): vibration, a thermostat or a warm-up rather than "
            "noise",
        )
    elif misfit(bins, best.squares) < MISFIT:
        yield Note(
            Severity.WARNING,
            "misfit",
            "the spectrum has another shape than white, flicker and random walk noise together; "
            "the intervals are too narrow",
        )


def _disagreements(rows: list[NoiseRow]) -> Iterator[Note]:
    """Yield where the least squares fit contradicts the published value."""
    others = {row.term: row for row in rows if row.method == "least_squares"}
    for row in rows:
        if row.method != "likelihood" or row.upper_limit or row.term == "rate_ramp":
            continue
        other = others[row.term]
        u = max(row.u, other.u)
        if abs(row.value - other.value) > DISAGREE * u:
            yield Note(
                Severity.WARNING,
                "disagreement",
                f"{row.symbol} is {row.value:.4g} {row.unit} by likelihood but {other.value:.4g} "
                f"by least squares of the Allan variance, {abs(row.value - other.value) / u:.1f} "
                "standard uncertainties apart: trust neither before the spectrum was looked at",
            )
