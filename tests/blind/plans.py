"""What was measured in which order: the plans of the blind benchmark."""

from dataclasses import dataclass, replace

import numpy as np

CARDINAL = (0.0, 90.0, 180.0, 270.0)


@dataclass(frozen=True)
class Plan:
    """Rows in the order of measuring; `setting` is the dial angle (deg) or the set rate (deg/s)."""

    name: str
    test: str
    run: np.ndarray
    mount: tuple[str, ...]
    setting: np.ndarray
    time: np.ndarray
    accumulation: float
    sample_rate: float

    @property
    def size(self) -> int:
        return len(self.run)

    @property
    def setups(self) -> np.ndarray:
        """Number of the bolting-on (n,): a change of mount begins a new one."""
        change = [a != b for a, b in zip(self.mount, ("", *self.mount[:-1]), strict=True)]
        return np.cumsum(change) - 1


Sweep = tuple[str, list[float]]


def clock(run: np.ndarray, mount: list[str], step: float) -> np.ndarray:
    """Start of each accumulation (s): a minute more before a run, five before a new setup."""
    gaps = np.full(len(run), step)
    for row in range(1, len(run)):
        gaps[row] += 60.0 * (run[row] != run[row - 1]) + 300.0 * (mount[row] != mount[row - 1])
    return np.cumsum(gaps) - step


def swept(name: str, test: str, sweeps: list[Sweep]) -> Plan:
    run = np.concatenate([np.full(len(s), i + 1) for i, (_, s) in enumerate(sweeps)])
    mount = [m for m, settings in sweeps for _ in settings]
    setting = np.concatenate([np.asarray(s, float) for _, s in sweeps])
    accumulation, step = (30.0, 42.0) if test == "rate_table" else (10.0, 30.0)
    time = clock(run, mount, step)
    return Plan(name, test, run, tuple(mount), setting, time, accumulation, 100.0)


def around(step: float, reverse: bool = False) -> list[float]:
    angles = [step * i for i in range(round(360.0 / step))]
    return angles[::-1] if reverse else angles


def head_plans() -> dict[str, list[Sweep]]:
    four = ["X_from", "X_to", "Y_from", "Y_to"]
    closed = [*around(15.0), 360.0, 0.0]
    return {
        "A24": [(m, list(CARDINAL)) for m in ("X_from", "Y_from") for _ in range(3)],
        "A8x3": [(m, [*CARDINAL, *CARDINAL]) for m in ("X_from", "X_to", "Y_from")],
        "A104": [(m, closed) for m in ("X_from", "Y_from") for _ in range(2)],
        "A192": [(m, around(15.0, back)) for m in four for back in (False, True)],
        "A80": [
            ("X_from", around(22.5)),
            ("X_to", around(22.5, True)),
            ("Y_from", around(22.5)),
            ("Z_from", around(22.5, True)),
            ("X_from@90", around(22.5)),
        ],
        "A48x1": [(m, around(15.0)) for m in ("X_from", "Y_from")],
        "A8": [(m, list(CARDINAL)) for m in ("X_from", "Y_from")],
        "A48s": [("X_from", around(15.0))] * 2,
        "A400": [("X_from", around(4.5)) for _ in range(5)],
    }


def rate_plans(rng: np.random.Generator) -> dict[str, list[Sweep]]:
    eleven = list(np.linspace(-100.0, 100.0, 11))
    many = list(np.linspace(-100.0, 100.0, 21))
    shuffled = [float(r) for _ in range(4) for r in rng.permutation(many)]
    return {
        "B11x3": [("Z_from", eleven)] * 3,
        "B11x1": [("Z_from", eleven)],
        "B84": [("Z_from", many + many[::-1])] * 2,
        "B84r": [("Z_from", shuffled[i : i + 21]) for i in range(0, 84, 21)],
    }


STATIC: dict[str, list[Sweep]] = {
    "C4": [("X_from", list(CARDINAL))],
    "C8": [("X_from", list(CARDINAL)), ("Y_from", list(CARDINAL))],
    "C8b": [("X_from", [0.0, 90.0, 180.0, 270.0, 0.0, 270.0, 180.0, 90.0])],
    "C16": [(m, [0.0, 90.0, 180.0, 270.0, 0.0, 270.0, 180.0, 90.0]) for m in ("X_from", "X_to")],
}
HEAD_NAMES = tuple(head_plans())
RATE_NAMES = ("B11x3", "B11x1", "B84", "B84r")
RECORD_NAMES = ("D1h", "D1h100")
NAMES = (*HEAD_NAMES, *RATE_NAMES, *STATIC, *RECORD_NAMES)


def plan_of(name: str, rng: np.random.Generator) -> Plan:
    if name in HEAD_NAMES:
        return swept(name, "dividing_head", head_plans()[name])
    if name in RATE_NAMES:
        return swept(name, "rate_table", rate_plans(rng)[name])
    if name in STATIC:
        return swept(name, "static_positions", STATIC[name])
    rate = {"D1h": 1.0, "D1h100": 100.0}[name]
    time = np.arange(int(3600 * rate)) / rate
    none = np.ones(len(time), int)
    return Plan(name, "record", none, (), np.zeros(len(time)), time, 1.0 / rate, rate)


def continued(plan: Plan, sweeps: list[Sweep], pause: float = 600.0) -> Plan:
    """The same plan with further sweeps measured after it."""
    extra = swept(plan.name, plan.test, sweeps)
    return replace(
        plan,
        run=np.concatenate([plan.run, extra.run + plan.run[-1]]),
        mount=plan.mount + extra.mount,
        setting=np.concatenate([plan.setting, extra.setting]),
        time=np.concatenate([plan.time, extra.time + plan.time[-1] + pause]),
    )
