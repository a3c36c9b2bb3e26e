"""A whole session on the simulated rig: an operator walks the plan, hands-free.

The hidden truth is printed beside the estimates and stands nowhere in the session's folder.
"""

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.errors import FormatError
from core.plans.plan import Plan, load_plans
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions
from drivers.virtual.address import rig_of
from drivers.virtual.devices import Output
from drivers.virtual.session import Order, simulate_session
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
        help="a further effect, or ROLE/ID=V,V for one sensor",
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
    truth = {output.role: output for output in rig.truth()}
    rows = [
        row
        for place in range(len(calibration.channels))
        for row in _compared(calibration, place, truth)
    ]
    covered = sum(row["covered"] is True for row in rows)
    text = "\n".join(
        f"{row['channel']:<6} {row['symbol']:<6} {row['estimate']:>13.6g} +- {row['U95']:<9.2g}"
        f" truth {row['truth']:>13.6g}{'' if row['covered'] else '  outside'}"
        for row in rows
    )
    text += f"\n{covered} of {len(rows)} intervals (95 %) hold the truth; session in {args.folder}"
    return Answer({"session": args.folder, "parameters": rows, "covered": covered}, text)


def _plan(args: argparse.Namespace) -> Plan:
    plans = load_plans()
    if args.plan not in plans:
        raise FormatError(args.plan, f"there is no such plan; there are: {', '.join(plans)}")
    plan = plans[args.plan]
    return plan if args.accumulation is None else replace(plan, accumulation_s=args.accumulation)


def _compared(
    calibration: Calibration, place: int, truth: dict[str, Output]
) -> list[dict[str, object]]:
    """Estimate, interval and truth of each parameter of one sensor."""
    name, fit = calibration.channels[place], calibration.fits[place]
    which = name.rpartition("_")[2]
    hidden = truth[f"acc.{which}" if which in "xyz" else f"adc.{which}"]
    half = fit.expanded()
    return [
        {
            "channel": name,
            "symbol": parameter.symbol,
            "unit": parameter.unit,
            "estimate": float(value),
            "U95": float(width),
            "truth": hidden.value(parameter.name),
            "covered": bool(np.abs(value - hidden.value(parameter.name)) <= width),
        }
        for parameter, value, width in zip(fit.parameters, fit.values, half, strict=True)
    ]
