"""Simulated gyros switched on again and again; shares nothing with core.

Two exponentials of warm-up, five bends of the slope, and one fast transition whose moment moves
with the temperature; every turn-on has its own amplitude (1 %), offset and white noise. "smooth"
curves are the exponentials alone.
"""

import math

import numpy as np

HORIZON_S = 120.0
AMBIENTS = np.linspace(-40.0, 60.0, 11)
SHARP_NOISE = 1e-3
"""Angle random walk of the "sharp" device, deg/sqrt(s)."""
SMOOTH_NOISE = 4e-3
AMPLITUDE = 0.01
OFFSET_DPS = 0.05


def drift(t: np.ndarray, ambient_c: float, device: int, kind: str = "sharp") -> np.ndarray:
    """Noise-free drift, deg/s."""
    rng = np.random.default_rng(1000 + device)
    warm = ambient_c / 50.0

    def sign() -> float:
        return 1.0 if rng.random() < 0.5 else -1.0

    slow, fast = sign() * rng.uniform(0.04, 0.08), sign() * rng.uniform(0.01, 0.03)
    slow_s, fast_s = rng.uniform(40.0, 70.0), rng.uniform(5.0, 10.0)
    y = slow * (1.0 + 0.4 * warm) * (1.0 - np.exp(-t / slow_s))
    y = y + fast * (1.0 - 0.5 * warm) * (1.0 - np.exp(-t / fast_s))
    if kind == "smooth":
        return y
    slopes = rng.uniform(0.5e-3, 1.4e-3, 6) * np.array([1, -1, 1, -1, 1, -1]) * sign()
    moments = np.sort(rng.uniform(8.0, 112.0, 5))
    for before, after, moment in zip(slopes[:-1], slopes[1:], moments, strict=True):
        tempco = 0.3 * rng.uniform(-1.0, 1.0)
        y = y + (after - before) * (1.0 + tempco * warm) * np.maximum(t - moment, 0.0)
    centre, height = rng.uniform(25.0, 95.0), sign() * rng.uniform(0.014, 0.024)
    passed = (t - centre - 0.02 * ambient_c) / 0.3
    return y + height * (1.0 + 0.3 * warm) / (1.0 + np.exp(-passed))


def turn_on(
    rng: np.random.Generator,
    ambient_c: float,
    device: int,
    *,
    kind: str = "sharp",
    noise: float = SHARP_NOISE,
    rate: float = 1000.0,
) -> tuple[np.ndarray, np.ndarray]:
    """One record: outputs (n,), deg/s, and chip temperatures (n,), degC."""
    n = round(HORIZON_S * rate)
    t = (np.arange(n) + 0.5) / rate
    y = drift(t, ambient_c, device, kind) * (1.0 + AMPLITUDE * rng.standard_normal())
    y += noise * math.sqrt(rate) * rng.standard_normal(n) + OFFSET_DPS * rng.standard_normal()
    chip = ambient_c + 1.0 + 12.0 * (1.0 - np.exp(-t / 30.0)) + 0.2 * rng.standard_normal()
    return y, chip
