"""Sealed cases for practice: rows of the simulated bench in which something is hidden.

What is hidden is drawn by a seed and sealed by a hash before anyone looks; the operator names it,
the program names it, and then the seal is opened. Needs no Qt. This is practice and no measure of
the program: the cases are made by the same effects that it looks for.
"""

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.discrepancy.ladder import Ladder
from core.discrepancy.problem import Problem
from core.discrepancy.result import Explanation
from core.discrepancy.settings import Settings
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Effect, Kind, Sensor
from core.model.sensor_model import SensorModel
from core.samples.run import Conditions, Run
from core.units import RAD_PER_ARCSEC
from drivers.virtual.rows import Found, walk_rows
from gui.discrepancy.working import Story, is_fact

HIDDEN = (
    *("second_order_nonlinearity", "third_order_nonlinearity", "cross_coupling"),
    *("scale_factor_asymmetry", "bias_asymmetry", "hysteresis", "head_eccentricity"),
    *("head_ellipticity", "bias_drift", "warm_up", "bias_jump", "bias_temperature"),
    *("scale_factor_temperature", "outlier", "wrong_angle", "positions_swapped"),
)
"""What can be hidden in a case."""

_G = 9.8106
_K, _CROSS, _ZERO = 1335.0, (14.0, -57.0), -230.0
_WHITE, _DRIFT = 0.5, 0.3
_HEAD_ARCSEC, _SETTING_ARCSEC = 3.0, 2.0
_PLANS = (("X_from", "Y_from"), ("X_from", "Y_from", "Z_from"))
_ANGLES = np.arange(0.0, 360.0, 22.5)
_EVERY_S = 40.0
_COUNTS, _SHARES = (0, 1, 2), (0.2, 0.6, 0.2)
_LEAST, _MOST = 12.0, 40.0


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """One sealed case.

    Parameters
    ----------
    seed : its number; the same number gives the same case
    run : what was measured
    truth : identifiers of what is hidden, in alphabetical order
    key : what the seal covers, as text
    """

    seed: int
    run: Run
    truth: tuple[str, ...]
    key: str

    @property
    def seal(self) -> str:
        """SHA-256 of the key, shown before anyone answers."""
        return hashlib.sha256(self.key.encode()).hexdigest()


@dataclass(frozen=True, slots=True)
class Score:
    """Cases that were opened, how many of them each had right, and cases that were begun."""

    cases: int = 0
    operator: int = 0
    program: int = 0
    begun: int = 0

    def after(self, *, operator: bool, program: bool) -> "Score":
        """With one more case."""
        right = self.operator + operator, self.program + program
        return Score(self.cases + 1, *right, self.begun)

    def to_section(self) -> dict[str, int]:
        """For the settings."""
        return {
            "cases": self.cases,
            "operator": self.operator,
            "program": self.program,
            "begun": self.begun,
        }


def score_of(section: Mapping[str, Any]) -> Score:
    """The score in the settings; what is not there or impossible counts as nothing."""
    cases, *right = (_count(section.get(name)) for name in ("cases", "operator", "program"))
    operator, program = (min(one, cases) for one in right)
    return Score(cases, operator, program, max(_count(section.get("begun")), cases))


def make_case(seed: int) -> Case:
    """Measure on the simulated bench with something hidden in it."""
    rng = np.random.default_rng([seed, 0xB11D])
    rows = _rows(rng)
    plain = SensorModel(
        Sensor("accelerometer", "z", rows.unit, (*_CROSS, _K)),
        (CATALOGUE["bias"], CATALOGUE["scale_factor"], CrossAxis("xy")),
    )
    values = frozen([_ZERO, _K, *_CROSS])
    clean = replace(rows, y=plain.predict(Problem.of(rows).stimulus, values)[:, None])
    hidden = _drawn(Problem.of(clean), rng)
    n = len(rows)
    found = Found(
        models=[_instant(plain, values, hidden)],
        white=np.array([_WHITE]),
        drift=np.array([_DRIFT]),
        setting=np.full(n, _SETTING_ARCSEC * RAD_PER_ARCSEC),
        repeating=np.full(n, _HEAD_ARCSEC * RAD_PER_ARCSEC),
        columns=Problem.of(clean).stimulus.columns,
    )
    y = walk_rows(clean, found, seed)
    y = _afterwards(y, Problem.of(clean), hidden)
    truth = tuple(sorted(effect.id for effect, _ in hidden))
    key = {
        "case": seed,
        "hidden": [
            {
                "effect": effect.id,
                "values": [float(f"{value:.6g}") for value in sizes],
                "shape": [float(f"{value:.6g}") for _, value in effect.shape],
            }
            for effect, sizes in hidden
        ],
        "salt": rng.bytes(8).hex(),
    }
    return Case(seed, replace(clean, y=frozen(y)), truth, json.dumps(key, sort_keys=True))


def story_of(case: Case, settings: Settings, tell: Callable[[str], None]) -> Story:
    """The case as a run that was opened."""
    tell("floor")
    ladder = Ladder.of(case.run, settings)
    tell("where")
    return Story(case.run, (Path(f"case {case.seed}"),), ladder, ladder.explanation)


