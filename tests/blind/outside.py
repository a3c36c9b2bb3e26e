"""Causes that stand in no catalogue: the right answer to them is "none of the names fits".

Their names stand in `OUTSIDE` by test; sealed until a benchmark is scored.
"""

from collections.abc import Callable

import numpy as np

from tests.blind.world import Effects, World

Term = Callable[[dict], np.ndarray]
OUTSIDE = {
    "dividing_head": ("notch", "ripple", "worn_sector", "creep", "alternating", "telegraph"),
    "rate_table": ("mesh_bump", "mesh_ripple", "mesh_step", "alternating", "telegraph"),
    "static_positions": ("cable_pull", "alternating", "telegraph", "third_power"),
    "record": ("temperature_kink", "chirp", "sawtooth", "visit"),
}


def bump(shape: dict, angle: np.ndarray) -> np.ndarray:
    """A hump over part of the circle."""
    distance = np.angle(np.exp(1j * (angle - shape["at"])))
    return np.exp(-0.5 * (distance / shape["width"]) ** 2)


def accelerometer_terms(s: np.ndarray) -> dict[str, Term]:
    return {
        "notch": lambda h: np.exp(-0.5 * ((s - h["at"]) / h["width"]) ** 2),
        "ripple": lambda h: np.sin(h["lines"] * s + h["phase"]),
    }


def dial_error(effects: Effects, dial: np.ndarray) -> np.ndarray:
    """A stretch of the dial that reads wrong (rad)."""
    worn = effects.get("worn_sector")
    return np.zeros(len(dial)) if worn is None else worn.size * bump(worn.shape, dial)


def memory(world: World, effects: Effects, values: np.ndarray) -> np.ndarray:
    """A part of the answer that follows with minutes of delay."""
    creep = effects.get("creep")
    out = np.zeros_like(values)
    if creep is None:
        return out
    channel, now = creep.shape["channel"], 0.0
    for row in range(1, world.plan.size):
        part = np.exp(-(world.plan.time[row] - world.plan.time[row - 1]) / creep.shape["tau"])
        now = part * now + (1.0 - part) * values[row - 1, channel]
        out[row, channel] = creep.size * now
    return out


def rate_terms(rate: np.ndarray) -> dict[str, Term]:
    def step(h: dict) -> np.ndarray:
        return np.tanh((rate - h["at"]) / h["width"])

    return {
        "mesh_bump": lambda h: np.exp(-0.5 * ((rate - h["at"]) / h["width"]) ** 2),
        "mesh_ripple": lambda h: np.sin(h["lines"] * rate / 100.0 + h["phase"]),
        "mesh_step": step,
    }


def record_terms(t: np.ndarray, warmth: np.ndarray) -> dict[str, Term]:
    hours = t / 3600.0
    return {
        "temperature_kink": lambda h: np.maximum(warmth - np.quantile(warmth, h["share"]), 0.0),
        "chirp": lambda h: np.sin(2 * np.pi * (h["cycles"] * hours + h["sweep"] * hours**2)),
        "sawtooth": lambda h: (h["cycles"] * hours + h["start"]) % 1.0,
        "visit": lambda h: np.exp(-0.5 * ((hours - h["at"]) / h["width"]) ** 2),
    }


def shape_of(name: str, rng: np.random.Generator, rows: int) -> dict:
    """Draw where and how wide."""
    turn = rng.uniform(0.0, 2.0 * np.pi)
    table: dict[str, Callable[[], dict]] = {
        "notch": lambda: {"at": rng.uniform(-0.7, 0.7), "width": rng.uniform(0.1, 0.2)},
        "ripple": lambda: {"lines": rng.uniform(7.0, 12.0), "phase": turn},
        "worn_sector": lambda: {"at": turn, "width": rng.uniform(0.2, 0.45)},
        "cable_pull": lambda: {"at": turn, "width": rng.uniform(0.5, 0.9)},
        "creep": lambda: {"tau": rng.uniform(150.0, 600.0)},
        "alternating": dict,
        "telegraph": lambda: {"states": switched(rng, rows)},
        "third_power": dict,
        "mesh_bump": lambda: {"at": rng.uniform(-70, 70), "width": rng.uniform(10, 20)},
        "mesh_ripple": lambda: {"lines": rng.uniform(6.0, 10.0), "phase": turn},
        "mesh_step": lambda: {"at": rng.choice([-1, 1]) * rng.uniform(25, 70), "width": 6.0},
        "temperature_kink": lambda: {"share": rng.uniform(0.3, 0.6)},
        "chirp": lambda: {"cycles": rng.uniform(2, 4), "sweep": rng.uniform(4, 9)},
        "sawtooth": lambda: {"cycles": rng.uniform(3, 7), "start": rng.uniform()},
        "visit": lambda: {"at": rng.uniform(0.2, 0.8), "width": rng.uniform(0.03, 0.08)},
    }
    return table[name]()


def switched(rng: np.random.Generator, rows: int, stay: float = 0.0) -> np.ndarray:
    """Two states, changed at random; at least four changes."""
    stay = stay or rows / 8.0
    while True:
        changes = rng.uniform(size=rows) < 1.0 / max(stay, 2.0)
        if changes.sum() >= min(4, rows // 2):
            return (np.cumsum(changes) % 2).astype(float)
