"""Follow-ups that can be done on the bench, as rows behind those that were measured."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from core.arrays import FloatArray
from core.plans.orientation import Mount
from core.plans.plan import Plan, Step
from core.samples.run import Run

_MOST = 24
_SMALL = 150
"""Outputs of a run that may be followed by far more rows than it has."""
TIMES = 2
"""How often each place of a series is measured that is chosen for the rivals."""
_POOL = tuple(5.0 * step for step in range(72))
_STEP_MIN, _MOUNT_MIN = 0.5, 8.0
_Place = tuple[str, float]


@dataclass(frozen=True, slots=True, eq=False)
class FollowUp:
    """One more series.

    Parameters
    ----------
    title, why : in words
    plan : the series alone
    run : what was measured and the series; the outputs of the series are zero
    minutes : of bench time
    """

    title: str
    why: str
    plan: Plan
    run: Run
    minutes: float


def followups_of(run: Run) -> tuple[FollowUp, ...]:
    """All follow-ups that fit a run."""
    if run.test == "rate_table":
        return _on_table(run)
    return _on_head(run)


def everywhere(run: Run) -> tuple[tuple[_Place, ...], Run]:
    """All places of the head that a series could be made of, and the run with their rows."""
    first = run.mount[0]
    mounts = dict.fromkeys(
        [_turned(first), _flipped(first), _turned(_flipped(first)), _across(run)]
    )
    places = tuple((mount, angle) for mount in mounts for angle in _POOL)
    return places, _longer(run, list(places))


def most_rows(run: Run) -> int:
    """Rows that a series behind this run may have."""
    return 10 * _MOST if run.y.size <= _SMALL else 5 * _MOST


def where_they_differ(run: Run, places: Sequence[_Place]) -> FollowUp:
    """A series of chosen places, each mounting by itself, in two orders of its angles.

    What is repeated there tells how much these rows scatter.
    """
    order: list[_Place] = []
    for mount in dict.fromkeys(mount for mount, _ in places):
        first = _shuffled([angle for where, angle in places if where == mount])
        order += [(mount, angle) for angle in (*first, *_shuffled(first))]
    return _follow(
        run,
        f"Where they differ most, {len(order)} positions",
        "angles at which the tied effects read most differently, each twice, in mixed order",
        order,
    )


def _across(run: Run) -> str:
    """A mounting with another axis along the shaft than the first."""
    used = {Mount.parse(mount).axis for mount in run.mount}
    free = [axis for axis in "ZYX" if axis not in used]
    return f"{free[0] if free else 'Z'}_from"


def _on_head(run: Run) -> tuple[FollowUp, ...]:
    mounts = list(dict.fromkeys(run.mount))
    angles = _sweep(run)
    first = mounts[0]
    mixed = _shuffled(angles)
    twice = (_turned(first), _flipped(first), "Z_from", _turned(first), _flipped(first))
    found = [
        _follow(run, title, why, [(mount, angle) for mount in chosen for angle in order])
        for title, why, chosen, order in (
            ("Reversed sweep", "the same angles the other way round", (first,), angles[::-1]),
            ("Mixed sweep", "the same angles in mixed order", (first,), mixed),
            (
                "Unit re-indexed by 90 deg",
                "the dial errs at other attitudes",
                (_turned(first),),
                mixed,
            ),
            ("Unit end for end", "errors of the rig turn their sign", (_flipped(first),), mixed),
            *(
                (
                    f"{axis} along the shaft",
                    "another cross axis is vertical",
                    (f"{axis}_from",),
                    mixed,
                )
                for axis in "XYZ"
                if f"{axis}_from" not in mounts
            ),
            (
                "Back to the first mounting",
                "what goes with time is not what came by bolting",
                (first,),
                angles[: len(angles) // 2],
            ),
            (
                "End for end, and re-indexed",
                "rig, dial and sensor apart",
                (_flipped(first), _turned(first)),
                mixed,
            ),
            (
                "All mountings, mixed",
                "rig, dial and sensor apart",
                (_turned(first), _flipped(first), "Z_from"),
                mixed[:16],
            ),
            (
                "All mountings twice, mixed",
                "rig, dial and sensor apart, with half the noise",
                twice,
                _dense(mixed),
            ),
        )
    ]
    if most_rows(run) >= 2 * _MOST * len(twice):
        finer = _shuffled((np.arange(2 * _MOST) * 7.5).tolist())
        found.append(
            _follow(
                run,
                "All mountings twice, twice as dense",
                "rig, dial and sensor apart, and marks between those of the first plan",
                [(mount, angle) for mount in twice for angle in finer],
            )
        )
    return tuple(found)


def _on_table(run: Run) -> tuple[FollowUp, ...]:
    rates = np.unique(run.set_rate_dps).tolist()
    mount = run.mount[0] or "Z_from"
    dense = sorted({*rates, *[0.5 * (a + b) for a, b in pairwise(rates)]})
    fine = [rate / 4.0 for rate in rates]
    found = [
        _follow(run, title, why, [(mount, rate) for rate in order])
        for title, why, order in (
            ("Mixed rates", "the same rates in mixed order", _shuffled(rates)),
            (
                "Mixed rates twice",
                "the same rates in mixed order, twice",
                [*_shuffled(rates), *_shuffled(rates)[::-1]],
            ),
            ("Falling rates", "the same rates downwards", rates[::-1]),
            ("Rates between", "rates between those that were measured", _shuffled(dense)[:_MOST]),
            ("Small rates", "rates close to zero", _shuffled(fine)),
        )
    ]
    return tuple(found)


def _sweep(run: Run) -> list[float]:
    angles = np.unique(np.mod(run.head_deg, 360.0).round(6))
    if len(angles) < 8:
        angles = np.arange(16) * 22.5
    if len(angles) > _MOST:
        angles = angles[np.linspace(0, len(angles) - 1, _MOST).astype(int)]
    return angles.tolist()


def _dense(angles: list[float]) -> list[float]:
    """These angles, or an even turn in mixed order where they are few."""
    return angles if len(angles) >= _MOST else _shuffled((np.arange(_MOST) * 15.0).tolist())


def _shuffled(values: Sequence[float]) -> list[float]:
    """Mixed, the same each time: neighbours lie far apart and steps differ."""
    return [values[int(i)] for i in np.random.default_rng(7).permutation(len(values))]


def _turned(mount: str) -> str:
    parsed = Mount.parse(mount)
    return f"{parsed.key}@{(parsed.reindex_deg + 90.0) % 360.0:g}"


def _flipped(mount: str) -> str:
    parsed = Mount.parse(mount)
    return f"{parsed.axis}_{'to' if parsed.sense == 'from' else 'from'}"


def _follow(run: Run, title: str, why: str, places: list[_Place]) -> FollowUp:
    table = run.test == "rate_table"
    steps = tuple(
        Step(i, title, mount, rate_dps=at, axis=Mount.parse(mount).axis.lower())
        if table
        else Step(i, title, mount, head_deg=at)
        for i, (mount, at) in enumerate(places, 1)
    )
    changes = sum(a[0] != b[0] for a, b in pairwise(places)) + 1
    length = run.conditions.accumulation_s
    plan = Plan(
        id="follow_up",
        title=title,
        test=run.test,
        source="model vs data",
        accumulation_s=length if np.isfinite(length) else 10.0,
        settle_s=3.0,
        temperatures_c=(),
        steps=steps,
    )
    minutes = _STEP_MIN * len(steps) + _MOUNT_MIN * changes
    return FollowUp(title, why, plan, _longer(run, places), minutes)


def _longer(run: Run, places: list[_Place]) -> Run:
    """The run with the rows of a plan behind it, another run of the same session."""
    k, c = len(places), run.y.shape[1]
    at = np.array([place for _, place in places])
    table = run.test == "rate_table"
    nothing = np.full(k, np.nan)
    step = float(np.median(np.diff(run.t_s))) if len(run) > 1 else 60.0

    def as_last(old: FloatArray) -> FloatArray:
        return np.concatenate([old, np.full(k, old[-1])])

    return replace(
        run,
        y=np.vstack([run.y, np.zeros((k, c))]),
        y_se=np.vstack([run.y_se, np.tile(np.median(run.y_se, axis=0), (k, 1))]),
        run=np.concatenate([run.run, np.full(k, run.run.max() + 1)]),
        order=np.concatenate([run.order, run.order.max() + 1 + np.arange(k)]),
        mount=(*run.mount, *(mount if run.mount[0] else "" for mount, _ in places)),
        head_deg=np.concatenate([run.head_deg, nothing if table else at]),
        set_rate_dps=np.concatenate([run.set_rate_dps, at if table else nothing]),
        temperature_c=as_last(run.temperature_c),
        t_s=np.concatenate([run.t_s, run.t_s[-1] + 10.0 * step + step * np.arange(k)]),
        extra={name: as_last(old) for name, old in run.extra.items()},
    )
