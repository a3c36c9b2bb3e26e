"""Sealed cases on hour-long records."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.blind import long_record, run_file, severity
from tests.blind.cases import FOREIGN, Spec, packed, streams, unpacked, vars_of
from tests.blind.long_record import Record
from tests.blind.outside import OUTSIDE
from tests.blind.plans import plan_of
from tests.blind.severity import CLASS
from tests.blind.world import Effects, Hidden


@dataclass(frozen=True)
class RecordCase:
    spec: Spec
    record: Record
    effects: Effects
    table: np.ndarray
    key: dict[str, Any]

    @property
    def text(self) -> str:
        return run_file.of_record(self.record, self.table)


def names_of(spec: Spec, rng: np.random.Generator) -> list[str]:
    count = {"double": 2, "triple": 3}.get(spec.kind, 0)
    if count:
        return [str(name) for name in rng.choice(long_record.SLOW, count, replace=False)]
    return [] if spec.kind in ("none", "coloured") else [spec.effect]


def hide(spec: Spec, record: Record, rng: np.random.Generator) -> Effects:
    found: Effects = {}
    for name in names_of(spec, rng):
        if name in long_record.NATURAL:
            found[name] = long_record.natural(name, rng)
        else:
            shape = long_record.shape_of(name, rng, record)
            size = long_record.sized(record, name, shape, spec.lam) * rng.choice([-1.0, 1.0])
            found[name] = Hidden(float(size), shape)
    return found


def separate(record: Record, factor: np.ndarray, hidden: Effects) -> bool:
    """Whether each of several effects stays visible when the others are known, as in runs."""
    values = [e.size * long_record.form(name, e.shape, record) for name, e in hidden.items()]
    seen = [long_record.visible(record, factor, one) for one in values]
    return severity.apart(np.stack(seen, axis=1))


def draw_record(spec: Spec, known: dict[str, Any] | None = None) -> RecordCase | None:
    unit, shapes, air, _ = streams(spec.seed)
    record = long_record.record_of(plan_of(spec.plan, unit), unit, spec.kind == "coloured")
    if known is not None:
        hidden = {n: Hidden(e["size"], unpacked(e["shape"])) for n, e in known["effects"].items()}
        return RecordCase(spec, record, hidden, long_record.measure(record, hidden, air), known)
    hidden = hide(spec, record, shapes)
    factor = long_record.whitener(record)
    if spec.kind in ("double", "triple") and not separate(record, factor, hidden):
        return None
    parts = {}
    for name, effect in hidden.items():
        parts[name] = {"size": effect.size, "shape": packed(effect.shape), "lambda": spec.lam}
        equals: list[str] = []
        if name not in long_record.NATURAL and name != "pickup":
            values = effect.size * long_record.form(name, effect.shape, record)
            target = long_record.visible(record, factor, values)
            leave = FOREIGN if name in OUTSIDE["record"] else CLASS
            equals = long_record.mimics(record, target, name, leave)
            if equals and name in OUTSIDE["record"]:
                return None
        parts[name]["equals"] = equals
    key = {
        "spec": vars_of(spec),
        "test": "record",
        "sensor": "cvg_record",
        "unit": "V",
        "outputs": 1,
        "has_se": False,
        "levels": vars_of(record.levels),
        "effects": parts,
        "scale": [1.0],
    }
    return RecordCase(spec, record, hidden, long_record.measure(record, hidden, air), key)
