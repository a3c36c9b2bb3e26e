"""A unit on the dividing head: accelerometers in g, gyros in deg/s."""

from dataclasses import dataclass

import numpy as np

from tests.blind import geometry, outside, timeline
from tests.blind.world import KYIV_DEG, Effects, World

EARTH_DPS = 15.041067 / 3600.0


@dataclass(frozen=True)
class Weather:
    """One realisation of what disturbs the settings and the output."""

    angle: np.ndarray
    """(n,) rad; on the table the relative error of the rate."""
    drift: np.ndarray
    """(n, c)"""


def still(world: World) -> Weather:
    return Weather(np.zeros(world.plan.size), np.zeros((world.plan.size, world.outputs)))


def dial_error(world: World, effects: Effects, dial: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """(n,) rad by which the shaft stands further than the dial says."""
    error = np.zeros(len(dial))
    for name, harmonic in (("head_eccentricity", 1.0), ("head_ellipticity", 2.0)):
        if name in effects:
            error += effects[name].size * np.sin(harmonic * dial - effects[name].shape["phase"])
    if "head_periodic_error" in effects:
        shape = effects["head_periodic_error"].shape
        error += effects["head_periodic_error"].size * np.sin(
            shape["lines"] * dial + shape["phase"]
        )
    if "wrong_angle" in effects:
        error += effects["wrong_angle"].size * (rows == effects["wrong_angle"].shape["row"])
    if "wrong_stop" in effects:
        shape = effects["wrong_stop"].shape
        here = (world.plan.setups == shape["setup"]) & (world.plan.setting == shape["setting"])
        error += effects["wrong_stop"].size * here[rows]
    return error + outside.dial_error(effects, dial)


def attitudes(world: World, effects: Effects, weather: Weather) -> np.ndarray:
    plan = world.plan
    rows = timeline.relabelled(world, effects)
    mounts = [plan.mount[row] for row in rows]
    if "mount_reversed" in effects:
        wrong = effects["mount_reversed"].shape["setup"]
        swap = {"from": "to", "to": "from"}
        for row, setup in enumerate(plan.setups):
            if setup == wrong:
                axis, _, rest = mounts[row].partition("_")
                sense, at, index = rest.partition("@")
                mounts[row] = f"{axis}_{swap[sense]}{at}{index}"
    dial = np.radians(plan.setting[rows])
    dial = dial + dial_error(world, effects, dial, rows) + weather.angle
    roll = np.zeros(plan.size)
    if "mounting_angle" in effects:
        roll = effects["mounting_angle"].size * effects["mounting_angle"].shape["setups"]
        roll = roll[plan.setups]
    tilt = effects["shaft_tilt"].size if "shaft_tilt" in effects else 0.0
    return geometry.attitude(mounts, dial, tilt, roll)


def accelerometer(world: World, effects: Effects, force: np.ndarray) -> np.ndarray:
    """(n, c) answer in g before temperature and time."""
    out = force @ world.linear.T
    for channel, own in enumerate(world.axes):
        s = out[:, channel].copy()
        others, products = [(own + 1) % 3, (own + 2) % 3], pairs(own)
        terms = {
            "second_order_nonlinearity": lambda h, s=s: s**2,
            "third_order_nonlinearity": lambda h, s=s: s**3,
            "odd_quadratic_nonlinearity": lambda h, s=s: s * np.abs(s),
            "cross_axis_nonlinearity": lambda h, o=others: force[:, o[h["other"]]] ** 2,
            "cross_coupling": lambda h, p=products: np.prod(force[:, p[h["pair"]]], axis=1),
            "scale_factor_asymmetry": lambda h, s=s: 0.5 * np.abs(s),
            "bias_asymmetry": lambda h, s=s: 0.5 * np.sign(np.where(abs(s) < 1e-9, 0.0, s)),
            "hysteresis": lambda h, s=s: timeline.senses(world, s),
            **outside.accelerometer_terms(s),
        }
        for name, term in terms.items():
            hidden = effects.get(name)
            if hidden is not None and hidden.shape["channel"] == channel:
                out[:, channel] += hidden.size * term(hidden.shape)
    return out


def pairs(own: int) -> list[list[int]]:
    """Products of cross coupling: own axis with either other, and the two others."""
    first, second = (own + 1) % 3, (own + 2) % 3
    return [[first, own], [second, own], [first, second]]


def gyro(world: World, effects: Effects, room_from_case: np.ndarray) -> np.ndarray:
    """(n, c) answer in deg/s: the Earth's turning, then what gravity does to the sensor."""
    force = geometry.seen_from_case(geometry.UP, room_from_case)
    latitude = np.radians(KYIV_DEG)
    earth = EARTH_DPS * np.sin(latitude) * geometry.UP
    if "earth_rate" in effects:
        azimuth = effects["earth_rate"].shape["azimuth"]
        north = np.cos(azimuth) * geometry.SHAFT + np.sin(azimuth) * geometry.SIDE
        earth = earth + effects["earth_rate"].size * EARTH_DPS * np.cos(latitude) * north
    out = geometry.seen_from_case(earth, room_from_case)[:, list(world.axes)]
    out = out + force @ world.linear.T
    if "g_squared_sensitivity" in effects:
        hidden = effects["g_squared_sensitivity"]
        squares = np.einsum("ni,ij,nj->n", force, hidden.shape["matrix"], force)
        out += timeline.in_channel(world, hidden, squares)
    if "magnetic_sensitivity" in effects:
        hidden = effects["magnetic_sensitivity"]
        field = geometry.seen_from_case(hidden.shape["field"], room_from_case)
        out += timeline.in_channel(world, hidden, field[:, world.axes[hidden.shape["channel"]]])
    if "cable_pull" in effects:
        hidden = effects["cable_pull"]
        dial = np.radians(world.plan.setting)
        out += timeline.in_channel(world, hidden, outside.bump(hidden.shape, dial))
    if "third_power" in effects:
        hidden = effects["third_power"]
        own = force[:, world.axes[hidden.shape["channel"]]]
        out += timeline.in_channel(world, hidden, own**3)
    return out


def answer(world: World, effects: Effects, weather: Weather) -> np.ndarray:
    """(n, c) analogue output in g or deg/s, before limits and sampling."""
    room_from_case = attitudes(world, effects, weather)
    if world.sensor == "accelerometer":
        force = geometry.seen_from_case(geometry.UP, room_from_case)
        out = accelerometer(world, effects, force)
        out = out + outside.memory(world, effects, out)
    else:
        out = gyro(world, effects, room_from_case)
    out = out * timeline.warmed_scale(world, effects) + world.offset
    out = out + timeline.additive(world, effects) + weather.drift
    return timeline.events(world, effects, timeline.settled(world, effects, out))
