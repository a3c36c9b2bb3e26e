"""What can be measured with this sensor and rig, and how well, before anything is measured.

With a plan the uncertainty of each parameter follows from its positions; ``--drop`` and ``--add``
show what positions are worth. Without one all packaged plans are compared.
"""

import argparse
from collections.abc import Sequence

import numpy as np

from core.errors import FitError
from core.plans.orientation import Mount
from core.plans.plan import Plan, Step, load_plans
from core.procedures.prediction.bench import TOOLS, Bench
from core.procedures.prediction.catalogue import METHODS
from core.procedures.prediction.design import Prediction
from core.procedures.prediction.propose import predict, propose, with_positions
from core.procedures.prediction.unseen import unseen
from core.samples.run import Conditions
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of
from gui.commands.noise import add_noise, noise_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the sensor, the rig, the plan and what is wanted."""
    parser.add_argument("sensor", choices=("accelerometer", "gyro"))
    parser.add_argument("--axis", choices=("x", "y", "z"), default="z", help="of the sensor (z)")
    parser.add_argument(
        "--tool",
        action="append",
        choices=TOOLS,
        default=[],
        help="what the rig has; may be given several times (all)",
    )
    parser.add_argument("--method", choices=list(METHODS), help="one method only")
    parser.add_argument("--plan", help="one plan only")
    parser.add_argument(
        "--drop", type=int, nargs="+", default=[], metavar="N", help="steps to leave out"
    )
    parser.add_argument(
        "--add",
        nargs="+",
        default=[],
        metavar="STEP",
        help="steps to add: MOUNT:ANGLE on the head, e.g. X_from:45; MOUNT:RATE on the table",
    )
    parser.add_argument(
        "--want",
        nargs="+",
        default=[],
        metavar="NAME=U",
        help="standard uncertainty wanted, e.g. bias=3e-4, in the unit that is printed",
    )
    parser.add_argument(
        "--pause", type=float, default=15.0, metavar="S", help="time to turn the rig (15)"
    )
    add_noise(parser)
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Predict one plan, or compare all."""
    conditions, assumed = conditions_of(args, Conditions(repeatability=0.0))
    bench = Bench(
        kind=args.sensor,
        noise=noise_of(args),
        conditions=conditions,
        axis=args.axis,
        tools=frozenset(args.tool or TOOLS),
        pause_s=args.pause,
    )
    lines = [f"g = {KYIV_G_MPS2} m/s^2 was assumed (Kyiv); state yours by --g"] if assumed else []
    if args.plan is None:
        if args.drop or args.add:
            raise FitError("name the plan by --plan whose steps shall be dropped or added to")
        return _compare(args, bench, lines)
    plans = load_plans()
    if args.plan not in plans:
        raise FitError(f"there is no plan {args.plan!r}; there are: {', '.join(plans)}")
    plan = plans[args.plan]
    changed = with_positions(plan, args.drop, _steps(args.add, plan))
    found: list[dict[str, object]] = []
    for method in [args.method] if args.method else _methods(plan, bench):
        prediction = predict(method, changed, bench)
        blind = unseen(method, changed, bench, prediction)
        found.append({"method": method, "plan": plan.id, "prediction": prediction, "unseen": blind})
        lines += _lines(method, changed, prediction)
        lines += [f"    cannot see: {note.text}" for note in blind]
        if changed is not plan and (args.drop or args.add):
            lines += _compared(method, plan, prediction, bench)
    return Answer({"predictions": found}, "\n".join(lines))


def _methods(plan: Plan, bench: Bench) -> list[str]:
    found = [one.method for one in propose([plan], bench)]
    if not found:
        raise FitError(f"no method measures a {bench.kind} along {bench.axis} by {plan.id!r}")
    return found


def _compare(args: argparse.Namespace, bench: Bench, lines: list[str]) -> Answer:
    if not bench.noise.random_walk > 0:
        raise FitError("state the white noise of the sensor by --noise-n (N of its Allan analysis)")
    wanted = dict(_wanted(text) for text in args.want)
    found = propose(load_plans().values(), bench, wanted)
    if args.method:
        found = tuple(one for one in found if one.method == args.method)
    shown: set[str] = set()
    for one in found:
        if one.method not in shown:
            method = METHODS[one.method]
            lines += [f"{method.title}: {method.gives}", f"  needs {method.needs}"]
            shown.add(one.method)
        first, *others = _plan_lines(one.plan, one.prediction)
        lines += [f"{first}  <- good enough" if wanted and one.reaches else first, *others]
    for name, method in METHODS.items():
        if method.kind == bench.kind and method.predict is None and not args.method:
            lines += [f"{method.title}: {method.gives}", f"  needs {method.needs}"]
            shown.add(name)
    if not found:
        lines.append(f"no packaged plan measures a {bench.kind} along {bench.axis} with this rig")
    data = [
        {
            "method": one.method,
            "plan": one.plan.id,
            "title": one.plan.title,
            "reaches": one.reaches,
            "prediction": one.prediction,
        }
        for one in found
    ]
    return Answer({"proposals": data}, "\n".join(lines), 0 if found else 1)


def _wanted(text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    try:
        number = float(value)
    except ValueError:
        number = np.nan
    if not equals or not number > 0:
        raise FitError(f"--want {text}: expected NAME=U, e.g. bias=3e-4")
    return name, number


def _steps(texts: Sequence[str], plan: Plan) -> list[Step]:
    steps: list[Step] = []
    for text in texts:
        mount, _, value = text.rpartition(":")
        try:
            axis, number = Mount.parse(mount).axis.lower(), float(value)
        except ValueError as error:
            raise FitError(f"--add {text}: expected MOUNT:NUMBER, e.g. X_from:45") from error
        on_table = plan.test == "rate_table"
        steps.append(
            Step(0, "", mount, 0.0, number, axis) if on_table else Step(0, "", mount, number)
        )
    return steps


def _lines(method: str, plan: Plan, prediction: Prediction) -> list[str]:
    return [METHODS[method].title, *_plan_lines(plan, prediction)]


def _plan_lines(plan: Plan, prediction: Prediction) -> list[str]:
    lines = [
        f"  {plan.id} ({plan.title}): {prediction.rows} accumulations, {prediction.minutes:.0f}"
        f" min, {prediction.dof} degrees of freedom"
    ]
    lines += [
        f"    {one.symbol:<8} u = {one.u:<9.3g} {one.unit:<14} {one.name}, limited by"
        f" {one.limited_by}"
        for one in prediction.parameters
    ]
    if prediction.free:
        lines.append(f"    not determined: {', '.join(prediction.free)}")
    return lines


def _compared(method: str, plan: Plan, prediction: Prediction, bench: Bench) -> list[str]:
    whole = predict(method, plan, bench)
    changes = [
        f"{one.symbol} {one.u / whole.u(one.name):.3g} x"
        for one in prediction.parameters
        if np.isfinite(whole.u(one.name))
    ]
    return [f"    against the whole plan: {', '.join(changes)}"]
