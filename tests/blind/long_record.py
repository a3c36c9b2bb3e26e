"""An hour of a vibratory gyro at rest: output and its six auxiliary channels, V and us."""

from dataclasses import dataclass

import numpy as np

from tests.blind import outside
from tests.blind.plans import Plan
from tests.blind.world import Effects, Hidden, Levels, true_levels, wander

BLOCK_S = 10.0
NOISES = ("quantization", "angle_random_walk", "bias_instability", "rate_random_walk", "markov")
AUX = ("AntiNodePeriod", "ExcitationDelay", "AntiNodeAmplitude", "ExcitationAmpl", "QuadratureAmpl")


@dataclass(frozen=True)
class Record:
    plan: Plan
    levels: Levels
    warmth: np.ndarray
    aux: dict[str, np.ndarray]
    """True auxiliary channels."""


def lagged(values: np.ndarray, tau: float, step: float) -> np.ndarray:
    from scipy.signal import lfilter

    keep = np.exp(-step / tau)
    return values[0] + lfilter([1.0 - keep], [1.0, -keep], values - values[0])


def backlash(values: np.ndarray, width: float) -> np.ndarray:
    out = np.empty_like(values)
    now = values[0]
    for i, v in enumerate(values):
        now = min(max(now, v - width), v + width)
        out[i] = now
    return out


def record_of(plan: Plan, rng: np.random.Generator, coloured: bool = False) -> Record:
    t, step = plan.time, plan.accumulation
    hours = t / 3600.0
    warmth = 24.0 + rng.uniform(3.0, 7.0) * (1.0 - np.exp(-t / rng.uniform(300.0, 1200.0)))
    warmth += rng.uniform(0.5, 2.0) * np.sin(
        2 * np.pi * hours * rng.uniform(0.8, 1.6) + rng.uniform(0, 6)
    )
    warmth += wander(t, 0.1, 600.0, rng)
    core = lagged(warmth, rng.uniform(60.0, 240.0), step)
    aux = {
        "AntiNodePeriod": 23.7336 + 6e-4 * (core - 24.0) + wander(t, 5e-5, 300.0, rng),
        "ExcitationDelay": 14.33 + 2e-3 * (warmth - 24.0) + wander(t, 3e-3, 500.0, rng),
        "AntiNodeAmplitude": 1.9 + wander(t, 2e-4, 400.0, rng),
        "ExcitationAmpl": 1.086 + 1e-3 * (core - 24.0) + wander(t, 1e-3, 700.0, rng),
        "QuadratureAmpl": 0.0714 + wander(t, 1e-3, 800.0, rng) + 2e-4 * (core - 24.0),
    }
    return Record(plan, true_levels("cvg_record", rng, coloured), warmth, aux)


def shape_of(name: str, rng: np.random.Generator, record: Record) -> dict:
    rows = record.plan.size
    rate = record.plan.sample_rate
    table = {
        "thermal_lag": lambda: {"tau": rng.uniform(200.0, 900.0)},
        "thermal_hysteresis": lambda: {"width": rng.uniform(0.3, 0.8)},
        "warm_up": lambda: {"tau": rng.uniform(120.0, 900.0)},
        "bias_jump": lambda: {"at": rng.uniform(0.15, 0.85)},
        "telegraph": lambda: {"states": outside.switched(rng, rows, rows / rng.uniform(6, 12))},
        "pickup": lambda: {"f": rng.uniform(0.03, 0.4) * rate, "phase": rng.uniform(0, 6.28)},
    }
    if name in outside.OUTSIDE["record"]:
        return outside.shape_of(name, rng, rows)
    return table.get(name, dict)()


