"""FILE is a run on the dividing head through several temperatures, or a record of a standing unit.

Of a run each sensor gets bias and scale factor against temperature, told apart, with their
hysteresis; ``--check`` compares roll and pitch before and after compensation on another run. Of a
record (a run file of the test ``record``, a recording, columns of numbers) each output gets a
polynomial of the temperature.
"""

import argparse
from pathlib import Path

import numpy as np

from core.errors import FitError
from core.procedures.dividing_head import calibrate
from core.procedures.thermal.cycle import ThermalCalibration, ThermalChannel, calibrate_thermal
from core.procedures.thermal.plateaus import plateaus_of
from core.procedures.thermal.record import Trend, fit_record
from core.procedures.thermal.tilt import TiltErrors, tilt_errors
from core.records.open import read_any
from core.records.series_run import record_run
from core.samples.run import Conditions, Run
from drivers.series import read_series
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of
from gui.commands.fitted import estimate_text, note_lines


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, the orders, the check, and what a record may not tell."""
    parser.add_argument("file", type=Path)
    parser.add_argument("--order", type=int, metavar="S", help="of the bias (cross-validated)")
    parser.add_argument("--scale-order", type=int, metavar="S", help="of the scale factor")
    parser.add_argument(
        "--reference", type=float, default=np.nan, metavar="DEGC", help="temperature T0 (the first)"
    )
    parser.add_argument("--check", type=Path, metavar="FILE", help="a run to compare attitudes on")
    record = parser.add_argument_group("of a record")
    record.add_argument(
        "--record", action="store_true", help="FILE is a record that is no run file"
    )
    record.add_argument(
        "--channel", action="append", default=[], help="name, role or number of an output"
    )
    record.add_argument("--temperature", default="", help="the same of the temperature")
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Fit a cycle or a record."""
    if args.record:
        measured = record_run(read_series(args.file), args.channel, args.temperature)
    else:
        measured = read_any(args.file)
    if measured.test == "record":
        return _record(args, measured)
    conditions, assumed = conditions_of(args, measured.conditions)
    found = calibrate_thermal(
        measured,
        conditions,
        bias_order=args.order,
        scale_order=args.scale_order,
        reference_c=args.reference,
    )
    data: dict[str, object] = {"file": args.file, "thermal": found}
    lines = [
        f"{args.file}: {measured.device}, {found.low_c:.1f} ... {found.high_c:.1f} degC;"
        f" t = T - {found.reference_c:g} degC"
    ]
    for channel in found.channels:
        lines += _channel_lines(channel)
    lines += note_lines(found.notes, "  ")
    if args.check is not None:
        data["check"] = _check(args, measured, found, conditions, lines)
    if assumed:
        lines.append(f"  g = {KYIV_G_MPS2} m/s^2 was assumed (Kyiv); state yours by --g")
    return Answer(data, "\n".join(lines))


def _channel_lines(channel: ThermalChannel) -> list[str]:
    lines = [
        f"  {channel.channel}, axis {channel.axis.upper()}: bias to order {channel.bias_order},"
        f" scale factor to order {channel.scale_order}"
    ]
    fit = channel.fit
    for p, value, half in zip(fit.parameters, fit.values, fit.expanded(), strict=True):
        lines.append(f"    {p.symbol:<8} {value:>14.8g} +- {half:.2g} {p.unit}  (95 %)")
    if channel.scores:
        shown = ", ".join(f"{s.bias}/{s.scale}: {s.rms:.4g}" for s in channel.scores)
        lines.append(f"    left at temperatures left out, by orders: {shown}")
    for one in channel.hysteresis:
        title = f"at {one.temperature_c:.0f} degC"
        lines.append(f"    heating less cooling {title}: {estimate_text('', one.bias).strip()}")
    return lines + note_lines(fit.notes, "    ")


def _check(
    args: argparse.Namespace,
    measured: Run,
    found: ThermalCalibration,
    conditions: Conditions,
    lines: list[str],
) -> dict[str, TiltErrors]:
    """Roll and pitch of another run by the first temperature alone, and by all."""
    other = read_any(args.check, sensor="accelerometer")
    first = plateaus_of(measured.temperature_c, measured.order)[0]
    alone = calibrate(measured.rows(first.rows), conditions).triad()
    before = tilt_errors(other, alone, conditions)
    after = tilt_errors(other, found, conditions)
    lines.append(f"  roll/pitch errors of {args.check}, deg: before compensation, after")
    lines += [
        f"    {before.roll_deg[row]:7.1f} /{before.pitch_deg[row]:6.1f}"
        f"   {_pair(before, row)}   {_pair(after, row)}   u {after.u_pitch_deg[row]:.2g}"
        for row in range(len(other))
    ]
    lines.append(f"    largest: {before.worst_deg:.3g}, {after.worst_deg:.3g} deg")
    return {"before": before, "after": after}


def _pair(errors: TiltErrors, row: int) -> str:
    return f"{errors.roll_error_deg[row]:+8.4f} /{errors.pitch_error_deg[row]:+8.4f}"


def _record(args: argparse.Namespace, measured: Run) -> Answer:
    if args.check is not None:
        raise FitError("a record in one orientation gives no attitude to check")
    found = fit_record(measured, order=args.order)
    lines = [f"{args.file}: {measured.device}, {len(measured)} rows"]
    for trend in found.trends:
        lines += _trend_lines(trend)
    return Answer(
        {"file": args.file, "trends": found.trends, "notes": found.notes},
        "\n".join(lines + note_lines(found.notes, "  ")),
    )


def _trend_lines(trend: Trend) -> list[str]:
    lines = [
        f"  {trend.channel}: order {trend.order} in t = T - {trend.reference_c:g} degC,"
        f" {trend.low_c:.1f} ... {trend.high_c:.1f} degC; R^2 = {trend.explained:.3f}, standard"
        f" deviation {trend.rms_before:.4g} -> {trend.rms_after:.4g} {trend.unit}"
    ]
    for power, one in enumerate(trend.coefficients):
        lines.append(f"    {estimate_text(f't^{power}', one)}")
    if np.isfinite(trend.hysteresis.value):
        largest = estimate_text("", trend.hysteresis).strip()
        lines.append(
            f"    heating less cooling, largest at {trend.hysteresis_at_c:.0f} degC: {largest}"
        )
    return lines
