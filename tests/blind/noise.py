"""The true covariance of a run, and one draw from it."""

import numpy as np

from tests.blind import head, table, timeline
from tests.blind.head import Weather
from tests.blind.world import Effects, World, wander

NUDGE = 1e-5


def answer(world: World, effects: Effects, weather: Weather) -> np.ndarray:
    physics = table if world.plan.test == "rate_table" else head
    return physics.answer(world, effects, weather)


def marks(world: World, effects: Effects) -> np.ndarray:
    """(n,) number of the mark on the dial (or the rate) that each row was really set to."""
    setting = world.plan.setting[timeline.relabelled(world, effects)]
    if world.plan.test != "rate_table":
        setting = setting % 360.0
    return np.unique(np.round(setting, 6), return_inverse=True)[1]


def draw(world: World, effects: Effects, rng: np.random.Generator) -> Weather:
    levels, rows = world.levels, world.plan.size
    mark = marks(world, effects)
    shared = rng.normal(size=rows)[mark] * levels.certificate
    angle = shared + rng.normal(size=rows) * levels.setting
    t = world.plan.time
    drift = np.empty((rows, world.outputs))
    for channel in range(world.outputs):
        drift[:, channel] = wander(t, levels.drift, levels.drift_tau, rng)
        drift[:, channel] += wander(t, levels.quick, levels.drift_tau / 4.0, rng)
        hours = np.diff(t, prepend=t[0]) / 3600.0
        drift[:, channel] += levels.walk * np.cumsum(rng.normal(size=rows) * np.sqrt(hours))
    return Weather(angle, drift)


def prolonged(world: World, effects: Effects, before: Weather, rng: np.random.Generator) -> Weather:
    """The weather of a longer run that begins as `before`; marks keep their errors."""
    new, old = draw(world, effects, rng), len(before.angle)
    mark = marks(world, effects)
    for row in range(old, world.plan.size):
        same = np.flatnonzero(mark[:old] == mark[row])
        if len(same):
            # Means over the repeats are the mark's own error to within the setting's scatter.
            jitter = world.levels.setting * rng.normal()
            new.angle[row] = before.angle[same].mean() + jitter
    apart = world.plan.time[old:] - world.plan.time[old - 1]
    fade = np.exp(-apart / world.levels.drift_tau)[:, None]
    new.drift[old:] += (before.drift[-1] - new.drift[old - 1]) * fade
    new.angle[:old], new.drift[:old] = before.angle, before.drift
    return new


def slopes(world: World) -> np.ndarray:
    """(n, c) change of the output with the setting (per rad, or per relative rate)."""
    zero = head.still(world)
    sides = [
        answer(world, {}, Weather(zero.angle + sign * NUDGE, zero.drift)) for sign in (1.0, -1.0)
    ]
    return (sides[0] - sides[1]) / (2.0 * NUDGE)


def in_time(world: World) -> np.ndarray:
    """(n, n) covariance of the drift of one output."""
    levels, t = world.levels, world.plan.time
    apart = np.abs(t[:, None] - t[None, :])
    slow = levels.drift**2 * np.exp(-apart / levels.drift_tau)
    quick = levels.quick**2 * np.exp(-4.0 * apart / levels.drift_tau)
    walk = levels.walk**2 * (np.minimum(t[:, None], t[None, :]) - t[0]) / 3600.0
    return slow + quick + walk


def covariance(world: World) -> np.ndarray:
    """True covariance (n c, n c) of the readings, output after output."""
    levels, rows, count = world.levels, world.plan.size, world.outputs
    slope = slopes(world).T.reshape(-1)
    mark = marks(world, {})
    one = np.eye(rows) * levels.setting**2
    one += levels.certificate**2 * (mark[:, None] == mark[None, :])
    total = np.tile(one, (count, count)) * slope[:, None] * slope[None, :]
    own = in_time(world) + np.eye(rows) * levels.white**2
    return total + np.kron(np.eye(count), own)
