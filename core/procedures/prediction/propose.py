"""Plans for the sensor and the rig at hand; plans with positions dropped or added."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from core.errors import FitError
from core.plans.plan import Plan, Step
from core.procedures.prediction.bench import Bench
from core.procedures.prediction.catalogue import METHODS, Method
from core.procedures.prediction.design import Prediction

_ADDED = "Added"


@dataclass(frozen=True, slots=True)
class Proposal:
    """A method with a plan.

    Parameters
    ----------
    method : key of `METHODS`
    plan : what to measure
    prediction : how well it would do
    reaches : whether every wanted parameter is determined as well as wanted
    """

    method: str
    plan: Plan
    prediction: Prediction
    reaches: bool


def predict(method: str, plan: Plan, bench: Bench) -> Prediction:
    """Predict the uncertainty of each parameter that a method gives by a plan.

    Parameters
    ----------
    method : key of `METHODS`

    Raises
    ------
    RankDeficient
        The plan leaves parameters free; they are named.
    FitError
        The method has no plan to predict from, is for another sensor, or the plan is for another
        method.
    """
    known = METHODS.get(method)
    if known is None:
        raise FitError(f"there is no method {method!r}; there are: {', '.join(METHODS)}")
    if known.predict is None:
        raise FitError(f"{known.title}: nothing can be predicted without a record; {known.needs}")
    if known.kind != bench.kind:
        raise FitError(f"{known.title} is for a {known.kind}, the sensor is a {bench.kind}")
    if not _serves(known, plan):
        raise FitError(f"the plan {plan.id!r} is for another method than {known.title!r}")
    return known.predict(plan, bench)


def propose(
    plans: Collection[Plan], bench: Bench, wanted: Mapping[str, float] | None = None
) -> tuple[Proposal, ...]:
    """Return what can be measured with this sensor and rig, the best first.

    Parameters
    ----------
    plans : to choose from
    bench : sensor, rig and statements
    wanted : names of parameters with the standard uncertainty wanted, in the unit of the
        prediction; the shortest plan that reaches all comes first, then those that come nearest.
        By default method by method, the plan that determines most first, among equals the shortest
    """
    found: list[Proposal] = []
    for name, method in METHODS.items():
        if method.kind != bench.kind or not set(method.tools) <= bench.tools:
            continue
        for plan in plans:
            if method.predict is None or not _serves(method, plan):
                continue
            try:
                prediction = method.predict(plan, bench)
            except FitError:
                # The packaged plans are tried on every method; those of another one do not count.
                continue
            found.append(Proposal(name, plan, prediction, _excess(prediction, wanted or {}) <= 1.0))
    return tuple(sorted(found, key=lambda one: _rank(one, wanted or {})))


def with_positions(plan: Plan, drop: Collection[int] = (), add: Sequence[Step] = ()) -> Plan:
    """The plan without some steps and with others after them.

    Parameters
    ----------
    drop : numbers of steps
    add : steps; they get the numbers that follow the highest

    Raises
    ------
    FitError
        The plan has no step of a number, or none is left.
    """
    unknown = set(drop) - {step.number for step in plan.steps}
    if unknown:
        names = ", ".join(str(number) for number in sorted(unknown))
        raise FitError(f"the plan {plan.id!r} has no step {names}")
    kept = [step for step in plan.steps if step.number not in drop]
    highest = max(step.number for step in plan.steps)
    added = [
        replace(step, number=highest + place, group=step.group or _ADDED)
        for place, step in enumerate(add, start=1)
    ]
    if not kept and not added:
        raise FitError("no position is left")
    return plan.with_steps((*kept, *added))


def _serves(method: Method, plan: Plan) -> bool:
    return plan.test in method.tests and bool(plan.temperatures_c) == method.over_temperature


def _excess(prediction: Prediction, wanted: Mapping[str, float]) -> float:
    """Largest ratio of predicted to wanted uncertainty; inf where a parameter stays free."""
    ratios = [prediction.u(name) / target for name, target in wanted.items()]
    return max((ratio if ratio == ratio else float("inf") for ratio in ratios), default=0.0)


def _rank(one: Proposal, wanted: Mapping[str, float]) -> tuple[float, float, float]:
    prediction = one.prediction
    if wanted:
        return (max(_excess(prediction, wanted), 1.0), prediction.minutes, prediction.rows)
    place = list(METHODS).index(one.method)
    return (place, -len(prediction.parameters), prediction.minutes)