def is_right(truth: Sequence[str], named: Sequence[Sequence[str]]) -> bool:
    """Whether the names are those that are hidden, no more and no less.

    Parameters
    ----------
    truth : identifiers of what is hidden
    named : for each effect that was named, all identifiers that it stands for
    """
    left = [set(one) for one in named]
    if len(left) != len(truth):
        return False
    for name in truth:
        match = next((one for one in left if name in one), None)
        if match is None:
            return False
        left.remove(match)
    return True


def named_by_program(told: Explanation) -> list[tuple[str, ...]]:
    """For each step of the program's answer the names that it cannot tell apart."""
    return [(step.effect, *step.indistinguishable_from) for step in told.steps if not is_fact(step)]


def named_by_operator(told: Explanation, names: Sequence[str]) -> list[tuple[str, ...]]:
    """For each name of the operator that name with those that look the same in these rows."""
    aliases = {each.effect: each.aliases for each in told.smallest}
    return [(name, *aliases.get(name, ())) for name in names]


def _count(value: object) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else 0


def _rows(rng: np.random.Generator) -> Run:
    """The plan: mixed angles, all twice, the unit warming up by some tenths of a degree."""
    mounts = _PLANS[int(rng.integers(len(_PLANS)))]
    places = [
        (mount, float(angle))
        for _ in range(2)
        for mount in mounts
        for angle in rng.permutation(_ANGLES)
    ]
    n = len(places)
    t = _EVERY_S * np.arange(n)
    warm = 24.0 + 0.9 * (1.0 - np.exp(-t / 1500.0)) + 0.1 * np.sin(t / 700.0)
    half = n // 2
    return Run(
        test="dividing_head",
        sensor="accelerometer",
        device="Blind trial",
        channels=("acc_z",),
        axes=("z",),
        unit="code",
        # Something that a plain model can be prepared from.
        y=rng.standard_normal((n, 1)),
        y_se=np.full((n, 1), _WHITE),
        run=frozen_int([1] * half + [2] * (n - half)),
        order=np.arange(n),
        mount=tuple(mount for mount, _ in places),
        head_deg=frozen([angle for _, angle in places]),
        set_rate_dps=np.full(n, np.nan),
        temperature_c=frozen(warm.round(3)),
        t_s=frozen(t),
        conditions=Conditions(
            g_mps2=_G, accumulation_s=2.0, head_u_arcsec=_HEAD_ARCSEC, sample_rate_hz=25.0
        ),
    )


def _drawn(problem: Problem, rng: np.random.Generator) -> list[tuple[Effect, FloatArray]]:
    """What is hidden, each at a size that these rows show."""
    count = int(rng.choice(_COUNTS, p=_SHARES))
    names = rng.choice(HIDDEN, size=count, replace=False).tolist()
    hidden: list[tuple[Effect, FloatArray]] = []
    design = problem.design()
    for name in names:
        effect = _instance(CATALOGUE[name], problem, rng)
        columns = problem.columns(effect, 0)
        if not columns.shape[1]:
            hidden.append((effect, np.zeros(0)))
            continue
        direction = rng.standard_normal(columns.shape[1])
        curve = columns @ direction
        seen = curve - design @ np.linalg.lstsq(design, curve, rcond=None)[0]
        wanted = float(rng.uniform(_LEAST, _MOST)) * float(np.hypot(_WHITE, _DRIFT))
        hidden.append((effect, direction * wanted / max(float(np.linalg.norm(seen)), 1e-300)))
    return hidden


def _instance(effect: Effect, problem: Problem, rng: np.random.Generator) -> Effect:
    """One place and shape that the rows could show."""
    if effect.kind is Kind.EXCHANGE:
        pairs = effect.exchanges(problem.stimulus)
        first, second = pairs[int(rng.integers(len(pairs)))].tolist()
        return effect.exchanged(first, second)
    instances = effect.instances(problem.stimulus, problem.models[0].sensor)
    return instances[int(rng.integers(len(instances)))]


def _instant(
    plain: SensorModel, values: FloatArray, hidden: Sequence[tuple[Effect, FloatArray]]
) -> tuple[SensorModel, FloatArray]:
    """The unit on the bench: what acts at the moment."""
    model, numbers = plain, values.tolist()
    for effect, sizes in hidden:
        if effect.instant:
            model, numbers = model.with_effect(effect), [*numbers, *sizes.tolist()]
    return model, frozen(numbers)


def _afterwards(
    y: FloatArray, problem: Problem, hidden: Sequence[tuple[Effect, FloatArray]]
) -> FloatArray:
    """What acts between rows, and rows that were exchanged."""
    for effect, sizes in hidden:
        if not effect.instant and len(sizes):
            y = y + (problem.columns(effect, 0) @ sizes)[:, None]
    for effect, sizes in hidden:
        if not len(sizes):
            y = effect.relabel(problem.stimulus, y)[1]
    return y