def form(name: str, shape: dict, record: Record) -> np.ndarray:
    """(n,) what size one adds to the output."""
    t, warmth, aux = record.plan.time, record.warmth, record.aux
    step = record.plan.accumulation
    away = {key: values - values.mean() for key, values in aux.items()}
    table = {
        "bias_temperature": lambda: warmth - warmth[0],
        "temperature_rate": lambda: lagged(np.gradient(warmth, step) * 60.0, 20.0, step),
        "thermal_lag": lambda: lagged(warmth, shape["tau"], step) - warmth[0],
        "thermal_hysteresis": lambda: backlash(warmth, shape["width"]) - warmth,
        "warm_up": lambda: np.exp(-t / shape["tau"]),
        "bias_drift": lambda: t / 3600.0,
        "bias_jump": lambda: (t >= shape["at"] * t[-1]).astype(float),
        "telegraph": lambda: shape["states"],
        "quadrature_leakage": lambda: away["QuadratureAmpl"],
        "phase_error": lambda: away["ExcitationDelay"] * aux["QuadratureAmpl"],
        "damping_anisotropy": lambda: away["ExcitationAmpl"],
        "resonator_frequency": lambda: away["AntiNodePeriod"],
        "amplitude_error": lambda: away["AntiNodeAmplitude"],
        "pickup": lambda: np.sin(2 * np.pi * shape["f"] * t + shape["phase"]),
    }
    if name in table:
        return table[name]()
    return outside.record_terms(t, warmth)[name](shape)


SLOW = (
    "bias_temperature",
    "temperature_rate",
    "thermal_lag",
    "thermal_hysteresis",
    "warm_up",
    "bias_drift",
    "bias_jump",
    "telegraph",
    "quadrature_leakage",
    "phase_error",
    "damping_anisotropy",
    "resonator_frequency",
    "amplitude_error",
)
FAULTS = ("dropouts", "missing_codes", "stuck_reading", "outlier", "stale_temperature")
NATURAL = (*FAULTS, "variance_burst", *(n for n in NOISES if n != "angle_random_walk"))
FAMILIES: dict[str, list[dict]] = {
    "thermal_lag": [{"tau": tau} for tau in np.geomspace(60.0, 1500.0, 10)],
    "thermal_hysteresis": [{"width": w} for w in (0.2, 0.4, 0.6, 0.8, 1.0)],
    "warm_up": [{"tau": tau} for tau in np.geomspace(60.0, 1500.0, 12)],
    "bias_jump": [{"at": at} for at in np.linspace(0.02, 0.98, 97)],
}


