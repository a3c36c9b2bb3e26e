"""Simulated records of a resting gyro with known noise, for the tests of records and windows."""

import numpy as np

from core.arrays import FloatArray


def gyro_noise(n: int, rate: float, noise: tuple[float, float, float], seed: int = 1) -> FloatArray:
    """White noise N, flicker B and random walk K together (two-sided densities as in (6.3))."""
    rng = np.random.default_rng(seed)
    white, flicker, walk = noise
    dt = 1.0 / rate
    frequency = np.fft.rfftfreq(2 * n, dt)
    frequency[0] = frequency[1]
    shaped = np.fft.rfft(rng.standard_normal(2 * n))
    shaped *= np.sqrt(flicker**2 / (2.0 * np.pi * frequency) / dt)
    return (
        rng.standard_normal(n) * white / np.sqrt(dt)
        + np.fft.irfft(shaped)[:n]
        + np.cumsum(rng.standard_normal(n)) * walk * np.sqrt(dt)
    )
