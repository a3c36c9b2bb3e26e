"""Which effects are hidden in runs with settings: how their shapes are drawn, how large they get.

Sizes are in g (accelerometers) or deg/s (gyros), rad, or without unit. The same list tells which
other single cause could draw the same picture, see `severity`.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tests.blind.plans import Plan
from tests.blind.world import World

Shape = dict
Draw = Callable[[np.random.Generator, World], Shape]
Family = Callable[[World], list[list[Shape]]]
TURN = 2.0 * np.pi
QUADRATURES = [{"phase": 0.0}, {"phase": np.pi / 2.0}]


@dataclass(frozen=True)
class Kind:
    """One kind of effect.

    draw : a random shape
    family : blocks of shapes; the members of a block may be mixed freely
    limit : largest size that is still this effect and no wreck
    unit : "g" (scaled to the sensor's output), "rad" or ""
    private : it lives in one output
    needs : what the run must have
    natural : it has one size only
    """

    draw: Draw = lambda rng, world: {}
    family: Family = lambda world: [[{}]]
    limit: float = 0.1
    unit: str = "g"
    private: bool = True
    needs: tuple[str, ...] = ()
    natural: bool = False


def row_of(rng: np.random.Generator, world: World) -> Shape:
    return {"row": int(rng.integers(1, world.plan.size))}


def middle_row(rng: np.random.Generator, world: World) -> Shape:
    n = world.plan.size
    return {"row": int(rng.integers(max(1, n // 8), n - max(1, n // 8)))}


def every_row(world: World) -> list[list[Shape]]:
    return [[{"row": row}] for row in range(1, world.plan.size)]


def phase(rng: np.random.Generator, world: World) -> Shape:
    return {"phase": rng.uniform(0.0, TURN)}


def phases(world: World) -> list[list[Shape]]:
    return [QUADRATURES]


def unit_vectors(key: str, count: Callable[[Plan], int], first: int = 0) -> tuple[Draw, Family]:
    """A number for each run or setup, drawn at random; the first may serve as reference."""

    def draw(rng: np.random.Generator, world: World) -> Shape:
        values = rng.normal(size=count(world.plan))
        values[:first] = 0.0
        return {key: values / max(np.linalg.norm(values), 1e-9)}

    def family(world: World) -> list[list[Shape]]:
        return [[{key: column} for column in np.eye(count(world.plan))[first:]]]

    return draw, family


def runs(plan: Plan) -> int:
    return int(plan.run.max())


def setups(plan: Plan) -> int:
    return int(plan.setups.max()) + 1


RUNS = unit_vectors("runs", runs, first=1)
SETUPS = unit_vectors("setups", setups, first=1)
EACH_SETUP = unit_vectors("setups", setups)


def tau(rng: np.random.Generator, world: World) -> Shape:
    return {"tau": float(np.exp(rng.uniform(np.log(120.0), np.log(1200.0))))}


def taus(world: World) -> list[list[Shape]]:
    return [[{"tau": t}] for t in np.geomspace(100.0, 1500.0, 10)]


def line(rng: np.random.Generator, world: World) -> Shape:
    pace = np.median(np.diff(world.plan.time))
    return {"frequency": rng.uniform(0.08, 0.45) / pace, "phase": rng.uniform(0.0, TURN)}


def lines(world: World) -> list[list[Shape]]:
    pace = np.median(np.diff(world.plan.time))
    count = min(world.plan.size, 120)
    return [
        [{"frequency": f, **q} for q in QUADRATURES] for f in np.linspace(0.03, 0.49, count) / pace
    ]


def swapped(rng: np.random.Generator, world: World) -> Shape:
    while True:
        i, j = sorted(rng.choice(world.plan.size, 2, replace=False))
        if world.plan.setting[i] % 360 != world.plan.setting[j] % 360 and (
            world.plan.run[i] == world.plan.run[j]
        ):
            return {"rows": (int(i), int(j))}


def stop(rng: np.random.Generator, world: World) -> Shape:
    row = int(rng.integers(world.plan.size))
    return {"setup": int(world.plan.setups[row]), "setting": float(world.plan.setting[row])}


def stops(world: World) -> list[list[Shape]]:
    seen = dict.fromkeys(zip(world.plan.setups.tolist(), world.plan.setting.tolist(), strict=True))
    return [[{"setup": setup, "setting": setting}] for setup, setting in seen]


def permuted(rng: np.random.Generator, world: World) -> Shape:
    run = rng.integers(1, runs(world.plan) + 1)
    columns = [[1, 0, 2], [0, 2, 1], [2, 1, 0]][rng.integers(3)]
    return {"rows": np.flatnonzero(world.plan.run == run), "columns": columns}


def quadratic(rng: np.random.Generator, world: World) -> Shape:
    matrix = np.zeros((3, 3))
    i, j = sorted(rng.integers(3, size=2))
    matrix[i, j] = 1.0
    return {"matrix": matrix}


def quadratics(world: World) -> list[list[Shape]]:
    blocks = []
    for i in range(3):
        for j in range(i, 3):
            matrix = np.zeros((3, 3))
            matrix[i, j] = 1.0
            blocks.append([{"matrix": matrix}])
    return blocks


def magnetic(rng: np.random.Generator, world: World) -> Shape:
    """The room's field: strong downward part, any azimuth."""
    azimuth = rng.uniform(0.0, TURN)
    return {"field": np.array([0.4 * np.cos(azimuth), 0.4 * np.sin(azimuth), -0.9])}


def sides(world: World) -> list[list[Shape]]:
    return [[{"side": side}] for side in (1, -1)]


COMMON = {
    "bias_drift": Kind(limit=0.05),
    "bias_temperature": Kind(limit=0.05, needs=("temperature",)),
    "scale_factor_temperature": Kind(limit=0.03, unit="", needs=("temperature",)),
    "warm_up": Kind(tau, taus, 0.05),
    "bias_jump": Kind(middle_row, every_row),
    "run_bias": Kind(*RUNS, needs=("runs",)),
    "settling_lag": Kind(limit=0.2, unit=""),
    "hysteresis": Kind(limit=0.02),
    "saturation": Kind(lambda rng, w: {"side": int(rng.choice([-1, 1]))}, sides, 0.3),
    "outlier": Kind(row_of, every_row, 0.2),
    "pickup": Kind(line, lines),
    "stuck_reading": Kind(row_of, private=False, natural=True),
    "positions_swapped": Kind(swapped, private=False, natural=True),
    "stale_temperature": Kind(private=False, natural=True, needs=("temperature", "many")),
}
CHOICE = {
    "other": lambda rng, w: {"other": int(rng.integers(2))},
    "pair": lambda rng, w: {"pair": int(rng.integers(3))},
}
RIG = {
    "mounting_angle": Kind(*EACH_SETUP, limit=0.004, unit="rad", private=False, needs=("setups",)),
    "shaft_tilt": Kind(limit=0.003, unit="rad", private=False),
    "remount_bias": Kind(*SETUPS, needs=("setups",)),
    "head_eccentricity": Kind(phase, phases, 0.001, "rad", private=False),
    "head_ellipticity": Kind(phase, phases, 0.001, "rad", private=False),
    "head_periodic_error": Kind(
        lambda rng, w: {"lines": int(rng.integers(3, 9)), **phase(rng, w)},
        lambda w: [[{"lines": n, **q} for q in QUADRATURES] for n in range(3, 13)],
        0.001,
        "rad",
        private=False,
    ),
    "wrong_angle": Kind(row_of, every_row, 0.03, "rad", private=False),
    "wrong_stop": Kind(stop, stops, 0.03, "rad", private=False, needs=("repeats",)),
    "mount_reversed": Kind(
        lambda rng, w: {"setup": int(rng.integers(setups(w.plan)))},
        private=False,
        natural=True,
        needs=("setups",),
    ),
    "short_accumulation": Kind(row_of, every_row, 0.5, "", private=False),
}
ACCELEROMETER = {
    "second_order_nonlinearity": Kind(),
    "third_order_nonlinearity": Kind(),
    "odd_quadratic_nonlinearity": Kind(),
    "cross_axis_nonlinearity": Kind(
        CHOICE["other"], lambda w: [[{"other": other}] for other in range(2)]
    ),
    "cross_coupling": Kind(CHOICE["pair"], lambda w: [[{"pair": pair}] for pair in range(3)]),
    "scale_factor_asymmetry": Kind(),
    "bias_asymmetry": Kind(limit=0.02),
    "channels_permuted": Kind(permuted, private=False, natural=True, needs=("triad", "runs")),
}
TABLE = {
    "second_order_nonlinearity": Kind(),
    "third_order_nonlinearity": Kind(),
    "scale_factor_asymmetry": Kind(),
    "dead_band": Kind(limit=0.09),
    "table_slip": Kind(
        lambda rng, w: {"from": rng.uniform(45.0, 75.0)},
        lambda w: [[{"from": f}] for f in np.linspace(30.0, 90.0, 13)],
        0.2,
        "",
    ),
    "wrong_rate": Kind(
        lambda rng, w: {"setting": float(rng.choice(w.plan.setting))},
        lambda w: [[{"setting": r}] for r in np.unique(w.plan.setting)],
        needs=("repeats",),
    ),
    "wobble": Kind(
        lambda rng, w: {"phase": rng.uniform(0, TURN)},
        lambda w: [[{"phase": 0.0}, {"phase": np.pi / 2}]],
        limit=0.02,
    ),
    "run_scale_factor": Kind(*RUNS, limit=0.1, unit="", needs=("runs",)),
    "rate_sign_reversed": Kind(
        lambda rng, w: {"runs": [int(rng.integers(1, runs(w.plan) + 1))]},
        private=False,
        natural=True,
        needs=("runs",),
    ),
    "amplitude_scale_factor": Kind(limit=50.0, unit="", needs=("amplitude",)),
}
STATIC = {
    "earth_rate": Kind(
        lambda rng, w: {"azimuth": rng.uniform(0, TURN)},
        lambda w: [[{"azimuth": 0.0}, {"azimuth": np.pi / 2}]],
        1.0,
        "",
        private=False,
    ),
    "g_squared_sensitivity": Kind(quadratic, quadratics),
    "magnetic_sensitivity": Kind(magnetic, lambda w: [[{"field": f}] for f in np.eye(3)]),
}
WITHOUT_STIMULUS = ("settling_lag", "hysteresis", "saturation", "scale_factor_temperature")
HIDDEN: dict[str, dict[str, Kind]] = {
    "dividing_head": {**COMMON, **RIG, **ACCELEROMETER},
    "rate_table": {**COMMON, **TABLE},
    "static_positions": {
        **{name: kind for name, kind in COMMON.items() if name not in WITHOUT_STIMULUS},
        "remount_bias": RIG["remount_bias"],
        "mount_reversed": RIG["mount_reversed"],
        **STATIC,
    },
}
OUTSIDE_KIND = Kind(limit=0.1)


def has(world: World, need: str) -> bool:
    plan = world.plan
    places = set(zip(plan.setups.tolist(), plan.setting.tolist(), strict=True))
    return {
        "temperature": world.has_temperature,
        "runs": runs(plan) > 1,
        "setups": setups(plan) > 1,
        "repeats": len(places) < plan.size,
        "triad": world.outputs == 3,
        "many": plan.size >= 20,
        "amplitude": world.has_amplitude,
    }[need]


def testable(world: World) -> dict[str, Kind]:
    """The kinds that this run could hold."""
    kinds = HIDDEN[world.plan.test]
    return {name: kind for name, kind in kinds.items() if all(has(world, n) for n in kind.needs)}


def limit_of(world: World, name: str, kind: Kind) -> float:
    """Largest size; additive ones grow with the sensor's range."""
    if kind.unit != "g":
        return kind.limit
    return kind.limit * {"accelerometer": 1.0, "cvg": 0.1}.get(world.sensor, 100.0)
