"""A sealed case: a run file for the engine, and the key that is opened after its answer."""

import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tests.blind import effects as kinds
from tests.blind import head, noise, outside, play, run_file, severity
from tests.blind.effects import OUTSIDE_KIND, Kind
from tests.blind.plans import Plan, plan_of
from tests.blind.severity import Glass
from tests.blind.world import Effects, Hidden, World, world_of

FOREIGN = 3.5
"""What lies outside the catalogue must differ from every single name by so many sigmas."""

ONE_SIGN = (
    "saturation",
    "dead_band",
    "table_slip",
    "settling_lag",
    "short_accumulation",
    "earth_rate",
)


@dataclass(frozen=True)
class Spec:
    """What to hide: `kind` is none, coloured, single, double, triple, fault or outside."""

    plan: str
    kind: str
    lam: float
    seed: int
    effect: str = ""


@dataclass(frozen=True)
class Case:
    spec: Spec
    world: World
    effects: Effects
    weather: head.Weather
    readings: play.Readings
    key: dict[str, Any]

    @property
    def text(self) -> str:
        return run_file.of_settings(self.world, self.readings)


def streams(seed: int) -> Iterator[np.random.Generator]:
    return iter([np.random.default_rng(s) for s in np.random.SeedSequence(seed).spawn(4)])


def unit_of(spec: Spec, rng: np.random.Generator) -> World:
    """A random unit on the plan; some runs lack columns, some have three outputs."""
    plan = plan_of(spec.plan, rng)
    needs = {**kinds.HIDDEN[plan.test]}.get(spec.effect, Kind()).needs
    triad = plan.test != "rate_table" and plan.size <= 200 and rng.uniform() < 0.35
    return world_of(
        plan,
        rng,
        triad=triad or "triad" in needs,
        coloured=spec.kind == "coloured",
        has_temperature=rng.uniform() < 0.85 or "temperature" in needs,
        has_se=rng.uniform() < 0.75,
        has_amplitude=plan.test == "rate_table" and (rng.uniform() < 0.3 or "amplitude" in needs),
    )


def shape_for(world: World, kind: Kind, rng: np.random.Generator) -> dict[str, Any]:
    shape = kind.draw(rng, world)
    return {"channel": int(rng.integers(world.outputs)), **shape} if kind.private else shape


def hide(spec: Spec, glass: Glass, rng: np.random.Generator) -> Effects | None:
    """Draw the hidden effects; None if these data cannot show them at this lambda."""
    world = glass.world
    if spec.kind in ("none", "coloured"):
        return {}
    if spec.kind == "outside":
        return hide_foreign(spec, glass, rng)
    possible = kinds.testable(world)
    if spec.kind in ("single", "fault"):
        names = [spec.effect]
        if spec.effect not in possible:
            return None
    else:
        additive = [name for name, kind in possible.items() if not kind.natural]
        names = list(rng.permutation(additive))
    found: Effects = {}
    for name in names:
        hidden = hidden_of(spec, glass, name, possible[name], rng)
        if hidden is not None:
            found[str(name)] = hidden
        if len(found) == {"double": 2, "triple": 3}.get(spec.kind, 1):
            return found if separate(glass, found) else None
    return None


def hidden_of(
    spec: Spec, glass: Glass, name: str, kind: Kind, rng: np.random.Generator
) -> Hidden | None:
    shape = shape_for(glass.world, kind, rng)
    if kind.natural:
        hidden = Hidden(1.0, shape)
        seen = name == "stale_temperature" or glass.visibility(name, hidden) > 20.0
        return hidden if seen else None
    limit = kinds.limit_of(glass.world, name, kind)
    sign = 1.0 if name in ONE_SIGN else float(rng.choice([-1.0, 1.0]))
    size = severity.sized(glass, name, shape, limit, spec.lam, sign)
    return None if size is None else Hidden(float(size * sign), shape)


def separate(glass: Glass, found: Effects) -> bool:
    """Whether each of several effects stays visible when the others are known."""
    if len(found) == 1:
        return True
    seen = np.stack([glass.change({name: hidden}) for name, hidden in found.items()], axis=1)
    return severity.apart(seen)


def hide_foreign(spec: Spec, glass: Glass, rng: np.random.Generator) -> Effects | None:
    world = glass.world
    limit = kinds.limit_of(world, spec.effect, OUTSIDE_KIND)
    for _ in range(4):
        shape = outside.shape_of(spec.effect, rng, world.plan.size)
        shape["channel"] = int(rng.integers(world.outputs))
        size = severity.sized(glass, spec.effect, shape, limit, spec.lam)
        if size is None:
            return None
        hidden = {spec.effect: Hidden(float(size), shape)}
        if not severity.mimics(glass, glass.change(hidden), spec.effect, FOREIGN):
            return hidden
    return None


