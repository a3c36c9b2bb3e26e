"""Simulated gyros switched on again and again; uses nothing of the procedure that they test.

Two exponentials of warm-up, five bends of the slope, and one fast transition whose moment moves
with the temperature; every turn-on has its own amplitude (1 %), offset and white noise. "smooth"
curves are the exponentials alone.
"""

import math

import numpy as np

from core.arrays import FloatArray, frozen
from core.procedures.drift.turn_on import TurnOn

HORIZON_S = 120.0
AMBIENTS = frozen(np.linspace(-40.0, 60.0, 11))
TURN_ONS = 5
UNIT = "deg/s"
SHARP_NOISE = 1e-3
"""Angle random walk of the "sharp" device, deg/sqrt(s)."""
SMOOTH_NOISE = 4e-3
_AMPLITUDE = 0.01
_OFFSET_DPS = 0.05


def drift(t: FloatArray, ambient_c: float, device: int, kind: str = "sharp") -> FloatArray:
    """Noise-free drift (n,), deg/s, at times (n,), s, of one of the devices."""
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
) -> tuple[FloatArray, FloatArray]:
    """One record: outputs (n,), deg/s, and chip temperatures (n,), degC."""
    n = round(HORIZON_S * rate)
    t = (np.arange(n, dtype=np.float64) + 0.5) / rate
    y = drift(t, ambient_c, device, kind) * (1.0 + _AMPLITUDE * rng.standard_normal())
    y += noise * math.sqrt(rate) * rng.standard_normal(n) + _OFFSET_DPS * rng.standard_normal()
    chip = ambient_c + 1.0 + 12.0 * (1.0 - np.exp(-t / 30.0)) + 0.2 * rng.standard_normal()
    return y, chip


def simulated_turn_ons(
    seed: int, *, rate: float, count: int = TURN_ONS, device: int = 0, kind: str = "sharp"
) -> tuple[TurnOn, ...]:
    """A whole set: `count` turn-ons of one device at each of `AMBIENTS`.

    Parameters
    ----------
    seed : of what differs between turn-ons
    rate : samples per second
    device : whose drift
    kind : ``"sharp"`` or ``"smooth"``, which is also four times as noisy
    """
    rng = np.random.default_rng(seed)
    noise = SHARP_NOISE if kind == "sharp" else SMOOTH_NOISE
    made: list[TurnOn] = []
    for ambient in AMBIENTS.tolist():
        for number in range(1, count + 1):
            y, chip = turn_on(rng, ambient, device, kind=kind, noise=noise, rate=rate)
            label = f"simulated, {ambient:g} degC, turn-on {number}"
            made.append(TurnOn(label, ambient, y, rate, chip))
    return tuple(made)
