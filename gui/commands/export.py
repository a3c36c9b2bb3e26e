"""FILE is what `calrig fit` takes, or a calibration that was exported as JSON before."""

import argparse
from pathlib import Path

from core.errors import FormatError
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import read_calibration
from core.records.exports import EXPORTS, export, proposed_name
from core.records.open import read_any
from gui.commands.answer import Answer
from gui.commands.conditions import add_conditions, conditions_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, the formats and the place."""
    parser.add_argument("file", type=Path, help="measured positions or a JSON calibration")
    parser.add_argument(
        "--format", action="append", choices=list(EXPORTS), help="repeatable; all if not given"
    )
    parser.add_argument("--out", type=Path, default=Path(), metavar="FOLDER", help="where to")
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Write the calibration in each format."""
    calibration = _calibration(args)
    args.out.mkdir(parents=True, exist_ok=True)
    written: list[Path] = []
    for kind in args.format or EXPORTS:
        path = args.out / proposed_name(calibration, kind)
        export(calibration, kind, path)
        written.append(path)
    return Answer({"written": written}, "\n".join(map(str, written)))


def _calibration(args: argparse.Namespace) -> Calibration:
    if args.file.suffix == ".json" and args.file.name != "session.json":
        return read_calibration(args.file)
    measured = read_any(args.file)
    conditions, assumed = conditions_of(args, measured.conditions)
    if assumed:
        raise FormatError(args.file, "does not say the local gravity; state it by --g")
    return calibrate(measured, conditions)
