"""Further records that could be made: how temperature, time and drive would go in them."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.problem import Problem
from core.model.stimulus import Stimulus
from core.plans.plan import Plan, Step

_SPAN_C = 20.0
_RATES = (1.0, 3.0)
"""Of a chamber, degC/min: what all of them can, and what shows a lag of half a minute."""
_HOLD_MIN = 20.0
_COOL_MIN, _SETTLE_MIN = 30.0, 60.0
_DRIVE = 0.02
_DRIVEN = ("AntiNodeAmplitude", "ExcitationAmpl", "QuadratureAmpl")
_S_PER_MIN = 60.0


@dataclass(frozen=True, slots=True, eq=False)
class FollowRecord:
    """One more record.

    Parameters
    ----------
    title, why : in words
    plan : its parts as steps, with the temperatures that they lead to
    stimulus : from switching on, or from the end of the record that was made
    measured : (n,) rows of the stimulus that are recorded
    step_s : length of a row
    minutes : of bench time
    """

    title: str
    why: str
    plan: Plan
    stimulus: Stimulus
    measured: FloatArray
    step_s: float
    minutes: float


def follow_records(problem: Problem) -> tuple[FollowRecord, ...]:
    """All records that fit the channels of one that was made."""
    old = problem.stimulus
    span = float(np.ptp(old.column("t_s"))) / _S_PER_MIN
    found = [
        _follow(
            problem,
            "Another record right behind this one",
            "what settles has settled then, what drifts goes on, what jumped stays",
            [("as before", span, 0.0)],
        ),
        _follow(
            problem,
            "Restart from cold",
            "what settles after switching on begins anew, what drifts goes on",
            [("off", _COOL_MIN, 0.0), ("on, temperature held", span, 0.0)],
            began=1,
        ),
        _follow(
            problem,
            "Temperature held after a warm-up of an hour",
            "nothing that goes with temperature or with switching on is left",
            [("wait", _SETTLE_MIN, 0.0), ("temperature held", span, 0.0)],
        ),
    ]
    if "temperature_c" in old.columns:
        found += [
            _follow(
                problem,
                f"Temperature up and down by {_SPAN_C:g} degC at {rate:g} degC/min",
                "both directions and a rest between tell lag, hysteresis, slope and time apart",
                [
                    (f"up by {_SPAN_C:g} degC", _SPAN_C / rate, _SPAN_C),
                    ("held", _HOLD_MIN, _SPAN_C),
                    (f"down by {_SPAN_C:g} degC", _SPAN_C / rate, 0.0),
                    ("held", _HOLD_MIN, 0.0),
                ],
            )
            for rate in _RATES
        ]
    if any(name in old.columns for name in _DRIVEN):
        found.append(
            _follow(
                problem,
                f"Drive amplitude {100.0 * _DRIVE:g} % higher for a third of the record",
                "what goes with the drive steps, what goes with temperature or time does not",
                [("amplitude as it is", span / 3.0, 0.0)] * 3,
                driven=True,
            )
        )
    return tuple(found)


_Part = tuple[str, float, float]
"""What is done, minutes, degC above the temperature now at its end."""


def _follow(
    problem: Problem,
    title: str,
    why: str,
    parts: list[_Part],
    *,
    began: int = 0,
    driven: bool = False,
) -> FollowRecord:
    old = problem.stimulus
    rows = problem.rows
    idle = sum(minutes for name, minutes, _ in parts if name in ("off", "wait"))
    recorded = sum(minutes for _, minutes, _ in parts) - idle
    step_s = recorded * _S_PER_MIN / rows
    waited = 0 if began else sum(m for name, m, _ in parts if name == "wait")
    before = round(waited * _S_PER_MIN / step_s)
    # What was on goes on; a unit that is switched off begins again.
    past = 0.0 if began else float(np.ptp(old.column("t_s")))
    n = before + rows
    t: FloatArray = np.asarray(past + step_s * (np.arange(n) + 0.5), dtype=np.float64)
    columns: dict[str, FloatArray] = {
        "t_s": t,
        "start_s": np.zeros(n),
        "mount": np.zeros(n),
        "run": np.ones(n),
    }
    if "temperature_c" in old.columns:
        warm = old.column("temperature_c")
        columns["temperature_c"] = _course(parts, float(warm[-1]), t - t[0])
        columns["reference_c"] = np.full(n, float(np.mean(warm)))
    columns |= _channels(old, columns.get("temperature_c"), n, driven)
    zero = np.zeros((n, 3))
    plan = Plan(
        id="follow_up",
        title=title,
        test="record",
        source="model vs data",
        accumulation_s=recorded * _S_PER_MIN,
        settle_s=idle * _S_PER_MIN,
        temperatures_c=_temperatures(parts, columns),
        steps=tuple(
            Step(i, f"{name}, {minutes:.0f} min") for i, (name, minutes, _) in enumerate(parts, 1)
        ),
    )
    measured = (np.arange(n) >= before).astype(np.float64)
    return FollowRecord(
        title,
        why,
        plan,
        Stimulus(zero, zero, zero, zero, columns),
        measured,
        step_s,
        recorded + idle,
    )


def _course(parts: list[_Part], now: float, t: FloatArray) -> FloatArray:
    """(n,) temperature along the parts that are not idle."""
    at, value = [0.0], [now]
    for name, minutes, rise in parts:
        if name == "off":
            continue
        at.append(at[-1] + minutes * _S_PER_MIN)
        value.append(now + rise)
    return np.interp(t, at, value)


def _temperatures(parts: list[_Part], columns: Mapping[str, FloatArray]) -> tuple[float, ...]:
    if "temperature_c" not in columns:
        return ()
    now = float(columns["temperature_c"][0])
    found = dict.fromkeys(round(now + rise, 1) for _, _, rise in parts)
    return tuple(found) if len(found) > 1 else ()


def _channels(
    old: Stimulus, temperature: FloatArray | None, n: int, driven: bool
) -> dict[str, FloatArray]:
    """Each channel as it would go: with the temperature as it did, and wandering by itself."""
    found: dict[str, FloatArray] = {}
    warm = old.columns.get("temperature_c")
    for name, values in old.columns.items():
        if name in ("t_s", "start_s", "mount", "run", "temperature_c"):
            continue
        slope, middle = 0.0, 0.0
        if warm is not None and temperature is not None:
            middle = float(np.mean(warm))
            away = warm - middle
            slope = float(away @ values) / float(away @ away)
            values = values - slope * away
        # Its own wandering, backwards: as large and as slow, and at other times.
        own = np.resize(np.concatenate([values[::-1], values]), n)
        found[name] = own if temperature is None else own + slope * (temperature - middle)
        if driven and name in _DRIVEN:
            middle_third = (np.arange(n) >= n // 3) & (np.arange(n) < 2 * n // 3)
            found[name] = found[name] * (1.0 + _DRIVE * middle_third)
    return found
