"""The five noise terms of an inertial sensor and their laws (practicum (6.3), (6.4)).

With a two-sided spectral density S(f) and averaging time tau (IEEE 952 names):

=====================  ======  ===================  ============================
term                   symbol  S(f)                 Allan variance
=====================  ======  ===================  ============================
quantization           Q       (2 pi f)^2 Q^2 dt    3 Q^2 / tau^2
random_walk            N       N^2                  N^2 / tau
bias_instability       B       B^2 / (2 pi f)       (2 ln 2 / pi) B^2
rate_random_walk       K       (K / (2 pi f))^2     K^2 tau / 3
rate_ramp              R       (not a spectrum)     R^2 tau^2 / 2
=====================  ======  ===================  ============================

In (6.4) the quantisation noise is that of an output of angle (or velocity) increments; rounding
of a rate output adds white noise instead, so the term is offered for increments only. The
letters are for the screen: N also counts samples and K also names scale factors.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray

FLOOR = math.sqrt(2.0 * math.log(2.0) / math.pi)
"""Flat part of the Allan deviation over B: 0.66428."""


@dataclass(frozen=True, slots=True)
class Term:
    """One term of the Allan variance: `factor` * coefficient^2 * tau^`power`.

    Parameters
    ----------
    symbol : the letter of (6.4)
    factor, power : see above; the deviation has slope power/2 in the log-log plot
    seconds : exponent of s in the unit of the coefficient, beside the unit of the rate
    reading : tau at which the asymptote of the deviation equals the coefficient, s; 0 where it
        does so nowhere (B is read as the floor over 0.664)
    """

    symbol: str
    factor: float
    power: int
    seconds: float
    reading: float


TERMS: dict[str, Term] = {
    "quantization": Term("Q", 3.0, -2, 1.0, math.sqrt(3.0)),
    "random_walk": Term("N", 1.0, -1, 0.5, 1.0),
    "bias_instability": Term("B", FLOOR**2, 0, 0.0, 0.0),
    "rate_random_walk": Term("K", 1.0 / 3.0, 1, -0.5, 3.0),
    "rate_ramp": Term("R", 0.5, 2, -1.0, math.sqrt(2.0)),
}
RANDOM = ("random_walk", "bias_instability", "rate_random_walk")
"""The terms a rate output can have that are noise rather than trend."""


@dataclass(frozen=True, slots=True)
class NoiseModel:
    """Coefficients of the five terms; 0 for an absent one.

    Units follow the record's unit u: quantization u s, random_walk u sqrt(s), bias_instability u,
    rate_random_walk u / sqrt(s), rate_ramp u / s.
    """

    random_walk: float = 0.0
    bias_instability: float = 0.0
    rate_random_walk: float = 0.0
    rate_ramp: float = 0.0
    quantization: float = 0.0

    def coefficient(self, term: str) -> float:
        """Return the coefficient of a key of TERMS."""
        return float(getattr(self, term))

    def part(self, term: str, tau: FloatArray) -> FloatArray:
        """Return one term's share of the Allan variance at `tau` (s)."""
        law = TERMS[term]
        return law.factor * self.coefficient(term) ** 2 * tau**law.power

    def variance(self, tau: FloatArray) -> FloatArray:
        """Return the Allan variance (6.4) at `tau` (s)."""
        total = np.zeros_like(tau)
        for term in TERMS:
            total += self.part(term, tau)
        return total

    def density(self, frequency: FloatArray, dt: float) -> FloatArray:
        """Return the two-sided spectral density at `frequency` (Hz) of samples `dt` s apart."""
        names = (*RANDOM, "quantization")
        squares = np.array([self.coefficient(name) ** 2 for name in names])
        return spectral_columns(names, 2.0 * np.pi * frequency * dt, dt) @ squares * dt


def from_squares(terms: Sequence[str], squares: FloatArray) -> NoiseModel:
    """Return the model whose squared coefficients are `squares`, in the order of `terms`."""
    values = np.sqrt(np.maximum(squares, 0.0)).tolist()
    return NoiseModel(**dict(zip(terms, values, strict=True)))


def variance_columns(terms: Sequence[str], tau: FloatArray) -> FloatArray:
    """Return (len(tau), len(terms)): the Allan variance of unit squared coefficients."""
    return np.stack([TERMS[name].factor * tau ** TERMS[name].power for name in terms], axis=1)


def spectral_columns(terms: Sequence[str], w: FloatArray, dt: float) -> FloatArray:
    """Return the variance of a cosine-transform coefficient for unit squared coefficients.

    Parameters
    ----------
    terms : names out of TERMS without rate_ramp
    w : (b,) angular frequency times dt, in (0, pi)
    dt : sampling interval, s

    Returns
    -------
    (b, len(terms))
        The orthonormal DCT-II diagonalises white noise and a random walk exactly and flicker
        noise nearly, so these are also S(f)/dt of sampled noise.
    """
    sine = 4.0 * np.sin(0.5 * w) ** 2
    laws = {
        "random_walk": np.full_like(w, 1.0 / dt),
        "bias_instability": 1.0 / w,
        "rate_random_walk": dt / sine,
        "quantization": sine / dt**2,
    }
    return np.stack([laws[name] for name in terms], axis=1)
