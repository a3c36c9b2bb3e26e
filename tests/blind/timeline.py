"""What time, temperature and history do to any output: shared by the head and the table.

`private` effects live in one output, `Hidden.shape["channel"]`.
"""

import numpy as np

from tests.blind.world import Effects, Hidden, World


def in_channel(world: World, hidden: Hidden, values: np.ndarray) -> np.ndarray:
    """(n, c) with `values` (n,) in the effect's own output and zero in the others."""
    out = np.zeros((world.plan.size, world.outputs))
    out[:, hidden.shape["channel"]] = hidden.size * values
    return out


def senses(world: World, values: np.ndarray) -> np.ndarray:
    """(n,) sign of the last movement; a value met twice in a row keeps the older sense."""
    out = np.empty(len(values))
    now = world.first_sense
    for row, step in enumerate(np.diff(values, prepend=values[0])):
        now = np.sign(step) if abs(step) > 1e-4 else now
        out[row] = now
    return out


def additive(world: World, effects: Effects) -> np.ndarray:
    """Sum (n, c) of what is added to the output whatever the stimulus is."""
    plan, t = world.plan, world.plan.time
    total = np.zeros((plan.size, world.outputs))
    shapes = {
        "bias_drift": lambda s: (t - t[0]) / 3600.0,
        "bias_temperature": lambda s: world.warmth - world.warmth[0],
        "warm_up": lambda s: np.exp(-(t - t[0]) / s["tau"]),
        "bias_jump": lambda s: (np.arange(plan.size) >= s["row"]).astype(float),
        "run_bias": lambda s: s["runs"][plan.run - 1],
        "remount_bias": lambda s: s["setups"][plan.setups],
        "pickup": lambda s: hum(world, s["frequency"], s["phase"]),
        "telegraph": lambda s: s["states"][: plan.size],
        "alternating": lambda s: (-1.0) ** np.arange(plan.size),
    }
    for name, shape in shapes.items():
        if name in effects:
            total += in_channel(world, effects[name], shape(effects[name].shape))
    return total


def hum(world: World, frequency: float, phase: float) -> np.ndarray:
    """A sine averaged over each accumulation."""
    turn = 2.0 * np.pi * frequency
    begin = turn * world.plan.time + phase
    end = begin + turn * world.plan.accumulation
    return (np.cos(begin) - np.cos(end)) / (end - begin)


def warmed_scale(world: World, effects: Effects) -> np.ndarray:
    """(n, c) factor on the answer to the stimulus."""
    factor = np.ones((world.plan.size, world.outputs))
    if "scale_factor_temperature" in effects:
        hidden = effects["scale_factor_temperature"]
        factor += in_channel(world, hidden, world.warmth - world.warmth[0])
    if "run_scale_factor" in effects:
        hidden = effects["run_scale_factor"]
        factor += in_channel(world, hidden, hidden.shape["runs"][world.plan.run - 1])
    if "amplitude_scale_factor" in effects:
        hidden = effects["amplitude_scale_factor"]
        factor += in_channel(world, hidden, 1.9 / world.amplitude - 1.0)
    return factor


def settled(world: World, effects: Effects, values: np.ndarray) -> np.ndarray:
    """What has not died away of the previous reading when the next one is taken."""
    out = values.copy()
    lag = effects.get("settling_lag")
    if lag is not None:
        channel = lag.shape["channel"]
        for row in range(1, len(out)):
            step = out[row - 1, channel] - values[row, channel]
            out[row, channel] = values[row, channel] + lag.size * step
    short = effects.get("short_accumulation")
    if short is not None:
        row = short.shape["row"]
        out[row] += short.size * (values[row - 1] - values[row])
    return out


def events(world: World, effects: Effects, values: np.ndarray) -> np.ndarray:
    """Single bad readings."""
    if "outlier" in effects:
        hidden = effects["outlier"]
        values = values + in_channel(
            world, hidden, (np.arange(world.plan.size) == hidden.shape["row"]).astype(float)
        )
    return values


def relabelled(world: World, effects: Effects) -> np.ndarray:
    """(n,) which row's setting was really set when row i was measured."""
    order = np.arange(world.plan.size)
    if "positions_swapped" in effects:
        i, j = effects["positions_swapped"].shape["rows"]
        order[[i, j]] = order[[j, i]]
    return order


def recorded_rows(effects: Effects, values: np.ndarray) -> np.ndarray:
    """A reading saved twice, outputs written into each other's columns."""
    if "stuck_reading" in effects:
        row = effects["stuck_reading"].shape["row"]
        values = values.copy()
        values[row] = values[row - 1]
    if "channels_permuted" in effects:
        shape = effects["channels_permuted"].shape
        values = values.copy()
        rows = shape["rows"]
        values[rows] = values[rows][:, shape["columns"]]
    return values
