"""FILE is a run of one gyro on a level base at several headings; column head_deg is clockwise.

A column tilt_deg is the elevation of the input axis by an accelerometer. With the noise of the gyro
the answer also tells how long to average, and how long the heading can be kept; without FILE it
tells nothing else.
"""

import argparse
from pathlib import Path

import numpy as np

from core.errors import FitError
from core.procedures.gyrocompass import Gyrocompass, find_north
from core.procedures.north_seeking import (
    QUARTERS,
    Seeking,
    averaging_advice,
    heading_uncertainty,
    held_uncertainty,
)
from core.records.open import read_any
from gui.commands.answer import Answer
from gui.commands.conditions import add_conditions, conditions_of
from gui.commands.fitted import estimate_text, note_lines
from gui.commands.noise import add_noise, noise_of

_HOUR_S = 3600.0
_HOURS = (0.5, 1.0, 2.0, 4.0)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, what is known of the gyro, and the advice that is wanted."""
    parser.add_argument("file", nargs="?", type=Path)
    parser.add_argument(
        "--scale-factor", type=float, default=np.nan, metavar="K", help="output for 1 deg/s"
    )
    parser.add_argument(
        "--u-tilt", type=float, default=0.0, metavar="ARCMIN", help="u of one reading of the tilt"
    )
    parser.add_argument("--ramp", action="store_true", help="estimate a steady change of the drift")
    parser.add_argument(
        "--average", type=float, default=10.0, metavar="S", help="averaging time (10)"
    )
    parser.add_argument(
        "--pause", type=float, default=5.0, metavar="S", help="time to turn and settle (5)"
    )
    parser.add_argument(
        "--target", type=float, default=np.nan, metavar="DEG", help="u of the heading wanted"
    )
    add_noise(parser)
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Find north, or tell how well it would be found, or both."""
    data: dict[str, object] = {}
    lines: list[str] = []
    latitude = np.nan if args.latitude is None else float(args.latitude)
    headings: tuple[float, ...] = QUARTERS
    if args.file is not None:
        measured = read_any(args.file, sensor="gyro")
        conditions, _ = conditions_of(args, measured.conditions)
        found = find_north(
            measured,
            conditions,
            scale_factor=args.scale_factor,
            u_tilt_arcmin=args.u_tilt,
            ramp=args.ramp,
        )
        data = {"file": args.file, "gyrocompass": found}
        lines += [f"{args.file}: {measured.device}", *_found_lines(found)]
        latitude = conditions.latitude_deg
        headings = tuple(measured.head_deg.tolist())
    elif not args.noise_n > 0:
        raise FitError("name a file, or state the noise of a gyro by --noise-n")
    if args.noise_n > 0:
        if np.isnan(latitude):
            raise FitError("state the latitude by --latitude")
        data["advice"] = _advice(args, Seeking(latitude, headings, args.pause), lines)
    return Answer(data, "\n".join(lines))


def _found_lines(found: Gyrocompass) -> list[str]:
    heading = found.heading
    lines = [
        f"  heading  {heading.value:.4f} deg, {heading.low:.4f} ... {heading.high:.4f} (95 %)",
        f"  {estimate_text('drift', found.drift)}",
        f"  {estimate_text('level', found.level)}",
    ]
    if np.isfinite(found.expected_dph):
        lines.append(f"  level part of the Earth's rate here: {found.expected_dph:.5g} deg/h")
    return lines + note_lines(found.notes, "  ")


def _advice(args: argparse.Namespace, seeking: Seeking, lines: list[str]) -> dict[str, object]:
    noise = noise_of(args)
    u = heading_uncertainty(noise, seeking, args.average)
    advice = averaging_advice(noise, seeking, target_deg=args.target)
    kept = held_uncertainty(noise, seeking, args.average, np.array(_HOURS) * _HOUR_S)
    lines += [
        f"  averaging {args.average:g} s at each of {len(seeking.headings_deg)} headings: u ="
        f" {u:.3g} deg",
        f"  best: {advice.best_s:.3g} s, u = {advice.best_deg:.3g} deg",
    ]
    if np.isfinite(args.target):
        reached = np.isfinite(advice.enough_s)
        lines.append(
            f"  {args.target:g} deg: {advice.enough_s:.3g} s are enough"
            if reached
            else f"  {args.target:g} deg cannot be reached with this gyro"
        )
    shown = ", ".join(f"{h:g} h: {value:.2g}" for h, value in zip(_HOURS, kept, strict=True))
    lines.append(f"  kept afterwards by the same noise, u in deg: {shown}")
    return {
        "average_s": args.average,
        "u_deg": u,
        "curve": advice,
        "kept_hours": _HOURS,
        "kept_u_deg": kept,
    }
