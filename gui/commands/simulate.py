"""A whole session on the simulated rig: an operator walks the plan, hands-free.

Accelerometers and attitude units walk plans of the dividing head and accuracy checks, gyros those
of the rate table and the head at rest; with ``--seconds`` any unit is recorded at rest instead.
The hidden truth is printed beside the estimates and stands nowhere in the folder.
"""

import argparse
from dataclasses import replace
from pathlib import Path

from core.errors import FormatError, StorageError
from core.plans.plan import Plan, load_plans
from core.procedures.dividing_head import calibrate
from core.procedures.g_sensitivity import fit_g_sensitivity
from core.procedures.rate_table import calibrate_rate_table
from core.samples.run import Conditions, Run
from drivers.virtual.address import rig_of
from drivers.virtual.rig import Rig
from drivers.virtual.session import RAW_NAME, Order, simulate_record, simulate_session
from drivers.virtual.truth import Compared, compare, compare_rates, report
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of

_PLANS = {"clbacc": "accelerometer_8", "pointer": "accelerometer_8", "clbdus": "rate_table_100"}
"""What is walked where no plan is named; a unit without one can only be recorded."""
_GYROS = ("rate_table", "static_positions")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the device, the plan and what goes wrong."""
    devices = [*_PLANS, "cvg25"]
    parser.add_argument("device", choices=devices, help="unit on the rig")
    parser.add_argument("folder", type=Path, help="new folder for what is measured")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--plan", help="identifier of a plan (that of the unit)")
    what.add_argument(
        "--seconds", type=float, metavar="S", help="record the unit at rest for so long instead"
    )
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
    parser.add_argument("--cold", action="store_true", help="the unit was just switched on")
    parser.add_argument(
        "--setting-arcsec", type=float, default=5.0, help="scatter of the angles really set (5)"
    )
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Measure on the rig, calibrate, and compare with the truth."""
    effects = "".join(f"&effect={effect.replace('=', ':', 1)}" for effect in args.effects)
    g = KYIV_G_MPS2 if args.g is None else args.g
    url = f"sim://{args.device}?speed=max&seed={args.seed}&g={g}&name={args.folder.name}"
    url += effects + ("&cold=1" if args.cold else "")
    try:
        rig = rig_of(url)
    except ValueError as error:
        raise FormatError("--effects", str(error)) from error
    if args.seconds is not None:
        return _recorded(url, args)
    conditions, _ = conditions_of(args, Conditions())
    plan = _plan(args)
    order = Order(
        url=url,
        plan=plan,
        sensor="gyro" if plan.test in _GYROS else "accelerometer",
        conditions=conditions,
        setting_arcsec=args.setting_arcsec,
        seed=args.seed,
        replicates=args.replicates,
    )
    measured = simulate_session(order, args.folder)
    rows = _beside_truth(measured, conditions, rig)
    text = "\n".join([*(report(rows) if rows else []), f"session in {args.folder}"])
    covered = sum(row.covered for row in rows)
    return Answer({"session": args.folder, "parameters": rows, "covered": covered}, text)


def _recorded(url: str, args: argparse.Namespace) -> Answer:
    path: Path = args.folder / RAW_NAME
    if path.exists():
        raise StorageError(f"{args.folder} already holds a recording; name a new folder")
    if not args.seconds > 0:
        raise FormatError("--seconds", f"{args.seconds:g}; a record takes longer than nothing")
    args.folder.mkdir(parents=True, exist_ok=True)
    simulate_record(url, args.seconds, path)
    return Answer({"recording": path}, f"recording in {path}")


def _beside_truth(measured: Run, conditions: Conditions, rig: Rig) -> tuple[Compared, ...]:
    """What a calibration finds beside the truth; an accuracy check calibrates nothing."""
    if measured.test == "dividing_head":
        return compare(calibrate(measured, conditions), rig)
    if measured.test == "rate_table":
        return compare_rates(calibrate_rate_table(measured, conditions), rig)
    if measured.test == "static_positions":
        return compare(fit_g_sensitivity(measured, conditions).calibration(), rig)
    return ()


def _plan(args: argparse.Namespace) -> Plan:
    plans = load_plans()
    name = args.plan or _PLANS.get(args.device)
    if name is None:
        raise FormatError(args.device, "this unit has no plan of its own; --plan or --seconds")
    if name not in plans:
        raise FormatError(name, f"there is no such plan; there are: {', '.join(plans)}")
    plan = plans[name]
    return plan if args.accumulation is None else replace(plan, accumulation_s=args.accumulation)
