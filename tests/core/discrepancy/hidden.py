"""Runs of the head and the table with a hidden effect, by formulas of their own."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from core.samples.run import Conditions, Run

G = 9.81
K = 2.0
WHITE, SETTING, HEAD, DRIFT = 25e-6, 3.0, 5.0, 30e-6
ARCSEC = np.pi / 648000.0
Rows = list[tuple[int, str, float]]


@dataclass
class Truth:
    """What the rows of the head really were: a (n, 3) in g, slope of a_z, time, temperature."""

    a: np.ndarray
    slope: np.ndarray
    head: np.ndarray
    mount: np.ndarray
    run: np.ndarray
    t: np.ndarray
    temperature: np.ndarray


Hidden = Callable[[Truth], np.ndarray]
NOTHING: Hidden = lambda truth: 0.0 * truth.t  # noqa: E731
FORTY_EIGHT: Rows = [
    (run, mount, angle)
    for run in (1, 2)
    for mount in ("X_from", "Y_from")
    for angle in np.arange(0.0, 360.0, 15.0)
]
APART: Rows = [
    (1, mount, angle)
    for mount, way in (
        ("X_from", 1),
        ("X_to", -1),
        ("Y_from", 1),
        ("Z_from", -1),
        ("X_from@90", 1),
    )
    for angle in np.arange(0.0, 360.0, 22.5)[::way]
]
"""The plan whose effects have no aliases."""


def felt(mount: str, head: float) -> np.ndarray:
    """Specific force in g on the case axes: tables 1.1 and 2.1 and their mirror images."""
    key, _, turned = mount.partition("@")
    angle = np.radians(head + float(turned or 0.0))
    s, c = np.sin(angle), np.cos(angle)
    return {
        "X_from": np.array([0.0, -s, c]),
        "X_to": np.array([0.0, s, c]),
        "Y_from": np.array([s, 0.0, c]),
        "Y_to": np.array([-s, 0.0, c]),
        "Z_from": np.array([c, s, 0.0]),
        "Z_to": np.array([c, -s, 0.0]),
    }[key]


def head_run(
    hidden: Hidden = NOTHING, rows: Rows = FORTY_EIGHT, seed: int = 0, noise: float = 1.0
) -> Run:
    """A run of one accelerometer along z with a hidden effect, stated in g."""
    rng = np.random.default_rng(seed)
    n = len(rows)
    run = np.array([row[0] for row in rows])
    mount = [row[1] for row in rows]
    head = np.array([row[2] for row in rows])
    dial = {angle: rng.normal(0.0, HEAD) for angle in sorted(set(head))}
    wrong = noise * np.array([dial[angle] + rng.normal(0.0, SETTING) for angle in head]) / 3600.0
    a = np.array([felt(m, h + e) for m, h, e in zip(mount, head, wrong, strict=True)])
    ahead = np.array([felt(m, h + 90.0) for m, h in zip(mount, head, strict=True)])
    t = 40.0 * np.arange(n)
    temperature = 25.0 + 0.6 * (1.0 - np.exp(-t / 900.0))
    ideal = np.array([felt(m, h) for m, h in zip(mount, head, strict=True)])
    truth = Truth(ideal, ahead[:, 2], head, np.array(mount), run, t, temperature)
    u = a[:, 2] + 0.012 * a[:, 0] - 0.008 * a[:, 1] + 0.003 + hidden(truth)
    u = u + noise * (WHITE * rng.standard_normal(n) + wandering(rng, t))
    return Run(
        test="dividing_head",
        sensor="accelerometer",
        device="A1",
        channels=("y",),
        axes=("z",),
        unit="V",
        y=K * u[:, None],
        y_se=np.full((n, 1), K * WHITE),
        run=run,
        order=np.arange(n),
        mount=tuple(mount),
        head_deg=head,
        set_rate_dps=np.full(n, np.nan),
        temperature_c=np.round(temperature / 0.02) * 0.02,
        t_s=t,
        conditions=Conditions(g_mps2=G, head_u_arcsec=HEAD, accumulation_s=10.0),
    )


def wandering(rng: np.random.Generator, t: np.ndarray) -> np.ndarray:
    """A drift with a memory of 300 s, in g."""
    covariance = DRIFT**2 * np.exp(-np.abs(np.subtract.outer(t, t)) / 300.0)
    return np.linalg.cholesky(covariance + 1e-18 * np.eye(len(t))) @ rng.standard_normal(len(t))


def table_run(
    hidden: Callable[[np.ndarray], np.ndarray] = lambda w: 0.0 * w,
    seed: int = 0,
    *,
    mixed: bool = True,
) -> Run:
    """Four times 21 rates of one gyro, with a hidden effect in deg/s."""
    rng = np.random.default_rng(seed)
    rates = np.linspace(-100.0, 100.0, 21)
    sweeps = [rng.permutation(rates) if mixed else rates[:: (-1) ** i] for i in range(4)]
    w = np.concatenate(sweeps)
    n = len(w)
    speed = {rate: 1.0 + 1e-4 * rng.standard_normal() for rate in rates}
    true = np.array([rate * speed[rate] for rate in w]) * (1.0 + 1.5e-4 * rng.standard_normal(n))
    t = 60.0 * np.arange(n)
    y = true + 0.3 + hidden(w) + 6.5e-3 * rng.standard_normal(n)
    y = y + 8e-3 / DRIFT * wandering(rng, t)
    base = head_run(rows=FORTY_EIGHT[:n], noise=0.0)
    return replace(
        base,
        test="rate_table",
        sensor="gyro",
        unit="deg/s",
        y=y[:, None],
        y_se=np.full((n, 1), 6.5e-3),
        run=np.repeat(np.arange(1, 5), 21),
        order=np.arange(n),
        mount=("",) * n,
        head_deg=np.full(n, np.nan),
        set_rate_dps=w,
        temperature_c=np.full(n, np.nan),
        t_s=t,
        conditions=Conditions(rate_u_ppm=150.0),
    )
