"""FILE is an accuracy check: the unit turned to known angles of pitch or roll.

The unit's own angles (Inter, Mags/Accels) stand beside those that a calibration makes of its raw
codes; a limit gives a verdict by a stated rule.
"""

import argparse
from pathlib import Path

import numpy as np

from core.procedures.accuracy import OWN, RULES, TITLES, Accuracy, Limit, check_accuracy
from core.procedures.calibration import Calibration
from core.records.open import read_any
from core.records.open_calibration import open_calibration
from gui.commands.answer import Answer
from gui.commands.conditions import add_conditions, conditions_of
from gui.commands.fitted import note_lines


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, the calibration, what was set and what is allowed."""
    parser.add_argument("file", type=Path)
    parser.add_argument(
        "--calibration", type=Path, metavar="FILE", help="a .cal.json, or positions to fit"
    )
    parser.add_argument("--kind", choices=["pitch", "roll"], help="found from the data")
    parser.add_argument(
        "--angle", type=float, action="append", metavar="DEG", help="set angle of each row"
    )
    parser.add_argument("--limit", type=float, metavar="DEG", help="largest allowed error")
    parser.add_argument("--rule", choices=list(RULES), default="guarded", help="decision rule")
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Compare the angles with the set ones; exit code 1 if a limit is not kept."""
    measured = read_any(args.file)
    conditions, _ = conditions_of(args, measured.conditions)
    limit = None if args.limit is None else Limit(args.limit, RULES[args.rule])
    found = check_accuracy(
        measured,
        conditions,
        calibration=_calibration(args),
        kind=args.kind,
        angles_deg=args.angle,
        limit=limit,
    )
    verdicts = [trace.verdict for trace in found.traces if trace.verdict is not None]
    failed = any(verdict.value == "fail" for verdict in verdicts)
    return Answer(found, "\n".join(_lines(args.file, found)), int(failed))


def _calibration(args: argparse.Namespace) -> Calibration | None:
    path: Path | None = args.calibration
    if path is None:
        return None
    return open_calibration(path, lambda stated: conditions_of(args, stated)[0])


def _lines(path: Path, found: Accuracy) -> list[str]:
    lines = [f"{path}: {found.device}, {found.kind}{', full turn' if found.full_turn else ''}"]
    for trace in found.traces:
        told = trace.statistics
        verdict = "" if trace.verdict is None else f"  {trace.verdict.value}"
        lines.append(
            f"  {TITLES[trace.source]:<20} Min {told.minimum:+.4f}  Max {told.maximum:+.4f}"
            f"  (+/-) {told.half_span:.4f}  RMS {told.rms:.4f} deg{verdict}"
        )
        # What the calibration does not know acts on its own angles alone.
        calibration = found.u_calibration if trace.source == OWN else np.zeros_like(trace.error)
        total = np.hypot(trace.u_error, calibration)
        lines += [
            f"    {at:>7.2f}  {angle:>10.4f}  error {error:+.4f} deg (u = {u:.2g})"
            for at, angle, error, u in zip(
                found.set_deg, trace.angle, trace.error, total, strict=True
            )
        ]
    if found.limit is not None:
        lines.append(f"  limit {found.limit.error_deg:g} deg; {found.limit.rule.text}")
    return lines + note_lines(found.notes, "  ")
