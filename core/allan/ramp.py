"""A rate ramp beside random noise: generalised least squares on the cosine coefficients.

A straight line through a random walk is mostly the walk itself, so its uncertainty comes from the
noise model, and the noise model from what the line leaves: the two are fitted in turn.
"""

from dataclasses import dataclass

import numpy as np

from core.allan.model import spectral_columns
from core.allan.spectrum import SINGLE, Spectrum, ramp_amplitudes
from core.allan.whittle import Bins, Likelihood, log_likelihood, maximise
from core.arrays import FloatArray

TURNS = 8
SIGNIFICANT = 9.0
"""Gain of 2 log L for which a ramp is believed (three standard uncertainties)."""


@dataclass(frozen=True, slots=True)
class Ramp:
    """A ramp of the rate.

    Parameters
    ----------
    value, u : unit of the record / s, signed
    significant : the record shows it beyond its random walk; the noise terms are then those of the
        record less the ramp
    """

    value: float
    u: float
    significant: bool


def fit_ramp(
    spectrum: Spectrum, terms: tuple[str, ...], bins: Bins, best: Likelihood
) -> tuple[Ramp, Bins, Likelihood]:
    """Estimate the ramp and decide whether it is there.

    Parameters
    ----------
    spectrum : of the record
    terms : noise terms fitted
    bins : the band fitted, ramp included
    best : the noise fit with the ramp included

    Returns
    -------
    ramp, and the bins and noise fit to go on with: without the ramp if it is significant
    """
    without, noise = bins, best
    value = u = 0.0
    for _ in range(TURNS):
        value, u = _estimate(spectrum, terms, noise.squares)
        power = spectrum.power(value)[: len(bins.power)]
        without = Bins(power, bins.counts, bins.columns)
        noise = maximise(without)
    gain = 2.0 * (log_likelihood(without, noise.squares) - log_likelihood(bins, best.squares))
    if gain > SIGNIFICANT:
        return Ramp(value, u, True), without, noise
    value, u = _estimate(spectrum, terms, best.squares)
    return Ramp(value, u, False), bins, best


def _estimate(
    spectrum: Spectrum, terms: tuple[str, ...], squares: FloatArray
) -> tuple[float, float]:
    """Return the ramp and its standard uncertainty, from the coefficients that can tell."""
    used = min(SINGLE, spectrum.n - 1)
    w = np.pi * np.arange(1, used + 1) / spectrum.n
    weights = 1.0 / (spectral_columns(terms, w, spectrum.dt) @ squares)
    shape = ramp_amplitudes(spectrum.n, spectrum.dt)[:used]
    information = float((shape * shape * weights).sum())
    value = float((shape * spectrum.amplitudes[:used] * weights).sum()) / information
    return value, 1.0 / float(np.sqrt(information))