def blocks(values: np.ndarray, record: Record) -> np.ndarray:
    """Means over ten seconds."""
    each = round(BLOCK_S * record.plan.sample_rate)
    return values[: len(values) // each * each].reshape(-1, each).mean(axis=1)


def whitener(record: Record) -> np.ndarray:
    """Lower factor of the covariance of the block means."""
    levels = record.levels
    t = np.arange(round(3600.0 / BLOCK_S)) * BLOCK_S
    apart = np.abs(t[:, None] - t[None, :])
    total = levels.drift**2 * np.exp(-apart / levels.drift_tau)
    total += levels.quick**2 * np.exp(-4.0 * apart / levels.drift_tau)
    total += levels.walk**2 * np.minimum(t[:, None], t[None, :]) / 3600.0
    return np.linalg.cholesky(total + np.eye(len(t)) * levels.white**2 / BLOCK_S)


def visible(record: Record, factor: np.ndarray, values: np.ndarray) -> np.ndarray:
    from scipy.linalg import solve_triangular

    white = solve_triangular(factor, blocks(values, record), lower=True)
    one = solve_triangular(factor, np.ones(len(white)), lower=True)
    return white - one * (one @ white) / (one @ one)


def sized(record: Record, name: str, shape: dict, wanted: float) -> float:
    """Size that gives lambda `wanted`; everything here is linear."""
    values = form(name, shape, record)
    if name == "pickup":
        sigma = record.levels.white * np.sqrt(record.plan.sample_rate)
        return wanted * sigma / float(np.linalg.norm(values))
    return wanted / float(np.linalg.norm(visible(record, whitener(record), values)))


def mimics(record: Record, target: np.ndarray, own: str, leave: float) -> list[str]:
    """Other slow names that leave less than `leave` sigmas of a visible change."""
    factor = whitener(record)
    found = []
    for name in SLOW:
        if name in (own, "telegraph"):
            continue
        for shape in FAMILIES.get(name, [{}]):
            column = visible(record, factor, form(name, shape, record))
            rest = target - column * (column @ target) / (column @ column)
            if np.linalg.norm(rest) <= leave:
                found.append(name)
                break
    return found


def noise(record: Record, effects: Effects, rng: np.random.Generator) -> np.ndarray:
    """(n,) white, drift, and the noise terms that were hidden."""
    plan, levels, rows = record.plan, record.levels, record.plan.size
    sigma = levels.white * np.sqrt(plan.sample_rate)
    out = sigma * rng.standard_normal(rows)
    burst = effects.get("variance_burst")
    if burst is not None:
        there = slice(int(0.4 * rows), int(0.4 * rows + rows * burst.shape["part"]))
        out[there] *= burst.size
    out += wander(plan.time, levels.drift, levels.drift_tau, rng)
    if levels.quick:
        out += wander(plan.time, levels.quick, levels.drift_tau / 4.0, rng)
        step = levels.walk * np.sqrt(plan.accumulation / 3600.0)
        out += step * np.cumsum(rng.standard_normal(rows))
    if "bias_instability" in effects:
        b = effects["bias_instability"].size * levels.white
        # Flicker: one Ornstein-Uhlenbeck process an octave pair, of equal variance.
        for tau in 4.0 ** np.arange(0.0, 7.0):
            out += wander(plan.time, b * np.sqrt(np.log(4.0) / np.pi), tau, rng)
    if "rate_random_walk" in effects:
        k = effects["rate_random_walk"].size * levels.white
        out += k * np.sqrt(plan.accumulation) * np.cumsum(rng.standard_normal(rows))
    if "markov" in effects:
        hidden = effects["markov"]
        out += wander(plan.time, hidden.size * levels.white, hidden.shape["tau"], rng)
    if "quantization" in effects:
        edges = rng.uniform(-0.5, 0.5, rows + 1) * np.sqrt(12.0)
        out += effects["quantization"].size * levels.white * np.diff(edges) / plan.accumulation
    return out


def faulty_rows(record: Record, effects: Effects, table: np.ndarray, rng) -> np.ndarray:
    """Faults of the recording; columns t_s, temperature_c, y, then the auxiliary ones."""
    rows = len(table)
    lsb = 2e-5
    table[:, 2] = np.rint(table[:, 2] / lsb) * lsb
    if "missing_codes" in effects:
        codes = np.rint(table[:, 2] / lsb)
        table[:, 2] = (codes + (codes % 4 == 1)) * lsb
    if "stuck_reading" in effects:
        start = int(rng.integers(rows // 4, rows // 2))
        table[start : start + max(8, rows // 360), 2] = table[start, 2]
    if "outlier" in effects:
        sigma = record.levels.white * np.sqrt(record.plan.sample_rate)
        table[int(rng.integers(rows)), 2] += 12.0 * sigma
    if "stale_temperature" in effects:
        table[:, 1] = table[0, 1]
    if "dropouts" in effects:
        keep = np.ones(rows, bool)
        for start in rng.integers(10, rows - 30, 12):
            keep[start : start + int(rng.integers(2, 20))] = False
        table = table[keep]
    return table


def measure(record: Record, effects: Effects, rng: np.random.Generator) -> np.ndarray:
    """(n, 8) columns of the file."""
    rows = record.plan.size
    y = -0.0206 + noise(record, effects, rng)
    for name, hidden in effects.items():
        if name not in NATURAL:
            y = y + hidden.size * form(name, hidden.shape, record)
    seen = lagged(record.warmth, 15.0, record.plan.accumulation)
    temperature = np.round((seen + 0.003 * rng.standard_normal(rows)) / 0.001) * 0.001
    scatter = (2e-6, 2e-4, 2e-5, 5e-5, 5e-5)
    aux = [
        record.aux[name] + s * rng.standard_normal(rows)
        for name, s in zip(AUX, scatter, strict=True)
    ]
    table = np.stack([record.plan.time, temperature, y, *aux], axis=1)
    return faulty_rows(record, effects, table, rng)


def natural(name: str, rng: np.random.Generator) -> Hidden:
    """Sizes that are plain for an hour, as parts of the white noise at one second."""
    sizes = {
        "variance_burst": Hidden(3.0, {"part": rng.uniform(0.08, 0.2)}),
        "bias_instability": Hidden(rng.uniform(0.6, 1.0)),
        "rate_random_walk": Hidden(rng.uniform(0.06, 0.12)),
        "markov": Hidden(rng.uniform(1.0, 2.0), {"tau": rng.uniform(20.0, 90.0)}),
        "quantization": Hidden(rng.uniform(1.5, 3.0)),
    }
    return sizes.get(name, Hidden(1.0))
