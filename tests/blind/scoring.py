"""Compare one answer of an engine with the key of its case."""

import math
from typing import Any

from tests.blind.long_record import NOISES, SLOW

UNKNOWN = "unexplained_structure"
QUIET = ("adequate", "not_enough_data")
SURE = 0.8
Z95 = 1.959964

SIZES: dict[str, tuple[str, ...]] = {
    "g": (
        "second_order_nonlinearity",
        "third_order_nonlinearity",
        "odd_quadratic_nonlinearity",
        "cross_axis_nonlinearity",
        "cross_coupling",
        "bias_jump",
        "outlier",
        "scale_factor_asymmetry",
        "hysteresis",
        "bias_drift",
        "bias_temperature",
    ),
    "rad": ("head_eccentricity", "head_ellipticity", "shaft_tilt", "wrong_angle", "wrong_stop"),
    "": ("scale_factor_temperature", "settling_lag"),
}
"""Effects with one number whose definition leaves no choice, by dimension."""
UNSCALED = ("bias_temperature",)
"""Of records: where a curve is named, its slope is that at another temperature."""
PREFIX = {
    "m/s^2": 1.0 / 9.8106,
    "µg": 1e-6,
    "ug": 1e-6,
    "mg": 1e-3,
    "g": 1.0,
    "mdeg/s": 1e-3,
    "mdps": 1e-3,
    "deg/s": 1.0,
    "dps": 1.0,
    "deg/h": 1.0 / 3600.0,
    "arcsec": math.pi / 648000.0,
    '"': math.pi / 648000.0,
    "″": math.pi / 648000.0,
    "arcmin": math.pi / 10800.0,
    "deg": math.pi / 180.0,
    "rad": 1.0,
    "mrad": 1e-3,
    "ppm": 1e-6,
    "%": 1e-2,
    "": 1.0,
    "1": 1.0,
}


def factor_of(unit: str, scale: float, output_unit: str) -> float | None:
    """What turns a number of `unit` into g, deg/s, rad or 1; None if the unit is strange.

    What stands in the denominator (g^2, degC, h) is the same on both sides.
    """
    if unit in PREFIX:
        return PREFIX[unit]
    for name, size in ((output_unit, 1.0 / abs(scale)), *PREFIX.items()):
        if name and unit.startswith(f"{name}/"):
            return size
    return 1.0 / abs(scale) if unit == output_unit else None


def steps_of(key: dict[str, Any], answer: dict[str, Any]) -> list[dict[str, Any]]:
    """The steps; naming the noise of a record accuses nobody unless noise was hidden."""
    hidden_noise = any(name in NOISES for name in key["effects"])
    steps = answer.get("steps", [])
    if key["test"] == "record" and not hidden_noise:
        steps = [step for step in steps if step["effect"] not in NOISES]
    return steps


def held(step: dict[str, Any]) -> set[str]:
    """All names that a step leaves possible."""
    return {step["effect"], *step.get("indistinguishable_from", [])}


def is_sure(step: dict[str, Any]) -> bool:
    lone = not step.get("indistinguishable_from")
    return lone and (step.get("probability") or 0.0) >= SURE and step["effect"] != UNKNOWN


def score(key: dict[str, Any], answer: dict[str, Any]) -> dict[str, Any]:
    """One row of the benchmark; NaN where a number makes no sense for the case."""
    steps = steps_of(key, answer)
    hidden = key["effects"]
    verdict = answer.get("verdict", "")
    good = set(hidden).union(*(set(e["equals"]) for e in hidden.values()))
    foreign = key["spec"]["kind"] == "outside"
    names = [step["effect"] for step in steps]
    alarm = bool(steps) or (verdict not in QUIET and not only_noise(key, answer))
    wrong = [s["effect"] for s in steps if is_sure(s) and (foreign or s["effect"] not in good)]
    row: dict[str, Any] = {
        "spec": key["spec"],
        "test": key["test"],
        "verdict": verdict,
        "names": names,
        "sets": [sorted(held(step)) for step in steps],
        "alarm": alarm,
        "named": any(name != UNKNOWN for name in names),
        "abstained": verdict in ("not_enough_data",),
        "sure_wrong": wrong,
        "set_size": max([len(held(step)) for step in steps], default=0),
    }
    said = verdict == UNKNOWN or any(UNKNOWN in held(s) for s in steps) or verdict == "excess_noise"
    row["said_unknown"] = said
    if hidden and not foreign:
        row |= identified(hidden, steps)
        row |= {"identifiable": all(not e["equals"] for e in hidden.values())}
    if hidden and len(hidden) == 1 and not foreign:
        row["z"] = parameter_z(key, steps)
    if "oracle_rms" in key and hidden:
        row["closure"] = closure(key, answer)
    return row


