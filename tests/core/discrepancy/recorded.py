"""Records of a vibratory gyro with something hidden, by formulas of their own."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.samples.run import Conditions, Run

WHITE = 3e-4
"""Standard deviation of one sample at 1 Hz, V."""


@dataclass
class Hour:
    """What an hour of the gyro was: seconds, true temperature, true channels."""

    t: np.ndarray
    temperature: np.ndarray
    quadrature: np.ndarray
    delay: np.ndarray
    rng: np.random.Generator


Hidden = Callable[[Hour], np.ndarray]
NOTHING: Hidden = lambda hour: 0.0 * hour.t  # noqa: E731


def wander(n: int, size: float, memory: float, rng: np.random.Generator) -> np.ndarray:
    """A Markov chain sample by sample."""
    keep = np.exp(-1.0 / memory)
    steps = size * np.sqrt(1.0 - keep**2) * rng.standard_normal(n)
    found = np.empty(n)
    found[0] = size * rng.standard_normal()
    for i in range(1, n):
        found[i] = keep * found[i - 1] + steps[i]
    return found


def hour_run(
    hidden: Hidden = NOTHING, seed: int = 0, n: int = 3600, drift: float = 1e-5, rate: float = 1.0
) -> Run:
    """An hour at `rate` samples a second, its temperature up and down by some degrees."""
    rng = np.random.default_rng(seed)
    t = np.arange(n) / rate
    span = t[-1]
    warm = 24.0 + 4.0 * np.sin(2.3 * t / span) ** 2 + 0.4 * np.sin(9.0 * t / span + seed)
    hour = Hour(
        t=t,
        temperature=warm,
        quadrature=0.07 + 0.002 * np.sin(5.1 * t / span + 1.0 + seed),
        delay=14.3 + 0.02 * np.cos(7.7 * t / span + 0.5 * seed),
        rng=rng,
    )
    white = WHITE * np.sqrt(rate) * rng.standard_normal(n)
    y = -0.02 + hidden(hour) + white + wander(n, drift, 400.0 * rate, rng)
    noisy = lambda x, size: x + size * rng.standard_normal(n)  # noqa: E731
    unknown = np.full(n, np.nan)
    return Run(
        test="record",
        sensor="gyro",
        device="CVG 1",
        channels=("y",),
        axes=("z",),
        unit="V",
        y=np.round(y / 2e-6)[:, None] * 2e-6,
        y_se=unknown[:, None],
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n, dtype=np.int64),
        mount=("",) * n,
        head_deg=unknown,
        set_rate_dps=unknown,
        temperature_c=np.round(noisy(warm, 0.005), 3),
        t_s=t,
        conditions=Conditions(sample_rate_hz=rate),
        extra={
            "QuadratureAmpl": noisy(hour.quadrature, 1e-4),
            "ExcitationDelay": noisy(hour.delay, 4e-4),
        },
    )
