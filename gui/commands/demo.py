"""The real window measures eight positions on the simulated rig by itself, offscreen if need be.

Files and pictures go to the folder; the estimates are compared with the rig's hidden truth.
"""

import argparse
import os
import sys
from pathlib import Path

from drivers.virtual.truth import report
from gui.commands.answer import Answer


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the folder, the unit and the seed."""
    parser.add_argument("--out", type=Path, default=Path("demo-output"), metavar="FOLDER")
    parser.add_argument("--device", choices=["pointer", "clbacc"], default="pointer")
    parser.add_argument("--seed", type=int, default=1, help="of the unit and its noise")


def run(args: argparse.Namespace) -> Answer:
    """Play the demonstration and tell what it found."""
    if sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    ):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

    from gui.demonstration import demonstrate

    outcome = demonstrate(args.out.resolve(), args.device, args.seed)
    lines = [*report(outcome.parameters), f"session: {outcome.session}"]
    lines += [str(path) for path in outcome.files]
    return Answer(outcome, "\n".join(lines))