def only_noise(key: dict[str, Any], answer: dict[str, Any]) -> bool:
    """Whether the verdict rests on noise terms of a record, or on more noise where there is."""
    more = key["spec"]["kind"] == "coloured" and answer.get("verdict") == "excess_noise"
    return more or (key["test"] == "record" and bool(answer.get("steps")))


def identified(hidden: dict[str, Any], steps: list[dict[str, Any]]) -> dict[str, Any]:
    names = [step["effect"] for step in steps]
    first = bool(names) and names[0] in hidden
    return {
        "detected": bool(steps),
        "first": first and len(names) == 1 if len(hidden) == 1 else sorted(names) == sorted(hidden),
        "unique": first and len(names) == 1 and not steps[0].get("indistinguishable_from"),
        "covered": matched(list(hidden), [held(step) for step in steps]) == len(hidden),
        "class": bool(names)
        and all(any(n == h or n in e["equals"] for h, e in hidden.items()) for n in names),
        "recall": matched(list(hidden), [held(step) for step in steps]) / len(hidden),
        "extra": max(len(names) - len(hidden), 0),
    }


def matched(wanted: list[str], sets: list[set[str]]) -> int:
    """How many names can be given a step of their own whose set holds them."""
    owner: dict[int, str] = {}

    def place(name: str, seen: set[int]) -> bool:
        for i, names in enumerate(sets):
            if name in names and i not in seen:
                seen.add(i)
                if i not in owner or place(owner[i], seen):
                    owner[i] = name
                    return True
        return False

    return sum(place(name, set()) for name in wanted)


def parameter_z(key: dict[str, Any], steps: list[dict[str, Any]]) -> float:
    """(estimate - truth) / standard uncertainty of the size, NaN where it is not comparable."""
    (name, effect), *_ = key["effects"].items()
    if key["test"] == "record":
        return record_z(name, effect, steps)
    dimension = next((d for d, names in SIZES.items() if name in names), None)
    step = next((step for step in steps if step["effect"] == name), None)
    if dimension is None or step is None:
        return math.nan
    if key["test"] == "rate_table" and dimension == "g":
        return math.nan  # nonlinearity may be given at full rate or for each (deg/s)^2
    scale = key["scale"][effect["shape"].get("channel", 0)]
    for parameter in step.get("parameters", []):
        factor = factor_of(parameter["unit"], scale, key["unit"])
        spread = parameter.get("u")
        if factor is None or not spread or parameter["value"] is None:
            continue
        value, u, truth = parameter["value"] * factor, spread * factor, effect["size"]
        return (abs(value) - abs(truth)) / u
    return math.nan


def record_z(name: str, effect: dict[str, Any], steps: list[dict[str, Any]]) -> float:
    """The same for a record, whose numbers are in units of the output on both sides."""
    own = [step for step in steps if step["effect"] == name]
    if name not in SLOW or name in UNSCALED or len(own) != 1:
        return math.nan
    parameter = own[0]["parameters"][0]
    if not parameter["u"]:
        return math.nan
    # The branches of a hysteresis are apart by its width times what goes with the temperature.
    truth = abs(effect["size"]) * effect["shape"].get("width", 1.0)
    return (abs(parameter["value"]) - truth) / parameter["u"]


def closure(key: dict[str, Any], answer: dict[str, Any]) -> float:
    """Closed part of the gap that the oracle closes."""
    before, after = answer["before"]["rms"], answer["after"]["rms"]
    if before is None or after is None:  # nothing was judged
        return math.nan
    oracle = before * key["oracle_rms"] / key["before_rms"]
    return (before - after) / (before - oracle) if before > oracle * 1.0001 else math.nan
