"""A gyro on the rate table, deg/s."""

import numpy as np

from tests.blind import outside, timeline
from tests.blind.head import Weather
from tests.blind.world import Effects, World

FULL = 100.0


def true_rate(world: World, effects: Effects, weather: Weather) -> np.ndarray:
    """(n,) rate of the table, sense of rotation as it really was."""
    rows = timeline.relabelled(world, effects)
    rate = world.plan.setting[rows].copy()
    if "rate_sign_reversed" in effects:
        reversed_runs = effects["rate_sign_reversed"].shape["runs"]
        rate = np.where(np.isin(world.plan.run, reversed_runs), -rate, rate)
    if "wrong_rate" in effects:
        wrong = effects["wrong_rate"]
        rate += wrong.size * (world.plan.setting[rows] == wrong.shape["setting"])
    if "table_slip" in effects:
        slip = effects["table_slip"]
        rate -= slip.size * np.sign(rate) * np.maximum(np.abs(rate) - slip.shape["from"], 0.0)
    return rate * (1.0 + weather.angle)


def wobble(world: World, rate: np.ndarray, shape: dict) -> np.ndarray:
    """Mean of sin(angle) over an accumulation that begins at a mark on the table."""
    turn = np.radians(rate) * world.plan.accumulation
    start = shape["phase"]
    small = np.abs(turn) < 1e-9
    turn = np.where(small, 1.0, turn)
    return np.where(small, np.sin(start), (np.cos(start) - np.cos(start + turn)) / turn)


def answer(world: World, effects: Effects, weather: Weather) -> np.ndarray:
    """(n, 1) analogue output in deg/s, before limits and sampling."""
    rate = true_rate(world, effects, weather)
    x = rate / FULL
    out = rate.copy()
    terms = {
        "second_order_nonlinearity": lambda h: x**2,
        "third_order_nonlinearity": lambda h: x**3,
        "scale_factor_asymmetry": lambda h: np.abs(x),
        "hysteresis": lambda h: timeline.senses(world, rate),
        "wobble": lambda h: wobble(world, rate, h),
        **outside.rate_terms(rate),
    }
    for name, term in terms.items():
        if name in effects:
            out = out + effects[name].size * term(effects[name].shape)
    if "dead_band" in effects:
        half = effects["dead_band"].size
        out = out - np.clip(rate, -half, half)
    out = out[:, None] * timeline.warmed_scale(world, effects) + world.offset
    out = out + timeline.additive(world, effects) + weather.drift
    return timeline.events(world, effects, timeline.settled(world, effects, out))
