"""Between the old programs' text files, run files (``NAME.run.csv``) and sessions.

The target is recognised by its name: ``.run.csv`` is a run file; otherwise ``--to`` names the
legacy layout.
"""

import argparse
from pathlib import Path

from core.errors import FormatError
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.legacy.writer import write_legacy
from core.records.open import read_any
from core.records.run_file import write_run
from gui.commands.answer import Answer


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add source, target and the choices that a source may leave."""
    parser.add_argument("source", type=Path)
    parser.add_argument("target", type=Path)
    parser.add_argument("--to", choices=list(LEGACY_FORMATS), help="legacy layout of the target")
    parser.add_argument("--sensor", choices=["accelerometer", "gyro"])
    parser.add_argument("--mount", action="append", help="of each pass, where the source is silent")


def run(args: argparse.Namespace) -> Answer:
    """Read the source and write the target; what the source does not hold is left out."""
    measured = read_any(args.source, sensor=args.sensor, mounts=args.mount)
    if args.to is not None:
        write_legacy(measured, LEGACY_FORMATS[args.to], args.target)
    elif args.target.name.endswith(".run.csv"):
        write_run(measured, args.target)
    else:
        raise FormatError(args.target, "is no .run.csv; name a legacy layout by --to")
    notes = "".join(f"\n{note.severity.value}: {note.text}" for note in measured.notes)
    text = f"{args.target}: {len(measured)} rows, {measured.device}{notes}"
    return Answer({"file": args.target, "rows": len(measured), "notes": measured.notes}, text)
