"""A rate ramp beside random noise: generalised least squares on the cosine coefficients.

A straight line through a random walk is mostly the walk itself, so its uncertainty comes from the
noise model, and the noise model from what the line leaves: the two are fitted in turn.
"""

from dataclasses import dataclass, replace

import numpy as np

from core.allan.model import spectral_columns
from core.allan.spectrum import SINGLE, Spectrum, ramp_amplitudes
from core.allan.whittle import Bins, Likelihood, expected_squares, log_likelihood, maximise
from core.arrays import FloatArray

TURNS = 5
SIGNIFICANT = 12.0
"""Gain of 2 log L for which a ramp is believed: some 1 in 500 records without one shows it."""


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
    shape = ramp_amplitudes(spectrum.n, spectrum.dt)
    _, without, noise = _in_turn(spectrum, shape, terms, bins, best, restricted=False)
    gain = 2.0 * (log_likelihood(without, noise.squares) - log_likelihood(bins, best.squares))
    if gain > SIGNIFICANT:
        value, without, noise = _in_turn(spectrum, shape, terms, bins, noise, restricted=True)
        u = _estimate(spectrum, shape, terms, expected_squares(without, noise.squares))[1]
        return Ramp(value, u, True), without, noise
    value, u, _ = _estimate(spectrum, shape, terms, best.squares)
    return Ramp(value, u, False), bins, best


def _in_turn(
    spectrum: Spectrum,
    shape: FloatArray,
    terms: tuple[str, ...],
    bins: Bins,
    noise: Likelihood,
    *,
    restricted: bool,
) -> tuple[float, Bins, Likelihood]:
    """Fit ramp and noise in turn; `restricted` allows for what the ramp took from the noise."""
    value, without = 0.0, bins
    for _ in range(TURNS):
        value, _, leverage = _estimate(spectrum, shape, terms, noise.squares)
        left = replace(spectrum, amplitudes=spectrum.amplitudes - value * shape)
        power, counts = left.bins(leverage if restricted else np.zeros(1))
        used = len(bins.power)
        without = Bins(power[:used], counts[:used], bins.columns)
        noise = maximise(without)
    return value, without, noise


def _estimate(
    spectrum: Spectrum, shape: FloatArray, terms: tuple[str, ...], squares: FloatArray
) -> tuple[float, float, FloatArray]:
    """Return the ramp, its standard uncertainty and its (n - 1,) leverages."""
    used = min(SINGLE, spectrum.n - 1)
    w = np.pi * np.arange(1, used + 1) / spectrum.n
    near = shape[:used]
    weighted = near / (spectral_columns(terms, w, spectrum.dt) @ squares)
    information = float((near * weighted).sum())
    value = float((weighted * spectrum.amplitudes[:used]).sum()) / information
    leverage = np.zeros(spectrum.n - 1)
    leverage[:used] = near * weighted / information
    return value, 1.0 / float(np.sqrt(information)), leverage
