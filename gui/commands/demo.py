"""The real window measures sessions on the simulated rig by itself, offscreen if need be.

Files and pictures go to the folder; the estimates are compared with the rig's hidden truth. With
--pictures the pictures of the documentation are renewed instead.
"""

import argparse
import os
import sys
import tempfile
from pathlib import Path

from drivers.virtual.truth import report
from gui.commands.answer import Answer
from gui.demonstration.scenes import SCENES, with_what_they_need


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the folder, the parts and the seed."""
    parser.add_argument("--out", type=Path, default=Path("demo-output"), metavar="FOLDER")
    parser.add_argument(
        "--part",
        action="append",
        choices=list(SCENES),
        help="what is played; everything if it is not given",
    )
    parser.add_argument("--seed", type=int, default=1, help="of the units and their noise")
    parser.add_argument(
        "--pictures",
        type=Path,
        metavar="FOLDER",
        help="renew the pictures that the documentation shows, in this folder",
    )


def run(args: argparse.Namespace) -> Answer:
    """Play the demonstration and tell what it found."""
    if sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    ):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    keys = with_what_they_need(args.part or SCENES)
    return _play(args, keys) if args.pictures is None else _renew(args, keys)


def _play(args: argparse.Namespace, keys: tuple[str, ...]) -> Answer:
    from gui.demonstration.playing import demonstrate

    out = args.out.resolve()
    outcome = demonstrate(out, keys, args.seed)
    lines: list[str] = []
    for part in outcome.parts:
        session = part.session.relative_to(out)
        lines += [part.title, *report(part.parameters), f"session: {session}"]
    lines += [str(path.relative_to(out)) for path in outcome.files]
    return Answer(outcome, "\n".join([*lines, f"all in {args.out}"]))


def _renew(args: argparse.Namespace, keys: tuple[str, ...]) -> Answer:
    from gui.demonstration.pictures import renew

    # One name for all runs: a picture that shows it does not change because of it.
    scratch = Path(tempfile.gettempdir()) / "calrig-pictures"
    renewed = renew(args.pictures, scratch, keys, args.seed)
    lines = [f"{one.file:42s} {100 * one.changed:5.1f} % of the pixels changed" for one in renewed]
    return Answer({"pictures": renewed}, "\n".join(lines))
