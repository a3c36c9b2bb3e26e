"""The real window measures sessions on the simulated rig by itself, offscreen if need be.

Files and pictures go to the folder; the estimates are compared with the rig's hidden truth.
"""

import argparse
import os
import sys
from pathlib import Path

from drivers.virtual.truth import report
from gui.commands.answer import Answer

_PARTS = {
    "head": "gui.dividing_head.demo",
    "rate": "gui.rate_table.demo",
    "accuracy": "gui.accuracy.demo",
    "live": "gui.live.demo",
    "allan": "gui.allan.demo",
    "thermal": "gui.thermal.demo",
    "drift": "gui.drift.demo",
    "frames": "gui.frames.demo",
    "certificate": "gui.certificate.demo",
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the folder, the parts and the seed."""
    parser.add_argument("--out", type=Path, default=Path("demo-output"), metavar="FOLDER")
    parser.add_argument(
        "--part",
        action="append",
        choices=list(_PARTS),
        help="what is measured; everything if it is not given",
    )
    parser.add_argument("--seed", type=int, default=1, help="of the units and their noise")


def run(args: argparse.Namespace) -> Answer:
    """Play the demonstration and tell what it found."""
    if sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    ):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

    from gui.demonstration import STEPS, demonstrate

    chosen = tuple(_PARTS[part] for part in args.part or ())
    outcome = demonstrate(args.out.resolve(), chosen or STEPS, args.seed)
    lines: list[str] = []
    for part in outcome.parts:
        lines += [part.title, *report(part.parameters), f"session: {part.session}"]
    lines += [str(path) for path in outcome.files]
    return Answer(outcome, "\n".join(lines))
