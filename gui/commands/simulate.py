"""A whole session on the simulated rig: an operator walks the plan, hands-free.

The hidden truth is printed beside the estimates and stands nowhere in the session's folder.
"""

import argparse
from dataclasses import replace
from pathlib import Path

from core.errors import FormatError
from core.plans.plan import Plan, load_plans
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions
from drivers.virtual.address import rig_of
from drivers.virtual.session import Order, simulate_session
from drivers.virtual.truth import compare, report
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the device, the plan and what goes wrong."""
    parser.add_argument("device", choices=["clbacc", "pointer"], help="unit on the rig")
    parser.add_argument("folder", type=Path, help="new folder for the session")
    parser.add_argument("--plan", default="accelerometer_8", help="identifier of a plan")
    parser.add_argument("--accumulation", type=float, metavar="S", help="seconds of each position")
    parser.add_argument("--replicates", type=int, default=1, help="how often to walk the plan")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--effects",
        action="append",
        default=[],
        metavar="ID=V,V",
        help="a further effect by its identifier in the catalogue, or ROLE/ID=V,V for one sensor;"
        " values of its shape (time constant, level) follow those of its parameters",
    )
    parser.add_argument(
        "--setting-arcsec", type=float, default=5.0, help="scatter of the angles really set (5)"
    )
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Measure on the rig, calibrate, and compare with the truth."""
    effects = "".join(f"&effect={effect.replace('=', ':', 1)}" for effect in args.effects)
    g = KYIV_G_MPS2 if args.g is None else args.g
    url = f"sim://{args.device}?speed=max&seed={args.seed}&g={g}&name={args.folder.name}{effects}"
    try:
        rig = rig_of(url)
    except ValueError as error:
        raise FormatError("--effects", str(error)) from error
    conditions, _ = conditions_of(args, Conditions())
    order = Order(
        url=url,
        plan=_plan(args),
        sensor="accelerometer",
        conditions=conditions,
        setting_arcsec=args.setting_arcsec,
        seed=args.seed,
        replicates=args.replicates,
    )
    measured = simulate_session(order, args.folder)
    calibration = calibrate(measured, conditions)
    rows = compare(calibration, rig)
    text = "\n".join([*report(rows), f"session in {args.folder}"])
    covered = sum(row.covered for row in rows)
    return Answer({"session": args.folder, "parameters": rows, "covered": covered}, text)


def _plan(args: argparse.Namespace) -> Plan:
    plans = load_plans()
    if args.plan not in plans:
        raise FormatError(args.plan, f"there is no such plan; there are: {', '.join(plans)}")
    plan = plans[args.plan]
    return plan if args.accumulation is None else replace(plan, accumulation_s=args.accumulation)
