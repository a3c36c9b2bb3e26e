"""Noise records whose coefficients are known."""

from collections.abc import Callable

import numpy as np
import pytest

from core.arrays import FloatArray

Maker = Callable[..., FloatArray]


def make_noise(
    rng: np.random.Generator,
    n: int,
    rate: float,
    *,
    N: float = 0.0,
    B: float = 0.0,
    K: float = 0.0,
    R: float = 0.0,
) -> FloatArray:
    """Sum exact white noise, an exact random walk, a ramp, and flicker noise cut out of a Fourier
    synthesis at least four times as long."""
    dt = 1.0 / rate
    y = rng.normal(size=n) * N * np.sqrt(rate) + R * dt * np.arange(n)
    if K:
        y += np.cumsum(rng.normal(size=n)) * K * np.sqrt(dt)
    if B:
        length = 1 << int(np.ceil(np.log2(4 * n)))
        frequency = np.fft.rfftfreq(length, dt)
        density = np.zeros_like(frequency)
        density[1:] = B * B / (2.0 * np.pi * frequency[1:])
        parts = rng.normal(size=len(frequency)) + 1j * rng.normal(size=len(frequency))
        y += np.fft.irfft(parts * np.sqrt(0.5 * density * length * rate), length)[:n]
    return y


@pytest.fixture
def noise() -> Maker:
    return make_noise
