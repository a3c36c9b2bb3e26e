"""Seal the cases, let an engine answer, open the keys, score. Uses all processes it is given."""

import hashlib
import importlib
import json
import secrets
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

from tests.blind import scoring, severity
from tests.blind.cases import Case, Spec, continued, draw_case, sealed
from tests.blind.plans import RECORD_NAMES, Sweep, around
from tests.blind.plans import continued as longer
from tests.blind.record_cases import RecordCase, draw_record

Engine = Callable[[Path], dict[str, Any]]
"""Gives what `calrig explain FILE --json OUT` writes, with `advice` as a list of sweeps

{"mount": ..., "settings": [...]} where there is a next measurement.
"""
CLEAR = 3.5


def make(spec: Spec, known: dict[str, Any] | None = None) -> Case | RecordCase | None:
    return (draw_record if spec.plan in RECORD_NAMES else draw_case)(spec, known)


def file_name(spec: Spec) -> str:
    text = "/".join(map(str, (spec.plan, spec.kind, spec.lam, spec.seed, spec.effect)))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def seal(job: tuple[Spec, str]) -> tuple[Spec, str] | None:
    """Write the run and its key; None if the data cannot show what was to be hidden."""
    spec, folder = job
    case = make(spec)
    if case is None:
        return None
    path = Path(folder) / file_name(spec)
    key, seal_hash = sealed(case.key, secrets.token_hex(16))
    path.with_suffix(".run.csv").write_text(case.text, encoding="utf-8")
    path.with_suffix(".key.json").write_text(key, encoding="utf-8")
    return spec, seal_hash


def engine_of(name: str) -> Engine:
    module, _, function = name.partition(":")
    return getattr(importlib.import_module(module), function)


def asked(engine: Engine, path: Path) -> dict[str, Any]:
    """The answer; a crash of the engine is a result as well."""
    try:
        return engine(path)
    except Exception as error:  # noqa: BLE001  (whatever it is, the other cases go on)
        return {
            "verdict": f"crash: {error!r}",
            "steps": [],
            "before": {"rms": None},
            "after": {"rms": None},
        }


def answer(job: tuple[Spec, str, str, str, str]) -> dict[str, Any]:
    """Ask the engine, then open the key."""
    spec, seal_hash, folder, engine_name, group = job
    engine = engine_of(engine_name)
    path = (Path(folder) / file_name(spec)).with_suffix(".run.csv")
    start = time.process_time()
    given = asked(engine, path)
    seconds = time.process_time() - start
    text = path.with_name(path.name.replace(".run.csv", ".key.json")).read_text("utf-8")
    if hashlib.sha256(text.encode()).hexdigest() != seal_hash:
        raise ValueError(f"{path}: the key is not the one that was sealed")
    key = json.loads(text)
    row = {**scoring.score(key, given), "seconds": seconds, "group": group}
    row["rows"] = 0 if spec.plan in RECORD_NAMES else len(key["noise_free"])
    if group in ("double", "triple") and spec.plan not in RECORD_NAMES:
        row["equivalent"] = equivalent(spec, key, row)
    if group == "advice" and row["set_size"] > 1:
        row |= advised(spec, key, given, engine, Path(folder))
    return row


def equivalent(spec: Spec, key: dict[str, Any], row: dict[str, Any]) -> bool:
    """No more names than hidden effects, and they leave next to nothing of them."""
    if not row["names"] or len(row["names"]) > len(key["effects"]):
        return False
    case = draw_case(spec, key)
    glass = severity.Glass(case.world)
    return severity.left_over(glass, glass.change(case.effects), row["names"]) < CLEAR


def advised(
    spec: Spec, key: dict[str, Any], given: dict[str, Any], engine: Engine, folder: Path
) -> dict[str, Any]:
    """Measure what the engine asks for, or a sweep chosen by lot, and ask it again."""
    case = draw_case(spec, key)
    rng = np.random.default_rng(spec.seed + 1)
    proposed: list[Sweep] = [(s["mount"], list(s["settings"])) for s in given.get("advice") or []]
    mount = str(rng.choice(["X_from", "X_to", "Y_from", "Y_to"]))
    by_lot: list[Sweep] = [(mount, around(15.0, bool(rng.integers(2))))]
    out = {}
    for name, sweeps in (("advice", proposed), ("lot", by_lot)):
        if not sweeps:
            out[f"unique_{name}"] = False
            continue
        again = continued(case, longer(case.world.plan, sweeps), rng)
        path = folder / f"{file_name(spec)}-{name}.run.csv"
        path.write_text(again.text, encoding="utf-8")
        result = scoring.score(key, asked(engine, path))
        out[f"unique_{name}"] = bool(result.get("unique"))
    return out


def run(
    groups: dict[str, list[Spec]],
    engine: str,
    processes: int = 1,
    say: Callable[[str], None] = lambda text: None,
) -> list[dict[str, Any]]:
    """Rows of all cases; the hash of all keys is said before the first answer."""
    with tempfile.TemporaryDirectory() as folder:
        jobs = [(spec, folder, group) for group, some in groups.items() for spec in some]
        kept = list(mapped(seal, [(spec, where) for spec, where, _ in jobs], processes))
        ready = [
            (made[0], made[1], folder, engine, job[2])
            for made, job in zip(kept, jobs, strict=True)
            if made is not None
        ]
        together = hashlib.sha256("".join(sorted(job[1] for job in ready)).encode()).hexdigest()
        say(f"{len(ready)} cases sealed ({len(jobs) - len(ready)} invisible): SHA-256 {together}")
        return list(mapped(answer, ready, processes))


def mapped(work: Callable[[Any], Any], jobs: list[Any], processes: int) -> Iterator[Any]:
    if processes == 1:
        yield from map(work, jobs)
        return
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        yield from pool.map(work, jobs, chunksize=4)
