"""The entry: without a subcommand the window opens, with one the work is done headless."""

import argparse
from collections.abc import Sequence
from pathlib import Path

from core.version import VERSION
from gui.commands.table import COMMANDS, run_command


def main(arguments: Sequence[str]) -> int:
    """Run CalRig.

    Parameters
    ----------
    arguments : what follows the program's name on the command line

    Returns
    -------
    int
        The exit code of the process.

    Raises
    ------
    SystemExit
        After ``--help``, ``--version`` and arguments that cannot be understood.
    """
    if arguments and arguments[0] in COMMANDS:
        return run_command(arguments[0], arguments[1:])
    parser = _parser()
    if arguments and not arguments[0].startswith("-"):
        parser.error(f"there is no command {arguments[0]!r}; there are: {', '.join(COMMANDS)}")
    options = parser.parse_args(arguments)

    from gui.widgets.override_guard import guard_overrides

    # Before the first class of a window is defined.
    guard_overrides()
    from gui.app import Options, run

    return run(Options(options.simulated, options.folder))


def _parser() -> argparse.ArgumentParser:
    width = max(map(len, COMMANDS))
    listing = "\n".join(f"  {name:<{width}}  {entry.help}" for name, entry in COMMANDS.items())
    parser = argparse.ArgumentParser(
        prog="calrig",
        usage="calrig [--simulated [DEVICE]] [--folder FOLDER] | calrig COMMAND ...",
        description="Calibration bench for gyroscopes and accelerometers.\n"
        "Without a command the window opens.",
        epilog=f"commands (`calrig COMMAND --help` tells more):\n{listing}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--simulated",
        nargs="?",
        const="pointer",
        default="",
        metavar="DEVICE",
        help="open the window on the simulated rig: pointer, clbacc, or a whole sim:// address",
    )
    parser.add_argument("--folder", type=Path, help="folder of all sessions (~/CalRig)")
    parser.add_argument("--version", action="version", version=f"calrig {VERSION}")
    return parser