def residual_rms(glass: Glass, readings: np.ndarray, removed: np.ndarray | None) -> float:
    """RMS (g or deg/s) after a generalised least-squares fit of the plain model.

    removed : (n, c) true change, fitted along with one factor
    """
    world = glass.world
    plain = np.kron(np.eye(world.outputs), severity.plain_columns(world))
    if removed is not None and np.any(removed):
        plain = np.hstack([plain, removed.T.reshape(-1, 1)])
    flat = (readings / world.scale).T.reshape(-1)
    solution, *_ = np.linalg.lstsq(glass.whiten(plain), glass.whiten(flat), rcond=1e-9)
    return float(np.sqrt(np.mean((flat - plain @ solution) ** 2)))


def draw_case(spec: Spec, known: dict[str, Any] | None = None) -> Case | None:
    """Make a case; with the `known` key of an earlier draw only the readings are made again."""
    unit, shapes, air, electronics = streams(spec.seed)
    world = unit_of(spec, unit)
    glass = Glass(world)
    if known is None:
        hidden = hide(spec, glass, shapes)
    else:
        hidden = {n: Hidden(e["size"], unpacked(e["shape"])) for n, e in known["effects"].items()}
    if hidden is None:
        return None
    weather = noise.draw(world, hidden, air)
    readings = play.measure(world, hidden, weather, electronics)
    key = known or key_of(spec, glass, hidden, readings)
    return Case(spec, world, hidden, weather, readings, key)


def key_of(spec: Spec, glass: Glass, hidden: Effects, readings: play.Readings) -> dict[str, Any]:
    world = glass.world
    possible = kinds.testable(world)
    change = play.truth(world, hidden) - glass.healthy
    parts = {}
    for name, effect in hidden.items():
        seen = glass.change({name: effect})
        additive = name in possible and not possible[name].natural
        parts[name] = {
            "size": effect.size,
            "shape": packed(effect.shape),
            "lambda": float(np.linalg.norm(seen)),
            "equals": severity.mimics(glass, seen, name) if additive else [],
        }
    return {
        "spec": vars_of(spec),
        "test": world.plan.test,
        "sensor": world.sensor,
        "unit": world.unit,
        "outputs": world.outputs,
        "has_se": world.has_se,
        "levels": vars_of(world.levels),
        "effects": parts,
        "scale": world.scale.tolist(),
        "before_rms": residual_rms(glass, readings.y, None),
        "oracle_rms": residual_rms(glass, readings.y, change),
        "noise_free": (play.truth(world, hidden) * world.scale).tolist(),
    }


def vars_of(value: Any) -> dict[str, Any]:
    return {name: getattr(value, name) for name in value.__dataclass_fields__}


def packed(shape: dict[str, Any]) -> dict[str, Any]:
    return {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in shape.items()}


def unpacked(shape: dict[str, Any]) -> dict[str, Any]:
    arrays = ("runs", "setups", "states", "rows", "matrix", "field")
    return {k: np.asarray(v) if k in arrays else v for k, v in shape.items()}


def sealed(key: dict[str, Any], salt: str) -> tuple[str, str]:
    """The key as text, and the hash that proves later that it was not touched."""
    text = json.dumps({"salt": salt, **key}, sort_keys=True, default=float)
    return text, hashlib.sha256(text.encode()).hexdigest()


def continued(case: Case, plan: Plan, rng: np.random.Generator) -> Case:
    """Measure more of the same hidden unit: `plan` begins with the rows of the case."""
    world, old = case.world, case.world.plan.size
    t = plan.time
    fresh = world_of(plan, rng, triad=world.outputs == 3)
    settle = np.exp(-(t[old:] - t[old - 1]) / 1800.0)
    warmth, recorded = fresh.warmth.copy(), fresh.recorded.copy()
    for new, was in ((warmth, world.warmth), (recorded, world.recorded)):
        new[old:] += (was[-1] - new[old - 1]) * settle
        new[:old] = was
    recorded = np.round(recorded / 0.02) * 0.02
    amplitude = np.concatenate([world.amplitude, fresh.amplitude[old:]])
    longer = replace(world, plan=plan, warmth=warmth, recorded=recorded, amplitude=amplitude)
    hidden = {
        name: Hidden(h.size, lengthened(h.shape, longer, rng)) for name, h in case.effects.items()
    }
    weather = noise.prolonged(longer, hidden, case.weather, rng)
    readings = play.measure(longer, hidden, weather, rng)
    for new, was in ((readings.y, case.readings.y), (readings.se, case.readings.se)):
        new[:old] = was
    return Case(case.spec, longer, hidden, weather, readings, case.key)


def lengthened(shape: dict[str, Any], world: World, rng: np.random.Generator) -> dict[str, Any]:
    """What differs from run to run or setup to setup goes on differing."""
    counts = {"runs": kinds.runs, "setups": kinds.setups}
    out = dict(shape)
    for name, count in counts.items():
        values = out.get(name)
        if isinstance(values, np.ndarray) and values.dtype == float:
            size = np.sqrt(np.mean(values**2))
            more = rng.normal(size=max(count(world.plan) - len(values), 0)) * size
            out[name] = np.concatenate([values, more])
    if "states" in out:
        out["states"] = np.concatenate([out["states"], out["states"], out["states"]])
    return out
