"""Measure a hidden unit: the readings of a whole run, with or without noise."""

from dataclasses import dataclass

import numpy as np

from tests.blind import adc, head, noise, timeline
from tests.blind.world import Effects, World


@dataclass(frozen=True)
class Readings:
    """Means (n, c) and their standard errors in output units; temperature (n,) as recorded."""

    y: np.ndarray
    se: np.ndarray
    temperature: np.ndarray


def limits(world: World, effects: Effects) -> tuple[np.ndarray, np.ndarray]:
    """Clipping levels (c,) in g or deg/s; infinite where nothing clips."""
    low, high = np.full(world.outputs, -np.inf), np.full(world.outputs, np.inf)
    if "saturation" in effects:
        clip = effects["saturation"]
        channel = clip.shape["channel"]
        healthy = noise.answer(world, {}, head.still(world))[:, channel]
        # Size zero is where the noise of single samples just fails to touch the limit.
        reach = 4.0 * world.levels.white * np.sqrt(samples_of(world, {}).max())
        if clip.shape["side"] > 0:
            high[channel] = healthy.max() + reach - clip.size
        else:
            low[channel] = healthy.min() - reach + clip.size
    return low, high


def samples_of(world: World, effects: Effects) -> np.ndarray:
    """(n,) samples in each accumulation."""
    count = np.full(world.plan.size, round(world.plan.accumulation * world.plan.sample_rate))
    if "short_accumulation" in effects:
        count[effects["short_accumulation"].shape["row"]] //= 20
    return count


def truth(world: World, effects: Effects) -> np.ndarray:
    """(n, c) noise-free means in g or deg/s."""
    values = noise.answer(world, effects, head.still(world))
    sigma = world.levels.white * np.sqrt(samples_of(world, effects).max())
    values = adc.expected(values, sigma, *limits(world, effects))
    return timeline.recorded_rows(effects, values)


def measure(
    world: World, effects: Effects, weather: head.Weather, rng: np.random.Generator
) -> Readings:
    values = noise.answer(world, effects, weather)
    count = samples_of(world, effects)
    y, se = adc.accumulated(world, values, limits(world, effects), count, rng)
    temperature = world.recorded
    if "stale_temperature" in effects:
        temperature = np.full(world.plan.size, temperature[0])
    return Readings(
        timeline.recorded_rows(effects, y) * world.scale,
        timeline.recorded_rows(effects, se) * np.abs(world.scale),
        temperature,
    )
