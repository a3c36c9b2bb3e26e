"""FILE is a record that began with switching on, or a run file of several such records.

Turn-ons that began at one temperature make one set, about five each. The answer is a table against
time and chip temperature, with what it leaves on turn-ons that it has not seen; ``--c-header``
writes it for a microcontroller.
"""

import argparse
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from core.errors import FitError
from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import DriftResult, compensate
from core.procedures.drift.curves import Curves, curves_of
from core.procedures.drift.export import c_header, document
from core.procedures.drift.held_out import residuals_of
from core.procedures.drift.turn_on import TurnOn
from core.records.atomic import write_text_atomic
from core.version import SOFTWARE
from gui.commands.answer import Answer
from gui.commands.fitted import note_lines
from gui.drift.reading import How, read_turn_ons

_WORDS = {
    "none": "no correction",
    "cubic": "cubic in time",
    "quartic": "quartic in time",
    "angles": "knots by angles (source 003)",
    "table": "this table",
    "mean": "mean curve (floor)",
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the files, the settings of the table, and what the files may not tell."""
    parser.add_argument("file", nargs="+", type=Path)
    parser.add_argument(
        "--unseen", nargs="+", type=Path, default=[], metavar="FILE", help="turn-ons to test it on"
    )
    parser.add_argument(
        "--limit", type=int, default=16, metavar="TP", help="most knots that the memory allows (16)"
    )
    parser.add_argument("--knots", type=int, metavar="TP", help="how many (by held-out turn-ons)")
    parser.add_argument(
        "--window",
        nargs=2,
        type=float,
        default=(1.5, 2.0),
        metavar="S",
        help="start alignment (1.5 2.0)",
    )
    parser.add_argument("--block", type=float, default=1.0, metavar="S", help="block length (1)")
    parser.add_argument(
        "--horizon", type=float, default=np.nan, metavar="S", help="how long it shall work"
    )
    parser.add_argument("--channel", default="", help="name, role or number of the output")
    parser.add_argument("--temperature", default="", help="the same of the chip's temperature")
    parser.add_argument(
        "--ambient",
        type=float,
        action="append",
        default=[],
        metavar="DEGC",
        help="temperature of the chamber; give it once a file",
    )
    parser.add_argument("--rate", type=float, default=0.0, metavar="HZ", help="samples per second")
    parser.add_argument(
        "--scale-factor", type=float, default=0.0, metavar="K", help="output for 1 deg/s"
    )
    parser.add_argument("--c-header", type=Path, metavar="OUT", help="write a C header")
    parser.add_argument("--name", default="", help="prefix of the names in the C header")


def run(args: argparse.Namespace) -> Answer:
    """Make the table, judge it, write it."""
    if args.ambient and len(args.ambient) != len(args.file):
        raise FitError(f"{len(args.ambient)} temperatures for {len(args.file)} files")
    ambients = args.ambient or [np.nan] * len(args.file)
    how = How(args.channel, args.temperature, args.rate, args.scale_factor)
    made = [
        read_turn_ons(path, how, ambient) for path, ambient in zip(args.file, ambients, strict=True)
    ]
    units = {unit for _, unit in made}
    if len(units) > 1:
        raise FitError(f"turn-ons in {', '.join(sorted(units))}; one unit is needed")
    curves = _curves([one for ones, _ in made for one in ones], args)
    result = compensate(curves, units.pop(), limit=args.limit, knots=args.knots)
    provenance = Provenance(
        procedure="drift after switching on, source 003",
        device=str(args.file[0].stem),
        software=SOFTWARE,
        computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
    )
    data = document(result, provenance)
    lines = _report(result)
    if args.unseen:
        others = [one for path in args.unseen for one in read_turn_ons(path, how)[0]]
        left = residuals_of(result.table, _curves(others, args))
        data["unseen_rms"] = float(np.sqrt(np.mean(left**2)))
        lines.append(f"  on {len(left)} other turn-ons it leaves {data['unseen_rms']:.4g}")
    if args.c_header is not None:
        name = args.name or args.c_header.stem
        write_text_atomic(args.c_header, c_header(result.table, name, provenance))
        lines.append(f"  written: {args.c_header}")
    return Answer(data, "\n".join(lines))


def _curves(turn_ons: list[TurnOn], args: argparse.Namespace) -> Curves:
    return curves_of(
        turn_ons,
        window_s=(args.window[0], args.window[1]),
        block_s=args.block,
        horizon_s=args.horizon,
    )


def _report(result: DriftResult) -> list[str]:
    table, curves = result.table, result.curves
    lines = [
        f"{len(curves.labels)} turn-ons at {len(table.temperatures_c)} temperatures,"
        f" {table.temperatures_c[0]:.1f} ... {table.temperatures_c[-1]:.1f} degC",
        f"  table of {len(table.times_s)} knots x {len(table.temperatures_c)} temperatures,"
        f" {table.bytes} bytes, {table.times_s[0]:g} ... {table.times_s[-1]:g} s",
        f"  knots: {', '.join(f'{time:g}' for time in table.times_s)} s",
        f"  start aligned over {table.alignment.start_s:g} ... {table.alignment.stop_s:g} s, whose"
        f" noise is {table.alignment.u:.3g} {table.unit} (u)",
    ]
    if result.methods:
        lines.append(f"  left on turn-ons that were not seen, rms in {table.unit}:")
        best = result.score("table").rms
        lines += [
            f"    {_WORDS[score.method]:<30} {score.rms:.4g}  ({score.rms / best:.2f} x),"
            f" {score.bytes} bytes"
            for score in result.methods
        ]
    if result.knot_scores:
        shown = ", ".join(f"{score.knots}: {score.rms:.4g}" for score in result.knot_scores)
        lines.append(f"  by number of knots: {shown}")
    return lines + note_lines(result.notes, "  ")
